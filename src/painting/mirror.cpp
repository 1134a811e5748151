// Centroids are sorted into the cells of a grid by counting: as many buckets as faces, each cell's
// bucket by a hash of its place. A cell is at least as wide as twice the tolerance, so what lies
// within it of a point is in the cells of the (at most eight) corners of a box around the point.
#include "limn/painting/mirror.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "limn/contract.h"

namespace limn {
namespace {

std::vector<glm::dvec3> face_centroids(const ControlMesh& mesh) {
  std::vector<glm::dvec3> centroids(mesh.face_count());
  const glm::dvec3 origin = mesh.bounds().centre();
  for (std::size_t f = 0; f < centroids.size(); ++f) {
    glm::dvec3 sum(0.0);
    for (const std::uint32_t vertex : mesh.face(f)) {
      sum += mesh.positions()[vertex] - origin;
    }
    centroids[f] = sum / static_cast<double>(mesh.face(f).size());
  }
  return centroids;
}

using Cell = std::array<std::int64_t, 3>;

/// Points by the cell of a grid they lie in.
class PointGrid {
 public:
  /// `pitch` is positive.
  PointGrid(std::span<const glm::dvec3> points, double pitch)
      : pitch_(pitch),
        mask_(static_cast<std::uint32_t>(std::bit_ceil(points.size() + 1) - 1)),
        offsets_(mask_ + 2, 0),
        members_(points.size()) {
    std::vector<std::uint32_t> buckets(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      buckets[i] = bucket(cell_of(points[i]));
      ++offsets_[buckets[i] + 1];
    }
    for (std::size_t b = 1; b < offsets_.size(); ++b) {
      offsets_[b] += offsets_[b - 1];
    }
    std::vector<std::uint32_t> next(offsets_.begin(), offsets_.end() - 1);
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      members_[next[buckets[i]]++] = i;
    }
  }

  /// Calls `look_at` with every point that lies within `reach` (at most half the pitch) of a place,
  /// and some others; with some more than once.
  template <class LookAt>
  void around(const glm::dvec3& place, double reach, LookAt&& look_at) const {
    const Cell low = cell_of(place - reach);
    const Cell high = cell_of(place + reach);
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        for (std::int64_t z = low[2]; z <= high[2]; ++z) {
          const std::uint32_t b = bucket({x, y, z});
          for (std::uint32_t i = offsets_[b]; i < offsets_[b + 1]; ++i) {
            look_at(members_[i]);
          }
        }
      }
    }
  }

 private:
  [[nodiscard]] Cell cell_of(const glm::dvec3& point) const {
    return {std::llround(std::floor(point.x / pitch_)), std::llround(std::floor(point.y / pitch_)),
            std::llround(std::floor(point.z / pitch_))};
  }
  [[nodiscard]] std::uint32_t bucket(const Cell& cell) const {
    std::uint64_t hash = 0x9E3779B97F4A7C15ULL;
    for (const std::int64_t part : cell) {
      hash = (hash ^ static_cast<std::uint64_t>(part)) * 0xBF58476D1CE4E5B9ULL;
      hash ^= hash >> 29U;
    }
    return static_cast<std::uint32_t>(hash >> 7U) & mask_;
  }

  double pitch_;
  std::uint32_t mask_;
  std::vector<std::uint32_t> offsets_;
  std::vector<std::uint32_t> members_;
};

/// Bit 0, 1, 2 for X, Y, Z.
unsigned bits_of(const MirrorAxes& axes) {
  return (axes.x ? 1U : 0U) | (axes.y ? 2U : 0U) | (axes.z ? 4U : 0U);
}

/// What all combinations of axes are looked up in.
struct Centroids {
  Centroids(const ControlMesh& mesh, double tolerance)
      : points(face_centroids(mesh)),
        reach(tolerance * mesh.bounds().diagonal()),
        // Not so fine that the cells outnumber the faces by far, and never 0.
        grid(points, std::max({2.0 * reach,
                               mesh.bounds().diagonal() /
                                   std::sqrt(static_cast<double>(points.size()) + 1.0),
                               std::numeric_limits<double>::min()})) {}

  [[nodiscard]] std::vector<std::uint32_t> partners(const ControlMesh& mesh, unsigned axes) const {
    const glm::dvec3 sign((axes & 1U) != 0 ? -1.0 : 1.0, (axes & 2U) != 0 ? -1.0 : 1.0,
                          (axes & 4U) != 0 ? -1.0 : 1.0);
    std::vector<std::uint32_t> found(points.size(), kNone);
    if (!std::isfinite(reach)) {
      return found;  // Coordinates at the end of what a double holds.
    }
    for (std::size_t f = 0; f < points.size(); ++f) {
      const glm::dvec3 image = sign * points[f];
      double nearest = reach;
      grid.around(image, reach, [&](std::uint32_t other) {
        const double away = glm::distance(points[other], image);
        const bool is_nearer = away < nearest || (away == nearest && other < found[f]);
        if (is_nearer && mesh.face(other).size() == mesh.face(f).size()) {
          nearest = away;
          found[f] = other;
        }
      });
    }
    return found;
  }

  std::vector<glm::dvec3> points;
  double reach;
  PointGrid grid;
};

}  // namespace

std::string to_string(const MirrorAxes& axes) {
  return std::string(axes.x ? "x" : "") + (axes.y ? "y" : "") + (axes.z ? "z" : "");
}

std::vector<std::uint32_t> mirror_partners(const ControlMesh& mesh, const MirrorAxes& axes,
                                           double tolerance) {
  return Centroids(mesh, tolerance).partners(mesh, bits_of(axes));
}

FaceMirror::FaceMirror(const ControlMesh& mesh, const MirrorAxes& axes, double tolerance)
    : axes_(axes) {
  if (!axes.any()) {
    return;
  }
  const Centroids centroids(mesh, tolerance);
  const unsigned all = bits_of(axes);
  for (unsigned some = 1; some <= all; ++some) {
    if ((some & ~all) == 0) {
      partners_.push_back(centroids.partners(mesh, some));
    }
  }
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    lone_faces_ += std::ranges::any_of(
        partners_, [f](const std::vector<std::uint32_t>& table) { return table[f] == kNone; });
  }
}

std::vector<std::uint32_t> FaceMirror::with_images(std::span<const std::uint32_t> faces) const {
  std::vector<std::uint32_t> all(faces.begin(), faces.end());
  if (partners_.empty()) {
    return all;
  }
  // A sorted copy of what was asked for tells what is new without an array over the whole mesh.
  std::vector<std::uint32_t> images;
  images.reserve(faces.size() * partners_.size());
  for (const auto& table : partners_) {
    for (const std::uint32_t face : faces) {
      LIMN_EXPECTS(face < table.size());
      if (table[face] != kNone) {
        images.push_back(table[face]);
      }
    }
  }
  std::ranges::sort(images);
  images.erase(std::unique(images.begin(), images.end()), images.end());
  std::vector<std::uint32_t> asked(faces.begin(), faces.end());
  std::ranges::sort(asked);
  std::ranges::set_difference(images, asked, std::back_inserter(all));
  return all;
}

FaceDepths mirror_depths(const FaceMirror& mirror, const FaceDepths& depths) {
  FaceDepths result = depths;
  for (const auto& table : mirror.partners()) {
    LIMN_EXPECTS(table.size() == depths.size());
    for (std::size_t f = 0; f < table.size(); ++f) {
      if (table[f] != kNone) {
        result.set(f, std::max(result[f], depths[table[f]]));
      }
    }
  }
  return result;
}

}  // namespace limn
