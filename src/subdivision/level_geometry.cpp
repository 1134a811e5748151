// Uniform Catmull-Clark with the ring in centroid form, which holds for any face size: with e_i the
// neighbours of v, c_i the centroids of the n faces around it,
//   face point c,  edge point (a + b + c_left + c_right) / 4,
//   vertex point ((n - 2) / n) v + (sum e + sum c) / n^2;
// on boundaries the cubic B-spline (a + b) / 2 and (a + 6 v + b) / 8.
// Every point gathers what it needs, so no loop writes to another one's place.
#include "limn/contract.h"
#include "subdivision/step_geometry.h"

namespace limn {
namespace {

template <class Sides>
glm::dvec3 centroid_of_face(const Sides& sides, const Level& level, std::size_t f) {
  const std::uint32_t first = sides.first(f);
  const std::uint32_t n = sides.sides(f);
  glm::dvec3 sum(0.0);
  for (std::uint32_t i = 0; i < n; ++i) {
    sum += level.positions[level.corner_vertices[first + i]];
  }
  return sum / static_cast<double>(n);
}

template <class Sides>
glm::dvec3 vertex_point(const Sides& sides, const Level& level,
                        const FlatArray<glm::dvec3>& centroids, CornerRule corners,
                        std::uint32_t v) {
  const glm::dvec3& here = level.positions[v];
  const std::uint32_t start = level.vertex_corners[v];
  glm::dvec3 neighbours(0.0);
  glm::dvec3 faces(0.0);
  double n = 0.0;
  std::uint32_t corner = start;
  do {
    neighbours += level.positions[level.corner_vertices[sides.next(corner)]];
    faces += centroids[sides.face(corner)];
    n += 1.0;
    const std::uint32_t before = sides.previous(corner);
    const std::uint32_t across = level.twins[before];
    if (across == kBoundary) {
      if (n == 1.0 && corners == CornerRule::kSharp) {
        return here;
      }
      return (level.positions[level.corner_vertices[sides.next(start)]] + 6.0 * here +
              level.positions[level.corner_vertices[before]]) /
             8.0;
    }
    LIMN_EXPECTS(across != kMissing);
    corner = across;
  } while (corner != start);
  return ((n - 2.0) / n) * here + (neighbours + faces) / (n * n);
}

template <class Sides>
glm::dvec3 edge_point(const Sides& sides, const Level& level,
                      const FlatArray<glm::dvec3>& centroids, std::uint32_t corner) {
  const glm::dvec3 ends = level.positions[level.corner_vertices[corner]] +
                          level.positions[level.corner_vertices[sides.next(corner)]];
  const std::uint32_t twin = level.twins[corner];
  if (twin == kBoundary) {
    return 0.5 * ends;
  }
  LIMN_EXPECTS(twin != kMissing);
  return 0.25 * (ends + centroids[sides.face(corner)] + centroids[sides.face(twin)]);
}

/// Where the missing virtual point of this edge leads the finished quad to: v3, as last placed.
template <class Sides>
glm::dvec3 far_vertex(const Sides& sides, const Level& level, const Step& step, const Level& next,
                      std::uint32_t corner) {
  const auto leads_from = [&](std::uint32_t c) {
    const FaceCode code = step.codes[sides.face(c)];
    return code < kFaceIsY ? 0u : (sides.side(c) - (code - kFaceIsY)) & 3u;
  };
  std::uint32_t far = sides.next(corner);  // v2 v3 seen from its Y-element, or v4 v3 from beyond.
  if (leads_from(corner) == 2 ||
      (leads_from(corner) != 1 && leads_from(level.twins[corner]) == 1)) {
    far = corner;
  }
  const std::uint32_t v = level.corner_vertices[far];
  const std::uint32_t moved = step.vertex_points[v];
  return moved == kNone ? level.positions[v] : next.positions[moved];
}

}  // namespace

template <class Sides>
void place_points(Sweep& sweep, const Sides& sides, const Level& level, const Step& step,
                  const GeometryRules& rules, Level* next, RefinedMesh& output) {
  FlatArray<glm::dvec3> centroids(level.face_count());
  sweep.each(level.face_count(),
             [&](std::size_t f) { centroids[f] = centroid_of_face(sides, level, f); });

  const auto made_at = static_cast<std::uint8_t>(level.number + 1);
  const auto place = [&](std::uint32_t point, std::uint32_t vertex, const glm::dvec3& position) {
    if (next != nullptr) {
      next->positions[point] = position;
    }
    if (vertex != kNone) {
      output.positions[vertex] = glm::vec3(position);
      output.vertex_levels[vertex] = made_at;
    }
  };

  sweep.each(level.vertex_count(), [&](std::size_t v) {
    if (step.vertex_points[v] != kNone) {
      place(step.vertex_points[v], level.vertex_outputs[v],
            vertex_point(sides, level, centroids, rules.corners, static_cast<std::uint32_t>(v)));
    }
  });
  sweep.each(level.face_count(), [&](std::size_t f) {
    const std::uint32_t point = step.face_points[f];
    if (point != kNone) {
      place(point, step.output_of(point), centroids[f]);
    }
  });
  sweep.each(level.corner_count(), [&](std::size_t c) {
    const auto corner = static_cast<std::uint32_t>(c);
    const std::uint32_t point = step.edge_points[corner];
    if (point == kNone || !is_edge_owner(level, corner)) {
      return;
    }
    const std::uint32_t vertex = step.output_of(point);
    if (vertex != kNone) {
      place(point, vertex, edge_point(sides, level, centroids, corner));
    } else if (next != nullptr) {  // A virtual point: nobody reads it after the last step.
      place(point, vertex,
            rules.faults.drop_virtual_points ? far_vertex(sides, level, step, *next, corner)
                                             : edge_point(sides, level, centroids, corner));
    }
  });
}

template void place_points(Sweep&, const QuadSides&, const Level&, const Step&,
                           const GeometryRules&, Level*, RefinedMesh&);
template void place_points(Sweep&, const PolygonSides&, const Level&, const Step&,
                           const GeometryRules&, Level*, RefinedMesh&);

}  // namespace limn
