#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace limn::detail {

/// Counts what a file holds and Limn does not read, so that nothing is lost in silence.
class UnusedData {
 public:
  void add(std::size_t count, std::string_view one, std::string_view many);
  /// The same with an s for many.
  void add(std::size_t count, const std::string& one) { add(count, one, one + 's'); }
  /// Of a kind that the file names itself, as in `"foo" statement`. The first eight kinds are told
  /// by name and the rest as `other`: a file that is no mesh has thousands.
  void add_named(std::size_t count, std::string_view name, std::string_view what);

  /// "12 normals", "2 line elements", in the order of first appearance.
  [[nodiscard]] std::vector<std::string> phrases() const;

 private:
  struct Entry {
    std::string one;
    std::string many;
    std::size_t count;
  };

  std::vector<Entry> entries_;
  std::size_t named_kinds_ = 0;
};

/// Counts an OBJ statement that is not read.
void count_obj_statement(UnusedData& unused, std::string_view keyword);

}  // namespace limn::detail
