#pragma once

#include "subdivision/cage.h"
#include "subdivision/vertex_ring.h"

// From the cage to the ring of one of its vertices. Internal to this folder.
namespace limn {

/// The mean sharpness of the other semi-sharp edges at the far end of the edge that leaves a
/// corner.
[[nodiscard]] float far_sharpness(const Cage& cage, std::uint32_t v, std::uint32_t edge);

/// Makes `ring` that of vertex v, with sharpness but without points.
void seed_sharpness(VertexRing& ring, const Cage& cage, std::uint32_t v);

}  // namespace limn
