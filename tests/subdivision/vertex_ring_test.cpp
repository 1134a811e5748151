#include "subdivision/vertex_ring.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "subdivision/sharpness.h"
#include "support/opensubdiv_reference.h"
#include "support/shapes.h"

// Rings are followed from level to level beside OpenSubdiv's uniform meshes: every vertex of
// random meshes, all its neighbours, centroids and sharpness.
namespace limn::test {
namespace {

struct CreasingChance {
  double edge = 0.0;      // That an edge inside is sharp,
  double vertex = 0.0;    // or a vertex.
  double infinite = 0.0;  // That what is sharp is so for ever.
  float greatest = 3.0f;  // Of semi-sharp things.
  bool has_whole = true;  // Draws whole numbers too.
  CreasingMethod method = CreasingMethod::kUniform;
};

double unit(Random& random) {
  return std::uniform_real_distribution<double>(0.0, 1.0)(random);
}

float random_sharpness(const CreasingChance& chance, Random& random) {
  if (unit(random) < chance.infinite) {
    return unit(random) < 0.5 ? kInfiniteSharpness : 12.0f;
  }
  const float sharpness = chance.greatest * static_cast<float>(unit(random));
  return chance.has_whole && unit(random) < 0.3 ? std::ceil(sharpness) : sharpness;
}

ControlMesh creased(const ControlMesh& mesh, const CreasingChance& chance, Random& random) {
  MeshAttributes attributes;
  attributes.creases.method = chance.method;
  for (std::size_t e = 0; e < mesh.edge_count(); ++e) {
    const bool is_sharp = unit(random) < chance.edge;
    attributes.creases.edge_sharpness.push_back(is_sharp ? random_sharpness(chance, random) : 0.0f);
  }
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const bool is_sharp = unit(random) < chance.vertex;
    attributes.creases.vertex_sharpness.push_back(is_sharp ? random_sharpness(chance, random)
                                                           : 0.0f);
  }
  return mesh.with_attributes(std::move(attributes));
}

/// n polygons of 3 to 8 sides around a vertex, closed to a circle or not, in random places.
PolygonSoup fan_soup(std::uint32_t n, bool is_boundary, Random& random) {
  PolygonSoup soup;
  const auto add_point = [&](double radius, double turn) {
    const double angle = turn * 2.0 * std::numbers::pi / (is_boundary ? n + 2 : n);
    soup.positions.push_back({radius * std::cos(angle) + 0.5 * unit(random),
                              radius * std::sin(angle) + 0.5 * unit(random), unit(random)});
    return static_cast<std::uint32_t>(soup.positions.size() - 1);
  };
  const std::uint32_t centre = add_point(0.0, 0.0);
  const std::uint32_t first = add_point(2.0, 0.0);
  std::uint32_t from = first;
  for (std::uint32_t i = 0; i < n; ++i) {
    std::vector<std::uint32_t> polygon{centre, from};
    const std::uint32_t sides = std::uniform_int_distribution<std::uint32_t>(3, 8)(random);
    for (std::uint32_t k = 1; k + 2 < sides; ++k) {
      polygon.push_back(add_point(3.0, i + static_cast<double>(k) / (sides - 2)));
    }
    from = !is_boundary && i + 1 == n ? first : add_point(2.0, i + 1.0);
    polygon.push_back(from);
    soup.add_face(polygon);
  }
  return soup;
}

void expect_near(const Point& point, const glm::dvec3& expected, double tolerance,
                 const std::string& what) {
  EXPECT_LE(glm::distance(to_vec3(point), expected), tolerance) << what;
}

/// Every vertex of the control mesh followed down to the last level.
void expect_rings_follow(const ControlMesh& mesh, int levels, CornerRule corners) {
  const UniformHierarchy hierarchy(mesh, levels, corners);
  const auto positions = hierarchy.positions(mesh.positions());
  const double tolerance = 1e-13 * glm::length(mesh.bounds().high - mesh.bounds().low) + 1e-14;
  for (std::uint32_t control = 0; control < mesh.vertex_count(); ++control) {
    VertexRing ring = ring_at(hierarchy, positions[0], 0, control);
    std::uint32_t vertex = control;
    for (int level = 1; level <= levels; ++level) {
      vertex = hierarchy.child_of_vertex(level - 1, vertex);
      ring.step(mesh.creases().method, corners);
      VertexRing expected =
          ring_at(hierarchy, positions[static_cast<std::size_t>(level)], level, vertex);
      const std::string where =
          fmt::format("vertex {} ({} faces{}), level {}", control, ring.face_count(),
                      ring.is_boundary() ? ", boundary" : "", level);
      expect_near(ring.centre(), to_vec3(expected.centre()), tolerance, where);
      EXPECT_EQ(ring.vertex_sharpness(), expected.vertex_sharpness()) << where;
      for (std::size_t i = 0; i < ring.edges().size(); ++i) {
        const std::string edge = fmt::format("{}, edge {}", where, i);
        expect_near(ring.edges()[i], to_vec3(expected.edges()[i]), tolerance, edge);
        EXPECT_EQ(ring.edge_sharpness()[i], expected.edge_sharpness()[i]) << edge;
      }
      for (std::size_t i = 0; i < ring.centroids().size(); ++i) {
        expect_near(ring.centroids()[i], to_vec3(expected.centroids()[i]), tolerance,
                    fmt::format("{}, face {}", where, i));
      }
      if (testing::Test::HasFailure()) {
        return;
      }
    }
  }
}

/// What has been compared, so that no comparison passes for want of cases.
struct Compared {
  int positions = 0;
  int normals = 0;
  int corners = 0;
};

/// The limit of every control vertex, from its ring at level 0, beside OpenSubdiv's at the last
/// level, where nothing semi-sharp is left.
void expect_limits_meet(const ControlMesh& mesh, int levels, CornerRule corners,
                        Compared& compared) {
  const CreasingMethod method = mesh.creases().method;
  const UniformHierarchy hierarchy(mesh, levels, corners);
  const auto positions = hierarchy.positions(mesh.positions());
  const ReferenceLimits limits = hierarchy.limits(mesh.positions());
  const double tolerance = 1e-12 * mesh.bounds().diagonal();
  for (std::uint32_t control = 0; control < mesh.vertex_count(); ++control) {
    std::uint32_t vertex = control;
    for (int level = 0; level < levels; ++level) {
      vertex = hierarchy.child_of_vertex(level, vertex);
    }
    const VertexRing last = ring_at(hierarchy, positions.back(), levels, vertex);
    const Feature feature(last);
    const LimitPoint limit = ring_at(hierarchy, positions[0], 0, control).limit(method, corners);
    const std::string where = fmt::format("vertex {} ({} faces{}), {} sharp edges{}", control,
                                          last.face_count(), last.is_boundary() ? ", boundary" : "",
                                          feature.count, feature.is_corner ? ", corner" : "");
    if (!feature.is_dart()) {
      EXPECT_LE(glm::distance(limit.position, limits.positions[vertex]), tolerance) << where;
      ++compared.positions;
    }
    if (feature.has_exact_normal_mask()) {
      EXPECT_LE(angle_between(limit.normal, limits.normals[vertex]), 1e-6) << where;
      ++compared.normals;
    } else if (feature.is_corner && feature.count >= 2 && feature.first == 0) {
      const LimitPoint at_last = last.limit(method, corners);
      EXPECT_LE(angle_between(at_last.normal, limits.normals[vertex]), 1e-6) << where;
      ++compared.corners;
    }
  }
}

/// A ring with quads around as a mesh, vertex 0 in the middle, edge i to vertex 1 + i.
ControlMesh quads_of(const VertexRing& ring) {
  const std::size_t n = ring.face_count();
  const std::size_t edges = ring.edges().size();
  std::vector<glm::dvec3> positions{to_vec3(ring.centre())};
  for (const Point& edge : ring.edges()) {
    positions.push_back(to_vec3(edge));
  }
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % edges;
    positions.push_back(
        to_vec3(4.0 * ring.centroids()[i] - ring.centre() - ring.edges()[i] - ring.edges()[next]));
    faces.push_back({0, static_cast<std::uint32_t>(1 + i),
                     static_cast<std::uint32_t>(1 + edges + i),
                     static_cast<std::uint32_t>(1 + next)});
  }
  const MeshPointer mesh = control_mesh(positions, faces);
  MeshAttributes attributes;
  attributes.creases.edge_sharpness.assign(mesh->edge_count(), 0.0f);
  attributes.creases.vertex_sharpness.assign(mesh->vertex_count(), 0.0f);
  attributes.creases.vertex_sharpness[0] = ring.vertex_sharpness();
  for (std::size_t e = 0; e < mesh->edge_count(); ++e) {
    const auto [a, b] = mesh->topology().edge_vertices[e];
    if (std::min(a, b) == 0 && std::max(a, b) <= edges) {
      attributes.creases.edge_sharpness[e] = ring.edge_sharpness()[std::max(a, b) - 1];
    }
  }
  return mesh->with_attributes(std::move(attributes));
}

/// A bumpy disc or fan of n faces, no two alike.
VertexRing random_ring(std::size_t n, bool is_boundary, Random& random) {
  VertexRing ring;
  ring.reset(n, is_boundary);
  const double turn =
      (is_boundary ? std::numbers::pi : 2.0 * std::numbers::pi) / static_cast<double>(n);
  const auto point = [&](double radius, double angle) {
    const double x = radius * std::cos(angle) + 0.2 * unit(random);
    const double y = radius * std::sin(angle) + 0.2 * unit(random);
    return glm::dvec3(x, y, 0.5 * unit(random));
  };
  ring.centre() = to_point(point(0.0, 0.0));
  for (std::size_t i = 0; i < ring.edges().size(); ++i) {
    ring.edges()[i] = to_point(point(1.0, static_cast<double>(i) * turn));
  }
  for (std::size_t i = 0; i < n; ++i) {
    ring.centroids()[i] = to_point(point(0.7, (static_cast<double>(i) + 0.5) * turn));
  }
  return ring;
}

/// The ring some levels down, with the vertex moved to the origin and magnified after each.
VertexRing far_down(VertexRing ring, int levels, CornerRule corners) {
  for (int level = 0; level < levels; ++level) {
    ring.step(CreasingMethod::kUniform, corners);
    for (Point& edge : ring.edges()) {
      edge = 1.6 * (edge - ring.centre());
    }
    for (Point& centroid : ring.centroids()) {
      centroid = 1.6 * (centroid - ring.centre());
    }
    ring.centre() = Point{};
  }
  return ring;
}

/// After which OpenSubdiv's normal beside a crease has settled. With one face it is the limit's at
/// once, and loses digits: the surface bends away from its tangent by 1/2 less than it shrinks.
int levels_beside_crease(std::size_t faces) {
  return faces == 1 ? 3 : 40;
}

/// OpenSubdiv's normal in the middle of a ring, the side of a crease as the ring has it.
glm::dvec3 reference_normal(const VertexRing& ring, CornerRule corners) {
  const ControlMesh mesh = quads_of(ring);
  const UniformHierarchy hierarchy(mesh, 0, corners);
  EXPECT_EQ(hierarchy.vertex_faces(0, 0).front(), 0u);
  return hierarchy.limits(mesh.positions()).normals[0];
}

/// Open and closed, all valences, all kinds of faces.
std::vector<MeshPointer> random_meshes(Random& random) {
  std::vector<MeshPointer> meshes;
  for (std::uint32_t n = 3; n <= 12; ++n) {
    meshes.push_back(control_mesh(fan_soup(n, false, random)));
  }
  for (std::uint32_t n = 1; n <= 6; ++n) {
    meshes.push_back(control_mesh(fan_soup(n, true, random)));
  }
  meshes.push_back(control_mesh(jittered(with_mixed_faces(torus_soup(7, 5), random), 0.1, random)));
  meshes.push_back(control_mesh(jittered(with_holes(grid_soup(5, 5), 4, random), 0.3, random)));
  return meshes;
}

void expect_rings_follow(const CreasingChance& chance, unsigned seed) {
  Random random(seed);
  for (const MeshPointer& mesh : random_meshes(random)) {
    for (const CornerRule corners : {CornerRule::kSharp, CornerRule::kSmooth}) {
      expect_rings_follow(creased(*mesh, chance, random), 3, corners);
      if (testing::Test::HasFailure()) {
        return;
      }
    }
  }
}

}  // namespace

TEST(VertexRing, FollowsSmoothSurfacesOfAllValencesAndFaceSizes) {
  expect_rings_follow(CreasingChance{}, 1);
}

TEST(VertexRing, FollowsUniformCreases) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    expect_rings_follow({.edge = 0.15, .infinite = 0.2}, 100 + seed);
    expect_rings_follow({.edge = 0.5, .vertex = 0.2, .infinite = 0.2}, 200 + seed);
    expect_rings_follow({.edge = 0.3, .vertex = 0.1, .greatest = 1.2f}, 300 + seed);
  }
}

TEST(VertexRing, FollowsChaikinCreases) {
  const CreasingMethod chaikin = CreasingMethod::kChaikin;
  for (unsigned seed = 0; seed < 6; ++seed) {
    expect_rings_follow({.edge = 0.15, .infinite = 0.2, .method = chaikin}, 400 + seed);
    expect_rings_follow({.edge = 0.5, .vertex = 0.2, .infinite = 0.2, .method = chaikin},
                        500 + seed);
    expect_rings_follow({.edge = 0.4, .vertex = 0.1, .greatest = 1.4f, .method = chaikin},
                        600 + seed);
  }
}

TEST(VertexRing, LimitIsOpenSubdivs) {
  Compared compared;
  for (unsigned seed = 0; seed < 4; ++seed) {
    Random random(700 + seed);
    for (const CreasingMethod method : {CreasingMethod::kUniform, CreasingMethod::kChaikin}) {
      for (const MeshPointer& mesh : random_meshes(random)) {
        const CreasingChance chance{.edge = 0.12 * seed,
                                    .vertex = 0.05 * seed,
                                    .infinite = 0.4,
                                    .greatest = 2.0f,
                                    .method = method};
        const ControlMesh sharp = creased(*mesh, chance, random);
        expect_limits_meet(sharp, 2, CornerRule::kSharp, compared);
        expect_limits_meet(sharp, 2, CornerRule::kSmooth, compared);
      }
    }
  }
  EXPECT_GT(compared.positions, 5000);
  EXPECT_GT(compared.normals, 3000);
  EXPECT_GT(compared.corners, 300);
}

TEST(VertexRing, NormalAtABoundaryIsWhatOpenSubdivsTendsTo) {
  Random random(800);
  for (std::size_t n = 1; n <= 6; ++n) {
    const VertexRing ring = random_ring(n, true, random);
    const CornerRule corners = CornerRule::kSmooth;
    const LimitPoint limit = ring.limit(CreasingMethod::kUniform, corners);
    const VertexRing below = far_down(ring, levels_beside_crease(n), corners);
    EXPECT_LE(angle_between(limit.normal, reference_normal(below, corners)), 1e-7) << n;
  }
}

TEST(VertexRing, NormalBesideACreaseIsWhatOpenSubdivsTendsTo) {
  Random random(810);
  for (std::size_t n = 3; n <= 9; ++n) {
    for (std::size_t first = 0; first < n; ++first) {
      for (std::size_t last = first + 1; last < n; ++last) {
        VertexRing ring = random_ring(n, false, random);
        ring.edge_sharpness()[first] = ring.edge_sharpness()[last] = kInfiniteSharpness;
        const CornerRule corners = CornerRule::kSharp;
        const LimitPoint limit = ring.limit(CreasingMethod::kUniform, corners);
        const VertexRing below = far_down(ring, levels_beside_crease(last - first), corners);
        EXPECT_LE(angle_between(limit.normal, reference_normal(below, corners)), 1e-7)
            << n << " faces, " << first << " to " << last;
      }
    }
  }
}

TEST(VertexRing, DartTendsToItsLimit) {
  Random random(820);
  for (std::size_t n = 3; n <= 12; ++n) {
    VertexRing ring = random_ring(n, false, random);
    ring.edge_sharpness()[n / 2] = kInfiniteSharpness;
    const CornerRule corners = CornerRule::kSharp;
    const LimitPoint limit = ring.limit(CreasingMethod::kUniform, corners);
    const VertexRing below = far_down(ring, 200, corners);
    EXPECT_LE(angle_between(limit.normal, reference_normal(below, corners)), 1e-6) << n;
    for (int level = 0; level < 100; ++level) {
      ring.step(CreasingMethod::kUniform, corners);
    }
    expect_near(ring.centre(), limit.position, 1e-13, fmt::format("{} faces", n));
  }
}

TEST(VertexRing, LimitIsTheSameFromEveryLevel) {
  Random random(830);
  const CornerRule corners = CornerRule::kSharp;
  int normals = 0;
  for (int repeat = 0; repeat < 400; ++repeat) {
    const bool is_boundary = random() % 2 == 0;
    const std::size_t n = 2 + random() % 11;
    const CreasingMethod method =
        random() % 2 == 0 ? CreasingMethod::kUniform : CreasingMethod::kChaikin;
    VertexRing ring = random_ring(n, is_boundary, random);
    for (std::size_t i = 0; i < ring.edges().size(); ++i) {
      if (random() % 6 == 0) {
        ring.edge_sharpness()[i] = random_sharpness({.infinite = 0.4}, random);
        ring.far_sharpness()[i] = static_cast<float>(2.0 * unit(random));
      }
    }
    ring.vertex_sharpness() = random() % 6 == 0 ? random_sharpness({}, random) : 0.0f;
    const LimitPoint limit = ring.limit(method, corners);
    for (int level = 1; level <= 4; ++level) {
      ring.step(method, corners);
      const LimitPoint again = ring.limit(method, corners);
      EXPECT_LE(glm::distance(limit.position, again.position), 1e-13) << repeat;
      Feature feature(ring);
      if (level == 4 && !feature.is_corner) {
        EXPECT_NEAR(glm::length(limit.normal), 1.0, 1e-12) << repeat << ", " << n;
        EXPECT_LE(angle_between(limit.normal, again.normal), 1e-9) << repeat << ", " << n;
        ++normals;
      }
    }
  }
  EXPECT_GT(normals, 200);
}

TEST(VertexRing, TwoFacesInsideHaveTheLimitOfManySteps) {
  Random random(840);
  VertexRing ring = random_ring(2, false, random);
  const CornerRule corners = CornerRule::kSharp;
  const LimitPoint limit = ring.limit(CreasingMethod::kUniform, corners);
  EXPECT_GT(limit.normal.z, 0.5);
  for (int level = 0; level < 40; ++level) {
    ring.step(CreasingMethod::kUniform, corners);
  }
  expect_near(ring.centre(), limit.position, 1e-14, "centre");
}

TEST(VertexRing, TipOfAConeHasItsAxisForANormal) {
  constexpr std::size_t kFaces = 7;
  VertexRing ring;
  ring.reset(kFaces, false);
  ring.centre() = Point{0.0, 0.0, 2.0, 0.0};
  for (std::size_t i = 0; i < kFaces; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / kFaces;
    const double half = angle + std::numbers::pi / kFaces;
    ring.edges()[i] = Point{std::cos(angle), std::sin(angle), 0.0, 0.0};
    ring.centroids()[i] = Point{0.8 * std::cos(half), 0.8 * std::sin(half), 0.5, 0.0};
  }
  ring.vertex_sharpness() = kInfiniteSharpness;
  const LimitPoint limit = ring.limit(CreasingMethod::kUniform, CornerRule::kSharp);
  EXPECT_EQ(limit.position, glm::dvec3(0.0, 0.0, 2.0));
  EXPECT_LE(glm::distance(limit.normal, glm::dvec3(0.0, 0.0, 1.0)), 1e-12);
}

TEST(VertexRing, AllPointsAlikeHaveNoNormal) {
  VertexRing ring;
  for (const bool is_boundary : {false, true}) {
    ring.reset(5, is_boundary);
    ring.centre() = Point{3.0, 2.0, 1.0, 0.0};
    std::ranges::fill(ring.edges(), ring.centre());
    std::ranges::fill(ring.centroids(), ring.centre());
    const LimitPoint limit = ring.limit(CreasingMethod::kUniform, CornerRule::kSharp);
    EXPECT_LE(glm::distance(limit.position, glm::dvec3(3.0, 2.0, 1.0)), 1e-14);
    EXPECT_EQ(limit.normal, glm::dvec3(0.0));
  }
}

}  // namespace limn::test
