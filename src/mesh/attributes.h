#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "limn/mesh/build.h"
#include "limn/mesh/texture_coordinates.h"
#include "mesh/edge_matching.h"

// From what a soup's tags say to what a control mesh carries.
namespace limn::detail {

/// Sharpness of every edge of the matching, or nothing where no edge is sharp. The tags name
/// vertices of `faces`. Counts lost tags and negative values in `report`.
[[nodiscard]] std::vector<float> edge_sharpness(std::span<const CreaseTag> tags,
                                                const FaceArrays& faces, const EdgeMatching& edges,
                                                ImportReport& report);

/// Sharpness of every vertex, or nothing where none is sharp. `vertex_sources` has the soup's
/// vertex for each.
[[nodiscard]] std::vector<float> vertex_sharpness(const PolygonSoup& soup,
                                                  std::span<const std::uint32_t> vertex_sources,
                                                  ImportReport& report);

/// The soup's texture coordinates that `corner_uvs` uses. Corners without one are given one common
/// point. Counts those, and coordinates that no corner uses, in `report`.
[[nodiscard]] TextureCoordinates texture_coordinates(const PolygonSoup& soup,
                                                     std::vector<std::uint32_t> corner_uvs,
                                                     ImportReport& report);

}  // namespace limn::detail
