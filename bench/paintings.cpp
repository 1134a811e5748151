// Both layouts visit the faces in some order and paint the first ones: patches in the order of a
// breadth-first search from twelve faces at once, scattered ones in random order.
#include "paintings.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace limn::bench {
namespace {

constexpr std::size_t kPatches = 12;

std::vector<std::uint32_t> random_order(std::size_t faces) {
  std::vector<std::uint32_t> order(faces);
  std::iota(order.begin(), order.end(), 0U);
  std::mt19937 random(1234);  // NOLINT(bugprone-random-generator-seed): the same in each run.
  std::shuffle(order.begin(), order.end(), random);
  return order;
}

std::vector<std::uint32_t> order_around_seeds(const ControlMesh& mesh) {
  const FlatTopology& topology = mesh.topology();
  std::vector<std::uint32_t> order = random_order(mesh.face_count());
  order.resize(kPatches);
  std::vector<bool> seen(mesh.face_count(), false);
  for (const std::uint32_t seed : order) {
    seen[seed] = true;
  }
  for (std::size_t next = 0; next < order.size(); ++next) {
    const std::uint32_t face = order[next];
    for (std::uint32_t c = topology.face_offsets[face]; c < topology.face_offsets[face + 1]; ++c) {
      const std::uint32_t twin = topology.corner_twins[c];
      if (twin != kNone && !seen[topology.corner_faces[twin]]) {
        seen[topology.corner_faces[twin]] = true;
        order.push_back(topology.corner_faces[twin]);
      }
    }
  }
  return order;
}

}  // namespace

std::vector<std::uint8_t> paint(const ControlMesh& mesh, Layout layout, double share, int depth) {
  const std::vector<std::uint32_t> order =
      layout == Layout::kPatches ? order_around_seeds(mesh) : random_order(mesh.face_count());
  const auto painted =
      static_cast<std::size_t>(std::lround(share * static_cast<double>(mesh.face_count())));
  std::vector<std::uint8_t> depths(mesh.face_count(), 0);
  for (std::size_t i = 0; i < std::min(painted, order.size()); ++i) {
    depths[order[i]] = static_cast<std::uint8_t>(depth);
  }
  return depths;
}

}  // namespace limn::bench
