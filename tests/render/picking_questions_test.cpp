// What the picker answers, against the whole id image read back and against meshes whose answer is
// known.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "limn/mesh/bundled.h"
#include "render/named_views.h"
#include "render/navigation.h"
#include "render/picking_fixture.h"
#include "support/shapes.h"

namespace limn::test {
namespace {

using render::BrushCapsule;
using render::Camera;
using render::FacePicker;
using render::FramebufferPoint;
using render::FramebufferSize;
using render::make_camera;
using render::make_surface;
using render::NamedView;
using render::PickScene;
using render::SurfaceBuffers;
using testing::ElementsAre;
using testing::IsEmpty;

using Faces = std::vector<std::uint32_t>;
using Quads = std::vector<std::vector<std::uint32_t>>;

class Picking : public PickingTest {};

std::shared_ptr<const ControlMesh> creature() {
  auto imported = load_bundled_mesh(kDefaultMesh);
  EXPECT_TRUE(imported);
  return imported->mesh;
}

Camera camera_at(NamedView direction, const Bounds& scene, FramebufferSize size) {
  return make_camera(named_view(direction, scene, size.aspect()), scene, size);
}

/// Control faces of a set of ids, ascending.
Faces control_faces_of(const std::set<std::uint32_t>& ids, const SurfaceBuffers& surface) {
  std::set<std::uint32_t> faces;
  for (const std::uint32_t id : ids) {
    if (id != 0) {
      faces.insert(surface.face_control_faces()[id - 1]);
    }
  }
  return {faces.begin(), faces.end()};
}

/// `count` quads one behind the other, seen from +z; quad 0 is drawn first. `depth(i)` is the z of
/// quad i.
template <class Depth>
std::shared_ptr<const ControlMesh> stack_of_quads(std::uint32_t count, const Depth& depth) {
  std::vector<glm::dvec3> positions;
  Quads quads;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double z = depth(i);
    positions.insert(positions.end(), {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}});
    quads.push_back({4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3});
  }
  return control_mesh(positions, quads);
}

TEST_P(Picking, PickFindsTheFaceAndThePlaceThatTheRayMeets) {
  const auto control = creature();
  const RefinedMesh refined = refined_in_places(*control);
  const PickedMesh mesh = picked_mesh(*control, refined);
  const std::vector<std::uint32_t> order = mesh.drawn_order();
  const Raycaster caster(mesh.polygons);
  SurfaceBuffers buffers;
  upload(buffers, mesh.surface);
  FacePicker picker;
  std::mt19937 random(5);
  for (const NamedCamera& named : cameras_around(mesh.bounds)) {
    SCOPED_TRACE(named.name);
    const Camera& camera = named.camera;
    std::uniform_int_distribution<int> column(0, camera.size.width - 1);
    std::uniform_int_distribution<int> row(0, camera.size.height - 1);
    int agreed = 0;
    for (int i = 0; i < 300; ++i) {
      const FramebufferPoint point{column(random) + 0.5, row(random) + 0.5};
      const auto picked = picker.pick({buffers, camera}, point);
      const render::Ray ray = ray_through(camera, point);
      const auto met = caster.nearest(ray.origin, ray.direction);
      // Pixels on an edge are the business of the agreement tests.
      if (!picked || !met || order[picked->drawn_face] != met->face) {
        continue;
      }
      ++agreed;
      EXPECT_EQ(picked->control_face, refined.face_control_faces[met->face]);
      const glm::dvec3 place = ray.origin + met->distance * ray.direction;
      EXPECT_LT(glm::length(picked->position - place),
                0.3 * pixel_size_at(camera, picked->view_depth));
      EXPECT_NEAR(picked->view_depth, view_depth_of(camera, picked->position),
                  1e-9 * camera.far_plane);
    }
    EXPECT_GT(agreed, 20);
  }
}

TEST_P(Picking, NothingIsPickedBesideTheSurfaceAndOutsideTheImage) {
  const auto mesh = cube();
  SurfaceBuffers buffers;
  upload(buffers, make_surface(*mesh));
  FacePicker picker;
  const FramebufferSize size{101, 51};
  const Camera camera = camera_at(NamedView::kFront, mesh->bounds(), size);
  const PickScene scene{buffers, camera};
  EXPECT_FALSE(picker.pick(scene, {1.0, 1.0}));
  EXPECT_TRUE(picker.pick(scene, {50.5, 25.5}));
  EXPECT_EQ(picker.pick(scene, {50.5, 25.5})->control_face, 5U);
  for (const FramebufferPoint outside : {FramebufferPoint{-0.5, 25.0},
                                         {101.0, 25.0},
                                         {50.0, -0.1},
                                         {50.0, 51.0},
                                         {1e9, 1e9},
                                         {NAN, 25.0}}) {
    EXPECT_FALSE(picker.pick(scene, outside));
  }
}

TEST_P(Picking, BrushMeetsExactlyTheFacesOfItsPixels) {
  const auto control = creature();
  const PickedMesh mesh = picked_mesh(*control, refined_in_places(*control));
  SurfaceBuffers buffers;
  upload(buffers, mesh.surface);
  FacePicker picker;
  const FramebufferSize size{173, 131};
  const Camera camera =
      make_camera(render::default_view(mesh.bounds, size.aspect()), mesh.bounds, size);
  const PickScene scene{buffers, camera};
  (void)picker.pick(scene, {0.0, 0.0});
  const std::vector<std::uint32_t> ids = seen_ids(picker);

  std::mt19937 random(9);
  std::uniform_real_distribution<double> x(-30.0, size.width + 30.0);
  std::uniform_real_distribution<double> y(-30.0, size.height + 30.0);
  std::uniform_real_distribution<double> radius(0.0, 30.0);
  for (int i = 0; i < 200; ++i) {
    BrushCapsule capsule{{x(random), y(random)}, {x(random), y(random)}, radius(random)};
    if (i % 3 == 0) {
      capsule.to = capsule.from;
    }
    std::set<std::uint32_t> under;
    for (int row = 0; row < size.height; ++row) {
      for (int column = 0; column < size.width; ++column) {
        const glm::dvec2 a(capsule.from.x, capsule.from.y);
        const glm::dvec2 way = glm::dvec2(capsule.to.x, capsule.to.y) - a;
        const glm::dvec2 p = glm::dvec2(column + 0.5, row + 0.5) - a;
        const double length = glm::dot(way, way);
        const double t = length > 0.0 ? std::clamp(glm::dot(p, way) / length, 0.0, 1.0) : 0.0;
        if (glm::length(p - t * way) <= std::max(capsule.radius, 0.7072)) {
          under.insert(ids[static_cast<std::size_t>(row * size.width + column)]);
        }
      }
    }
    Faces met = picker.brush(scene, capsule);
    std::sort(met.begin(), met.end());
    EXPECT_EQ(met, control_faces_of(under, buffers));
  }
  EXPECT_EQ(picker.draw_count(), 1U);
}

TEST_P(Picking, AFastStrokeLeavesNoGaps) {
  const std::uint32_t n = 20;
  const auto mesh = grid(n);
  SurfaceBuffers buffers;
  upload(buffers, make_surface(*mesh));
  FacePicker picker;
  const FramebufferSize size{211, 211};
  ViewState view = render::named_view(NamedView::kFront, mesh->bounds(), 1.0);
  view.orthographic = true;
  const Camera camera = make_camera(view, mesh->bounds(), size);
  // One step of the mouse from the first to the last face; the thinnest brush.
  const glm::dvec3 first(0.4, 0.3, 0.0);
  const glm::dvec3 last(n - 0.3, n - 0.6, 0.0);
  const auto from = project(camera, first);
  const auto to = project(camera, last);
  ASSERT_TRUE(from && to);
  const Faces met = picker.brush({buffers, camera}, {from->point, to->point, 0.0});
  for (int i = 0; i <= 1000; ++i) {
    const glm::dvec3 place = glm::mix(first, last, i / 1000.0);
    const auto face = static_cast<std::uint32_t>(place.y) * n + static_cast<std::uint32_t>(place.x);
    EXPECT_THAT(met, testing::Contains(face));
  }
  EXPECT_LT(met.size(), 4 * n);
}

TEST_P(Picking, VisibleFacesAreThoseOfTheImage) {
  const auto control = creature();
  for (const PickedMesh& mesh :
       {picked_mesh(*control), picked_mesh(*control, refined_in_places(*control))}) {
    SurfaceBuffers buffers;
    upload(buffers, mesh.surface);
    FacePicker picker;
    for (const NamedCamera& named : cameras_around(mesh.bounds)) {
      SCOPED_TRACE(named.name);
      const Faces visible = picker.visible_faces({buffers, named.camera});
      const std::vector<std::uint32_t> ids = seen_ids(picker);
      EXPECT_EQ(visible, control_faces_of({ids.begin(), ids.end()}, buffers));
      EXPECT_GT(visible.size(), 10U);
      EXPECT_LT(visible.size(), control->face_count());
    }
  }
}

TEST_P(Picking, FacesDrawnFirstAndCoveredLaterAreNotVisible) {
  constexpr std::uint32_t kCount = 70;
  const std::vector<std::shared_ptr<const ControlMesh>> stacks{
      stack_of_quads(kCount, [](std::uint32_t i) { return 0.1 * i; }),
      stack_of_quads(kCount, [](std::uint32_t i) { return -0.1 * i; }),
      stack_of_quads(kCount, [](std::uint32_t i) { return 0.1 * ((i * 37 + 5) % kCount); })};
  const std::array<std::uint32_t, 3> front{kCount - 1, 0, 32};
  for (std::size_t i = 0; i < stacks.size(); ++i) {
    ViewState view = render::named_view(NamedView::kFront, stacks[i]->bounds(), 1.0);
    view.orthographic = true;
    const Camera camera = make_camera(view, stacks[i]->bounds(), {65, 63});
    SurfaceBuffers buffers;
    upload(buffers, make_surface(*stacks[i]));
    FacePicker picker;
    EXPECT_THAT(picker.visible_faces({buffers, camera}), ElementsAre(front[i]));
    EXPECT_THAT(picker.brush({buffers, camera}, {{30.0, 30.0}, {40.0, 20.0}, 9.0}),
                ElementsAre(front[i]));
  }
}

// On a closed surface seen from outside, what faces away is hidden. At the silhouette it is as deep
// as the front face it shares an edge with, and rounding must not let it through.
TEST_P(Picking, FacesThatTurnAwayAreNeverVisibleOnAClosedSurface) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> yaw(-180.0, 180.0);
  std::uniform_real_distribution<double> pitch(-90.0, 90.0);
  for (const char* name : {"cube", "icosahedron", "creature"}) {
    const auto mesh = load_bundled_mesh(name).value().mesh;
    SurfaceBuffers buffers;
    upload(buffers, make_surface(*mesh));
    FacePicker picker;
    for (int round = 0; round < 60; ++round) {
      ViewState view = named_view(NamedView::kIso, mesh->bounds(), 1.0);
      if (round > 0) {
        view.yaw = yaw(random);
        view.pitch = pitch(random);
        view.orthographic = round % 3 == 0;
      }
      const Camera camera = make_camera(view, mesh->bounds(), {100 + 37 * round, 150 + 11 * round});
      for (const std::uint32_t face : picker.visible_faces({buffers, camera})) {
        const auto corners = mesh->face(face);
        const glm::dvec3 a = mesh->positions()[corners[0]];
        const glm::dvec3 to_eye = camera.orthographic ? camera.back : camera.eye - a;
        double turned = -1.0;  // Cosine of the triangle that faces the eye most.
        for (std::size_t i = 2; i < corners.size(); ++i) {
          const glm::dvec3 normal =
              glm::cross(mesh->positions()[corners[i - 1]] - a, mesh->positions()[corners[i]] - a);
          turned = std::max(turned, glm::dot(glm::normalize(normal), glm::normalize(to_eye)));
        }
        EXPECT_GT(turned, -1e-4) << name << ", camera " << round << ", face " << face;
      }
    }
  }
}

TEST_P(Picking, TheOrderOfDrawingDoesNotMatter) {
  const auto mesh = creature();
  Faces order(mesh->face_count());
  std::iota(order.begin(), order.end(), 0U);
  const std::vector<glm::dvec3> positions(mesh->positions().begin(), mesh->positions().end());
  const Camera camera = camera_at(NamedView::kIso, mesh->bounds(), {321, 255});
  SurfaceBuffers buffers;
  upload(buffers, make_surface(*mesh));
  FacePicker picker;
  const Faces expected = picker.visible_faces({buffers, camera});

  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  Quads shuffled;
  for (const std::uint32_t f : order) {
    shuffled.emplace_back(mesh->face(f).begin(), mesh->face(f).end());
  }
  upload(buffers, make_surface(*control_mesh(positions, shuffled)));
  Faces visible;
  for (const std::uint32_t f : picker.visible_faces({buffers, camera})) {
    visible.push_back(order[f]);
  }
  std::sort(visible.begin(), visible.end());
  EXPECT_EQ(visible, expected);
}

TEST_P(Picking, TheImageIsDrawnAgainOnlyWhenWhatItShowsChanges) {
  const auto mesh = cube();
  const auto sheet = grid(3);
  SurfaceBuffers buffers;
  SurfaceBuffers other;
  upload(buffers, make_surface(*mesh));
  FacePicker picker;
  const FramebufferSize size{40, 30};
  const Camera front = camera_at(NamedView::kFront, mesh->bounds(), size);
  const Camera top = camera_at(NamedView::kTop, mesh->bounds(), size);
  EXPECT_EQ(picker.draw_count(), 0U);
  for (int i = 0; i < 5; ++i) {
    (void)picker.pick({buffers, front}, {20.0 + i, 15.0});
    (void)picker.brush({buffers, front}, {{0.0, 0.0}, {20.0 + i, 15.0}, 3.0});
    (void)picker.visible_faces({buffers, front});
  }
  EXPECT_EQ(picker.draw_count(), 1U);
  EXPECT_EQ(picker.pick({buffers, top}, {20.0, 15.0})->control_face, 3U);
  EXPECT_EQ(picker.draw_count(), 2U);
  upload(buffers, make_surface(*sheet));
  EXPECT_EQ(picker.pick({buffers, front}, {21.0, 14.0})->control_face, 0U);
  EXPECT_EQ(picker.draw_count(), 3U);
  const Camera larger = camera_at(NamedView::kFront, sheet->bounds(), {41, 30});
  EXPECT_EQ(picker.visible_faces({buffers, larger}).size(), 9U);
  EXPECT_EQ(picker.draw_count(), 4U);
  upload(other, make_surface(*mesh));
  EXPECT_THAT(picker.visible_faces({other, front}), ElementsAre(5U));
  EXPECT_EQ(picker.draw_count(), 5U);
}

TEST_P(Picking, BuffersMadeWhereOthersStoodAreNotTakenForThem) {
  const auto mesh = cube();
  const Camera camera = camera_at(NamedView::kFront, mesh->bounds(), {40, 30});
  FacePicker picker;
  std::optional<SurfaceBuffers> buffers;
  buffers.emplace();
  ASSERT_TRUE(buffers->upload(make_surface(*mesh), 1));
  EXPECT_THAT(picker.visible_faces({*buffers, camera}), ElementsAre(5U));
  buffers.emplace();
  ASSERT_TRUE(buffers->upload(make_surface(*grid(1)), 1));
  EXPECT_THAT(picker.visible_faces({*buffers, camera}), ElementsAre(0U));
}

TEST_P(Picking, NothingShowsOfEmptySurfacesInEmptyImagesAndBehindTheEye) {
  const auto mesh = cube();
  const Camera camera = camera_at(NamedView::kFront, mesh->bounds(), {40, 30});
  const Camera nowhere = camera_at(NamedView::kFront, mesh->bounds(), {0, 0});
  const Camera flat = camera_at(NamedView::kFront, mesh->bounds(), {40, 0});
  ViewState away = render::named_view(NamedView::kFront, mesh->bounds(), 1.0);
  away.target.z = -100.0;
  const Camera behind = make_camera(away, mesh->bounds(), {40, 30});
  SurfaceBuffers empty;
  SurfaceBuffers buffers;
  upload(buffers, make_surface(*mesh));
  FacePicker picker;
  const BrushCapsule everywhere{{0.0, 0.0}, {40.0, 30.0}, 100.0};
  const auto expect_nothing = [&](const PickScene& scene) {
    EXPECT_FALSE(picker.pick(scene, {20.0, 15.0}));
    EXPECT_THAT(picker.brush(scene, everywhere), IsEmpty());
    EXPECT_THAT(picker.visible_faces(scene), IsEmpty());
  };
  expect_nothing({empty, camera});
  expect_nothing({buffers, nowhere});
  expect_nothing({buffers, flat});
  expect_nothing({buffers, behind});
  EXPECT_THAT(picker.visible_faces({buffers, camera}), ElementsAre(5U));
  expect_nothing({empty, camera});
}

TEST_P(Picking, AnEyeInsideACubeSeesItsWallsFromWithin) {
  const auto mesh = cube();
  SurfaceBuffers buffers;
  upload(buffers, make_surface(*mesh));
  FacePicker picker;
  ViewState view;
  view.distance = 0.01;
  view.fov_degrees = 60.0;
  const Camera camera = make_camera(view, mesh->bounds(), {64, 64});
  // Looking along -z from the middle: the wall at -z fills the picture, the one behind is not seen.
  EXPECT_THAT(picker.visible_faces({buffers, camera}), ElementsAre(4U));
  view.fov_degrees = 120.0;
  const Camera wide = make_camera(view, mesh->bounds(), {64, 64});
  EXPECT_THAT(picker.visible_faces({buffers, wide}), ElementsAre(0U, 1U, 2U, 3U, 4U));
}

INSTANTIATE_TEST_SUITE_P(Contexts, Picking, both_contexts(), context_name);

}  // namespace
}  // namespace limn::test
