// Every child in closed form. The child at corner c of a face is (v e c' e~): its vertex, the point
// of the edge that leaves it, the face point, the point of the edge that arrives. With C(c) the
// child at corner c, next and previous around the face, and t = twin:
//
//   side 0, v -> e    lies opposite  C(next t(c)) side 3
//   side 1, e -> c'                  C(next c)    side 2
//   side 2, c' -> e~                 C(previous c) side 1
//   side 3, e~ -> v                  C(t(previous c)) side 0
//
// (compare Dupuy & Vanhoey 2021). A child that does not exist makes the side kMissing.
#include "limn/contract.h"
#include "subdivision/child_labels.h"
#include "subdivision/step.h"

namespace limn {
namespace {

std::uint32_t corner_or_missing(std::uint32_t child, std::uint32_t side) {
  return child == kNone ? kMissing : 4 * child + side;
}

/// The first corner counter-clockwise from `start` whose face leaves a child at the vertex.
template <class Sides>
std::uint32_t first_corner_with_child(const Sides& sides, const Level& level, const Step& step,
                                      std::uint32_t start) {
  std::uint32_t corner = start;
  while (child_at(sides, step, corner) == kNone) {
    const std::uint32_t across = level.twins[sides.previous(corner)];
    LIMN_ASSERT(across < kMissing && across != start);
    corner = across;
  }
  return corner;
}

template <class Sides>
void connect_children(const Sides& sides, const Level& level, const Step& step, std::size_t f,
                      Level& next) {
  const FaceCode code = step.codes[f];
  if (code == kFaceStays) {
    return;
  }
  const std::uint32_t first = sides.first(f);
  for (std::uint32_t i = 0; i < sides.sides(f); ++i) {
    const std::uint32_t corner = first + i;
    const std::uint32_t child = child_at(code, step.first_children[f], i);
    if (child == kNone) {
      continue;
    }
    const std::uint32_t before = sides.previous(corner);
    std::uint32_t* vertices = &next.corner_vertices[4 * std::size_t{child}];
    vertices[0] = step.vertex_points[level.corner_vertices[corner]];
    vertices[1] = step.edge_points[corner];
    vertices[2] = step.face_points[f];
    vertices[3] = step.edge_points[before];
    LIMN_ASSERT(vertices[0] != kNone && vertices[1] != kNone && vertices[3] != kNone);

    std::uint32_t* twins = &next.twins[4 * std::size_t{child}];
    const std::uint32_t leaving = level.twins[corner];
    const std::uint32_t arriving = level.twins[before];
    twins[0] = leaving >= kMissing
                   ? leaving
                   : corner_or_missing(child_at(sides, step, sides.next(leaving)), 3);
    twins[1] = corner_or_missing(child_at(sides, step, sides.next(corner)), 2);
    twins[2] = corner_or_missing(child_at(sides, step, before), 1);
    twins[3] =
        arriving >= kMissing ? arriving : corner_or_missing(child_at(sides, step, arriving), 0);

    next.face_control_faces[child] = level.face_control_faces[f];
    next.face_is_virtual[child] = code >= kFaceIsY && child != step.first_children[f] ? 1 : 0;
  }
}

template <class Sides>
std::uint8_t face_point_label(const Sides& sides, const Level& level, const Step& step,
                              std::size_t f) {
  std::uint8_t label = 0;
  if (step.codes[f] == kFaceSplits) {
    const std::uint32_t first = sides.first(f);
    for (std::uint32_t c = first; c < first + sides.sides(f); ++c) {
      label = least_positive(label,
                             edge_point_label(level.labels[level.corner_vertices[c]],
                                              level.labels[level.corner_vertices[sides.next(c)]]));
    }
  }
  return label;
}

}  // namespace

template <class Sides>
Level child_level(Sweep& sweep, const Sides& sides, const Level& level, const Step& step) {
  Level next;
  next.number = level.number + 1;
  const std::size_t corners = 4 * std::size_t{step.children};
  next.corner_vertices = FlatArray<std::uint32_t>(corners);
  next.twins = FlatArray<std::uint32_t>(corners);
  next.face_control_faces = FlatArray<std::uint32_t>(step.children);
  next.face_is_virtual = FlatArray<std::uint8_t>(step.children);
  next.positions = FlatArray<glm::dvec3>(step.points);
  next.labels = FlatArray<std::uint8_t>(step.points);
  next.vertex_outputs = FlatArray<std::uint32_t>(step.points);
  next.vertex_corners = FlatArray<std::uint32_t>(step.points);

  sweep.each(level.vertex_count(), [&](std::size_t v) {
    const std::uint32_t point = step.vertex_points[v];
    if (point == kNone) {
      return;
    }
    next.labels[point] = lowered(level.labels[v]);
    next.vertex_outputs[point] = level.vertex_outputs[v];
    const std::uint32_t corner =
        first_corner_with_child(sides, level, step, level.vertex_corners[v]);
    next.vertex_corners[point] = 4 * child_at(sides, step, corner);
  });

  sweep.each(level.face_count(), [&](std::size_t f) {
    connect_children(sides, level, step, f, next);
    const std::uint32_t point = step.face_points[f];
    if (point != kNone) {
      next.labels[point] = face_point_label(sides, level, step, f);
      next.vertex_outputs[point] = step.output_of(point);
      next.vertex_corners[point] = 4 * step.first_children[f] + 2;
    }
  });

  sweep.each(level.corner_count(), [&](std::size_t c) {
    const auto corner = static_cast<std::uint32_t>(c);
    const std::uint32_t point = step.edge_points[corner];
    if (point == kNone || !is_edge_owner(level, corner)) {
      return;
    }
    const std::uint32_t after = sides.next(corner);
    next.labels[point] = edge_point_label(level.labels[level.corner_vertices[corner]],
                                          level.labels[level.corner_vertices[after]]);
    next.vertex_outputs[point] = step.output_of(point);
    next.vertex_corners[point] =
        step.output_of(point) == kNone ? kNone : 4 * child_at(sides, step, after) + 3;
  });
  return next;
}

template Level child_level(Sweep&, const QuadSides&, const Level&, const Step&);
template Level child_level(Sweep&, const PolygonSides&, const Level&, const Step&);

}  // namespace limn
