// Parts of the picture, and the faces in them, against brute force: exact integers, angles added up
// around a point, points scattered over faces, and the ray caster.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "limn/mesh/bundled.h"
#include "render/named_views.h"
#include "render/picking/screen_region.h"
#include "render/picking/through_picker.h"
#include "render/picking_fixture.h"
#include "support/shapes.h"

namespace limn::test {
namespace {

using render::Camera;
using render::FramebufferPoint;
using render::FramebufferSize;
using render::ScreenRegion;
using render::ThroughPicker;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

using Faces = std::vector<std::uint32_t>;

/// How often a polygon winds around a place, by the angles between its corners as seen from there.
int turns_around(const std::vector<FramebufferPoint>& polygon, double x, double y) {
  double angle = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const FramebufferPoint& a = polygon[i];
    const FramebufferPoint& b = polygon[(i + 1) % polygon.size()];
    angle += std::remainder(std::atan2(b.y - y, b.x - x) - std::atan2(a.y - y, a.x - x),
                            2.0 * std::numbers::pi);
  }
  return static_cast<int>(std::lround(angle / (2.0 * std::numbers::pi)));
}

double distance_to_outline(const std::vector<FramebufferPoint>& polygon, double x, double y) {
  double nearest = INFINITY;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a(polygon[i].x, polygon[i].y);
    const glm::dvec2 b(polygon[(i + 1) % polygon.size()].x, polygon[(i + 1) % polygon.size()].y);
    const glm::dvec2 way = b - a;
    const double length2 = glm::dot(way, way);
    const glm::dvec2 p(x, y);
    const double t = length2 > 0.0 ? std::clamp(glm::dot(p - a, way) / length2, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, glm::distance(p, a + t * way));
  }
  return nearest;
}

std::vector<FramebufferPoint> random_lasso(Random& random, double width, double height) {
  std::uniform_real_distribution<double> x(-0.2 * width, 1.2 * width);
  std::uniform_real_distribution<double> y(-0.2 * height, 1.2 * height);
  std::vector<FramebufferPoint> points(3 + random() % 12);
  for (FramebufferPoint& point : points) {
    point = {x(random), y(random)};
  }
  return points;
}

TEST(ScreenRegion, CoversThePixelsThatItWindsAround) {
  Random random(1);
  const FramebufferSize size{70, 50};
  std::vector<render::PixelSpan> spans;
  for (int round = 0; round < 300; ++round) {
    const auto polygon = random_lasso(random, size.width, size.height);
    const ScreenRegion region(polygon);
    const render::PixelRect rect = region.pixel_rect(size);
    for (int row = 0; row < size.height; ++row) {
      region.covered_spans(row, spans);
      for (std::size_t i = 1; i < spans.size(); ++i) {
        EXPECT_GT(spans[i].first, spans[i - 1].last);
      }
      for (int column = 0; column < size.width; ++column) {
        const double x = column + 0.5;
        const double y = row + 0.5;
        if (distance_to_outline(polygon, x, y) < 1e-9) {
          continue;
        }
        const bool is_covered = std::ranges::any_of(
            spans, [&](const auto& span) { return column >= span.first && column < span.last; });
        ASSERT_EQ(is_covered, turns_around(polygon, x, y) != 0) << column << ',' << row;
        if (is_covered) {
          EXPECT_TRUE(column >= rect.x && column < rect.x + rect.width && row >= rect.y &&
                      row < rect.y + rect.height);
        }
      }
    }
  }
}

TEST(ScreenRegion, ALassoThatCrossesItselfLeavesNoHole) {
  // A star drawn in one go winds twice around its middle.
  std::vector<FramebufferPoint> star;
  for (int i = 0; i < 5; ++i) {
    const double angle = 2.0 * std::numbers::pi * (2 * i) / 5.0;
    star.push_back({50.0 + 40.0 * std::sin(angle), 50.0 - 40.0 * std::cos(angle)});
  }
  std::vector<render::PixelSpan> spans;
  ScreenRegion(star).covered_spans(50, spans);
  ASSERT_EQ(spans.size(), 1U);
  EXPECT_LT(spans[0].first, 50);
  EXPECT_GT(spans[0].last, 50);
}

struct Grid {
  std::int64_t x = 0;
  std::int64_t y = 0;
};
using GridPolygon = std::vector<Grid>;

std::int64_t turn(const Grid& a, const Grid& b, const Grid& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
bool on_segment(const Grid& a, const Grid& b, const Grid& p) {
  return turn(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}
int sign(std::int64_t value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}
bool cross_exactly(const Grid& a, const Grid& b, const Grid& c, const Grid& d) {
  return on_segment(a, b, c) || on_segment(a, b, d) || on_segment(c, d, a) || on_segment(c, d, b) ||
         (sign(turn(a, b, c)) * sign(turn(a, b, d)) < 0 &&
          sign(turn(c, d, a)) * sign(turn(c, d, b)) < 0);
}
std::vector<FramebufferPoint> to_points(const GridPolygon& polygon) {
  std::vector<FramebufferPoint> points;
  for (const auto& [x, y] : polygon) {
    points.push_back({static_cast<double>(x), static_cast<double>(y)});
  }
  return points;
}
bool winds_around(const GridPolygon& polygon, const Grid& point) {
  return turns_around(to_points(polygon), static_cast<double>(point.x),
                      static_cast<double>(point.y)) != 0;
}
/// Exact but for points strictly off the outlines, whose angles are far from a half turn's
/// rounding.
bool meet_by_brute_force(const GridPolygon& a, const GridPolygon& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (cross_exactly(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()])) {
        return true;
      }
    }
  }
  return winds_around(a, b[0]) || winds_around(b, a[0]);
}

TEST(ScreenRegion, MeetsWhatBruteForceSaysItMeets) {
  Random random(2);
  int met = 0;
  const auto polygon_within = [&](std::size_t corners, int size, Grid offset) {
    GridPolygon polygon(corners);
    for (Grid& point : polygon) {
      point = {offset.x + static_cast<std::int64_t>(random() % static_cast<unsigned>(size)),
               offset.y + static_cast<std::int64_t>(random() % static_cast<unsigned>(size))};
    }
    return polygon;
  };
  constexpr int kRounds = 40000;
  for (int round = 0; round < kRounds; ++round) {
    const GridPolygon lasso = polygon_within(1 + random() % 9, 12, {0, 0});
    const GridPolygon face = polygon_within(3 + random() % 3, 1 + static_cast<int>(random() % 8),
                                            {static_cast<std::int64_t>(random() % 14) - 2,
                                             static_cast<std::int64_t>(random() % 14) - 2});
    std::vector<glm::dvec2> points;
    for (const auto& [x, y] : face) {
      points.emplace_back(x, y);
    }
    const bool expected = meet_by_brute_force(lasso, face);
    met += expected ? 1 : 0;
    ASSERT_EQ(ScreenRegion(to_points(lasso)).meets(points), expected) << round;
  }
  EXPECT_GT(met, kRounds / 10);
  EXPECT_LT(met, kRounds * 9 / 10);
}

TEST(ScreenRegion, ABrushMeetsWhatIsWithinItsReach) {
  Random random(3);
  std::uniform_real_distribution<double> place(0.0, 40.0);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int round = 0; round < 400; ++round) {
    const render::BrushCapsule capsule{
        {place(random), place(random)}, {place(random), place(random)}, 1.0 + 0.1 * place(random)};
    std::vector<glm::dvec2> face(3);
    for (glm::dvec2& point : face) {
      point = {place(random), place(random)};
    }
    // Points scattered over the triangle, corners and edges included.
    double nearest = INFINITY;
    for (int i = 0; i < 3000; ++i) {
      double u = part(random);
      double v = i % 2 == 0 ? 0.0 : part(random);
      if (u + v > 1.0) {
        u = 1.0 - u;
        v = 1.0 - v;
      }
      const auto corner = static_cast<std::size_t>(i) % 3;
      const glm::dvec2 point = face[corner] + u * (face[(corner + 1) % 3] - face[corner]) +
                               v * (face[(corner + 2) % 3] - face[corner]);
      nearest =
          std::min(nearest, distance_to_outline({capsule.from, capsule.to}, point.x, point.y));
    }
    const bool meets = ScreenRegion(capsule).meets(face);
    if (nearest <= capsule.radius) {
      EXPECT_TRUE(meets);
    } else if (nearest > capsule.radius + 1.0) {
      EXPECT_FALSE(meets);
    }
  }
}

/// Places all over a face: of its fan's triangles, borders included.
std::vector<glm::dvec3> scattered(const Polygons& all, std::uint32_t face) {
  constexpr int kSteps = 24;
  std::vector<glm::dvec3> places;
  const std::uint32_t first = all.offsets[face];
  const auto at = [&](std::uint32_t i) { return all.positions[all.vertices[first + i]]; };
  for (std::uint32_t i = 1; i + 1 < all.offsets[face + 1] - first; ++i) {
    for (int u = 0; u <= kSteps; ++u) {
      for (int v = 0; u + v <= kSteps; ++v) {
        places.push_back(at(0) + static_cast<double>(u) / kSteps * (at(i) - at(0)) +
                         static_cast<double>(v) / kSteps * (at(i + 1) - at(0)));
      }
    }
  }
  return places;
}

TEST(ThroughPicker, TakesTheFacesWhoseProjectionMeetsTheRegion) {
  Random random(4);
  const auto mesh = control_mesh(with_mixed_faces(torus_soup(9, 6), random));
  const Polygons polygons = polygons_of(*mesh);
  ThroughPicker picker;
  int compared = 0;
  for (const auto& [name, camera] : cameras_around(mesh->bounds())) {
    std::vector<std::vector<FramebufferPoint>> shown(mesh->face_count());
    for (std::uint32_t f = 0; f < mesh->face_count(); ++f) {
      for (const glm::dvec3& place : scattered(polygons, f)) {
        if (const auto on_screen = project(camera, place)) {
          shown[f].push_back(on_screen->point);
        }
      }
    }
    for (int round = 0; round < 12; ++round) {
      const auto lasso = random_lasso(random, camera.size.width, camera.size.height);
      const Faces met = picker.faces_in(mesh, camera, ScreenRegion(lasso));
      EXPECT_TRUE(std::ranges::is_sorted(met));
      for (std::uint32_t f = 0; f < mesh->face_count(); ++f) {
        bool is_in = false;
        bool is_near = false;
        double reach = 2.0;  // As far apart as the places of a face lie on the screen.
        for (std::size_t i = 0; i < shown[f].size(); ++i) {
          const auto [x, y] = shown[f][i];
          is_in =
              is_in || (turns_around(lasso, x, y) != 0 && distance_to_outline(lasso, x, y) > 1e-6);
          if (i > 0) {
            reach = std::max(reach, std::hypot(x - shown[f][i - 1].x, y - shown[f][i - 1].y) * 0.1);
          }
          is_near =
              is_near || distance_to_outline(lasso, x, y) < reach || turns_around(lasso, x, y) != 0;
        }
        const bool is_met = std::ranges::binary_search(met, f);
        if (is_in) {
          EXPECT_TRUE(is_met) << name << ", face " << f;
          ++compared;
        } else if (!is_near) {
          EXPECT_FALSE(is_met) << name << ", face " << f;
          ++compared;
        }
      }
    }
  }
  EXPECT_GT(compared, 1000);
}

TEST(ThroughPicker, GoesThroughTheMesh) {
  const auto mesh = cube();
  const FramebufferSize size{100, 100};
  const Camera camera = make_camera(
      render::named_view(render::NamedView::kFront, mesh->bounds(), 1.0), mesh->bounds(), size);
  ThroughPicker picker;
  EXPECT_THAT(picker.faces_in(mesh, camera, ScreenRegion::rectangle({45, 45}, {55, 55})),
              ElementsAre(4, 5))
      << "back and front";
  EXPECT_THAT(picker.faces_in(mesh, camera, ScreenRegion::rectangle({-50, -50}, {150, 150})),
              ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_THAT(picker.faces_in(mesh, camera, ScreenRegion::rectangle({1, 1}, {3, 3})), IsEmpty());
  EXPECT_THAT(picker.faces_in(mesh, camera, render::BrushCapsule{{50, 50}, {50, 50}, 3.0}),
              ElementsAre(4, 5));
}

TEST(ThroughPicker, FollowsMeshAndCamera) {
  ThroughPicker picker;
  const FramebufferSize size{100, 100};
  const ScreenRegion middle = ScreenRegion::rectangle({45, 45}, {55, 55});
  for (int round = 0; round < 3; ++round) {
    // Each mesh is gone before the next is made, which may then lie in the same place.
    const auto mesh = round % 2 == 0 ? cube() : grid(3);
    for (const auto view : {render::NamedView::kFront, render::NamedView::kRight}) {
      const Camera camera =
          make_camera(render::named_view(view, mesh->bounds(), 1.0), mesh->bounds(), size);
      EXPECT_EQ(picker.faces_in(mesh, camera, middle),
                ThroughPicker().faces_in(mesh, camera, middle));
    }
  }
}

TEST(ThroughPicker, TakesControlFacesByTheirRefinedFaces) {
  const auto control = load_bundled_mesh("creature").value().mesh;
  const auto mesh = std::make_shared<const RefinedMesh>(refined_in_places(*control));
  const FramebufferSize size{300, 200};
  const Camera camera =
      make_camera(render::default_view(control->bounds(), size.aspect()), control->bounds(), size);
  Random random(6);
  ThroughPicker picker;
  for (int round = 0; round < 10; ++round) {
    const auto lasso = random_lasso(random, size.width, size.height);
    const ScreenRegion region(lasso);
    std::set<std::uint32_t> expected;
    for (std::size_t f = 0; f < mesh->face_count(); ++f) {
      std::vector<glm::dvec2> polygon;
      for (const std::uint32_t v : mesh->face(f)) {
        const auto shown = project(camera, mesh->position(v));
        ASSERT_TRUE(shown);
        polygon.emplace_back(shown->point.x, shown->point.y);
      }
      if (region.meets(polygon)) {
        expected.insert(mesh->face_control_faces[f]);
      }
    }
    EXPECT_EQ(picker.faces_in(mesh, control->face_count(), camera, region),
              Faces(expected.begin(), expected.end()));
  }
}

class RegionPicking : public PickingTest {};

TEST_P(RegionPicking, ALassoTakesWhatTheRayCasterSeesInIt) {
  const auto control = load_bundled_mesh("creature").value().mesh;
  const PickedMesh mesh = picked_mesh(*control);
  render::SurfaceBuffers buffers;
  upload(buffers, mesh.surface);
  render::FacePicker picker;
  const Raycaster caster(mesh.polygons);
  const FramebufferSize size{173, 131};
  const Camera camera =
      make_camera(render::default_view(mesh.bounds, size.aspect()), mesh.bounds, size);
  const auto seen_at = [&](double x, double y) -> std::optional<std::uint32_t> {
    const render::Ray ray = ray_through(camera, {x, y});
    const auto hit = caster.nearest(ray.origin, ray.direction);
    return hit ? std::optional(mesh.control_faces[hit->face]) : std::nullopt;
  };
  Random random(8);
  for (int round = 0; round < 15; ++round) {
    const auto lasso = random_lasso(random, size.width, size.height);
    const Faces met = picker.faces_in({buffers, camera}, ScreenRegion(lasso));
    std::set<std::uint32_t> sure;
    std::set<std::uint32_t> possible;
    for (int row = 0; row < size.height; ++row) {
      for (int column = 0; column < size.width; ++column) {
        const double x = column + 0.5;
        const double y = row + 0.5;
        if (turns_around(lasso, x, y) == 0) {
          continue;
        }
        const auto face = seen_at(x, y);
        bool is_sure = face.has_value() && distance_to_outline(lasso, x, y) > 1e-6;
        for (const auto& [dx, dy] : {std::pair{0.3, 0.3}, {-0.3, 0.3}, {0.3, -0.3}, {-0.3, -0.3}}) {
          const auto beside = seen_at(x + dx, y + dy);
          is_sure = is_sure && beside == face;
          if (beside) {
            possible.insert(*beside);
          }
        }
        if (face) {
          possible.insert(*face);
        }
        if (is_sure) {
          sure.insert(*face);
        }
      }
    }
    for (const std::uint32_t face : sure) {
      EXPECT_THAT(met, Contains(face));
    }
    for (const std::uint32_t face : met) {
      EXPECT_THAT(possible, Contains(face));
    }
  }
  EXPECT_EQ(picker.draw_count(), 1U);
}
INSTANTIATE_TEST_SUITE_P(Contexts, RegionPicking, both_contexts(), context_name);

}  // namespace
}  // namespace limn::test
