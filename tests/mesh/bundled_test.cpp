// The bundled meshes are what the generator writes, and what they promise: sound surfaces with
// exactly the boundary and the faces their descriptions speak of.
#include "limn/mesh/bundled.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <ostream>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "limn/mesh/statistics.h"
#include "limn/subdivision/crack_check.h"
#include "limn/subdivision/label_subdivision.h"
#include "support/scratch_folder.h"

namespace limn {
namespace {

using glm::dvec3;

std::shared_ptr<const ControlMesh> mesh_of(std::string_view name) {
  const Result<ImportedMesh> imported = load_bundled_mesh(name);
  if (!imported) {
    ADD_FAILURE() << to_string(imported.error());
    return nullptr;
  }
  return imported->mesh;
}

std::vector<std::uint32_t> vertices_of(const ControlMesh& mesh, std::size_t f) {
  const auto face = mesh.face(f);
  return {face.begin(), face.end()};
}

/// Twice the vector area of a polygon (Newell's method).
dvec3 area_vector(const ControlMesh& mesh, std::size_t f) {
  const std::vector<std::uint32_t> face = vertices_of(mesh, f);
  dvec3 sum(0.0);
  for (std::size_t i = 0; i < face.size(); ++i) {
    sum += glm::cross(mesh.positions()[face[i]], mesh.positions()[face[(i + 1) % face.size()]]);
  }
  return sum;
}

/// Six times the volume, each boundary loop closed by a fan around its centre.
double signed_volume(const ControlMesh& mesh) {
  const auto positions = mesh.positions();
  const FlatTopology& topology = mesh.topology();
  double volume = 0.0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const std::vector<std::uint32_t> face = vertices_of(mesh, f);
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      volume +=
          glm::dot(positions[face[0]], glm::cross(positions[face[i]], positions[face[i + 1]]));
    }
  }
  // The boundary, against the faces' direction: vertex -> the vertex before it.
  std::vector<std::uint32_t> before(positions.size(), kNone);
  for (std::size_t e = 0; e < mesh.edge_count(); ++e) {
    if (topology.edge_corners[e][1] == kNone) {
      const std::uint32_t corner = topology.edge_corners[e][0];
      const std::uint32_t face = topology.corner_faces[corner];
      const std::uint32_t next =
          corner + 1 == topology.face_offsets[face + 1] ? topology.face_offsets[face] : corner + 1;
      before[topology.corner_vertices[next]] = topology.corner_vertices[corner];
    }
  }
  for (std::uint32_t start = 0; start < before.size(); ++start) {
    std::vector<std::uint32_t> loop;
    for (std::uint32_t v = start; before[v] != kNone;) {
      loop.push_back(v);
      v = std::exchange(before[v], kNone);
    }
    dvec3 middle(0.0);
    for (const std::uint32_t v : loop) {
      middle += positions[v] / static_cast<double>(loop.size());
    }
    for (std::size_t i = 0; i < loop.size(); ++i) {
      volume +=
          glm::dot(middle, glm::cross(positions[loop[i]], positions[loop[(i + 1) % loop.size()]]));
    }
  }
  return volume;
}

/// The sine of a face's sharpest or most overstretched corner, negative where the face is not
/// convex seen along its own normal.
double flattest_corner(const ControlMesh& mesh, std::size_t f) {
  const std::vector<std::uint32_t> face = vertices_of(mesh, f);
  const auto positions = mesh.positions();
  const dvec3 normal = glm::normalize(area_vector(mesh, f));
  double flattest = 1.0;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const dvec3 here = positions[face[i]];
    const dvec3 ahead = glm::normalize(positions[face[(i + 1) % face.size()]] - here);
    const dvec3 behind =
        glm::normalize(positions[face[(i + face.size() - 1) % face.size()]] - here);
    flattest = std::min(flattest, glm::dot(normal, glm::cross(ahead, behind)));
  }
  return flattest;
}

TEST(GeneratedMeshes, AreTheOnesInTheProgram) {
  const test::ScratchFolder folder;
  const std::string command =
      std::string("'") + LIMN_GENERATE_MESHES + "' '" + folder.path().string() + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    files += entry.is_regular_file() ? 1 : 0;
  }
  EXPECT_EQ(files, bundled_meshes().size());
  for (const BundledMesh& mesh : bundled_meshes()) {
    const std::string name = std::string(mesh.name) + ".obj";
    EXPECT_FALSE(mesh.description.empty()) << name;
    EXPECT_THAT(mesh.obj_text, ::testing::StartsWith("# ")) << name;
    EXPECT_EQ(test::read_file(folder / name), mesh.obj_text) << name;
    EXPECT_EQ(test::read_file(std::filesystem::path(LIMN_ASSETS) / "meshes" / name), mesh.obj_text)
        << name;
  }
}

TEST(BundledMeshes, BeginWithTheDefault) {
  ASSERT_FALSE(bundled_meshes().empty());
  EXPECT_EQ(bundled_meshes().front().name, kDefaultMesh);
  EXPECT_TRUE(load_bundled_mesh(kDefaultMesh).has_value());
}

TEST(BundledMeshes, AnUnknownNameListsTheKnownOnes) {
  const Result<ImportedMesh> imported = load_bundled_mesh("dodo");
  ASSERT_FALSE(imported.has_value());
  EXPECT_EQ(imported.error().kind, ErrorKind::kUsage);
  for (const BundledMesh& mesh : bundled_meshes()) {
    EXPECT_THAT(imported.error().message, ::testing::HasSubstr(std::string(mesh.name)));
  }
}

/// What a mesh promises.
struct Promise {
  std::string name;
  std::map<std::size_t, std::size_t> faces_by_sides;
  std::size_t boundary_loops = 0;
  std::size_t boundary_edges = 0;
  std::size_t components = 1;
  long euler_characteristic = 2;
  std::size_t highest_valence = 4;
};

void PrintTo(const Promise& promise, std::ostream* out) {
  *out << promise.name;
}

class EveryBundledMesh : public ::testing::TestWithParam<Promise> {};

TEST_P(EveryBundledMesh, KeepsItsPromise) {
  const Promise& promise = GetParam();
  const auto mesh = mesh_of(promise.name);
  ASSERT_NE(mesh, nullptr);
  const MeshStatistics statistics = mesh_statistics(*mesh);
  EXPECT_EQ(statistics.faces_by_sides, promise.faces_by_sides);
  EXPECT_EQ(statistics.boundary_loops, promise.boundary_loops);
  EXPECT_EQ(statistics.boundary_edges, promise.boundary_edges);
  EXPECT_EQ(statistics.components, promise.components);
  EXPECT_EQ(statistics.euler_characteristic, promise.euler_characteristic);
  EXPECT_EQ(statistics.highest_valence, promise.highest_valence);
  EXPECT_EQ(mesh->is_closed(), promise.boundary_loops == 0);
}

TEST_P(EveryBundledMesh, ComesInAsItIs) {
  const Result<ImportedMesh> imported = load_bundled_mesh(GetParam().name);
  ASSERT_TRUE(imported.has_value()) << to_string(imported.error());
  EXPECT_FALSE(imported->report.is_mended());
  EXPECT_THAT(imported->report.sentences(), ::testing::IsEmpty());
}

TEST_P(EveryBundledMesh, IsTwoUnitsInSizeAroundTheOrigin) {
  const auto mesh = mesh_of(GetParam().name);
  ASSERT_NE(mesh, nullptr);
  const dvec3 size = mesh->bounds().high - mesh->bounds().low;
  const double longest = std::max({size.x, size.y, size.z});
  EXPECT_GT(longest, 1.7);
  EXPECT_LT(longest, 2.3);
  EXPECT_LT(glm::length(mesh->bounds().centre()), 0.1);
}

TEST_P(EveryBundledMesh, IsTurnedOutwards) {
  const auto mesh = mesh_of(GetParam().name);
  ASSERT_NE(mesh, nullptr);
  if (GetParam().name == "grid") {
    for (std::size_t f = 0; f < mesh->face_count(); ++f) {
      EXPECT_GT(area_vector(*mesh, f).y, 0.0) << "face " << f;
    }
  } else {
    EXPECT_GT(signed_volume(*mesh), 0.0);
  }
}

TEST_P(EveryBundledMesh, HasConvexFacesAndNoTinyEdges) {
  const auto mesh = mesh_of(GetParam().name);
  ASSERT_NE(mesh, nullptr);
  std::set<std::tuple<double, double, double>> places;
  for (const dvec3& p : mesh->positions()) {
    EXPECT_TRUE(places.insert({p.x, p.y, p.z}).second)
        << "two vertices at " << p.x << ' ' << p.y << ' ' << p.z;
  }
  for (std::size_t e = 0; e < mesh->edge_count(); ++e) {
    const auto [a, b] = mesh->topology().edge_vertices[e];
    EXPECT_GT(glm::distance(mesh->positions()[a], mesh->positions()[b]), 0.005) << "edge " << e;
  }
  for (std::size_t f = 0; f < mesh->face_count(); ++f) {
    EXPECT_GT(glm::length(area_vector(*mesh, f)), 1e-4) << "face " << f;
    EXPECT_GT(flattest_corner(*mesh, f), 0.15) << "face " << f;
  }
}

const std::vector<Promise>& promises() {
  static const std::vector<Promise> all = {
      {"creature", {{4, 1128}}, 0, 0, 1, 2, 6},
      // Body, lid, handle and spout; two poles with ten quads around each.
      {"teapot", {{4, 674}}, 6, 76, 4, 2, 10},
      {"cube", {{4, 6}}, 0, 0, 1, 2, 3},
      {"cube_triangulated", {{3, 12}}, 0, 0, 1, 2, 6},
      {"icosahedron", {{3, 20}}, 0, 0, 1, 2, 5},
      {"sphere", {{3, 32}}, 0, 0, 1, 2, 6},
      {"mixed", {{3, 20}, {4, 30}, {5, 12}}, 0, 0, 1, 2, 4},
      {"grid", {{4, 144}}, 1, 48, 1, 1, 4},
      {"torus_open", {{4, 188}}, 1, 14, 1, -1, 4},
  };
  return all;
}

INSTANTIATE_TEST_SUITE_P(Bundled, EveryBundledMesh, ::testing::ValuesIn(promises()),
                         [](const auto& instance) { return instance.param.name; });

TEST(BundledMeshes, AllHaveAPromiseInTheOrderOfTheList) {
  std::vector<std::string> promised;
  for (const Promise& promise : promises()) {
    promised.push_back(promise.name);
  }
  std::vector<std::string> bundled;
  for (const BundledMesh& mesh : bundled_meshes()) {
    bundled.emplace_back(mesh.name);
  }
  EXPECT_EQ(bundled, promised);
}

TEST(Icosahedron, LiesOnTheUnitSphereWithEqualEdges) {
  const auto mesh = mesh_of("icosahedron");
  ASSERT_NE(mesh, nullptr);
  for (const dvec3& p : mesh->positions()) {
    EXPECT_NEAR(glm::length(p), 1.0, 2e-6);
  }
  for (const auto& [a, b] : mesh->topology().edge_vertices) {
    EXPECT_NEAR(glm::distance(mesh->positions()[a], mesh->positions()[b]), 1.0514622, 4e-6);
  }
}

TEST(Sphere, LiesOnTheUnitSphereWithValencesFourAndSix) {
  const auto mesh = mesh_of("sphere");
  ASSERT_NE(mesh, nullptr);
  for (const dvec3& p : mesh->positions()) {
    EXPECT_NEAR(glm::length(p), 1.0, 2e-6);
  }
  const auto& offsets = mesh->topology().vertex_offsets;
  for (std::size_t v = 0; v < mesh->vertex_count(); ++v) {
    EXPECT_EQ(offsets[v + 1] - offsets[v], v < 6 ? 4U : 6U) << "vertex " << v;
  }
}

TEST(Rhombicosidodecahedron, LiesOnTheUnitSphereWithEqualEdges) {
  const auto mesh = mesh_of("mixed");
  ASSERT_NE(mesh, nullptr);
  for (const dvec3& p : mesh->positions()) {
    EXPECT_NEAR(glm::length(p), 1.0, 2e-6);
  }
  // Edge over circumradius: 2 / sqrt(11 + 4 sqrt(5)).
  const double edge = 2.0 / std::sqrt(11.0 + 4.0 * std::sqrt(5.0));
  for (const auto& [a, b] : mesh->topology().edge_vertices) {
    EXPECT_NEAR(glm::distance(mesh->positions()[a], mesh->positions()[b]), edge, 4e-6);
  }
}

TEST(Teapot, PassesThroughPublishedCornersOfItsPatches) {
  const auto mesh = mesh_of("teapot");
  ASSERT_NE(mesh, nullptr);
  // Corners of patches, z up: they lie on the surface, so they are vertices.
  const std::array<dvec3, 10> corners = {{{1.4, 0, 2.4},
                                          {0, -1.5, 2.4},
                                          {-2, 0, 0.9},
                                          {1.5, 0, 0.15},
                                          {0, 0, 0},
                                          {0, 0, 3.15},
                                          {0.2, 0, 2.7},
                                          {0, 1.3, 2.4},
                                          {-3, 0, 1.8},
                                          {3.3, 0, 2.4}}};
  for (const dvec3& c : corners) {
    const dvec3 expected = 0.34 * dvec3(c.x - 0.2, c.z - 1.575, -c.y);
    double nearest = std::numeric_limits<double>::max();
    for (const dvec3& p : mesh->positions()) {
      nearest = std::min(nearest, glm::distance(p, expected));
    }
    EXPECT_LT(nearest, 2e-6) << c.x << ' ' << c.y << ' ' << c.z;
  }
}

TEST(Creature, IsItsOwnMirrorImage) {
  const auto mesh = mesh_of("creature");
  ASSERT_NE(mesh, nullptr);
  std::set<std::tuple<double, double, double>> places;
  std::size_t in_plane = 0;
  for (const dvec3& p : mesh->positions()) {
    places.insert({p.x, p.y, p.z});
    in_plane += p.x == 0.0 ? 1 : 0;
  }
  for (const dvec3& p : mesh->positions()) {
    EXPECT_EQ(places.count({-p.x, p.y, p.z}), 1u) << p.x << ' ' << p.y << ' ' << p.z;
  }
  EXPECT_GT(in_plane, 20u);
  // Faces too: the area left and right of the plane is the same, point by point of y and z.
  double left = 0.0;
  double right = 0.0;
  for (std::size_t f = 0; f < mesh->face_count(); ++f) {
    dvec3 middle(0.0);
    for (const std::uint32_t v : mesh->face(f)) {
      middle += mesh->positions()[v];
    }
    (middle.x < 0.0 ? left : right) += glm::length(area_vector(*mesh, f));
  }
  EXPECT_NEAR(left, right, 1e-9);
}

TEST(Creature, RefinesItsPaintedHeadWithoutCracks) {
  const auto mesh = mesh_of("creature");
  ASSERT_NE(mesh, nullptr);
  std::vector<std::uint8_t> depths(mesh->face_count(), 0);
  std::size_t painted = 0;
  for (std::size_t f = 0; f < mesh->face_count(); ++f) {
    const bool is_head = std::ranges::all_of(
        mesh->face(f), [&](std::uint32_t v) { return mesh->positions()[v].z > 0.35; });
    depths[f] = is_head ? 2 : 0;
    painted += is_head ? 1 : 0;
  }
  EXPECT_GT(painted, mesh->face_count() / 4);
  EXPECT_LT(painted, mesh->face_count() / 2);
  IgnoreProgress progress;
  const auto legal = legal_labels(*mesh, depths, {}, progress);
  ASSERT_TRUE(legal);
  const auto refined = refine(*mesh, legal->labels, {}, {}, progress);
  ASSERT_TRUE(refined);
  EXPECT_TRUE(check_cracks(*mesh, *refined).is_watertight());
  EXPECT_GE(refined->face_count(), 16 * painted + (mesh->face_count() - painted));
  EXPECT_LT(refined->face_count(), 16 * mesh->face_count());
  // What no step reached is where it was; the head has drawn in by more than a rounding.
  double farthest = 0.0;
  for (std::size_t v = 0; v < mesh->vertex_count(); ++v) {
    const double moved = glm::distance(mesh->positions()[v], refined->position(v));
    if (refined->vertex_levels[v] == 0) {
      EXPECT_LT(moved, 1e-6) << "vertex " << v;
    }
    farthest = std::max(farthest, moved);
  }
  EXPECT_GT(farthest, 0.01);
  EXPECT_LT(farthest, 0.2);
}

/// Does the segment cross the triangle, both open?
bool crosses(const dvec3& from, const dvec3& to, const std::array<dvec3, 3>& t) {
  const dvec3 d = to - from;
  const dvec3 e1 = t[1] - t[0];
  const dvec3 e2 = t[2] - t[0];
  const dvec3 h = glm::cross(d, e2);
  const double a = glm::dot(e1, h);
  if (std::abs(a) < 1e-14) {
    return false;
  }
  const dvec3 s = from - t[0];
  const double u = glm::dot(s, h) / a;
  const dvec3 q = glm::cross(s, e1);
  const double v = glm::dot(d, q) / a;
  const double w = glm::dot(e2, q) / a;
  return u > 0.0 && v > 0.0 && u + v < 1.0 && w > 0.0 && w < 1.0;
}

TEST(Creature, DoesNotPassThroughItself) {
  const auto mesh = mesh_of("creature");
  ASSERT_NE(mesh, nullptr);
  const auto positions = mesh->positions();
  std::size_t crossings = 0;
  for (std::size_t f = 0; f < mesh->face_count(); ++f) {
    const std::vector<std::uint32_t> face = vertices_of(*mesh, f);
    dvec3 low = positions[face[0]];
    dvec3 high = low;
    for (const std::uint32_t v : face) {
      low = glm::min(low, positions[v]);
      high = glm::max(high, positions[v]);
    }
    for (const auto& [a, b] : mesh->topology().edge_vertices) {
      const dvec3& p = positions[a];
      const dvec3& q = positions[b];
      if (std::ranges::count(face, a) + std::ranges::count(face, b) > 0 ||
          glm::any(glm::lessThan(glm::max(p, q), low)) ||
          glm::any(glm::greaterThan(glm::min(p, q), high))) {
        continue;
      }
      const bool hit =
          crosses(p, q, {positions[face[0]], positions[face[1]], positions[face[2]]}) ||
          crosses(p, q, {positions[face[0]], positions[face[2]], positions[face[3]]});
      if (hit) {
        ++crossings;
        ADD_FAILURE() << "face " << f << " at " << p.x << ' ' << p.y << ' ' << p.z;
      }
    }
  }
  EXPECT_EQ(crossings, 0u);
}

}  // namespace
}  // namespace limn
