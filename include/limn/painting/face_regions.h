#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "limn/mesh/control_mesh.h"

/// Regions that grow from one face across edges: what a paint bucket fills. They never go on over a
/// boundary edge, nor through a vertex alone. All come out ascending; `seed` is always in them.
namespace limn {

/// Greatest threshold of a smart fill, in degrees.
inline constexpr double kMostFillAngle = 360.0;

/// The faces that can be reached from `seed` over faces of the depth that `seed` has. `depths` has
/// one entry per face.
[[nodiscard]] std::vector<std::uint32_t> flood_region(const ControlMesh& mesh,
                                                      std::span<const std::uint8_t> depths,
                                                      std::uint32_t seed);

/// The faces that can be reached from `seed` at all: its connected component.
[[nodiscard]] std::vector<std::uint32_t> connected_region(const ControlMesh& mesh,
                                                          std::uint32_t seed);

/// The faces that can be reached from `seed` by a path whose dihedral angles add up to at most
/// `degrees` (by more than kDihedralTolerance to be left out), so that a surface which bends slowly
/// stops the fill as surely as one sharp edge does.
///
/// `edge_angles` is what `edge_dihedral_angles` gives for the mesh: whoever fills again and again
/// asks for it once. Time is O(n log n) in the faces of the region, besides an array over all
/// faces.
[[nodiscard]] std::vector<std::uint32_t> smart_region(const ControlMesh& mesh,
                                                      std::span<const double> edge_angles,
                                                      std::uint32_t seed, double degrees);

}  // namespace limn
