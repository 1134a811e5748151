// Boxes first, polygons where the boxes overlap. A face with a vertex before the near plane is cut
// there, in world coordinates, since depth is linear in them; that is done when it is asked about.
#include "render/picking/through_picker.h"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>

#include "limn/contract.h"

namespace limn::render {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

glm::dvec3 position_of(const ControlMesh& mesh, std::size_t vertex) {
  return mesh.positions()[vertex];
}
glm::dvec3 position_of(const RefinedMesh& mesh, std::size_t vertex) {
  return mesh.position(vertex);
}

glm::dvec2 on_screen(const ProjectedPoint& projected) {
  return {projected.point.x, projected.point.y};
}

/// Appends the part of a polygon that is behind the near plane, as it shows.
template <class Mesh>
void project_cut(const Mesh& mesh, const Camera& camera, std::span<const std::uint32_t> corners,
                 std::vector<glm::dvec2>& polygon) {
  // A hair behind the plane, so that rounding cannot put the cut before it.
  const double near = camera.near_plane + 1e-9 * (camera.far_plane - camera.near_plane);
  glm::dvec3 before = position_of(mesh, corners.back());
  double before_depth = view_depth_of(camera, before);
  for (const std::uint32_t corner : corners) {
    const glm::dvec3 here = position_of(mesh, corner);
    const double depth = view_depth_of(camera, here);
    if ((before_depth < near) != (depth < near)) {
      const double part = (near - before_depth) / (depth - before_depth);
      if (const auto cut = project(camera, before + part * (here - before))) {
        polygon.push_back(on_screen(*cut));
      }
    }
    if (depth >= near) {
      if (const auto shown = project(camera, here)) {
        polygon.push_back(on_screen(*shown));
      }
    }
    before = here;
    before_depth = depth;
  }
}

}  // namespace

template <class Mesh>
void ThroughPicker::project_all(const std::shared_ptr<const Mesh>& mesh, const Camera& camera) {
  const std::weak_ptr<const void> asked = mesh;
  const bool is_same_mesh = !mesh_.owner_before(asked) && !asked.owner_before(mesh_);
  if (is_same_mesh && view_projection_ == camera.view_projection && size_ == camera.size) {
    return;
  }
  mesh_ = asked;
  view_projection_ = camera.view_projection;
  size_ = camera.size;
  points_.resize(mesh->vertex_count());
  is_before_.assign(points_.size(), false);
  for (std::size_t v = 0; v < points_.size(); ++v) {
    if (const auto shown = project(camera, position_of(*mesh, v))) {
      points_[v] = on_screen(*shown);
    } else {
      is_before_[v] = true;
    }
  }
  boxes_.resize(mesh->face_count());
  for (std::size_t f = 0; f < boxes_.size(); ++f) {
    Box& box = boxes_[f] = {glm::vec2(kInfinity), glm::vec2(-kInfinity)};
    bool is_cut = false;
    bool shows = false;
    for (const std::uint32_t vertex : mesh->face(f)) {
      is_cut = is_cut || is_before_[vertex];
      shows = shows || !is_before_[vertex];
      if (!is_before_[vertex]) {
        // Boxes only sort out what is far away: a pixel of room makes up for single precision.
        box.low = glm::min(box.low, glm::vec2(points_[vertex]) - 1.0F);
        box.high = glm::max(box.high, glm::vec2(points_[vertex]) + 1.0F);
      }
    }
    if (is_cut && shows) {
      box = {glm::vec2(-kInfinity), glm::vec2(kInfinity)};
    }
  }
}

template <class Mesh>
bool ThroughPicker::meets(const Mesh& mesh, const Camera& camera, const ScreenRegion& region,
                          std::size_t face) {
  polygon_.clear();
  const std::span<const std::uint32_t> corners = mesh.face(face);
  const bool is_cut =
      std::ranges::any_of(corners, [&](std::uint32_t vertex) { return is_before_[vertex]; });
  if (is_cut) {
    project_cut(mesh, camera, corners, polygon_);
  } else {
    for (const std::uint32_t vertex : corners) {
      polygon_.push_back(points_[vertex]);
    }
  }
  return region.meets(polygon_);
}

template <class Mesh, class ControlFace>
std::vector<std::uint32_t> ThroughPicker::gather(const Mesh& mesh, std::size_t control_faces,
                                                 const Camera& camera, const ScreenRegion& region,
                                                 ControlFace&& control_face) {
  const glm::vec2 low(region.box().low);
  const glm::vec2 high(region.box().high);
  std::vector<bool> is_met(control_faces, false);
  for (std::size_t f = 0; f < boxes_.size(); ++f) {
    const Box& box = boxes_[f];
    if (box.low.x > high.x || box.high.x < low.x || box.low.y > high.y || box.high.y < low.y) {
      continue;
    }
    const std::uint32_t control = control_face(f);
    LIMN_EXPECTS(control < control_faces);
    if (!is_met[control] && meets(mesh, camera, region, f)) {
      is_met[control] = true;
    }
  }
  std::vector<std::uint32_t> met;
  for (std::uint32_t f = 0; f < control_faces; ++f) {
    if (is_met[f]) {
      met.push_back(f);
    }
  }
  return met;
}

std::vector<std::uint32_t> ThroughPicker::faces_in(const std::shared_ptr<const ControlMesh>& mesh,
                                                   const Camera& camera,
                                                   const ScreenRegion& region) {
  project_all(mesh, camera);
  return gather(*mesh, mesh->face_count(), camera, region,
                [](std::size_t face) { return static_cast<std::uint32_t>(face); });
}

std::vector<std::uint32_t> ThroughPicker::faces_in(const std::shared_ptr<const RefinedMesh>& mesh,
                                                   std::size_t control_faces, const Camera& camera,
                                                   const ScreenRegion& region) {
  project_all(mesh, camera);
  return gather(*mesh, control_faces, camera, region,
                [&](std::size_t face) { return mesh->face_control_faces[face]; });
}

std::vector<std::uint32_t> ThroughPicker::refined_faces_in(
    const std::shared_ptr<const RefinedMesh>& mesh, const Camera& camera,
    const ScreenRegion& region) {
  project_all(mesh, camera);
  return gather(*mesh, mesh->face_count(), camera, region,
                [](std::size_t face) { return static_cast<std::uint32_t>(face); });
}

}  // namespace limn::render
