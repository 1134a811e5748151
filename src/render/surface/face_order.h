#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "limn/mesh/refined_mesh.h"
#include "render/surface/surface.h"

/// A refined mesh numbers quads first and its surface sorts faces by their number of sides: from
/// one number to the other, in time proportional to the faces asked about, but for a logarithm.
namespace limn::render {

/// The faces of the mesh that drawn faces of its surface are, ascending as those are.
[[nodiscard]] std::vector<std::uint32_t> refined_faces(const Surface& surface,
                                                       const RefinedMesh& mesh,
                                                       std::span<const std::uint32_t> drawn);

/// The drawn faces that faces of the mesh are, in their order.
[[nodiscard]] std::vector<std::uint32_t> drawn_faces(const Surface& surface,
                                                     const RefinedMesh& mesh,
                                                     std::span<const std::uint32_t> refined);

/// One byte for each face of the mesh, in the order of the surface.
[[nodiscard]] std::vector<std::uint8_t> in_drawn_order(const Surface& surface,
                                                       const RefinedMesh& mesh,
                                                       std::span<const std::uint8_t> of_refined);

}  // namespace limn::render
