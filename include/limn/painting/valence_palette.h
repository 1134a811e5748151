#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "limn/mesh/control_mesh.h"
#include "limn/mesh/refined_mesh.h"
#include "limn/painting/depth_palette.h"

namespace limn {

/// How far a vertex's valence, the number of its edges, is from a regular one: two or more too few,
/// one too few, one or two and more too many.
inline constexpr std::size_t kValenceBands = 4;

/// A vertex at which a mesh is not a regular grid.
struct IrregularVertex {
  std::uint32_t vertex = 0;
  std::uint8_t valence = 0;  ///< Edges at the vertex; 255 for more.
  std::uint8_t band = 0;     ///< 0..kValenceBands - 1.

  [[nodiscard]] bool operator==(const IrregularVertex&) const = default;
};

/// The vertices of another valence than a grid has, ascending. A mesh of triangles alone is
/// measured by the grid of triangles (6 inside, 4 at a boundary), every other by that of quads
/// (4 and 3).
[[nodiscard]] std::vector<IrregularVertex> irregular_vertices(const ControlMesh& mesh);
[[nodiscard]] std::vector<IrregularVertex> irregular_vertices(const RefinedMesh& mesh);

/// Irregular vertices of each band.
using ValenceCounts = std::array<std::size_t, kValenceBands>;
[[nodiscard]] ValenceCounts count_valences(const std::vector<IrregularVertex>& vertices) noexcept;

/// What the band is called: "2 or more too few", ...
[[nodiscard]] const char* valence_band_name(std::size_t band) noexcept;

/// One colour a band, from violet for too few to orange for too many, the darker the further: told
/// apart also by people with any of the three colour-vision deficiencies.
[[nodiscard]] const std::array<Rgb, kValenceBands>& valence_palette() noexcept;

}  // namespace limn
