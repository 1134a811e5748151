// Faces and boundary edges are counted by their labels; edges and vertices follow from them,
// since a refinement changes neither the Euler characteristic nor the number of boundary loops:
//   2 E = (sum of face sides) + (boundary edges),   V = (V0 - E0 + F0) + E - F.
// Stopping after N steps gives the counts of the labels min(L, N): the rules for new labels commute
// with that minimum. So one table, indexed by the labels of a quad or an edge, serves every
// question.
#include "limn/subdivision/prediction.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <optional>
#include <vector>

#include "limn/contract.h"
#include "limn/subdivision/settings.h"
#include "subdivision/fine/fine_counts.h"
#include "subdivision/label_counts.h"
#include "subdivision/parallel_ranges.h"
#include "subdivision/surroundings.h"

namespace limn {
namespace {

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

/// Of the texture coordinates, whose surface has the same faces and edges of its own, seams twice.
template <class InsideEdge>
std::uint64_t texture_bytes(const TextureSurface& texture, const RefinementPrediction& prediction,
                            std::uint64_t sides, const InsideEdge& inside_edge) {
  const FlatTopology& topology = texture.topology;
  std::uint64_t boundary_edges = 0;
  for (std::size_t e = 0; e < topology.edge_corners.size(); ++e) {
    const auto [corner, other] = topology.edge_corners[e];
    if (other == kNone) {
      const auto [a, b] = topology.edge_vertices[e];
      boundary_edges += 1 + inside_edge(corner, texture.vertices[a], texture.vertices[b]);
    }
  }
  const std::uint64_t edges = (sides + boundary_edges) / 2;
  const std::size_t faces = topology.face_offsets.size() - 1;
  const std::uint64_t points =
      texture.points.size() + (edges - topology.edge_corners.size()) - (prediction.faces - faces);
  return add(multiply(points, sizeof(glm::vec2)), multiply(sides, sizeof(std::uint32_t)));
}

/// The labels of finer levels, held to the levels.
std::optional<FineCounts> counts_of(const ControlMesh& mesh, const VertexLabels& labels, int levels,
                                    const FineLabels* fine) {
  if (fine == nullptr) {
    return std::nullopt;
  }
  Cage cage;
  cage.topology = &mesh.topology();
  cage.is_all_quads = mesh.is_all_quads();
  VertexLabels held = labels;
  for (std::uint8_t& label : held) {
    label = static_cast<std::uint8_t>(std::min<int>(label, levels));
  }
  return FineCounts(cage, held, *fine, levels);
}

}  // namespace

RefinementPrediction predict_refinement(const ControlMesh& mesh, const VertexLabels& labels,
                                        int levels, const FineLabels* fine) {
  LIMN_EXPECTS(labels.size() == mesh.vertex_count());
  LIMN_EXPECTS(levels >= 0);
  const FlatTopology& topology = mesh.topology();
  const auto label_of = [&](std::uint32_t v) {
    return static_cast<std::uint8_t>(std::min<int>(labels[v], levels));
  };

  const std::optional<FineCounts> fine_counts = counts_of(mesh, labels, levels, fine);
  const auto is_fine = [&](std::size_t f) { return fine_counts && fine_counts->has(f); };

  RefinementPrediction prediction;
  const LabelCounts& counts = LabelCounts::table();
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
    const int deepest = is_fine(f) ? fine_counts->face(f).deepest : greatest;
    prediction.levels = std::max(prediction.levels, deepest);
    sides += corners.size();
    if (is_fine(f) && greatest > 0) {
      prediction.faces = add(prediction.faces, fine_counts->face(f).quads);
    } else if (corners.size() == 4) {
      const FaceCounts& quad = counts.face({corners[0], corners[1], corners[2], corners[3]});
      LIMN_EXPECTS(quad.quads > 0);  // Else the labels are illegal.
      prediction.faces = add(prediction.faces, quad.quads);
    } else if (greatest > 0) {
      prediction.faces = add(prediction.faces, counts.split(corners).quads);
    } else {
      prediction.faces = add(prediction.faces, 1);
      ++polygons;
      polygon_sides += corners.size();
    }
  }

  const auto inside_edge = [&](std::uint32_t corner, std::uint8_t a, std::uint8_t b) {
    const std::uint32_t f = topology.corner_faces[corner];
    return is_fine(f) ? fine_counts->side(f, corner - topology.face_offsets[f]) : counts.edge(a, b);
  };
  std::uint64_t boundary_edges = 0;
  for (std::size_t e = 0; e < mesh.edge_count(); ++e) {
    const auto [corner, other] = topology.edge_corners[e];
    if (other == kNone) {
      const auto [a, b] = topology.edge_vertices[e];
      boundary_edges = add(boundary_edges, 1 + inside_edge(corner, label_of(a), label_of(b)));
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
  if (const TextureSurface* texture = mesh.texture_surface(); texture != nullptr) {
    prediction.bytes =
        add(prediction.bytes,
            texture_bytes(*texture, prediction, refined_sides,
                          [&](std::uint32_t corner, std::uint32_t a, std::uint32_t b) {
                            return inside_edge(corner, label_of(a), label_of(b));
                          }));
  }
  prediction.uniform_faces = mesh.face_count();
  if (prediction.levels > 0) {
    prediction.uniform_faces = sides;
    for (int level = 1; level < prediction.levels; ++level) {
      prediction.uniform_faces = multiply(prediction.uniform_faces, 4);
    }
  }
  return prediction;
}

PaintedCounts count_painted(const ControlMesh& mesh, const VertexLabels& labels) {
  LIMN_EXPECTS(labels.size() == mesh.vertex_count());
  const FlatTopology& topology = mesh.topology();
  const LabelCounts& counts = LabelCounts::table();
  std::atomic<std::uint64_t> faces = 0;
  std::atomic<std::uint64_t> illegal_quads = 0;
  constexpr std::size_t kGrain = std::size_t{1} << 12;
  parallel_ranges(0, mesh.face_count(), kGrain, [&](std::size_t begin, std::size_t end) {
    PaintedCounts here;
    std::vector<std::uint8_t> corners;
    for (std::size_t f = begin; f < end; ++f) {
      const std::span<const std::uint32_t> face = corners_of(topology, f);
      if (face.size() == 4) {
        QuadLabels quad{labels[face[0]], labels[face[1]], labels[face[2]], labels[face[3]]};
        std::uint32_t quads = counts.face(quad).quads;
        if (quads == 0) {
          ++here.illegal_quads;
          *std::ranges::find(quad, 0) = 1;
          quads = counts.face(quad).quads;
        }
        here.faces += quads;
      } else if (labels[face[0]] == 0) {
        ++here.faces;
      } else {
        corners.clear();
        for (const std::uint32_t v : face) {
          corners.push_back(labels[v]);
        }
        here.faces += counts.split(corners).quads;
      }
    }
    faces += here.faces;
    illegal_quads += here.illegal_quads;
  });
  return {faces, illegal_quads};
}

}  // namespace limn
