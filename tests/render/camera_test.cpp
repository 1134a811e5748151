#include "render/camera.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "render/named_views.h"
#include "render/navigation.h"

namespace limn::render {
namespace {

constexpr FramebufferSize kSize{641, 373};

/// Views all around, near and far, in both projections, of scenes from millimetres to kilometres.
struct Case {
  ViewState view;
  Bounds scene;
};

std::vector<Case> cases() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Case> all;
  for (const double scale : {1e-3, 1.0, 1e3, 1e6}) {
    for (int i = 0; i < 40; ++i) {
      const glm::dvec3 low =
          scale * (glm::dvec3(unit(random), unit(random), unit(random)) * 20.0 - 10.0);
      const glm::dvec3 extent =
          scale * (glm::dvec3(unit(random), unit(random), unit(random)) + 0.05);
      Case one;
      one.scene = {low, low + extent};
      one.view.target = low + 0.5 * extent;
      one.view.yaw = unit(random) * 720.0 - 360.0;
      one.view.pitch = i == 0 ? 90.0 : i == 1 ? -90.0 : unit(random) * 180.0 - 90.0;
      one.view.fov_degrees = 10.0 + 90.0 * unit(random);
      one.view.distance = scale * std::exp(unit(random) * 5.0 - 2.0);
      one.view.orthographic = i % 2 != 0;
      all.push_back(one);
    }
  }
  return all;
}

glm::dvec3 somewhere_in(const Bounds& box, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  return box.low + glm::dvec3(unit(random), unit(random), unit(random)) * (box.high - box.low);
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance) {
  EXPECT_LE(glm::length(a - b), tolerance)
      << a.x << ' ' << a.y << ' ' << a.z << " and " << b.x << ' ' << b.y << ' ' << b.z;
}

TEST(Camera, FrontLooksAlongMinusZWithYUp) {
  ViewState view;
  view.target = {1.0, 2.0, 3.0};
  view.distance = 4.0;
  const Camera camera = make_camera(view, {{0, 0, 0}, {2, 4, 6}}, kSize);
  expect_near(camera.eye, {1.0, 2.0, 7.0}, 1e-12);
  const Ray ray = ray_through(camera, {kSize.width / 2.0, kSize.height / 2.0});
  expect_near(ray.direction, {0.0, 0.0, -1.0}, 1e-12);
  const auto above = project(camera, {1.0, 2.5, 3.0});
  ASSERT_TRUE(above);
  EXPECT_LT(above->point.y, kSize.height / 2.0);
  const auto right = project(camera, {1.5, 2.0, 3.0});
  ASSERT_TRUE(right);
  EXPECT_GT(right->point.x, kSize.width / 2.0);
}

TEST(Camera, AxesAreOrthonormalAndRightHandedEvenStraightDown) {
  for (const Case& one : cases()) {
    const Camera camera = make_camera(one.view, one.scene, kSize);
    expect_near(glm::cross(camera.right, camera.up), camera.back, 1e-12);
    EXPECT_NEAR(glm::length(camera.right), 1.0, 1e-12);
    EXPECT_NEAR(glm::dot(camera.right, camera.up), 0.0, 1e-12);
  }
}

TEST(Camera, ProjectAgreesWithTheMatrix) {
  std::mt19937 random(3);
  for (const Case& one : cases()) {
    const Camera camera = make_camera(one.view, one.scene, kSize);
    for (int i = 0; i < 20; ++i) {
      const glm::dvec3 world = somewhere_in(one.scene, random);
      const auto shown = project(camera, world);
      const glm::dvec4 clip = camera.view_projection * glm::dvec4(world, 1.0);
      if (!shown) {
        EXPECT_GT(clip.z, clip.w - 1e-9 * std::abs(clip.w));
        continue;
      }
      EXPECT_NEAR(shown->point.x, (clip.x / clip.w + 1.0) * 0.5 * kSize.width, 1e-6);
      EXPECT_NEAR(shown->point.y, (1.0 - clip.y / clip.w) * 0.5 * kSize.height, 1e-6);
      const double buffer = clip.z / clip.w;
      EXPECT_GE(buffer, 0.0);
      EXPECT_LE(buffer, 1.0);
      EXPECT_NEAR(view_depth_from_buffer(camera, buffer), shown->view_depth,
                  1e-6 * std::abs(shown->view_depth));
    }
  }
}

TEST(Camera, RayThroughWhereAPointShowsMeetsThePoint) {
  std::mt19937 random(4);
  for (const Case& one : cases()) {
    const Camera camera = make_camera(one.view, one.scene, kSize);
    for (int i = 0; i < 20; ++i) {
      const glm::dvec3 world = somewhere_in(one.scene, random);
      const auto shown = project(camera, world);
      if (!shown) {
        continue;
      }
      const double tolerance = 1e-9 * (glm::length(world) + one.view.distance);
      expect_near(world_at(camera, shown->point, shown->view_depth), world, tolerance);
      const Ray ray = ray_through(camera, shown->point);
      const double t = glm::dot(world - ray.origin, ray.direction);
      EXPECT_GE(t, -tolerance);
      expect_near(ray.origin + t * ray.direction, world, tolerance);
    }
  }
}

TEST(Camera, NothingOfTheSceneIsClippedByTheFarPlaneNorInFrontOfAnOutsideEye) {
  for (const Case& one : cases()) {
    const Camera camera = make_camera(one.view, one.scene, kSize);
    EXPECT_LT(camera.near_plane, camera.far_plane);
    for (const glm::dvec3& corner : box_corners(one.scene)) {
      const double depth = view_depth_of(camera, corner);
      EXPECT_LT(depth, camera.far_plane);
      if (camera.orthographic || depth > 1.2e-3 * one.view.distance) {
        EXPECT_GE(depth, camera.near_plane);
      }
    }
    if (!camera.orthographic) {
      EXPECT_GE(camera.near_plane, 0.99 * 1e-3 * one.view.distance);
    }
  }
}

TEST(Camera, PixelSizeIsTheWorldStepBetweenNeighbouringPixels) {
  for (const Case& one : cases()) {
    const Camera camera = make_camera(one.view, one.scene, kSize);
    const double depth = camera.target_depth;
    const glm::dvec3 a = world_at(camera, {100.0, 50.0}, depth);
    const glm::dvec3 b = world_at(camera, {101.0, 50.0}, depth);
    const glm::dvec3 c = world_at(camera, {100.0, 51.0}, depth);
    const double pixel = pixel_size_at(camera, depth);
    EXPECT_NEAR(glm::length(a - b) / pixel, 1.0, 1e-6);
    EXPECT_NEAR(glm::length(a - c) / pixel, 1.0, 1e-6);
  }
}

TEST(Camera, SwitchingTheProjectionKeepsTheSizeAtTheTarget) {
  for (Case one : cases()) {
    one.view.orthographic = false;
    const Camera perspective = make_camera(one.view, one.scene, kSize);
    one.view.orthographic = true;
    const Camera orthographic = make_camera(one.view, one.scene, kSize);
    EXPECT_NEAR(pixel_size_at(perspective, perspective.target_depth) /
                    pixel_size_at(orthographic, orthographic.target_depth),
                1.0, 1e-12);
  }
}

TEST(Camera, LocalMatrixHoldsFarFromTheWorldsOrigin) {
  // One metre across, a thousand kilometres out: in float world coordinates it would be 16 grains.
  const glm::dvec3 origin{1e6, -2e6, 3e6};
  const Bounds scene{origin, origin + 1.0};
  const ViewState view = default_view(scene, kSize.aspect());
  const Camera camera = make_camera(view, scene, kSize);
  const glm::mat4 clip_from = clip_from_local(camera, origin);
  std::mt19937 random(5);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 world = somewhere_in(scene, random);
    const glm::vec4 clip = clip_from * glm::vec4(glm::vec3(world - origin), 1.0F);
    const auto shown = project(camera, world);
    ASSERT_TRUE(shown);
    EXPECT_NEAR((clip.x / clip.w + 1.0F) * 0.5F * kSize.width, shown->point.x, 1e-3);
    EXPECT_NEAR((1.0F - clip.y / clip.w) * 0.5F * kSize.height, shown->point.y, 1e-3);
  }
}

TEST(Camera, UnusableViewsStillGiveFiniteMatrices) {
  ViewState view;
  view.distance = 0.0;
  view.fov_degrees = 400.0;
  view.pitch = 1000.0;
  for (const bool orthographic : {false, true}) {
    view.orthographic = orthographic;
    const Camera camera = make_camera(view, Bounds{}, FramebufferSize{});
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row) {
        EXPECT_TRUE(std::isfinite(camera.view_projection[column][row]));
      }
    }
  }
}

}  // namespace
}  // namespace limn::render
