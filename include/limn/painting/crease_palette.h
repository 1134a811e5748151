#pragma once

#include <array>
#include <cstddef>

#include "limn/mesh/control_mesh.h"
#include "limn/painting/depth_palette.h"

namespace limn {

/// The bands of sharpness that have a colour of their own.
inline constexpr std::size_t kSharpnessBands = 6;

/// Up to 1, 2, 3, 4, below kInfiniteSharpness, and infinite. `sharpness` is greater than 0.
[[nodiscard]] std::size_t sharpness_band(float sharpness) noexcept;

/// What the band is called: "up to 1", ..., "infinite".
[[nodiscard]] const char* sharpness_band_name(std::size_t band) noexcept;

/// One colour a band, from dark red to white: the sharper, the lighter, so that the order is seen
/// also by people with any of the three colour-vision deficiencies.
[[nodiscard]] const std::array<Rgb, kSharpnessBands>& crease_palette() noexcept;

/// How many edges and vertices of a control mesh are in each band.
using CreaseCounts = std::array<std::size_t, kSharpnessBands>;
[[nodiscard]] CreaseCounts count_creases(const ControlMesh& mesh);

}  // namespace limn
