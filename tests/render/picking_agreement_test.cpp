// The id image against the ray caster, at every pixel's centre.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "limn/mesh/bundled.h"
#include "render/picking_fixture.h"

namespace limn::test {
namespace {

using render::Camera;
using render::FramebufferPoint;

/// How far from a pixel's centre an edge may run and still be the reason for another answer.
/// Drivers place corners on a grid of 1/256 of a pixel.
constexpr double kEdgeReach = 1.0 / 64.0;
/// What counts as exactly on an edge.
constexpr double kOnEdge = 1e-7;
/// Faces at the same depth to this part of it may take turns.
constexpr double kSameDepth = 1e-5;

std::optional<std::uint32_t> cast(const Raycaster& caster, const Camera& camera,
                                  FramebufferPoint point) {
  const render::Ray ray = ray_through(camera, point);
  const auto hit = caster.nearest(ray.origin, ray.direction);
  return hit ? std::optional(hit->face) : std::nullopt;
}

/// Whether `face` is what shows within `most` pixels of the point.
bool shows_beside(const Raycaster& caster, const Camera& camera, FramebufferPoint point,
                  std::optional<std::uint32_t> face, double most) {
  constexpr int kDirections = 16;
  for (const double reach : {most, 0.5 * most, 0.25 * most}) {
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kDirections;
      const FramebufferPoint beside{point.x + reach * std::cos(angle),
                                    point.y + reach * std::sin(angle)};
      if (cast(caster, camera, beside) == face) {
        return true;
      }
    }
  }
  return false;
}

/// Where a segment a-b, as it shows, is nearest to a place.
struct NearestOnEdge {
  double pixels = 0.0;      ///< From the place.
  double view_depth = 0.0;  ///< Of the segment's nearer end.
};
NearestOnEdge nearest_on_edge(const render::ProjectedPoint& a, const render::ProjectedPoint& b,
                              FramebufferPoint point) {
  const double dx = b.point.x - a.point.x;
  const double dy = b.point.y - a.point.y;
  const double along = (point.x - a.point.x) * dx + (point.y - a.point.y) * dy;
  const double squared = dx * dx + dy * dy;
  const double t = squared > 0.0 ? std::clamp(along / squared, 0.0, 1.0) : 0.0;
  return {std::hypot(point.x - a.point.x - t * dx, point.y - a.point.y - t * dy),
          std::min(a.view_depth, b.view_depth)};
}

/// View depth at which the ray through a point meets the surface.
std::optional<double> depth_met(const Raycaster& caster, const Camera& camera,
                                FramebufferPoint point) {
  const render::Ray ray = ray_through(camera, point);
  const auto met = caster.nearest(ray.origin, ray.direction);
  return met ? std::optional(view_depth_of(camera, ray.origin + met->distance * ray.direction))
             : std::nullopt;
}

/// Whether an edge of the face runs within kEdgeReach of the point without lying behind what is met
/// there. Tells of faces seen so edge-on that no ray beside the point meets them.
bool has_edge_at(const Raycaster& caster, const Camera& camera, FramebufferPoint point,
                 std::uint32_t face) {
  const double met_depth = depth_met(caster, camera, point).value_or(camera.far_plane);
  const Polygons& all = caster.polygons();
  const std::uint32_t first = all.offsets[face];
  const std::uint32_t sides = all.offsets[face + 1] - first;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const auto a = project(camera, all.positions[all.vertices[first + i]]);
    const auto b = project(camera, all.positions[all.vertices[first + (i + 1) % sides]]);
    if (!a || !b) {
      continue;
    }
    const NearestOnEdge edge = nearest_on_edge(*a, *b, point);
    if (edge.pixels < kEdgeReach && edge.view_depth <= met_depth + kSameDepth * camera.far_plane) {
      return true;
    }
  }
  return false;
}

Raycaster caster_of_face(const Polygons& all, std::uint32_t face) {
  Polygons one;
  one.positions = all.positions;
  one.vertices.assign(all.vertices.begin() + all.offsets[face],
                      all.vertices.begin() + all.offsets[face + 1]);
  one.offsets = {0, static_cast<std::uint32_t>(one.vertices.size())};
  return Raycaster(one);
}

/// Whether the face is met behind nothing, as far as a depth buffer of 24 bits can tell: where
/// faces run through each other.
bool is_as_near(const Raycaster& caster, const Camera& camera, FramebufferPoint point,
                std::uint32_t face) {
  const auto first = depth_met(caster, camera, point);
  const auto own = depth_met(caster_of_face(caster.polygons(), face), camera, point);
  if (!first || !own) {
    return false;
  }
  const double n = camera.near_plane;
  const double f = camera.far_plane;
  const double per_buffer_unit = camera.orthographic ? f - n : *own * *own * (f - n) / (f * n);
  return *own - *first <= 4.0 * std::ldexp(per_buffer_unit, -24);
}

/// Pixels that show a face or should, and how many of those do not show the face that is met.
struct Tally {
  std::size_t covered = 0;
  std::size_t different = 0;
};

/// Adds one picture to the tally. Pixels whose centre lies exactly on an edge belong to either face
/// and do not count.
void compare(const PickedMesh& mesh, const Raycaster& caster, const Camera& camera,
             const render::FacePicker& picker, Tally& tally) {
  const std::vector<std::uint32_t> ids = all_ids(picker);
  const std::vector<std::uint32_t> order = mesh.drawn_order();
  auto id = ids.begin();
  for (int y = 0; y < camera.size.height; ++y) {
    for (int x = 0; x < camera.size.width; ++x, ++id) {
      const FramebufferPoint centre{x + 0.5, y + 0.5};
      ASSERT_LE(*id, order.size());
      const auto drawn = *id == 0 ? std::nullopt : std::optional(order[*id - 1]);
      const auto met = cast(caster, camera, centre);
      tally.covered += drawn || met ? 1 : 0;
      if (drawn == met || shows_beside(caster, camera, centre, drawn, kOnEdge)) {
        continue;
      }
      ++tally.different;
      EXPECT_TRUE(shows_beside(caster, camera, centre, drawn, kEdgeReach) ||
                  (drawn && (has_edge_at(caster, camera, centre, *drawn) ||
                             is_as_near(caster, camera, centre, *drawn))))
          << "pixel " << x << ' ' << y << ": drawn " << (drawn ? std::to_string(*drawn) : "nothing")
          << ", met " << (met ? std::to_string(*met) : "nothing");
    }
  }
}

class PickingAgreement : public PickingTest {
 protected:
  /// All bundled meshes on OSMesa; on EGL, whose driver here is the same, those with most variety.
  [[nodiscard]] static std::vector<BundledMesh> meshes() {
    std::vector<BundledMesh> chosen;
    for (const BundledMesh& mesh : bundled_meshes()) {
      if (GetParam() == render::HeadlessKind::kOsmesa || mesh.name == kDefaultMesh ||
          mesh.name == "mixed") {
        chosen.push_back(mesh);
      }
    }
    return chosen;
  }

  void check(const PickedMesh& mesh) {
    render::SurfaceBuffers buffers;
    upload(buffers, mesh.surface);
    const Raycaster caster(mesh.polygons);
    render::FacePicker picker;
    Tally tally;
    for (const NamedCamera& named : cameras_around(mesh.bounds)) {
      SCOPED_TRACE(named.name);
      const std::size_t before = tally.covered;
      (void)picker.visible_faces({buffers, named.camera});
      compare(mesh, caster, named.camera, picker, tally);
      EXPECT_GT(tally.covered, before + 1000);
    }
    EXPECT_LE(static_cast<double>(tally.different), 0.001 * static_cast<double>(tally.covered))
        << tally.different << " of " << tally.covered;
  }
};

TEST_P(PickingAgreement, ControlMeshesShowTheFacesThatRaysMeet) {
  for (const BundledMesh& bundled : meshes()) {
    SCOPED_TRACE(bundled.name);
    const auto imported = load_bundled_mesh(bundled.name);
    ASSERT_TRUE(imported);
    check(picked_mesh(*imported->mesh));
  }
}

TEST_P(PickingAgreement, RefinedMeshesShowTheFacesThatRaysMeet) {
  for (const BundledMesh& bundled : meshes()) {
    SCOPED_TRACE(bundled.name);
    const auto imported = load_bundled_mesh(bundled.name);
    ASSERT_TRUE(imported);
    check(picked_mesh(*imported->mesh, refined_in_places(*imported->mesh)));
  }
}

INSTANTIATE_TEST_SUITE_P(Contexts, PickingAgreement, both_contexts(), context_name);

}  // namespace
}  // namespace limn::test
