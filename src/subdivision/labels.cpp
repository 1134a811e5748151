// Plain sweeps over the flat topology. The closure under kWherePainted is a breadth-first walk that
// visits each vertex once, when it becomes positive.
#include "limn/subdivision/labels.h"

#include <algorithm>

#include "limn/contract.h"
#include "subdivision/non_quads.h"
#include "subdivision/parallel_ranges.h"
#include "subdivision/surroundings.h"

namespace limn {
namespace {

bool is_illegal_quad(std::span<const std::uint32_t> corners, const VertexLabels& labels,
                     LegalisationMethod method) {
  if (corners.size() != 4 ||
      std::ranges::count_if(corners, [&](std::uint32_t v) { return labels[v] == 0; }) != 2) {
    return false;
  }
  return method == LegalisationMethod::kGreedy ||
         (labels[corners[0]] == 0) != (labels[corners[2]] == 0);
}

}  // namespace

FacePattern quad_pattern(int a, int b, int c, int d) noexcept {
  const int positive = (a > 0) + (b > 0) + (c > 0) + (d > 0);
  switch (positive) {
    case 0:
      return FacePattern::kStays;
    case 1:
      return FacePattern::kY;
    case 2:
      return (a > 0) == (c > 0) ? FacePattern::kSplit : FacePattern::kIllegal;
    default:
      return FacePattern::kSplit;
  }
}

VertexLabels vertex_labels(const ControlMesh& mesh, std::span<const std::uint8_t> depths) {
  LIMN_EXPECTS(depths.size() == mesh.face_count());
  LIMN_EXPECTS(std::ranges::all_of(depths, [](std::uint8_t depth) { return depth <= kMaxDepth; }));
  constexpr std::size_t kGrain = std::size_t{1} << 13;
  const FlatTopology& topology = mesh.topology();
  VertexLabels labels(mesh.vertex_count(), 0);
  parallel_ranges(0, labels.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<std::uint32_t>(begin); v < end; ++v) {
      for (const std::uint32_t corner : corners_around(topology, v)) {
        labels[v] = std::max(labels[v], depths[topology.corner_faces[corner]]);
      }
    }
  });
  return labels;
}

void raise_non_quads(const ControlMesh& mesh, VertexLabels& labels,
                     std::vector<std::uint32_t>& risen) {
  const FlatTopology& topology = mesh.topology();
  for (std::size_t next = 0; next < risen.size(); ++next) {
    for (const std::uint32_t corner : corners_around(topology, risen[next])) {
      const std::uint32_t f = topology.corner_faces[corner];
      if (sides_of(topology, f) == 4) {
        continue;
      }
      for (const std::uint32_t w : corners_of(topology, f)) {
        if (labels[w] == 0) {
          labels[w] = 1;
          risen.push_back(w);
        }
      }
    }
  }
}

VertexLabels apply_non_quad_rule(const ControlMesh& mesh, VertexLabels labels, NonQuadRule rule) {
  LIMN_EXPECTS(labels.size() == mesh.vertex_count());
  if (mesh.is_all_quads()) {
    return labels;
  }
  std::vector<std::uint32_t> positive;
  for (std::uint32_t v = 0; v < labels.size(); ++v) {
    if (labels[v] > 0) {
      positive.push_back(v);
    }
  }
  switch (rule) {
    case NonQuadRule::kUniformFirstStep:
      if (!positive.empty()) {
        for (std::uint8_t& label : labels) {
          ++label;
        }
      }
      break;
    case NonQuadRule::kWherePainted:
      raise_non_quads(mesh, labels, positive);
      break;
  }
  return labels;
}

std::vector<std::uint32_t> illegal_faces(const ControlMesh& mesh, const VertexLabels& labels,
                                         LegalisationMethod method) {
  LIMN_EXPECTS(labels.size() == mesh.vertex_count());
  std::vector<std::uint32_t> faces;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    if (is_illegal_quad(corners_of(mesh.topology(), f), labels, method)) {
      faces.push_back(f);
    }
  }
  return faces;
}

std::vector<std::uint32_t> illegal_vertices(const ControlMesh& mesh, const VertexLabels& labels,
                                            LegalisationMethod method) {
  std::vector<std::uint32_t> vertices;
  for (const std::uint32_t f : illegal_faces(mesh, labels, method)) {
    for (const std::uint32_t v : corners_of(mesh.topology(), f)) {
      if (labels[v] == 0) {
        vertices.push_back(v);
      }
    }
  }
  std::ranges::sort(vertices);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}  // namespace limn
