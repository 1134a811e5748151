#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "limn/mesh/control_mesh.h"
#include "limn/subdivision/settings.h"
#include "subdivision/point.h"

// What is subdivided. Internal to this folder.
namespace limn {

/// How points are averaged.
enum class Averaging {
  kSmooth,    ///< Catmull-Clark; boundaries are cubic B-splines.
  kPinned,    ///< Catmull-Clark inside; boundaries stay where they are, edge by edge.
  kBilinear,  ///< Faces stay bilinear: midpoints and centroids.
};

/// A mesh of connectivity and points: the control mesh, or its texture coordinates with seams for
/// boundaries. Faces and corners are the control mesh's in both.
struct Cage {
  const FlatTopology* topology = nullptr;
  std::span<const glm::dvec3> positions;  ///< One per vertex of the topology.
  glm::dvec3 origin{0.0};                 ///< Points are relative to it.
  const Creases* creases = nullptr;       ///< For its edges and vertices.
  Averaging averaging = Averaging::kSmooth;
  CornerRule corners = CornerRule::kSharp;
  bool is_all_quads = false;

  [[nodiscard]] std::size_t face_count() const noexcept {
    return topology->face_offsets.size() - 1;
  }
  [[nodiscard]] std::size_t vertex_count() const noexcept { return positions.size(); }
  /// By halves, of which a register holds one on any processor: put together as a Point they would
  /// go through memory and be waited for.
  void load_point(std::size_t v, Point& to) const noexcept {
    using Half [[gnu::vector_size(16)]] = double;
    const glm::dvec3& from = positions[v];
    const Half low = Half{from.x, from.y} - Half{origin.x, origin.y};
    const Half high = Half{from.z, 0.0} - Half{origin.z, 0.0};
    std::memcpy(&to, &low, sizeof low);
    std::memcpy(reinterpret_cast<std::byte*>(&to) + sizeof low, &high, sizeof high);
  }
  [[nodiscard]] Point point(std::size_t v) const noexcept {
    Point point;
    load_point(v, point);
    return point;
  }
  [[nodiscard]] float edge_sharpness(std::size_t e) const noexcept {
    return creases->edge_sharpness.empty() ? 0.0f : creases->edge_sharpness[e];
  }
  [[nodiscard]] float vertex_sharpness(std::size_t v) const noexcept {
    return creases->vertex_sharpness.empty() ? 0.0f : creases->vertex_sharpness[v];
  }

  /// How corners go around faces.
  [[nodiscard]] std::uint32_t first_corner(std::size_t f) const noexcept {
    return is_all_quads ? static_cast<std::uint32_t>(4 * f) : topology->face_offsets[f];
  }
  [[nodiscard]] std::uint32_t side_count(std::size_t f) const noexcept {
    return is_all_quads ? 4 : topology->face_offsets[f + 1] - topology->face_offsets[f];
  }
  [[nodiscard]] std::uint32_t face_of(std::uint32_t corner) const noexcept {
    return is_all_quads ? corner / 4 : topology->corner_faces[corner];
  }
  [[nodiscard]] std::uint32_t next(std::uint32_t corner) const noexcept {
    if (is_all_quads) {
      return (corner & ~3u) | ((corner + 1) & 3u);
    }
    const std::uint32_t f = topology->corner_faces[corner];
    return corner + 1 == topology->face_offsets[f + 1] ? topology->face_offsets[f] : corner + 1;
  }
  [[nodiscard]] std::uint32_t previous(std::uint32_t corner) const noexcept {
    if (is_all_quads) {
      return (corner & ~3u) | ((corner + 3) & 3u);
    }
    const std::uint32_t f = topology->corner_faces[corner];
    return corner == topology->face_offsets[f] ? topology->face_offsets[f + 1] - 1 : corner - 1;
  }
  /// The corner on the other side of a corner's edge; kNone on a boundary.
  [[nodiscard]] std::uint32_t twin(std::uint32_t corner) const noexcept {
    return topology->corner_twins[corner];
  }
  /// Whether a corner is the first of its edge.
  [[nodiscard]] bool is_first(std::uint32_t corner) const noexcept { return corner < twin(corner); }
  [[nodiscard]] Point centroid(std::size_t f) const noexcept {
    Point sum{};
    const std::uint32_t first = first_corner(f);
    const std::uint32_t n = side_count(f);
    for (std::uint32_t i = 0; i < n; ++i) {
      sum += point(topology->corner_vertices[first + i]);
    }
    return sum / static_cast<double>(n);
  }
};

/// The faces around a vertex, as corners of it, counter-clockwise.
struct Fan {
  std::span<const std::uint32_t> corners;
  bool is_boundary = false;

  /// The corner `steps` further around, kNone beyond a boundary.
  [[nodiscard]] std::uint32_t at(std::size_t rank, int steps) const noexcept {
    const auto n = static_cast<std::ptrdiff_t>(corners.size());
    const std::ptrdiff_t i = static_cast<std::ptrdiff_t>(rank) + steps;
    if (i >= 0 && i < n) {
      return corners[static_cast<std::size_t>(i)];
    }
    return is_boundary ? kNone : corners[static_cast<std::size_t>((i % n + n) % n)];
  }
};

[[nodiscard]] inline std::span<const std::uint32_t> corners_around(const Cage& cage,
                                                                   std::uint32_t v) noexcept {
  const FlatTopology& topology = *cage.topology;
  const std::uint32_t first = topology.vertex_offsets[v];
  return {topology.vertex_corners.data() + first, topology.vertex_offsets[v + 1] - first};
}

[[nodiscard]] inline Fan fan_of(const Cage& cage, std::uint32_t v) noexcept {
  const std::span<const std::uint32_t> corners = corners_around(cage, v);
  return {corners, cage.topology->corner_twins[corners[0]] == kNone};
}

}  // namespace limn
