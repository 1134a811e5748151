// Corners are radix-sorted by the higher and then, stably, by the lower end of their edge: two
// counting sorts whose digits are whole vertex numbers, so a pole of any valence costs no more than
// a regular mesh. Corners of one edge then stand side by side, lowest first.
#include "mesh/edge_matching.h"

#include <algorithm>

#include "limn/mesh/control_mesh.h"

namespace limn::detail {
namespace {

struct Ends {
  std::uint32_t low;
  std::uint32_t high;

  friend bool operator==(const Ends&, const Ends&) = default;
};

std::vector<Ends> ends_of_corners(const FaceArrays& faces) {
  std::vector<Ends> ends(faces.vertices.size());
  for (std::size_t f = 0; f < faces.face_count(); ++f) {
    const std::uint32_t begin = faces.offsets[f];
    const std::uint32_t end = faces.offsets[f + 1];
    for (std::uint32_t c = begin; c < end; ++c) {
      const std::uint32_t from = faces.vertices[c];
      const std::uint32_t to = faces.vertices[c + 1 < end ? c + 1 : begin];
      ends[c] = {std::min(from, to), std::max(from, to)};
    }
  }
  return ends;
}

/// Stable counting sort: `order` is filled with the items of `items` by rising key.
template <class Key>
void sort_by(std::span<const std::uint32_t> items, std::span<std::uint32_t> order,
             std::vector<std::uint32_t>& starts, const Key& key) {
  std::fill(starts.begin(), starts.end(), 0U);
  for (const std::uint32_t item : items) {
    ++starts[key(item) + 1];
  }
  for (std::size_t k = 1; k < starts.size(); ++k) {
    starts[k] += starts[k - 1];
  }
  for (const std::uint32_t item : items) {
    order[starts[key(item)]++] = item;
  }
}

std::vector<std::uint32_t> corners_by_edge(const std::vector<Ends>& ends,
                                           std::size_t vertex_count) {
  std::vector<std::uint32_t> corners(ends.size());
  for (std::uint32_t c = 0; c < corners.size(); ++c) {
    corners[c] = c;
  }
  std::vector<std::uint32_t> sorted(ends.size());
  std::vector<std::uint32_t> starts(vertex_count + 1);
  sort_by(corners, sorted, starts, [&](std::uint32_t c) { return ends[c].high; });
  sort_by(sorted, corners, starts, [&](std::uint32_t c) { return ends[c].low; });
  return corners;
}

}  // namespace

EdgeMatching match_edges(const FaceArrays& faces) {
  const std::size_t corner_count = faces.vertices.size();
  EdgeMatching result;
  result.crowded_corner = kNone;

  const std::vector<Ends> ends = ends_of_corners(faces);
  const std::vector<std::uint32_t> sorted = corners_by_edge(ends, faces.vertex_count);
  // Until edges are numbered, corner_edges holds the first corner of each corner's edge.
  result.corner_edges.resize(corner_count);
  std::size_t edge_count = 0;
  for (std::size_t i = 0; i < corner_count;) {
    const std::uint32_t first = sorted[i];
    std::size_t end = i;
    for (; end < corner_count && ends[sorted[end]] == ends[first]; ++end) {
      result.corner_edges[sorted[end]] = first;
    }
    if (end - i > 2) {
      result.crowded_corner = std::min(result.crowded_corner, sorted[i + 2]);
    }
    i = end;
    ++edge_count;
  }
  if (result.crowded_corner != kNone) {
    result.corner_edges.clear();
    return result;
  }

  result.edge_corners.reserve(edge_count);
  for (std::uint32_t c = 0; c < corner_count; ++c) {
    const std::uint32_t first = result.corner_edges[c];
    if (first == c) {
      result.corner_edges[c] = static_cast<std::uint32_t>(result.edge_corners.size());
      result.edge_corners.push_back({c, kNone});
    } else {
      result.corner_edges[c] = result.corner_edges[first];
      result.edge_corners[result.corner_edges[c]][1] = c;
    }
  }
  return result;
}

std::vector<std::uint32_t> corner_faces(std::span<const std::uint32_t> face_offsets) {
  std::vector<std::uint32_t> faces(face_offsets.back());
  for (std::size_t f = 0; f + 1 < face_offsets.size(); ++f) {
    std::fill(faces.begin() + face_offsets[f], faces.begin() + face_offsets[f + 1],
              static_cast<std::uint32_t>(f));
  }
  return faces;
}

}  // namespace limn::detail
