// A breadth-first flood decides on a side for every face; then all faces of the other side turn.
#include "mesh/manifold/orientation.h"

#include <algorithm>

#include "limn/mesh/flat_topology.h"

namespace limn::detail {
namespace {

/// For every face whether it is to be turned over.
std::vector<std::uint8_t> find_sides(const WorkingFaces& working, std::vector<std::uint32_t>& twins,
                                     MendLog& log) {
  constexpr std::uint8_t unseen = 2;
  const FaceArrays faces = working.arrays();
  const std::vector<std::uint32_t> face_of = corner_faces(faces.offsets);
  std::vector<std::uint8_t> side(faces.face_count(), unseen);
  std::vector<std::uint32_t> component;  // Faces in the order met; serves as the queue too.
  for (std::uint32_t seed = 0; seed < faces.face_count(); ++seed) {
    if (side[seed] != unseen) {
      continue;
    }
    side[seed] = 0;
    component.assign(1, seed);
    std::size_t other_side = 0;
    for (std::size_t i = 0; i < component.size(); ++i) {
      const std::uint32_t f = component[i];
      for (std::uint32_t c = faces.offsets[f]; c < faces.offsets[f + 1]; ++c) {
        const std::uint32_t twin = twins[c];
        if (twin == kNone) {
          continue;
        }
        const std::uint32_t neighbour = face_of[twin];
        const bool clashes = faces.vertices[c] == faces.vertices[twin];
        const auto wanted = static_cast<std::uint8_t>(clashes ? 1 - side[f] : side[f]);
        if (side[neighbour] == unseen) {
          side[neighbour] = wanted;
          other_side += wanted;
          component.push_back(neighbour);
        } else if (side[neighbour] != wanted) {
          log.add_edge(MendKind::kOneSidedEdge, working.sources[f], faces.vertices[c],
                       faces.vertices[next_corner(faces, f, c)]);
          twins[c] = kNone;
          twins[twin] = kNone;
        }
      }
    }
    if (2 * other_side > component.size()) {
      for (const std::uint32_t f : component) {
        side[f] = static_cast<std::uint8_t>(1 - side[f]);
      }
    }
  }
  return side;
}

}  // namespace

void orient(WorkingFaces& faces, CornerMatching& matching, MendLog& log) {
  const std::vector<std::uint8_t> is_flipped = find_sides(faces, matching.twins, log);
  if (std::ranges::none_of(is_flipped, [](std::uint8_t is) { return is != 0; })) {
    return;
  }
  // Vertices a b c d become a d c b: the edges in corner order ab bc cd da become ad dc cb ba, the
  // old order backwards.
  std::vector<std::uint32_t> new_corners(faces.vertices.size());
  for (std::uint32_t f = 0; f < is_flipped.size(); ++f) {
    const std::uint32_t begin = faces.offsets[f];
    const std::uint32_t end = faces.offsets[f + 1];
    for (std::uint32_t c = begin; c < end; ++c) {
      new_corners[c] = is_flipped[f] != 0 ? begin + (end - 1 - c) : c;
    }
    if (is_flipped[f] != 0) {
      log.add_face(MendKind::kFlippedFace, faces.sources[f]);
      std::reverse(faces.vertices.begin() + begin + 1, faces.vertices.begin() + end);
      if (!faces.uvs.empty()) {
        std::reverse(faces.uvs.begin() + begin + 1, faces.uvs.begin() + end);
      }
    }
  }
  std::vector<std::uint32_t> twins(matching.twins.size());
  for (std::size_t c = 0; c < twins.size(); ++c) {
    const std::uint32_t twin = matching.twins[c];
    twins[new_corners[c]] = twin == kNone ? kNone : new_corners[twin];
  }
  matching.twins = std::move(twins);
  for (std::uint32_t& c : matching.crowded_corners) {
    c = new_corners[c];
  }
}

}  // namespace limn::detail
