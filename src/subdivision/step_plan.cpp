// Three numberings, each a parallel count, a short serial sum over blocks and a parallel
// assignment: faces (children, finished quads, face points), vertices that move, and edges that are
// split.
//
// A Y-element, positive at v1; e6 and e7 are virtual, as are the faces (v2 e6 c e5), (v4 e8 c e7):
//
//      v4 --- e7 - - v3          v4 -------- v3
//      |      :      |           |  \        |
//      e8 --- c - - e6    emits  e8 --- c    |     two finished quads (e5 v2 v3 c) (e8 c v3 v4)
//      |      |      |           |      | \  |     and the child (v1 e5 c e8)
//      v1 --- e5 --- v2          v1 --- e5 - v2
#include "limn/contract.h"
#include "subdivision/step.h"

namespace limn {
namespace {

template <class Sides>
FaceCode code_of_face(const Sides& sides, const Level& level, std::size_t f) {
  const std::uint32_t first = sides.first(f);
  const std::uint32_t n = sides.sides(f);
  if (n != 4) {
    bool any = false;
    bool all = true;
    for (std::uint32_t i = 0; i < n; ++i) {
      const bool is_positive = level.labels[level.corner_vertices[first + i]] > 0;
      any = any || is_positive;
      all = all && is_positive;
    }
    LIMN_EXPECTS(any == all);
    return any ? kFaceSplits : kFaceStays;
  }
  unsigned positive = 0;  // One bit a side.
  for (std::uint32_t i = 0; i < 4; ++i) {
    positive |= static_cast<unsigned>(level.labels[level.corner_vertices[first + i]] > 0) << i;
  }
  constexpr FaceCode kIllegal = 255;
  constexpr std::array<FaceCode, 16> kCodes{kFaceStays,   kFaceIsY,    kFaceIsY + 1, kIllegal,
                                            kFaceIsY + 2, kFaceSplits, kIllegal,     kFaceSplits,
                                            kFaceIsY + 3, kIllegal,    kFaceSplits,  kFaceSplits,
                                            kIllegal,     kFaceSplits, kFaceSplits,  kFaceSplits};
  const FaceCode code = kCodes[positive];
  LIMN_EXPECTS(code != kIllegal);
  LIMN_ASSERT(code == kFaceStays || level.face_is_virtual[f] == 0);
  return code;
}

/// A vertex moves when it is positive or shares an edge with a positive vertex.
template <class Sides>
bool is_moving(const Sides& sides, const Level& level, std::uint32_t v) {
  if (level.labels[v] > 0) {
    return true;
  }
  const std::uint32_t start = level.vertex_corners[v];
  if (start == kNone) {
    return false;
  }
  std::uint32_t corner = start;
  do {
    if (level.labels[level.corner_vertices[sides.next(corner)]] > 0) {
      return true;
    }
    const std::uint32_t before = sides.previous(corner);
    const std::uint32_t across = level.twins[before];
    if (across == kBoundary) {
      return level.labels[level.corner_vertices[before]] > 0;
    }
    if (across == kMissing) {
      return false;  // Only rings of vertices that have stopped are incomplete.
    }
    corner = across;
  } while (corner != start);
  return false;
}

template <class Sides>
bool has_positive_end(const Sides& sides, const Level& level, std::uint32_t corner) {
  return level.labels[level.corner_vertices[corner]] > 0 ||
         level.labels[level.corner_vertices[sides.next(corner)]] > 0;
}

/// Whether the corner's edge is v2 v3 or v3 v4 of a Y-element.
template <class Sides>
bool is_far_side(const Sides& sides, const Step& step, std::uint32_t corner) {
  const FaceCode code = step.codes[sides.face(corner)];
  return code >= kFaceIsY && ((sides.side(corner) - (code - kFaceIsY)) & 3u) % 3 != 0;
}

}  // namespace

template <class Sides>
Step plan_step(Sweep& sweep, const Sides& sides, const Level& level, std::uint32_t first_quad,
               std::uint32_t first_vertex, bool is_last) {
  Step step;
  step.is_last = is_last;
  step.first_output = first_vertex;

  const std::size_t faces = level.face_count();
  step.codes = FlatArray<FaceCode>(faces);
  sweep.each(faces, [&](std::size_t f) { step.codes[f] = code_of_face(sides, level, f); });

  const std::size_t vertices = level.vertex_count();
  step.vertex_points = FlatArray<std::uint32_t>(vertices);
  sweep.each(vertices, [&](std::size_t v) {
    step.vertex_points[v] = is_moving(sides, level, static_cast<std::uint32_t>(v)) ? 0 : kNone;
  });
  step.moved = sweep.number<1>(
      vertices,
      [&](std::size_t v) -> std::array<std::uint32_t, 1> {
        return {step.vertex_points[v] != kNone ? 1u : 0u};
      },
      [&](std::size_t v, const auto& first, const auto&) {
        if (step.vertex_points[v] != kNone) {
          step.vertex_points[v] = first[0];
        }
      })[0];

  // Children, finished quads, face points.
  step.first_children = FlatArray<std::uint32_t>(faces);
  step.first_quads = FlatArray<std::uint32_t>(faces);
  step.face_points = FlatArray<std::uint32_t>(faces);
  const auto face_totals = sweep.number<3>(
      faces,
      [&](std::size_t f) -> std::array<std::uint32_t, 3> {
        const FaceCode code = step.codes[f];
        const std::uint32_t n = sides.sides(f);
        if (code == kFaceStays) {
          return {0, n == 4 && level.face_is_virtual[f] == 0 ? 1u : 0u, 0};
        }
        if (code == kFaceSplits) {
          return {n, is_last ? n : 0, 1};
        }
        return {3, is_last ? 3u : 2u, 1};
      },
      [&](std::size_t f, const auto& first, const auto&) {
        step.first_children[f] = first[0];
        step.first_quads[f] = first_quad + first[1];
        step.face_points[f] = step.codes[f] == kFaceStays ? kNone : step.moved + first[2];
      });
  step.children = face_totals[0];
  step.quads = face_totals[1];

  // Emitted and virtual edge points.
  step.edge_points = FlatArray<std::uint32_t>(level.corner_count());
  const std::uint32_t first_edge_point = step.moved + face_totals[2];
  const auto kind_of_edge = [&](std::uint32_t corner) -> std::array<std::uint32_t, 2> {
    if (!is_edge_owner(level, corner)) {
      return {0, 0};
    }
    const std::uint32_t twin = level.twins[corner];
    if (has_positive_end(sides, level, corner)) {
      LIMN_ASSERT(twin != kMissing);
      return {1, 0};
    }
    const bool is_virtual =
        is_far_side(sides, step, corner) || (twin < kMissing && is_far_side(sides, step, twin));
    LIMN_ASSERT(!is_virtual || twin != kMissing);
    return {0, is_virtual ? 1u : 0u};
  };
  const auto edge_totals = sweep.number<2>(
      level.corner_count(),
      [&](std::size_t c) { return kind_of_edge(static_cast<std::uint32_t>(c)); },
      [&](std::size_t c, const auto& first, const auto& totals) {
        const auto corner = static_cast<std::uint32_t>(c);
        if (!is_edge_owner(level, corner)) {
          return;
        }
        const auto kind = kind_of_edge(corner);
        std::uint32_t point = kNone;
        if (kind[0] != 0) {
          point = first_edge_point + first[0];
        } else if (kind[1] != 0) {
          point = first_edge_point + totals[0] + first[1];
        }
        step.edge_points[corner] = point;
        if (level.twins[corner] < kMissing) {
          step.edge_points[level.twins[corner]] = point;
        }
      });
  step.emitted = first_edge_point + edge_totals[0];
  step.points = step.emitted + edge_totals[1];
  return step;
}

template Step plan_step(Sweep&, const QuadSides&, const Level&, std::uint32_t, std::uint32_t, bool);
template Step plan_step(Sweep&, const PolygonSides&, const Level&, std::uint32_t, std::uint32_t,
                        bool);

}  // namespace limn
