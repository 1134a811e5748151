#pragma once

#include <array>
#include <cstdint>

#include "subdivision/patch.h"

// What distinguishes a patch from a bicubic B-spline's, counted and packed for a FlatPlan. Internal
// to this folder.
namespace limn {

/// Replaces the points beyond side i by those within, mirrored at the side.
void mirror_side(std::size_t i, std::array<Point, 16>& grid);

/// How a patch differs from a bicubic B-spline's.
class PatchShape {
 public:
  /// `with_limits`: sharp sides count until they have worn off, however deep the patch is refined.
  PatchShape(const Patch& patch, const Node& root, bool with_limits);

  [[nodiscard]] bool is_special() const noexcept { return corners_ != 0; }
  /// Sides beyond which points mirror those within: boundaries and infinitely sharp creases. Bits.
  [[nodiscard]] std::uint8_t curves() const noexcept { return curves_; }
  /// Sides with a semi-sharp crease. Bits.
  [[nodiscard]] std::uint8_t sharp() const noexcept { return sharp_; }
  [[nodiscard]] std::uint32_t sharp_levels(std::size_t side) const noexcept {
    return sharp_levels_[side];
  }
  /// Of the root, and how often it is refined.
  [[nodiscard]] int level() const noexcept { return level_; }
  [[nodiscard]] std::uint32_t levels() const noexcept { return levels_; }

  [[nodiscard]] std::uint64_t piece_count() const noexcept;
  [[nodiscard]] std::uint32_t ring_point_count(bool with_limits) const noexcept;
  [[nodiscard]] std::uint32_t share_count(std::size_t side, bool is_even) const noexcept;
  /// FlatSpecial::bits.
  [[nodiscard]] std::uint32_t bits() const noexcept;

 private:
  int level_;
  std::uint32_t levels_;
  std::uint8_t rings_ = 0;
  std::uint8_t before_ = 0;
  std::uint8_t after_ = 0;
  std::uint8_t curves_ = 0;
  std::uint8_t sharp_ = 0;
  std::uint8_t corners_ = 0;  ///< With a ring, or at the end of a sharp side.
  std::array<std::uint32_t, 4> sharp_levels_{};
};

/// Writes the shares of one level of a side that is `edges` edges long there (FlatPlan::shares).
/// Returns where the next level's go.
float* put_shares(const SideSharpness& sharpness, int level, std::ptrdiff_t edges, bool is_even,
                  float* out);

}  // namespace limn
