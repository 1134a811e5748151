// Breadth first over corner twins where every step is free, Dijkstra's algorithm where it costs an
// angle. A face's neighbours are the faces of its corners' twins.
#include "limn/painting/face_regions.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

#include "limn/contract.h"
#include "limn/painting/selection.h"

namespace limn {
namespace {

/// Everything that `may_enter` lets in, from the seed on.
template <class MayEnter>
std::vector<std::uint32_t> reach(const FlatTopology& topology, std::uint32_t seed,
                                 MayEnter&& may_enter) {
  std::vector<bool> is_met(topology.face_offsets.size() - 1, false);
  std::vector<std::uint32_t> region{seed};
  is_met[seed] = true;
  for (std::size_t next = 0; next < region.size(); ++next) {
    const std::uint32_t face = region[next];
    for (std::uint32_t c = topology.face_offsets[face]; c < topology.face_offsets[face + 1]; ++c) {
      const std::uint32_t twin = topology.corner_twins[c];
      if (twin == kNone) {
        continue;
      }
      const std::uint32_t neighbour = topology.corner_faces[twin];
      if (!is_met[neighbour] && may_enter(neighbour)) {
        is_met[neighbour] = true;
        region.push_back(neighbour);
      }
    }
  }
  std::ranges::sort(region);
  return region;
}

}  // namespace

std::vector<std::uint32_t> flood_region(const ControlMesh& mesh,
                                        std::span<const std::uint8_t> depths, std::uint32_t seed) {
  LIMN_EXPECTS(depths.size() == mesh.face_count() && seed < mesh.face_count());
  return reach(mesh.topology(), seed,
               [&](std::uint32_t face) { return depths[face] == depths[seed]; });
}

std::vector<std::uint32_t> connected_region(const ControlMesh& mesh, std::uint32_t seed) {
  LIMN_EXPECTS(seed < mesh.face_count());
  return reach(mesh.topology(), seed, [](std::uint32_t) { return true; });
}

std::vector<std::uint32_t> smart_region(const ControlMesh& mesh,
                                        std::span<const double> edge_angles, std::uint32_t seed,
                                        double degrees) {
  LIMN_EXPECTS(edge_angles.size() == mesh.edge_count() && seed < mesh.face_count());
  const FlatTopology& topology = mesh.topology();
  const double most = degrees + kDihedralTolerance;
  std::vector<double> distance(mesh.face_count(), std::numeric_limits<double>::infinity());
  std::vector<std::uint32_t> region;
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  distance[seed] = 0.0;
  open.emplace(0.0, seed);
  while (!open.empty()) {
    const auto [way, face] = open.top();
    open.pop();
    if (way > distance[face]) {
      continue;  // A shorter way was found after this entry was made.
    }
    region.push_back(face);
    for (std::uint32_t c = topology.face_offsets[face]; c < topology.face_offsets[face + 1]; ++c) {
      const std::uint32_t twin = topology.corner_twins[c];
      if (twin == kNone) {
        continue;
      }
      const std::uint32_t neighbour = topology.corner_faces[twin];
      const double beyond = way + edge_angles[topology.corner_edges[c]];
      if (beyond <= most && beyond < distance[neighbour]) {
        distance[neighbour] = beyond;
        open.emplace(beyond, neighbour);
      }
    }
  }
  std::ranges::sort(region);
  return region;
}

}  // namespace limn
