#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "limn/mesh/large_array.h"
#include "subdivision/cage.h"

// Sharpness along control edges, level by level. Internal to this folder.
namespace limn {

/// The sharpness of the edges that a side of a patch consists of, at any level. They are counted in
/// the direction of growing columns or rows.
class SideSharpness {
 public:
  SideSharpness() = default;
  /// The same everywhere, one less at each level.
  explicit SideSharpness(float at_level_0) : uniform_(at_level_0) {}
  /// Rows of 2^k numbers, one row after the other, up to `last_level`; 0 from there on.
  SideSharpness(const float* rows, int last_level) : rows_(rows), last_level_(last_level) {}

  /// Counted from the other end.
  [[nodiscard]] SideSharpness reversed() const noexcept {
    SideSharpness other = *this;
    other.is_reversed_ = !is_reversed_;
    return other;
  }
  /// One half of the side, for a patch that starts at level 1. `is_second` in this one's direction.
  [[nodiscard]] SideSharpness half(bool is_second) const noexcept {
    SideSharpness other = *this;
    other.first_level_ = 1;
    other.is_second_ = is_second != is_reversed_;
    return other;
  }

  /// Of edge i of the side; -1 and so on lie beyond its ends.
  [[nodiscard]] float at(int level, std::ptrdiff_t i) const noexcept;

 private:
  const float* rows_ = nullptr;
  int last_level_ = 0;
  int first_level_ = 0;  ///< Where the side is one edge.
  float uniform_ = 0.0f;
  bool is_reversed_ = false;
  bool is_second_ = false;
};

/// The rows of all semi-sharp edges of a cage whose creases follow Chaikin's rule; others need
/// none.
class CreaseRows {
 public:
  void build(const Cage& cage);
  /// Of the edge that leaves a corner, in its direction.
  [[nodiscard]] SideSharpness of_corner(const Cage& cage, std::uint32_t corner) const noexcept;

 private:
  struct Row {
    std::uint32_t first = kNone;
    int last_level = 0;
  };
  std::vector<Row> edges_;  ///< Empty where there are no rows.
  std::vector<float> sharpness_;
};

}  // namespace limn
