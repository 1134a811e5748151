// A finished quad is written once, at the place that the step's numbering gave to its face. Which
// output vertex a corner of it is follows from the step alone; the next level need not exist.
#include "subdivision/refinement_output.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace limn {
namespace {

/// The vertices of the refined mesh that a face's corner gives rise to.
template <class Sides>
class FacePoints {
 public:
  FacePoints(const Sides& sides, const Level& level, const Step& step, std::size_t f)
      : sides_(&sides), level_(&level), step_(&step), f_(f) {}

  [[nodiscard]] std::uint32_t vertex(std::uint32_t side) const {
    return level_->vertex_outputs[level_->corner_vertices[corner(side)]];
  }
  /// The point on the edge that leaves the corner.
  [[nodiscard]] std::uint32_t edge(std::uint32_t side) const {
    return step_->output_of(step_->edge_points[corner(side)]);
  }
  [[nodiscard]] std::uint32_t centre() const { return step_->output_of(step_->face_points[f_]); }

 private:
  [[nodiscard]] std::uint32_t corner(std::uint32_t side) const {
    const std::uint32_t n = sides_->sides(f_);
    return sides_->first(f_) + (side < n ? side : side - n);
  }

  const Sides* sides_;
  const Level* level_;
  const Step* step_;
  std::size_t f_;
};

/// Its first label speaks for all: a non-quad is positive as a whole or not at all.
bool stays_polygon(const ControlMesh& mesh, const VertexLabels& labels, std::uint32_t f) {
  const auto corners = mesh.face(f);
  return corners.size() != 4 && labels[corners.front()] == 0;
}

/// The world's origin, unless floats relative to it would be too coarse. The Catmull-Clark points
/// of a mesh lie within its bounds, so it is enough to look at these.
glm::dvec3 origin_of(const Bounds& bounds) {
  constexpr double kCoarsest = 3e-7;  // Of the diagonal; a third of what a vertex may be off.
  const glm::dvec3 farthest = glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
  const double rounding = std::ldexp(glm::length(farthest), -24);
  return rounding > kCoarsest * bounds.diagonal() ? bounds.centre() : glm::dvec3(0.0);
}

}  // namespace

RefinedMesh allocate_output(const ControlMesh& mesh, const VertexLabels& labels,
                            const RefinementPrediction& prediction) {
  RefinedMesh output;
  output.origin = origin_of(mesh.bounds());
  output.positions.resize(prediction.vertices);
  output.vertex_levels.resize(prediction.vertices);
  output.face_control_faces.resize(prediction.faces);
  output.face_levels.resize(prediction.faces);
  std::fill_n(output.vertex_levels.begin(), mesh.vertex_count(), std::uint8_t{0});
  std::ranges::transform(
      mesh.positions(), output.positions.begin(),
      [&output](const glm::dvec3& position) { return glm::vec3(position - output.origin); });
  std::size_t polygons = 0;
  std::size_t polygon_sides = 0;
  for (std::uint32_t f = 0; !mesh.is_all_quads() && f < mesh.face_count(); ++f) {
    if (stays_polygon(mesh, labels, f)) {
      ++polygons;
      polygon_sides += mesh.face(f).size();
    }
  }
  output.polygon_offsets.reserve(polygons + 1);  // It starts with its 0.
  output.polygon_vertices.reserve(polygon_sides);
  std::size_t next_face = prediction.faces - polygons;
  for (std::uint32_t f = 0; polygons > 0 && f < mesh.face_count(); ++f) {
    if (stays_polygon(mesh, labels, f)) {
      output.face_levels[next_face] = 0;
      output.face_control_faces[next_face++] = f;
      const auto corners = mesh.face(f);
      output.polygon_vertices.insert(output.polygon_vertices.end(), corners.begin(), corners.end());
      output.polygon_offsets.push_back(static_cast<std::uint32_t>(output.polygon_vertices.size()));
    }
  }
  output.quads.resize(prediction.faces - polygons);
  return output;
}

template <class Sides>
void emit_quads(Sweep& sweep, const Sides& sides, const Level& level, const Step& step,
                RefinedMesh& output) {
  const auto here = static_cast<std::uint8_t>(level.number);
  const auto below = static_cast<std::uint8_t>(level.number + 1);
  sweep.each(level.face_count(), [&](std::size_t f) {
    const FaceCode code = step.codes[f];
    std::size_t at = step.first_quads[f];
    const auto emit = [&](const std::array<std::uint32_t, 4>& quad, std::uint8_t made_at) {
      output.quads[at] = quad;
      output.face_control_faces[at] = level.face_control_faces[f];
      output.face_levels[at] = made_at;
      ++at;
    };
    const FacePoints points(sides, level, step, f);
    const std::uint32_t n = sides.sides(f);
    const auto emit_child = [&](std::uint32_t side) {
      emit({points.vertex(side), points.edge(side), points.centre(), points.edge(side + n - 1)},
           below);
    };
    if (code == kFaceStays) {
      if (n == 4 && level.face_is_virtual[f] == 0) {
        emit({points.vertex(0), points.vertex(1), points.vertex(2), points.vertex(3)}, here);
      }
    } else if (code == kFaceSplits) {
      for (std::uint32_t side = 0; step.is_last && side < n; ++side) {
        emit_child(side);
      }
    } else {
      const std::uint32_t side = code - kFaceIsY;  // Of v1.
      if (step.is_last) {
        emit_child(side);
      }
      const std::uint32_t e5 = points.edge(side);
      const std::uint32_t e8 = points.edge(side + 3);
      const std::uint32_t v3 = points.vertex(side + 2);
      emit({e5, points.vertex(side + 1), v3, points.centre()}, below);
      emit({e8, points.centre(), v3, points.vertex(side + 3)}, below);
    }
  });
}

template void emit_quads(Sweep&, const QuadSides&, const Level&, const Step&, RefinedMesh&);
template void emit_quads(Sweep&, const PolygonSides&, const Level&, const Step&, RefinedMesh&);

}  // namespace limn
