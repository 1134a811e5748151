#include "render/navigation.h"

#include <cmath>
#include <random>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "render/camera.h"
#include "render/named_views.h"

namespace limn::render {
namespace {

constexpr FramebufferSize kImageSize{800, 450};
const Bounds kScene{{-1.0, -2.0, -0.5}, {3.0, 2.0, 1.5}};

std::vector<ViewState> views() {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<ViewState> all;
  for (int i = 0; i < 60; ++i) {
    ViewState view;
    view.target = glm::dvec3(unit(random), unit(random), unit(random)) * 4.0 - 2.0;
    view.yaw = unit(random) * 360.0 - 180.0;
    view.pitch = unit(random) * 180.0 - 90.0;
    view.distance = 1.0 + 20.0 * unit(random);
    view.fov_degrees = 15.0 + 60.0 * unit(random);
    view.orthographic = i % 2 != 0;
    all.push_back(view);
  }
  return all;
}

FramebufferPoint shown_at(const ViewState& view, const glm::dvec3& world) {
  const auto shown = project(make_camera(view, kScene, kImageSize), world);
  EXPECT_TRUE(shown);
  return shown ? shown->point : FramebufferPoint{};
}

void expect_same_place(FramebufferPoint a, FramebufferPoint b) {
  EXPECT_NEAR(a.x, b.x, 1e-6);
  EXPECT_NEAR(a.y, b.y, 1e-6);
}

TEST(Orbit, DragToTheRightTakesTheFrontOfTheSurfaceToTheRight) {
  const ViewState view;
  const glm::dvec3 front = view.target + glm::dvec3(0.0, 0.0, 0.5);
  const FramebufferPoint before = shown_at(view, front);
  EXPECT_GT(shown_at(orbit(view, 0.1, 0.0), front).x, before.x + 1.0);
  EXPECT_GT(shown_at(orbit(view, 0.0, 0.1), front).y, before.y + 1.0);
}

TEST(Orbit, HalfATurnOverTheWholeHeightAndPitchStops) {
  const ViewState view;
  EXPECT_NEAR(std::abs(orbit(view, 1.0, 0.0).yaw), 180.0, 1e-12);
  EXPECT_EQ(orbit(view, 0.0, 5.0).pitch, 90.0);
  EXPECT_EQ(orbit(view, 0.0, -5.0).pitch, -90.0);
  EXPECT_LE(std::abs(orbit(view, 7.3, 0.0).yaw), 180.0);
}

TEST(Orbit, KeepsTargetAndDistance) {
  for (const ViewState& view : views()) {
    const ViewState turned = orbit(view, 0.37, -0.21);
    EXPECT_EQ(turned.target, view.target);
    EXPECT_EQ(turned.distance, view.distance);
  }
}

TEST(Orbit, AboutAPointKeepsItWhereItShowsAndHowDeep) {
  for (const ViewState& view : views()) {
    const Camera before = make_camera(view, kScene, kImageSize);
    for (const double depth : {0.3, 1.0, 2.5}) {
      const glm::dvec3 pivot = world_at(before, {630.0, 90.5}, depth * view.distance);
      const ViewState turned = orbit_about(view, 0.21, -0.13, pivot);
      const auto shown = project(make_camera(turned, Bounds{pivot, pivot}, kImageSize), pivot);
      ASSERT_TRUE(shown);
      expect_same_place(shown->point, {630.0, 90.5});
      EXPECT_NEAR(shown->view_depth, depth * view.distance, 1e-9 * view.distance);
      EXPECT_EQ(turned.distance, view.distance);
      EXPECT_EQ(turned.yaw, orbit(view, 0.21, -0.13).yaw);
      EXPECT_EQ(turned.pitch, orbit(view, 0.21, -0.13).pitch);
    }
  }
}

TEST(Orbit, AboutTheTargetIsThePlainOne) {
  for (const ViewState& view : views()) {
    const ViewState turned = orbit_about(view, 0.37, -0.21, view.target);
    EXPECT_LT(glm::length(turned.target - view.target), 1e-12);
  }
}

TEST(Orbit, AboutAPointAtThePoleStaysThere) {
  ViewState view;
  view.pitch = 80.0;
  const glm::dvec3 pivot{0.4, 0.2, 0.1};
  const FramebufferPoint before = shown_at(view, pivot);
  for (int i = 0; i < 20; ++i) {
    view = orbit_about(view, 0.05, 0.05, pivot);
  }
  EXPECT_EQ(view.pitch, 90.0);
  expect_same_place(shown_at(view, pivot), before);
}

TEST(Turn, TowardsADirectionPutsTheEyeThere) {
  for (const glm::dvec3& direction : {glm::dvec3{1, 2, 3}, glm::dvec3{-4, 0.1, 0.2},
                                      glm::dvec3{0, -5, 0}, glm::dvec3{0, 0, -1}}) {
    const ViewState turned = turn_towards(views()[2], direction);
    const Camera camera = make_camera(turned, kScene, kImageSize);
    EXPECT_LT(glm::length(camera.back - glm::normalize(direction)), 1e-9);
    EXPECT_EQ(turned.target, views()[2].target);
  }
  EXPECT_EQ(turn_towards(views()[2], glm::dvec3(0.0)), views()[2]);
}

TEST(Pan, WhatWasGrabbedFollowsTheMouse) {
  for (const ViewState& view : views()) {
    for (const double part : {0.3, 1.0, 2.5}) {
      const double depth = part * view.distance;
      const FramebufferPoint from{123.25, 77.5};
      const FramebufferPoint to{555.0, 301.75};
      const glm::dvec3 grabbed =
          world_at(make_camera(view, Bounds{view.target, view.target}, kImageSize), from, depth);
      const ViewState moved = pan(view, kImageSize, {from, to, depth});
      const Bounds around{grabbed, grabbed};
      const auto shown = project(make_camera(moved, around, kImageSize), grabbed);
      ASSERT_TRUE(shown);
      expect_same_place(shown->point, to);
    }
  }
}

TEST(Dolly, AnchorStaysWhereItShows) {
  for (const ViewState& view : views()) {
    const Camera camera = make_camera(view, kScene, kImageSize);
    const glm::dvec3 anchor = world_at(camera, {700.0, 60.0}, 0.8 * view.distance);
    for (const double factor : {0.5, 0.9, 1.0, 1.3, 3.0}) {
      const ViewState moved = dolly(view, factor, anchor, kScene);
      EXPECT_NEAR(moved.distance, view.distance * factor, 1e-12 * view.distance);
      const auto shown = project(make_camera(moved, Bounds{anchor, anchor}, kImageSize), anchor);
      ASSERT_TRUE(shown);
      expect_same_place(shown->point, {700.0, 60.0});
    }
  }
}

TEST(Dolly, NeverReachesTheTargetNorLosesTheScene) {
  ViewState view;
  for (int i = 0; i < 1000; ++i) {
    view = dolly(view, 0.5, kScene);
  }
  EXPECT_NEAR(view.distance, 1e-4 * 6.0, 1e-9);
  for (int i = 0; i < 1000; ++i) {
    view = dolly(view, 2.0, kScene);
  }
  EXPECT_NEAR(view.distance, 100.0 * 6.0, 1e-6);
}

TEST(Frame, ShowsTheWholeBoxAndLeavesLittleRoom) {
  for (const double aspect : {0.5, 1.0, 16.0 / 9.0}) {
    const FramebufferSize size{static_cast<int>(900 * aspect), 900};
    for (const ViewState& view : views()) {
      const ViewState framed = frame_bounds(view, kScene, size.aspect());
      const Camera camera = make_camera(framed, kScene, size);
      double fullest = 0.0;
      for (const glm::dvec3& corner : box_corners(kScene)) {
        const auto shown = project(camera, corner);
        ASSERT_TRUE(shown);
        fullest = std::max(fullest, std::abs(2.0 * shown->point.x / size.width - 1.0));
        fullest = std::max(fullest, std::abs(2.0 * shown->point.y / size.height - 1.0));
      }
      EXPECT_LT(fullest, 1.0);
      EXPECT_GT(fullest, 0.85);
      EXPECT_EQ(framed.yaw, view.yaw);
      EXPECT_EQ(framed.orthographic, view.orthographic);
    }
  }
}

TEST(Frame, PointsThatLeaveTheirBoxEmptyFillTheImageBetter) {
  // An octahedron: no point at its box's corners.
  const std::vector<glm::dvec3> points{{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                       {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
  const ViewState view = default_view(points, 1.5);
  EXPECT_LT(view.distance, 0.8 * default_view(Bounds{glm::dvec3(-1), glm::dvec3(1)}, 1.5).distance);
  const Camera camera = make_camera(view, Bounds{glm::dvec3(-1), glm::dvec3(1)}, {600, 400});
  for (const glm::dvec3& point : points) {
    const auto shown = project(camera, point);
    ASSERT_TRUE(shown);
    EXPECT_TRUE(shown->point.x > 0 && shown->point.x < 600);
    EXPECT_TRUE(shown->point.y > 0 && shown->point.y < 400);
  }
}

TEST(Frame, OnePointMovesTheTargetAloneAndNoPointsNothing) {
  const ViewState view = views()[0];
  const std::vector<glm::dvec3> one{{5.0, 6.0, 7.0}};
  const ViewState framed = frame_points(view, one, 1.0);
  EXPECT_EQ(framed.target, one[0]);
  EXPECT_EQ(framed.distance, view.distance);
  EXPECT_EQ(frame_points(view, {}, 1.0), view);
}

TEST(Frame, ALineOfSightDoesNotPullTheEyeIntoTheFirstPoint) {
  const std::vector<glm::dvec3> line{{0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}};
  EXPECT_GT(frame_points(ViewState{}, line, 1.0).distance, 1.01);
}

TEST(NamedViews, StandWhereTheirNameSays) {
  const auto back_of = [](NamedView named) {
    return make_camera(named_view(named, kScene, 1.0), kScene, kImageSize).back;
  };
  const auto expect_direction = [&](NamedView named, const glm::dvec3& expected) {
    EXPECT_LT(glm::length(back_of(named) - expected), 1e-12) << view_name(named);
  };
  expect_direction(NamedView::kFront, {0, 0, 1});
  expect_direction(NamedView::kBack, {0, 0, -1});
  expect_direction(NamedView::kLeft, {-1, 0, 0});
  expect_direction(NamedView::kRight, {1, 0, 0});
  expect_direction(NamedView::kTop, {0, 1, 0});
  expect_direction(NamedView::kBottom, {0, -1, 0});
  expect_direction(NamedView::kIso, glm::dvec3(1.0) / std::sqrt(3.0));
}

TEST(NamedViews, EveryNameParsesToItsView) {
  EXPECT_EQ(all_named_views().size(), 8U);
  for (const NamedView named : all_named_views()) {
    const auto parsed = parse_view_name(view_name(named));
    ASSERT_TRUE(parsed);
    EXPECT_EQ(*parsed, named);
  }
  const auto unknown = parse_view_name("sideways");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().kind, ErrorKind::kUsage);
  EXPECT_THAT(unknown.error().message, testing::HasSubstr("three-quarter, front, back"));
}

TEST(Ease, StartsAndEndsExactlyAndTurnsTheShortWay) {
  ViewState from = views()[0];
  ViewState to = views()[3];
  from.yaw = 170.0;
  to.yaw = -170.0;
  from.distance = 1.0;
  to.distance = 100.0;
  EXPECT_EQ(ease_view(from, to, 0.0), from);
  EXPECT_EQ(ease_view(from, to, 1.0), to);
  const ViewState middle = ease_view(from, to, 0.5);
  EXPECT_NEAR(std::abs(middle.yaw), 180.0, 1e-9);
  EXPECT_NEAR(middle.distance, 10.0, 1e-9);
  for (int i = 0; i <= 20; ++i) {
    EXPECT_GE(std::abs(ease_view(from, to, i / 20.0).yaw), 170.0 - 1e-9);
  }
}

}  // namespace
}  // namespace limn::render
