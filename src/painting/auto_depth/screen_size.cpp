// Every face, as the polygon of its corners on the limit surface, is cut by the view's frustum;
// what is left is measured on the screen and taken as a sample of the whole.
#include "limn/painting/auto_depth/screen_size.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "limn/contract.h"
#include "limn/subdivision/label_subdivision.h"
#include "painting/auto_depth/first_step.h"

namespace limn {
namespace {

/// Where the surface is seen at less than some 10 degrees, it turns away.
constexpr double kEdgeOnCosine = 0.17;
/// Part of a face's area that shows at least, if it does: less is rounding.
constexpr double kLeastShare = 1e-12;
/// Nearer to the eye nothing has a size.
constexpr double kLeastViewDepth = 1e-12;

/// The limit surface at the control vertices.
struct LimitCorners {
  std::vector<glm::dvec3> points;
  std::vector<glm::dvec3> normals;
};

Result<LimitCorners> limit_corners(const ControlMesh& mesh, CornerRule corners,
                                   Progress& progress) {
  SubdivisionSettings settings;
  settings.corners = corners;
  settings.points = SurfacePoints::kLimit;
  RefineLimits limits;
  limits.normals = true;
  const Result<RefinedMesh> refined =
      refine(mesh, VertexLabels(mesh.vertex_count(), 0), settings, limits, progress);
  if (!refined) {
    return tl::unexpected(refined.error());
  }
  LimitCorners result;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    result.points.push_back(refined->position(v));
    result.normals.emplace_back(refined->normals[v]);
  }
  return result;
}

/// A point in eye space: x to the right, y up, z the distance in front of the eye.
using EyePoint = glm::dvec3;
using EyePolygon = std::vector<EyePoint>;

/// A frustum as half-spaces, and what projects onto its picture.
class Frustum {
 public:
  explicit Frustum(const ScreenView& view) : view_(&view) {
    const double half_width = view.half_height * view.width / view.height;
    const double near_plane =
        view.is_orthographic ? view.near_plane : std::max(view.near_plane, kLeastViewDepth);
    const auto side = [&](const glm::dvec3& inwards, double half) {
      return view.is_orthographic ? Plane{inwards, half}
                                  : Plane{inwards + glm::dvec3(0.0, 0.0, half), 0.0};
    };
    planes_ = {Plane{{0.0, 0.0, 1.0}, -near_plane}, side({1.0, 0.0, 0.0}, half_width),
               side({-1.0, 0.0, 0.0}, half_width), side({0.0, 1.0, 0.0}, view.half_height),
               side({0.0, -1.0, 0.0}, view.half_height)};
  }

  [[nodiscard]] EyePoint to_eye(const glm::dvec3& p) const noexcept {
    const glm::dvec3 offset = p - view_->eye;
    return {glm::dot(offset, view_->right), glm::dot(offset, view_->up),
            -glm::dot(offset, view_->back)};
  }
  /// In pixels from the picture's middle; the point is in front of the near plane.
  [[nodiscard]] glm::dvec2 to_screen(const EyePoint& p) const noexcept {
    return glm::dvec2(p.x, p.y) / pixel_length(p.z);
  }
  [[nodiscard]] double pixel_length(double view_depth) const noexcept {
    const double scale = view_->is_orthographic ? 1.0 : std::max(view_depth, kLeastViewDepth);
    return 2.0 * view_->half_height * scale / view_->height;
  }
  /// Towards the eye from a point of the world.
  [[nodiscard]] glm::dvec3 towards_eye(const glm::dvec3& p) const {
    const glm::dvec3 direction = view_->is_orthographic ? view_->back : view_->eye - p;
    const double length = glm::length(direction);
    return length > 0.0 ? direction / length : view_->back;
  }
  /// What is inside, in place; `room` is scratch.
  void cut(EyePolygon& polygon, EyePolygon& room) const {
    for (const Plane& plane : planes_) {
      room.clear();
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const EyePoint& here = polygon[i];
        const EyePoint& next = polygon[i + 1 == polygon.size() ? 0 : i + 1];
        const double at_here = plane.at(here);
        const double at_next = plane.at(next);
        if (at_here >= 0.0) {
          room.push_back(here);
        }
        if ((at_here >= 0.0) != (at_next >= 0.0)) {
          room.push_back(here + (next - here) * (at_here / (at_here - at_next)));
        }
      }
      std::swap(polygon, room);
    }
  }
  /// The part of a segment that is inside, as parameters; empty where first > second.
  [[nodiscard]] std::pair<double, double> cut(const EyePoint& a, const EyePoint& b) const {
    double from = 0.0;
    double to = 1.0;
    for (const Plane& plane : planes_) {
      const double at_a = plane.at(a);
      const double at_b = plane.at(b);
      if (at_a < 0.0 && at_b < 0.0) {
        return {1.0, 0.0};
      }
      if (at_a < 0.0) {
        from = std::max(from, at_a / (at_a - at_b));
      } else if (at_b < 0.0) {
        to = std::min(to, at_a / (at_a - at_b));
      }
    }
    return {from, to};
  }

 private:
  struct Plane {
    glm::dvec3 normal{0.0};
    double offset = 0.0;
    [[nodiscard]] double at(const EyePoint& p) const noexcept {
      return glm::dot(normal, p) + offset;
    }
  };

  const ScreenView* view_;
  std::array<Plane, 5> planes_;
};

double area_of_polygon(const EyePolygon& polygon) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    sum += glm::cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  }
  return 0.5 * glm::length(sum);
}

double area_on_screen(const Frustum& frustum, const EyePolygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = frustum.to_screen(polygon[i]);
    const glm::dvec2 b = frustum.to_screen(polygon[i + 1 == polygon.size() ? 0 : i + 1]);
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * std::abs(twice);
}

/// How a face shows.
struct Seen {
  double edge = 0.0;  ///< Longest side in pixels.
  double area = 0.0;  ///< In square pixels.
  double pixel_length = std::numeric_limits<double>::infinity();
  bool is_silhouette = false;
};

class Looker {
 public:
  Looker(const ControlMesh& mesh, const LimitCorners& corners, const ScreenView& view)
      : mesh_(&mesh), corners_(&corners), frustum_(view) {}

  void look(std::size_t f, Seen& seen) {
    const auto face = mesh_->face(f);
    const Facing facing = facing_of(face);
    if (facing == Facing::kAway && mesh_->is_closed()) {
      return;
    }
    whole_.clear();
    for (const std::uint32_t v : face) {
      whole_.push_back(frustum_.to_eye(corners_->points[v]));
    }
    inside_ = whole_;
    frustum_.cut(inside_, room_);
    const double whole_area = area_of_polygon(whole_);
    const double inside_area = area_of_polygon(inside_);
    // What only touches the frustum does not show; a face without area may have sides that do.
    if (inside_.size() < 3 || (whole_area > 0.0 && inside_area <= kLeastShare * whole_area)) {
      return;
    }
    seen.is_silhouette = seen.is_silhouette || facing == Facing::kEdgeOn;
    double nearest = std::numeric_limits<double>::infinity();
    for (const EyePoint& p : inside_) {
      nearest = std::min(nearest, p.z);
    }
    const double pixel = frustum_.pixel_length(nearest);
    seen.pixel_length = std::min(seen.pixel_length, pixel);
    if (inside_area > 0.0) {
      seen.area =
          std::max(seen.area, area_on_screen(frustum_, inside_) * (whole_area / inside_area));
    }
    seen.edge = std::max(seen.edge, longest_side(pixel));
  }

 private:
  enum class Facing { kTowards, kEdgeOn, kAway };

  [[nodiscard]] Facing facing_of(std::span<const std::uint32_t> face) const {
    double least = 1.0;
    double greatest = -1.0;
    for (const std::uint32_t v : face) {
      const double cosine =
          glm::dot(corners_->normals[v], frustum_.towards_eye(corners_->points[v]));
      least = std::min(least, cosine);
      greatest = std::max(greatest, cosine);
    }
    return greatest < 0.0          ? Facing::kAway
           : least < kEdgeOnCosine ? Facing::kEdgeOn
                                   : Facing::kTowards;
  }

  /// Sides of which a part shows count as if all of them did; `pixel` is for a face that fills the
  /// picture and has its sides outside.
  [[nodiscard]] double longest_side(double pixel) const {
    double longest = 0.0;
    double in_space = 0.0;
    for (std::size_t i = 0; i < whole_.size(); ++i) {
      const EyePoint& a = whole_[i];
      const EyePoint& b = whole_[i + 1 == whole_.size() ? 0 : i + 1];
      in_space = std::max(in_space, glm::distance(a, b));
      if (const auto [from, to] = frustum_.cut(a, b); from < to) {
        const double length = glm::distance(frustum_.to_screen(a + (b - a) * from),
                                            frustum_.to_screen(a + (b - a) * to));
        longest = std::max(longest, length / (to - from));
      }
    }
    return longest > 0.0 ? longest : in_space / pixel;
  }

  const ControlMesh* mesh_;
  const LimitCorners* corners_;
  Frustum frustum_;
  EyePolygon whole_;
  EyePolygon inside_;
  EyePolygon room_;
};

Result<std::vector<Seen>> look_at_all(const ControlMesh& mesh, CornerRule corner_rule,
                                      std::span<const ScreenView> views, Progress& progress) {
  const Result<LimitCorners> corners = limit_corners(mesh, corner_rule, progress);
  if (!corners) {
    return tl::unexpected(corners.error());
  }
  std::vector<Seen> seen(mesh.face_count());
  for (const ScreenView& view : views) {
    LIMN_EXPECTS(view.width > 0.0 && view.height > 0.0 && view.half_height > 0.0);
    Looker looker(mesh, *corners, view);
    for (std::size_t f = 0; f < seen.size(); ++f) {
      looker.look(f, seen[f]);
    }
  }
  return seen;
}

double size_of(const Seen& seen, ScreenSize::Of of) {
  return of == ScreenSize::Of::kEdge ? seen.edge : seen.area;
}

}  // namespace

Result<std::vector<double>> screen_sizes(const ControlMesh& mesh, CornerRule corners,
                                         ScreenSize::Of of, std::span<const ScreenView> views,
                                         Progress& progress) {
  const Result<std::vector<Seen>> seen = look_at_all(mesh, corners, views, progress);
  if (!seen) {
    return tl::unexpected(seen.error());
  }
  std::vector<double> sizes(seen->size());
  std::ranges::transform(*seen, sizes.begin(),
                         [of](const Seen& face) { return size_of(face, of); });
  return sizes;
}

Result<std::vector<double>> pixel_lengths(const ControlMesh& mesh, CornerRule corners,
                                          std::span<const ScreenView> views, Progress& progress) {
  const Result<std::vector<Seen>> seen = look_at_all(mesh, corners, views, progress);
  if (!seen) {
    return tl::unexpected(seen.error());
  }
  std::vector<double> lengths(seen->size());
  std::ranges::transform(*seen, lengths.begin(), &Seen::pixel_length);
  return lengths;
}

Result<FaceDepths> depths_for_screen(const ControlMesh& mesh, const SubdivisionSettings& settings,
                                     const ScreenSize& size, std::span<const ScreenView> views,
                                     Progress& progress) {
  LIMN_EXPECTS(size.pixels > 0.0);
  const Result<std::vector<Seen>> seen = look_at_all(mesh, settings.corners, views, progress);
  if (!seen) {
    return tl::unexpected(seen.error());
  }
  const int first_step = first_step_levels(mesh, settings);
  FaceDepths depths(mesh.face_count());
  for (std::size_t f = 0; f < seen->size(); ++f) {
    double ratio = size_of((*seen)[f], size.of) / size.pixels;
    const double smaller_by = size.of == ScreenSize::Of::kEdge ? 2.0 : 4.0;
    int level = 0;
    for (; ratio > 1.0 && level < kMaxDepth + first_step; ratio /= smaller_by) {
      ++level;
    }
    if (level > 0 && (*seen)[f].is_silhouette) {
      level += size.silhouettes;
    }
    depths.set(f, std::clamp(level - first_step, 0, kMaxDepth));
  }
  return depths;
}

}  // namespace limn
