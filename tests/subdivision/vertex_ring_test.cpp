#include "subdivision/vertex_ring.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "limn/contract.h"
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

glm::dvec3 centroid(const UniformHierarchy& hierarchy, const std::vector<glm::dvec3>& positions,
                    int level, std::uint32_t face) {
  const auto vertices = hierarchy.face_vertices(level, face);
  glm::dvec3 sum(0.0);
  for (const std::uint32_t v : vertices) {
    sum += positions[v];
  }
  return sum / static_cast<double>(vertices.size());
}

std::uint32_t other_end(const UniformHierarchy& hierarchy, int level, std::uint32_t edge,
                        std::uint32_t vertex) {
  const auto [a, b] = hierarchy.edge_vertices(level, edge);
  return a == vertex ? b : a;
}

/// Of the semi-sharp edges at a vertex besides one.
float mean_sharpness_besides(const UniformHierarchy& hierarchy, int level, std::uint32_t vertex,
                             std::uint32_t edge) {
  float sum = 0.0f;
  int count = 0;
  for (const std::uint32_t other : hierarchy.vertex_edges(level, vertex)) {
    const float sharpness = hierarchy.edge_sharpness(level, other);
    if (sharpness > 0.0f && sharpness < kInfiniteSharpness) {
      sum += sharpness;
      ++count;
    }
  }
  // In OpenSubdiv's order, since sharpness is a float.
  return count < 2 ? 0.0f
                   : (sum - hierarchy.edge_sharpness(level, edge)) / static_cast<float>(count - 1);
}

VertexRing ring_at(const UniformHierarchy& hierarchy, const std::vector<glm::dvec3>& positions,
                   int level, std::uint32_t vertex) {
  const auto edges = hierarchy.vertex_edges(level, vertex);
  const auto faces = hierarchy.vertex_faces(level, vertex);
  VertexRing ring;
  ring.reset(faces.size(), edges.size() > faces.size());
  ring.centre() = to_point(positions[vertex]);
  ring.vertex_sharpness() = hierarchy.vertex_sharpness(level, vertex);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const std::uint32_t far = other_end(hierarchy, level, edges[i], vertex);
    ring.edges()[i] = to_point(positions[far]);
    ring.edge_sharpness()[i] = hierarchy.edge_sharpness(level, edges[i]);
    if (ring.edge_sharpness()[i] > 0.0f && ring.edge_sharpness()[i] < kInfiniteSharpness) {
      ring.far_sharpness()[i] = mean_sharpness_besides(hierarchy, level, far, edges[i]);
    }
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    ring.centroids()[i] = to_point(centroid(hierarchy, positions, level, faces[i]));
  }
  return ring;
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

}  // namespace limn::test
