#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace limn::detail {

/// Counts what an OBJ file says and Limn does not read, so that nothing is lost in silence.
class UnusedData {
 public:
  /// A statement that is not read; `argument` is its first word.
  void count(std::string_view keyword, std::string_view argument);
  void count_weight();
  void count_colour();
  void count_uv_depth();

  /// "12 normals", "2 line elements", in the order of first appearance.
  [[nodiscard]] std::vector<std::string> phrases() const;

 private:
  struct Entry {
    std::string one;
    std::string many;
    std::size_t count;
  };
  void add(std::string_view one, std::string_view many);
  void add_unknown(std::string_view what, std::string_view name);

  std::vector<Entry> entries_;
  std::size_t unknown_kinds_ = 0;
};

}  // namespace limn::detail
