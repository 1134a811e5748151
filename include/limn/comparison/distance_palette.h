#pragma once

#include <array>

#include "limn/painting/depth_palette.h"

namespace limn {

/// Colours of distances from 0 to the greatest, at even steps; between them colours are mixed.
///
/// Lightness rises evenly all the way, so that the order is seen in grey print and by people with
/// any of the three colour-vision deficiencies: viridis (van der Walt & Smith 2015, CC0).
[[nodiscard]] const std::array<Rgb, kDepthColours>& distance_palette() noexcept;

/// The colour of a distance as a part of the greatest, 0..1; what is outside is taken for the end.
[[nodiscard]] Rgb distance_colour(double part) noexcept;

}  // namespace limn
