#include "exactness_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <tuple>
#include <unordered_map>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "limn/subdivision/crack_check.h"
#include "subdivision/invariants.h"

namespace limn::test {
namespace {

double tolerance_of(const ControlMesh& mesh) {
  return 1e-6 * mesh.bounds().diagonal();
}

/// The same connectivity, numbers and all, with every vertex anywhere in the unit cube.
ControlMesh scattered(const ControlMesh& mesh) {
  HalfedgeMesh halfedges = mesh.halfedges();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(0.0, 1.0);
  for (const auto vertex : halfedges.vertices()) {
    const double x = coordinate(random);
    const double y = coordinate(random);
    const double z = coordinate(random);
    halfedges.set_point(vertex, {x, y, z});
  }
  return ControlMesh(std::move(halfedges), mesh.attributes());
}

Result<RefinedMesh> refined(const ControlMesh& mesh, const VertexLabels& labels,
                            const SubdivisionSettings& settings, int levels,
                            const FineLabels* fine = nullptr) {
  IgnoreProgress progress;
  RefineLimits limits;
  limits.fine = fine;
  limits.levels = levels;
  return refine(mesh, labels, settings, limits, progress);
}

/// Where to look for points: cells of a grid, hashed.
struct CellKey {
  double size;

  std::uint64_t operator()(const glm::dvec3& p, int neighbour) const {
    const std::array<int, 3> shift{neighbour % 3 - 1, neighbour / 3 % 3 - 1, neighbour / 9 - 1};
    std::uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<std::int64_t>(std::floor(p[axis] / size)) +
                      shift[static_cast<std::size_t>(axis)];
      hash = hash * 0x9E3779B97F4A7C15u + static_cast<std::uint64_t>(at);
    }
    return hash;
  }
};

struct Matching {
  std::vector<std::uint32_t> numbers;  ///< For each reference vertex the refined one.
  bool is_unique = true;  ///< False where vertices coincide, as on a pillow of two quads.
};

/// Pairs each point with a vertex of the refined mesh of its level and within the tolerance;
/// nothing if that fails anywhere.
std::optional<Matching> matched(const std::vector<glm::dvec3>& points,
                                const std::vector<ReferenceMesh::Vertex>& vertices,
                                const RefinedMesh& mesh, double tolerance) {
  const CellKey key{4.0 * tolerance};
  constexpr int kHere = 13;
  std::unordered_multimap<std::uint64_t, std::uint32_t> cells;
  cells.reserve(mesh.vertex_count());
  for (std::uint32_t i = 0; i < mesh.vertex_count(); ++i) {
    cells.emplace(key(mesh.position(i), kHere), i);
  }
  Matching matching;
  std::vector<char> is_taken(mesh.vertex_count(), 0);
  std::vector<std::pair<double, std::uint32_t>> candidates;
  for (std::size_t i = 0; i < points.size(); ++i) {
    candidates.clear();
    for (int neighbour = 0; neighbour < 27; ++neighbour) {
      const auto [begin, end] = cells.equal_range(key(points[i], neighbour));
      for (auto it = begin; it != end; ++it) {
        const std::uint32_t v = it->second;
        const double distance = glm::distance(points[i], mesh.position(v));
        if (distance <= tolerance) {
          matching.is_unique = matching.is_unique && candidates.empty() && is_taken[v] == 0;
          candidates.emplace_back(distance, v);
        }
      }
    }
    std::erase_if(candidates, [&](const auto& candidate) {
      const std::uint32_t v = candidate.second;
      return is_taken[v] != 0 || mesh.vertex_levels[v] != vertices[i].level;
    });
    std::ranges::sort(candidates);
    std::uint32_t best = kNone;
    for (const auto& [distance, v] : candidates) {
      // Of those that coincide the first: control vertices come first on both sides.
      if (distance <= candidates.front().first + 0.1 * tolerance) {
        best = std::min(best, v);
      }
    }
    if (best == kNone) {
      return std::nullopt;
    }
    is_taken[best] = 1;
    matching.numbers.push_back(best);
  }
  return matching;
}

using FaceRecord = std::tuple<std::vector<std::uint32_t>, int, std::uint32_t>;

FaceRecord face_record(std::vector<std::uint32_t> vertices, int level, std::uint32_t control) {
  std::rotate(vertices.begin(), std::ranges::min_element(vertices), vertices.end());
  return {std::move(vertices), level, control};
}

std::string compare_faces(const ReferenceMesh& reference, const RefinedMesh& mesh,
                          const std::vector<std::uint32_t>& numbers) {
  std::vector<FaceRecord> expected;
  for (const ReferenceMesh::Face& face : reference.faces) {
    std::vector<std::uint32_t> vertices;
    for (const std::uint32_t v : face.vertices) {
      vertices.push_back(numbers[v]);
    }
    expected.push_back(face_record(std::move(vertices), face.level, face.control_face));
  }
  std::vector<FaceRecord> found;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    found.push_back(
        face_record({face.begin(), face.end()}, mesh.face_levels[f], mesh.face_control_faces[f]));
  }
  std::ranges::sort(expected);
  std::ranges::sort(found);
  return expected == found ? "" : "faces differ";
}

/// What a prediction leaves aside.
std::size_t bytes_of_sharpness(const RefinedMesh& mesh) {
  return mesh.creases.size() * sizeof(RefinedCrease) + mesh.corners.size() * sizeof(RefinedCorner) +
         mesh.boundary_edges.size() * sizeof(RefinedBoundaryEdge);
}

}  // namespace

UniformReference::UniformReference(const ControlMesh& mesh, int levels, CornerRule corners)
    : mesh_(&mesh),
      scattered_(scattered(mesh)),
      hierarchy_(mesh, levels, corners),
      uniform_(hierarchy_.positions(mesh.positions())),
      uniform_scattered_(hierarchy_.positions(scattered_.positions())) {}

Exactness UniformReference::compare(const VertexLabels& labels, const SubdivisionSettings& settings,
                                    int levels) const {
  return compare_faulty(labels, settings, levels, [](RefinedMesh&) {});
}

std::vector<ReferenceMesh::Vertex> UniformReference::references(const VertexLabels& labels,
                                                                const SubdivisionSettings& settings,
                                                                int levels) const {
  return references({&labels, nullptr, nullptr, &settings, levels});
}

std::vector<ReferenceMesh::Vertex> UniformReference::references_fine(
    const VertexLabels& labels, const FineLabels* fine, const LevelLabels& given,
    const SubdivisionSettings& settings, int levels) const {
  return references({&labels, fine, &given, &settings, levels});
}

std::vector<ReferenceMesh::Vertex> UniformReference::references(const Case& at) const {
  const ReferenceMesh reference = reference_refinement(hierarchy_, *at.labels, at.levels, at.given);
  SubdivisionSettings at_level = *at.settings;
  at_level.points = SurfacePoints::kLevel;
  const auto refined_generic = refined(scattered_, *at.labels, at_level, at.levels, at.fine);
  if (!refined_generic || refined_generic->vertex_count() != reference.vertices.size()) {
    return {};
  }
  std::vector<glm::dvec3> points;
  for (const ReferenceMesh::Vertex& vertex : reference.vertices) {
    points.push_back(uniform_scattered_[static_cast<std::size_t>(vertex.level)][vertex.index]);
  }
  const auto matching =
      matched(points, reference.vertices, *refined_generic, tolerance_of(scattered_));
  if (!matching || !matching->is_unique) {
    return {};
  }
  std::vector<ReferenceMesh::Vertex> found(reference.vertices.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    found[matching->numbers[i]] = reference.vertices[i];
  }
  return found;
}

Exactness UniformReference::compare_faulty(const VertexLabels& labels,
                                           const SubdivisionSettings& settings, int levels,
                                           const std::function<void(RefinedMesh&)>& fault) const {
  return compare({&labels, nullptr, nullptr, &settings, levels}, fault);
}

Exactness UniformReference::compare_fine(const VertexLabels& labels, const FineLabels* fine,
                                         const LevelLabels& given,
                                         const SubdivisionSettings& settings, int levels) const {
  return compare({&labels, fine, &given, &settings, levels}, [](RefinedMesh&) {});
}

Exactness UniformReference::compare(const Case& at,
                                    const std::function<void(RefinedMesh&)>& fault) const {
  Exactness result;
  const ReferenceMesh reference = reference_refinement(hierarchy_, *at.labels, at.levels, at.given);
  const auto refined_generic = refined(scattered_, *at.labels, *at.settings, at.levels, at.fine);
  auto refined_mesh = refined(*mesh_, *at.labels, *at.settings, at.levels, at.fine);
  if (!refined_generic || !refined_mesh) {
    result.difference = "no refinement";
    return result;
  }
  fault(*refined_mesh);
  if (reference.vertices.size() != refined_mesh->vertex_count() ||
      reference.faces.size() != refined_mesh->face_count()) {
    result.difference =
        fmt::format("{} vertices and {} faces instead of {} and {}", refined_mesh->vertex_count(),
                    refined_mesh->face_count(), reference.vertices.size(), reference.faces.size());
    return result;
  }

  const auto positions_in = [&](const std::vector<std::vector<glm::dvec3>>& uniform) {
    std::vector<glm::dvec3> points;
    for (const ReferenceMesh::Vertex& vertex : reference.vertices) {
      points.push_back(uniform[static_cast<std::size_t>(vertex.level)][vertex.index]);
    }
    return points;
  };
  const auto matching = matched(positions_in(uniform_scattered_), reference.vertices,
                                *refined_generic, tolerance_of(scattered_));
  if (!matching) {
    result.difference = "some vertex of the scattered mesh lies off the uniform surfaces";
    return result;
  }
  const std::vector<std::uint32_t>& numbers = matching->numbers;
  for (std::uint32_t v = 0; v < mesh_->vertex_count(); ++v) {
    if (numbers[v] != v) {
      result.difference = "control vertices are renumbered";
    }
  }
  if (matching->is_unique) {
    result.difference += compare_faces(reference, *refined_mesh, numbers);
  }

  const double tolerance = tolerance_of(*mesh_);
  const std::vector<glm::dvec3> expected = positions_in(uniform_);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const std::uint32_t v = numbers[i];
    if (refined_mesh->vertex_levels[v] != reference.vertices[i].level) {
      result.difference += fmt::format("level of vertex {} differs", v);
      break;
    }
    const double deviation = glm::distance(refined_mesh->position(v), expected[i]);
    result.greatest_deviation =
        std::max(result.greatest_deviation, deviation / mesh_->bounds().diagonal());
    result.off += deviation <= tolerance ? 0 : 1;
  }
  return result;
}

std::string first_breach(const ControlMesh& mesh, const VertexLabels& labels,
                         const SubdivisionSettings& settings, int levels, const FineLabels* fine) {
  if (!illegal_faces(mesh, labels, settings.legalisation).empty()) {
    return "the labels are illegal";
  }
  const auto result = refined(mesh, labels, settings, levels, fine);
  if (!result) {
    return "no refinement";
  }
  const CrackCheck cracks = check_cracks(mesh, *result);
  if (!cracks.is_watertight() || !cracks.crack_faces.empty()) {
    return fmt::format("{} edges of a crack",
                       cracks.boundary_edges - cracks.control_boundary_edges);
  }
  if (mesh.is_closed() && cracks.boundary_edges != 0) {
    return "a closed mesh has opened";
  }
  for (std::size_t p = 0; p < result->polygon_count(); ++p) {
    const std::size_t f = result->quads.size() + p;
    const auto control = mesh.face(result->face_control_faces[f]);
    if (result->face_levels[f] != 0 || !std::ranges::equal(control, result->face(f))) {
      return "a polygon that is no control face";
    }
  }
  if (greatest_level_difference(*result) > 1) {
    return "levels jump across an edge";
  }
  const RefinementPrediction prediction = predict_refinement(mesh, labels, levels, fine);
  std::size_t sides = 0;
  for (std::size_t f = 0; f < result->face_count(); ++f) {
    sides += result->face(f).size();
  }
  if (prediction.faces != result->face_count() || prediction.vertices != result->vertex_count() ||
      2 * prediction.edges != sides + cracks.boundary_edges ||
      prediction.bytes != result->bytes() - bytes_of_sharpness(*result) ||
      (fine == nullptr &&
       prediction.levels != std::min<int>(levels, *std::ranges::max_element(labels)))) {
    return "not what was predicted";
  }
  return "";
}

}  // namespace limn::test
