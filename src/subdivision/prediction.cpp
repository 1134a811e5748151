// Faces and boundary edges are counted by recursion on labels; edges and vertices follow from them,
// since a refinement changes neither the Euler characteristic nor the number of boundary loops:
//   2 E = (sum of face sides) + (boundary edges),   V = (V0 - E0 + F0) + E - F.
// Stopping after N steps gives the counts of the labels min(L, N): the rules for new labels commute
// with that minimum. So one table, indexed by the four labels of a quad, serves every question.
#include "limn/subdivision/prediction.h"

#include <algorithm>
#include <array>
#include <vector>

#include "limn/contract.h"
#include "limn/subdivision/settings.h"
#include "subdivision/child_labels.h"
#include "subdivision/surroundings.h"

namespace limn {
namespace {

/// Labels run from 0 to kMaxDepth, and the uniform first step adds one.
constexpr std::size_t kLabels = kMaxDepth + 2;

/// One corner needs at most 4^(kMaxDepth + 1) < 2^24 quads and there are fewer than 2^32 corners,
/// so sums over a mesh fit 64 bits; the guard is for meshes of another age.
std::uint64_t add(std::uint64_t a, std::uint64_t b) {
  const std::uint64_t sum = a + b;
  return sum < a ? std::numeric_limits<std::uint64_t>::max() : sum;
}

std::uint64_t multiply(std::uint64_t a, std::uint64_t b) {
  return b != 0 && a > std::numeric_limits<std::uint64_t>::max() / b
             ? std::numeric_limits<std::uint64_t>::max()
             : a * b;
}

class QuadCounts {
 public:
  QuadCounts() : faces_(kLabels * kLabels * kLabels * kLabels, 0) {}

  /// Quads that become of one quad with these labels.
  std::uint64_t of(const std::array<std::uint8_t, 4>& labels) {
    std::uint64_t& known =
        faces_[((labels[0] * kLabels + labels[1]) * kLabels + labels[2]) * kLabels + labels[3]];
    if (known == 0) {
      known = count(labels);
    }
    return known;
  }

  /// The quad that a split leaves at corner i of an n-gon.
  std::uint64_t of_child(std::span<const std::uint8_t> labels, std::size_t i, std::uint8_t centre) {
    const std::size_t n = labels.size();
    const std::uint8_t before = labels[(i + n - 1) % n];
    const std::uint8_t after = labels[(i + 1) % n];
    return of({lowered(labels[i]), edge_point_label(labels[i], after), centre,
               edge_point_label(before, labels[i])});
  }

  /// Faces that become of an n-gon that is split.
  std::uint64_t of_split(std::span<const std::uint8_t> labels) {
    std::uint8_t centre = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      centre = least_positive(centre, edge_point_label(labels[i], labels[(i + 1) % labels.size()]));
    }
    std::uint64_t faces = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      faces = add(faces, of_child(labels, i, centre));
    }
    return faces;
  }

 private:
  std::uint64_t count(const std::array<std::uint8_t, 4>& labels) {
    switch (quad_pattern(labels[0], labels[1], labels[2], labels[3])) {
      case FacePattern::kStays:
        return 1;
      case FacePattern::kY: {
        const auto at = static_cast<std::size_t>(
            std::ranges::find_if(labels, [](int label) { return label > 0; }) - labels.begin());
        return add(2, of_child(labels, at, 0));
      }
      case FacePattern::kSplit:
        return of_split(labels);
      case FacePattern::kIllegal:
        break;
    }
    LIMN_EXPECTS(!"labels are legal");
    return 0;
  }

  std::vector<std::uint64_t> faces_;  // 0: not counted yet.
};

/// Edges that become of one edge; both orders of its ends give the same.
std::uint64_t edges_of_edge(std::uint8_t a, std::uint8_t b) {
  if (a == 0 && b == 0) {
    return 1;
  }
  const std::uint8_t middle = edge_point_label(a, b);
  return edges_of_edge(lowered(a), middle) + edges_of_edge(middle, lowered(b));
}

}  // namespace

RefinementPrediction predict_refinement(const ControlMesh& mesh, const VertexLabels& labels,
                                        int levels) {
  LIMN_EXPECTS(labels.size() == mesh.vertex_count());
  LIMN_EXPECTS(levels >= 0);
  const FlatTopology& topology = mesh.topology();
  const auto label_of = [&](std::uint32_t v) {
    return static_cast<std::uint8_t>(std::min<int>(labels[v], levels));
  };

  RefinementPrediction prediction;
  QuadCounts quads;
  std::vector<std::uint8_t> corners;
  std::uint64_t sides = 0;
  std::uint64_t polygons = 0;
  std::uint64_t polygon_sides = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    corners.clear();
    std::uint8_t greatest = 0;
    for (const std::uint32_t v : corners_of(topology, f)) {
      LIMN_EXPECTS(labels[v] < kLabels);
      corners.push_back(label_of(v));
      greatest = std::max(greatest, corners.back());
    }
    prediction.levels = std::max<int>(prediction.levels, greatest);
    sides += corners.size();
    if (corners.size() == 4) {
      prediction.faces =
          add(prediction.faces, quads.of({corners[0], corners[1], corners[2], corners[3]}));
    } else if (greatest > 0) {
      prediction.faces = add(prediction.faces, quads.of_split(corners));
    } else {
      prediction.faces = add(prediction.faces, 1);
      ++polygons;
      polygon_sides += corners.size();
    }
  }

  std::uint64_t boundary_edges = 0;
  for (std::size_t e = 0; e < mesh.edge_count(); ++e) {
    if (topology.edge_corners[e][1] == kNone) {
      const auto [a, b] = topology.edge_vertices[e];
      boundary_edges = add(boundary_edges, edges_of_edge(label_of(a), label_of(b)));
    }
  }

  const std::uint64_t refined_sides = add(multiply(4, prediction.faces - polygons), polygon_sides);
  prediction.edges = add(refined_sides, boundary_edges) / 2;
  // V = V0 + (E - E0) - (F - F0), all of which only grow.
  prediction.vertices = mesh.vertex_count() + (prediction.edges - mesh.edge_count()) -
                        (prediction.faces - mesh.face_count());
  prediction.bytes =
      add(add(multiply(prediction.vertices, sizeof(glm::vec3) + sizeof(std::uint8_t)),
              multiply(prediction.faces - polygons, sizeof(std::array<std::uint32_t, 4>))),
          add(multiply(prediction.faces, sizeof(std::uint32_t) + sizeof(std::uint8_t)),
              (polygons + 1 + polygon_sides) * sizeof(std::uint32_t)));
  prediction.uniform_faces = mesh.face_count();
  if (prediction.levels > 0) {
    prediction.uniform_faces = sides;
    for (int level = 1; level < prediction.levels; ++level) {
      prediction.uniform_faces = multiply(prediction.uniform_faces, 4);
    }
  }
  return prediction;
}

}  // namespace limn
