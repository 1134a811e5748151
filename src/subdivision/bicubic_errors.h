#pragma once

#include <cstddef>
#include <cstdint>

#include "subdivision/point.h"

// How far the triangles that regular pieces of surface are cut into are from them. Internal to this
// folder.
namespace limn {

/// Bicubics side by side.
struct BicubicBatch {
  static constexpr std::size_t kMost = 8;

  /// The 4 x 4 control points of each, row by row, all finite; the quad of side 1 is the one in the
  /// middle.
  StoredPoint points[kMost][16];
  /// Bits: which sides are curves of their own, boundaries or creases. There, what stands off
  /// within the surface counts as well, but along the curve.
  std::uint8_t curves[kMost];
};

/// Of quads of side 1 in each bicubic of a batch.
struct BicubicErrors {
  float outwards[BicubicBatch::kMost];  ///< The most that triangles are off in the direction of
                                        ///< the normal,
  float within[BicubicBatch::kMost];    ///< and at right angles to it.
  float turn[BicubicBatch::kMost];      ///< The greatest sine of an angle between the middle's
                                        ///< normal and another; 1 where it is a right one or more,
                                        ///< or somewhere is no normal.
};

/// From the derivatives at nine places: corners, middles of the sides, and centre. For vertices on
/// the limit surface or, `at_level`, where subdivision puts them; quads are cut along their shorter
/// diagonal, which may be either where both are about as long. Single precision: what is less than
/// a millionth of a bicubic's size is noise.
void bicubic_errors(const BicubicBatch& batch, bool at_level, BicubicErrors& errors) noexcept;

}  // namespace limn
