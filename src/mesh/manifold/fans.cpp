// Everything here walks corners: corner c's edge runs to the next corner of its face, and its twin
// is the corner at the other face of that edge.
#include "mesh/manifold/fans.h"

#include <utility>

#include "limn/mesh/flat_topology.h"

namespace limn::detail {

FanOwners find_fans(const FaceArrays& faces, std::span<const std::uint32_t> twins) {
  const std::vector<std::uint32_t> face_of = corner_faces(faces.offsets);
  // Counter-clockwise around a corner's vertex lies the face beyond the edge that arrives there,
  // clockwise the one beyond the edge that leaves.
  const auto left = [&](std::uint32_t c) { return twins[previous_corner(faces, face_of[c], c)]; };
  const auto right = [&](std::uint32_t c) {
    const std::uint32_t twin = twins[c];
    return twin == kNone ? kNone : next_corner(faces, face_of[twin], twin);
  };

  FanOwners result;
  std::vector<std::uint32_t>& owners = result.of_corners;
  owners.assign(faces.vertices.size(), kNone);
  std::vector<std::uint8_t> is_used(faces.vertex_count, 0);
  for (std::uint32_t start = 0; start < owners.size(); ++start) {
    if (owners[start] != kNone) {
      continue;
    }
    std::uint32_t owner = faces.vertices[start];
    if (std::exchange(is_used[owner], std::uint8_t{1}) != 0) {
      result.copy_sources.push_back(owner);
      owner = static_cast<std::uint32_t>(faces.vertex_count + result.copy_sources.size() - 1);
    }
    std::uint32_t c = start;
    do {
      owners[c] = owner;
      c = left(c);
    } while (c != kNone && c != start);
    if (c == kNone) {
      for (c = right(start); c != kNone; c = right(c)) {
        owners[c] = owner;
      }
    }
  }
  return result;
}

std::vector<std::uint32_t> separate_fans(WorkingFaces& faces, const FanOwners& owners,
                                         MendLog& log) {
  std::vector<std::uint8_t> is_used(faces.vertex_count, 0);
  for (const std::uint32_t v : faces.vertices) {
    is_used[v] = 1;
  }
  std::vector<std::uint32_t> sources;
  std::vector<std::uint32_t> new_numbers(faces.vertex_count, kNone);
  for (std::uint32_t v = 0; v < is_used.size(); ++v) {
    if (is_used[v] != 0) {
      new_numbers[v] = static_cast<std::uint32_t>(sources.size());
      sources.push_back(v);
    } else {
      log.add_loose_vertex(v);
    }
  }
  const std::size_t kept = sources.size();
  for (const std::uint32_t source : owners.copy_sources) {
    log.add_vertex(MendKind::kSplitVertex, source);
    sources.push_back(source);
  }
  for (std::size_t c = 0; c < faces.vertices.size(); ++c) {
    const std::uint32_t owner = owners.of_corners[c];
    faces.vertices[c] = owner < new_numbers.size()
                            ? new_numbers[owner]
                            : static_cast<std::uint32_t>(kept + (owner - new_numbers.size()));
  }
  faces.vertex_count = sources.size();
  return sources;
}

}  // namespace limn::detail
