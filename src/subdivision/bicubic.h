#pragma once

#include <array>

#include "subdivision/point.h"

// A regular piece of surface as the bicubic that it is. Internal to this folder.
namespace limn {

/// The 4 x 4 control points of a quad of side 1, row by row; the quad is the one in the middle.
using BicubicPoints = std::array<Point, 16>;

/// Derivatives at a place of it, u along rows and v along columns.
struct BicubicSample {
  Point u;
  Point v;
  Point uu;
  Point uv;
  Point vv;
};

/// How many places are looked at along a side: its ends and its middle.
inline constexpr std::size_t kSamplesAlong = 3;

/// At the corners, the middles of the sides, and the centre: row by row.
using BicubicSamples = std::array<BicubicSample, kSamplesAlong * kSamplesAlong>;

[[nodiscard]] BicubicSamples sample_bicubic(const BicubicPoints& points) noexcept;

}  // namespace limn
