// Both layouts visit the faces in some order and paint the first ones: patches in the order of a
// breadth-first search from twelve faces at once, scattered ones in random order.
#include "paintings.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>

#include "limn/contract.h"
#include "limn/subdivision/label_subdivision.h"

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

std::string path_of(const Painting& painting) {
  return std::string(painting.layout == Layout::kPatches ? "patches" : "scattered") + "/" +
         std::to_string(painting.percent) + "/" + std::to_string(painting.depth);
}

std::vector<std::uint8_t> depths_of(const ControlMesh& mesh, const Painting& painting) {
  const std::vector<std::uint32_t> order = painting.layout == Layout::kPatches
                                               ? order_around_seeds(mesh)
                                               : random_order(mesh.face_count());
  const std::size_t painted = mesh.face_count() * static_cast<std::size_t>(painting.percent) / 100;
  std::vector<std::uint8_t> depths(mesh.face_count(), 0);
  for (std::size_t i = 0; i < std::min(painted, order.size()); ++i) {
    depths[order[i]] = static_cast<std::uint8_t>(painting.depth);
  }
  return depths;
}

VertexLabels legal_labels_of(const ControlMesh& mesh, const Painting& painting) {
  IgnoreProgress progress;
  Result<Legalisation> legal = legal_labels(mesh, depths_of(mesh, painting), {}, progress);
  LIMN_EXPECTS(legal.has_value());
  return std::move(legal->labels);
}

const std::vector<Painting>& deepest_paintings() {
  static const std::vector<Painting> paintings = {
      {Layout::kPatches, 1, 5},   {Layout::kPatches, 5, 4},   {Layout::kPatches, 20, 3},
      {Layout::kScattered, 1, 5}, {Layout::kScattered, 5, 3}, {Layout::kScattered, 20, 2}};
  return paintings;
}

}  // namespace limn::bench
