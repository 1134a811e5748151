// Everything here walks corners: corner c's edge runs to the next corner of its face, and its twin
// is the corner at the other face of that edge.
#include "mesh/mending.h"

#include <algorithm>
#include <utility>

#include "limn/mesh/control_mesh.h"

namespace limn::detail {
namespace {

std::uint32_t next_corner(const FaceArrays& faces, std::uint32_t f, std::uint32_t c) {
  return c + 1 < faces.offsets[f + 1] ? c + 1 : faces.offsets[f];
}

std::uint32_t previous_corner(const FaceArrays& faces, std::uint32_t f, std::uint32_t c) {
  return c > faces.offsets[f] ? c - 1 : faces.offsets[f + 1] - 1;
}

}  // namespace

Orientation orient(const FaceArrays& faces, const EdgeMatching& edges) {
  constexpr std::uint8_t unseen = 2;
  const std::vector<std::uint32_t> face_of = corner_faces(faces.offsets);
  Orientation result;
  result.one_sided_face = kNone;
  std::vector<std::uint8_t>& side = result.is_flipped;
  side.assign(faces.face_count(), unseen);

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
        const std::uint32_t twin = edges.twin(c);
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
          result.one_sided_face = neighbour;
          return result;
        }
      }
    }
    if (2 * other_side > component.size()) {
      for (const std::uint32_t f : component) {
        side[f] = static_cast<std::uint8_t>(1 - side[f]);
      }
      other_side = component.size() - other_side;
    }
    result.flipped_faces += other_side;
  }
  return result;
}

void flip_faces(const std::vector<std::uint8_t>& is_flipped, WorkingFaces& faces,
                EdgeMatching& edges) {
  // Vertices a b c d become a d c b: the edges in corner order ab bc cd da become ad dc cb ba, the
  // old order backwards.
  for (std::size_t f = 0; f < is_flipped.size(); ++f) {
    if (is_flipped[f] != 0) {
      const auto begin = faces.offsets[f];
      const auto end = faces.offsets[f + 1];
      std::reverse(faces.vertices.begin() + begin + 1, faces.vertices.begin() + end);
      if (!faces.uvs.empty()) {
        std::reverse(faces.uvs.begin() + begin + 1, faces.uvs.begin() + end);
      }
      std::reverse(edges.corner_edges.begin() + begin, edges.corner_edges.begin() + end);
    }
  }
  // Edges are numbered as first met; corners have moved within their faces.
  std::vector<std::uint32_t> new_numbers(edges.edge_corners.size(), kNone);
  std::uint32_t met = 0;
  for (std::uint32_t c = 0; c < edges.corner_edges.size(); ++c) {
    std::uint32_t& number = new_numbers[edges.corner_edges[c]];
    if (number == kNone) {
      number = met++;
      edges.edge_corners[number] = {c, kNone};
    } else {
      edges.edge_corners[number][1] = c;
    }
    edges.corner_edges[c] = number;
  }
}

Fans separate_fans(WorkingFaces& working, const EdgeMatching& edges) {
  const FaceArrays faces = working.arrays();
  const std::vector<std::uint32_t> face_of = corner_faces(faces.offsets);
  // Counter-clockwise around a corner's vertex lies the face beyond the edge that arrives there,
  // clockwise the one beyond the edge that leaves.
  const auto left = [&](std::uint32_t c) {
    return edges.twin(previous_corner(faces, face_of[c], c));
  };
  const auto right = [&](std::uint32_t c) {
    const std::uint32_t twin = edges.twin(c);
    return twin == kNone ? kNone : next_corner(faces, face_of[twin], twin);
  };

  // Original vertices keep their numbers here; copies are numbered from vertex_count on.
  std::vector<std::uint32_t> owners(faces.vertices.size(), kNone);
  std::vector<std::uint32_t> copy_sources;
  std::vector<std::uint8_t> is_used(faces.vertex_count, 0);
  for (std::uint32_t start = 0; start < owners.size(); ++start) {
    if (owners[start] != kNone) {
      continue;
    }
    std::uint32_t owner = faces.vertices[start];
    if (std::exchange(is_used[owner], std::uint8_t{1}) != 0) {
      copy_sources.push_back(owner);
      owner = static_cast<std::uint32_t>(faces.vertex_count + copy_sources.size() - 1);
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

  Fans result;
  result.split_vertices = copy_sources.size();
  std::vector<std::uint32_t> new_numbers(faces.vertex_count, kNone);
  for (std::uint32_t v = 0; v < is_used.size(); ++v) {
    if (is_used[v] != 0) {
      new_numbers[v] = static_cast<std::uint32_t>(result.vertex_sources.size());
      result.vertex_sources.push_back(v);
    }
  }
  const std::size_t kept = result.vertex_sources.size();
  result.isolated_vertices = faces.vertex_count - kept;
  result.vertex_sources.insert(result.vertex_sources.end(), copy_sources.begin(),
                               copy_sources.end());
  for (std::size_t c = 0; c < owners.size(); ++c) {
    working.vertices[c] = owners[c] < new_numbers.size()
                              ? new_numbers[owners[c]]
                              : static_cast<std::uint32_t>(owners[c] - new_numbers.size() + kept);
  }
  working.vertex_count = result.vertex_sources.size();
  return result;
}

}  // namespace limn::detail
