// Corners are radix-sorted by the higher and then, stably, by the lower end of their edge: two
// counting sorts whose digits are whole vertex numbers, so a pole of any valence costs no more than
// a regular mesh. Corners of one edge then stand side by side, lowest first.
#include "mesh/edge_matching.h"

#include <algorithm>

#include "limn/contract.h"
#include "limn/mesh/flat_topology.h"

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

std::uint32_t most_sides_of(const FaceArrays& faces) {
  std::uint32_t most = 0;
  for (std::size_t f = 0; f < faces.face_count(); ++f) {
    most = std::max(most, faces.offsets[f + 1] - faces.offsets[f]);
  }
  return most;
}

}  // namespace

CornerMatching match_corners(const FaceArrays& faces) {
  const std::size_t corner_count = faces.vertices.size();
  CornerMatching result;
  result.twins.assign(corner_count, kNone);
  const std::vector<Ends> ends = ends_of_corners(faces);
  const std::vector<std::uint32_t> sorted = corners_by_edge(ends, faces.vertex_count);
  const std::uint32_t most_sides = most_sides_of(faces);
  const auto share_a_face = [&](std::uint32_t a, std::uint32_t b) {
    return b - a<most_sides&& * std::ranges::upper_bound(faces.offsets, a)> b;
  };
  std::vector<std::array<std::size_t, 2>> crowded;  // First corner, place in `sorted`.
  for (std::size_t i = 0; i < corner_count;) {
    std::size_t end = i + 1;
    while (end < corner_count && ends[sorted[end]] == ends[sorted[i]]) {
      ++end;
    }
    if (end - i == 2 && !share_a_face(sorted[i], sorted[i + 1])) {
      result.twins[sorted[i]] = sorted[i + 1];
      result.twins[sorted[i + 1]] = sorted[i];
    } else if (end - i >= 2) {
      crowded.push_back({sorted[i], i});
    }
    i = end;
  }
  std::ranges::sort(crowded);
  for (const auto& [first, begin] : crowded) {
    for (std::size_t i = begin; i < corner_count && ends[sorted[i]] == ends[first]; ++i) {
      result.crowded_corners.push_back(sorted[i]);
    }
    result.crowded_offsets.push_back(static_cast<std::uint32_t>(result.crowded_corners.size()));
  }
  return result;
}

EdgeMatching number_edges(std::span<const std::uint32_t> twins) {
  EdgeMatching result;
  result.corner_edges.resize(twins.size());
  result.edge_corners.reserve(twins.size() / 2);
  for (std::uint32_t c = 0; c < twins.size(); ++c) {
    if (twins[c] < c) {
      result.corner_edges[c] = result.corner_edges[twins[c]];
      result.edge_corners[result.corner_edges[c]][1] = c;
    } else {
      result.corner_edges[c] = static_cast<std::uint32_t>(result.edge_corners.size());
      result.edge_corners.push_back({c, kNone});
    }
  }
  return result;
}

EdgeMatching match_edges(const FaceArrays& faces) {
  const CornerMatching matching = match_corners(faces);
  LIMN_EXPECTS(!matching.is_crowded());
  return number_edges(matching.twins);
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
