// Two numberings (how many points each ring needs, then where they start) and two loops that run a
// VertexRing down the levels: around vertices first, whose edge points the faces' rings begin with.
#include "subdivision/ring_tables.h"

#include <algorithm>

#include "subdivision/ring_seed.h"

namespace limn {
namespace {

/// The points of one level; returns where the next one's go.
Point* keep(VertexRing& ring, Point* at) {
  *at++ = ring.centre();
  return std::ranges::copy(ring.edges(), at).out;
}

/// The ring's limit, before its points.
void keep_limit(VertexRing& ring, const Cage& cage, Point* points) {
  ring.step_until_worn(cage.creases->method, cage.corners);
  const LimitPoint limit = ring.limit(cage.creases->method, cage.corners);
  points[-2] = to_point(limit.position);
  points[-1] = to_point(limit.normal);
}

/// One per thread, so that rings cost no allocation.
VertexRing& ring_of_this_thread() {
  thread_local VertexRing ring;
  return ring;
}

}  // namespace

bool is_irregular(const Cage& cage, std::uint32_t v, const Fan& fan) {
  if (fan.corners.size() != (fan.is_boundary ? 2u : 4u) || cage.vertex_sharpness(v) > 0.0f ||
      (fan.is_boundary && cage.averaging == Averaging::kPinned)) {
    return true;
  }
  if (cage.is_all_quads && cage.creases->edge_sharpness.empty()) {
    return false;
  }
  for (const std::uint32_t corner : fan.corners) {
    if (cage.side_count(cage.face_of(corner)) != 4 ||
        (cage.topology->corner_twins[corner] != kNone &&
         cage.edge_sharpness(cage.topology->corner_edges[corner]) > 0.0f)) {
      return true;
    }
  }
  return false;
}

void RingTables::seed(const Cage& cage, std::uint32_t v, VertexRing& ring) const {
  const FlatTopology& topology = *cage.topology;
  const Fan fan = fan_of(cage, v);
  seed_sharpness(ring, cage, v);
  ring.centre() = cage.point(v);
  for (std::size_t i = 0; i < fan.corners.size(); ++i) {
    const std::uint32_t corner = fan.corners[i];
    ring.edges()[i] = cage.point(topology.corner_vertices[cage.next(corner)]);
    ring.centroids()[i] = centroid(cage, cage.face_of(corner));
  }
  if (fan.is_boundary) {
    ring.edges().back() = cage.point(topology.corner_vertices[cage.previous(fan.corners.back())]);
  }
}

void RingTables::build(Sweep& sweep, const Cage& cage, std::span<const std::uint8_t> greatest,
                       bool with_limits) {
  has_limits_ = with_limits;
  build_centroids(sweep, cage, greatest);
  rows_.build(cage);
  list_vertices(cage);
  sweep.each(vertices_.size(), [&](std::size_t i) {
    std::uint8_t levels = 0;
    for (const std::uint32_t corner : corners_around(cage, vertices_[i])) {
      levels = std::max(levels, greatest[cage.face_of(corner)]);
    }
    vertex_levels_[vertices_[i]] = levels;
  });
  number_points(sweep, cage);
  sweep.each(vertices_.size(), [&](std::size_t i) { run_vertex(cage, vertices_[i]); });
  sweep.each(face_levels_.size(),
             [&](std::size_t f) { run_face(cage, static_cast<std::uint32_t>(f)); });
}

/// All irregular vertices, whether anything around them is refined or not.
void RingTables::list_vertices(const Cage& cage) {
  vertex_levels_.resize(cage.vertex_count());
  vertex_firsts_.clear();
  vertex_firsts_.resize(cage.vertex_count(), kNone);
  vertices_.clear();
  const auto add = [this](std::uint32_t v) {
    if (vertex_firsts_[v] == kNone) {
      vertex_firsts_[v] = 0;  // Listed; its number comes later.
      vertices_.push_back(v);
    }
  };
  const FlatTopology& topology = *cage.topology;
  std::ranges::for_each(topology.irregular_vertices, add);
  const bool has_sharp_edges = !cage.creases->edge_sharpness.empty();
  for (std::uint32_t e = 0; (has_sharp_edges || cage.averaging == Averaging::kPinned) &&
                            e < topology.edge_corners.size();
       ++e) {
    const bool is_boundary = topology.edge_corners[e][1] == kNone;
    if (is_boundary ? cage.averaging == Averaging::kPinned : cage.edge_sharpness(e) > 0.0f) {
      std::ranges::for_each(topology.edge_vertices[e], add);
    }
  }
  for (std::uint32_t v = 0; v < cage.creases->vertex_sharpness.size(); ++v) {
    if (cage.vertex_sharpness(v) > 0.0f) {
      add(v);
    }
  }
}

void RingTables::build_centroids(Sweep& sweep, const Cage& cage,
                                 std::span<const std::uint8_t> greatest) {
  const std::size_t polygons = cage.is_all_quads ? 0 : cage.face_count();
  face_levels_.resize(polygons);
  centroids_.resize(polygons);
  sweep.each(polygons, [&](std::size_t i) {
    const auto f = static_cast<std::uint32_t>(i);
    face_levels_[f] = 0;
    if (cage.side_count(f) != 4) {
      face_levels_[f] = greatest[f];
      centroids_[f] = cage.centroid(f);
    }
  });
}

/// Where each ring's points start.
void RingTables::number_points(Sweep& sweep, const Cage& cage) {
  using Sizes = std::array<std::uint64_t, 1>;
  const std::uint32_t limits = has_limits_ ? 2 : 0;
  const auto of_ring = [limits](std::uint8_t levels, std::size_t edges) {
    return Sizes{levels == 0 ? 0 : levels * (edges + std::uint64_t{1}) + limits};
  };
  const auto vertex_points = [&](std::size_t i) {
    const std::uint32_t v = vertices_[i];
    const Fan fan = fan_of(cage, v);
    return of_ring(vertex_levels_[v], fan.corners.size() + (fan.is_boundary ? 1 : 0));
  };
  const auto face_points = [&](std::size_t f) {
    return of_ring(face_levels_[f], cage.side_count(f));
  };
  face_firsts_.resize(face_levels_.size());
  Sizes next{0};
  next = sweep.number(vertices_.size(), next, vertex_points, [&](std::size_t i, Sizes first) {
    const std::uint32_t v = vertices_[i];
    vertex_firsts_[v] =
        vertex_levels_[v] == 0 ? kNone : static_cast<std::uint32_t>(first[0]) + limits;
    return vertex_points(i);
  });
  next = sweep.number(face_levels_.size(), next, face_points, [&](std::size_t f, Sizes first) {
    face_firsts_[f] = face_levels_[f] == 0 ? kNone : static_cast<std::uint32_t>(first[0]) + limits;
    return face_points(f);
  });
  points_.resize(next[0]);
}

void RingTables::run_vertex(const Cage& cage, std::uint32_t v) {
  if (vertex_levels_[v] == 0) {
    return;
  }
  VertexRing& ring = ring_of_this_thread();
  seed(cage, v, ring);
  Point* const points = points_.data() + vertex_firsts_[v];
  Point* at = points;
  for (int level = 1; level <= vertex_levels_[v]; ++level) {
    ring.step(cage.creases->method, cage.corners);
    at = keep(ring, at);
  }
  if (has_limits_) {
    keep_limit(ring, cage, points);
  }
}

/// Seen from its centre, the face's quad at corner i + 1 lies between the points on sides i and
/// i + 1.
void RingTables::run_face(const Cage& cage, std::uint32_t f) {
  if (face_levels_[f] == 0) {
    return;
  }
  VertexRing& ring = ring_of_this_thread();
  const std::uint32_t n = cage.side_count(f);
  const std::uint32_t first = cage.first_corner(f);
  const auto ring_at = [&](std::uint32_t corner) {
    return of_vertex(cage, cage.topology->corner_vertices[corner]);
  };
  ring.reset(n, false);
  ring.centre() = centroids_[f];
  for (std::uint32_t side = 0; side < n; ++side) {
    ring.edges()[side] = ring_at(first + side).edge(1, cage.topology->corner_ranks[first + side]);
  }
  for (std::uint32_t side = 0; side < n; ++side) {
    const std::uint32_t after = side + 1 == n ? 0 : side + 1;
    ring.centroids()[side] = (ring.centre() + ring.edges()[side] + ring.edges()[after] +
                              ring_at(first + after).centre(1)) *
                             0.25;
  }
  Point* const points = points_.data() + face_firsts_[f];
  Point* at = keep(ring, points);
  for (int level = 2; level <= face_levels_[f]; ++level) {
    ring.step(cage.creases->method, cage.corners);
    at = keep(ring, at);
  }
  if (has_limits_) {
    keep_limit(ring, cage, points);
  }
}

RingView RingTables::of_vertex(const Cage& cage, std::uint32_t v) const noexcept {
  if (vertex_firsts_[v] == kNone) {
    return {};
  }
  const Fan fan = fan_of(cage, v);
  return {points_.data() + vertex_firsts_[v], fan.corners.size() + (fan.is_boundary ? 1 : 0), 1,
          vertex_levels_[v]};
}

RingView RingTables::of_face(const Cage& cage, std::uint32_t f) const noexcept {
  return {points_.data() + face_firsts_[f], cage.side_count(f), 1, face_levels_[f]};
}

}  // namespace limn
