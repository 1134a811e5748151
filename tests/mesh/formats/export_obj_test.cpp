#include "limn/mesh/export.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/mesh/import.h"
#include "mesh/mesh_checks.h"
#include "support/attribute_shapes.h"
#include "support/scratch_folder.h"

namespace limn {
namespace {

using test::faces_of;
using testing::HasSubstr;
using testing::IsEmpty;

template <class Mesh>
std::string text_of(const Mesh& mesh, const std::vector<std::uint8_t>& depths) {
  std::ostringstream out;
  write_mesh(out, MeshFormat::kObj, mesh, {.depths = depths});
  return out.str();
}

/// Two quads and a pentagon between them, made of three control faces.
RefinedMesh strip() {
  RefinedMesh mesh;
  mesh.positions = {{0, 0, 0},      {1, 0, 0}, {1, 1, 0},      {0, 1, 0},       {2, 0, 0.1F},
                    {2.5F, .5F, 0}, {2, 1, 0}, {3, 0, 1e-20F}, {3, 1, -1.5e10F}};
  mesh.vertex_levels.assign(9, 0);
  mesh.quads = {{0, 1, 2, 3}, {5, 4, 7, 8}};
  mesh.polygon_offsets = {0, 5};
  mesh.polygon_vertices = {1, 4, 5, 6, 2};
  mesh.face_control_faces = {0, 2, 1};
  mesh.face_levels = {1, 1, 0};
  return mesh;
}

TEST(WriteObj, RefinedMeshWithItsDepthGroups) {
  EXPECT_EQ(text_of(strip(), {2, 0, 2}),
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0.1\nv 2.5 0.5 0\nv 2 1 0\nv 3 0 1e-20\n"
            "v 3 1 -15000000000\nusemtl depth_2\nf 1 2 3 4\nf 6 5 8 9\nusemtl depth_0\n"
            "f 2 5 6 7 3\n");
  EXPECT_THAT(text_of(strip(), {}), testing::Not(HasSubstr("usemtl")));
}

TEST(WriteObj, ControlMeshComesBackBitForBit) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> mantissas(-1.0, 1.0);
  std::uniform_int_distribution<int> exponents(-300, 55);
  PolygonSoup soup;
  constexpr std::uint32_t columns = 40;
  for (std::uint32_t i = 0; i < columns * columns; ++i) {
    const auto number = [&] { return std::ldexp(mantissas(random), exponents(random)); };
    soup.positions.emplace_back(number(), number(), i % 3 == 0 ? -0.0 : number());
  }
  for (std::uint32_t r = 0; r + 1 < columns; ++r) {
    for (std::uint32_t c = 0; c + 1 < columns; ++c) {
      const std::uint32_t v = r * columns + c;
      if ((r + c) % 5 == 0) {
        soup.add_face(std::vector<std::uint32_t>{v + columns, v, v + 1});
        soup.add_face(std::vector<std::uint32_t>{v + 1, v + columns + 1, v + columns});
      } else {
        soup.add_face(std::vector<std::uint32_t>{v + columns + 1, v + columns, v, v + 1});
      }
    }
  }
  const auto built = build_control_mesh(soup);
  ASSERT_TRUE(built.has_value());
  const ControlMesh& mesh = *built->mesh;
  std::vector<std::uint8_t> depths(mesh.face_count());
  for (std::size_t f = 0; f < depths.size(); ++f) {
    depths[f] = static_cast<std::uint8_t>(f % 4);
  }
  const std::string text = text_of(mesh, depths);
  const auto again = import_obj(text, "written");
  ASSERT_TRUE(again.has_value()) << to_string(again.error());
  EXPECT_FALSE(again->report.is_mended());
  EXPECT_EQ(faces_of(*again->mesh), faces_of(mesh));
  ASSERT_EQ(again->mesh->vertex_count(), mesh.vertex_count());
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      const double was = mesh.positions()[v][axis];
      const double is = again->mesh->positions()[v][axis];
      ASSERT_EQ(is, was);
      ASSERT_EQ(std::signbit(is), std::signbit(was));
    }
  }
  EXPECT_EQ(text_of(*again->mesh, depths), text);
}

TEST(WriteObj, FloatsComeBackBitForBit) {
  RefinedMesh mesh = strip();
  std::mt19937 random(4);
  std::uniform_real_distribution<float> numbers(-3.0F, 3.0F);
  for (auto& p : mesh.positions) {
    p = {numbers(random), numbers(random), numbers(random)};
  }
  const auto again = import_obj(text_of(mesh, {}), "written");
  ASSERT_TRUE(again.has_value());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_EQ(glm::vec3(again->mesh->positions()[v]), mesh.positions[v]);
  }
}

TEST(WriteObj, RefinedMeshWithAllItCarries) {
  RefinedMesh mesh = strip();
  mesh.creases = {{{1, 2}, 0.7F}, {{4, 5}, kInfiniteSharpness}};
  mesh.corners = {{3, 1.5F}};
  mesh.creasing = CreasingMethod::kChaikin;
  mesh.corner_rule = CornerRule::kSmooth;
  EXPECT_THAT(text_of(mesh, {}), testing::EndsWith("f 1 2 3 4\nf 6 5 8 9\nf 2 5 6 7 3\n"
                                                   "t crease 2/1/0 1 2 0.7\n"
                                                   "t crease 2/1/0 4 5 10\n"
                                                   "t corner 1/1/0 3 1.5\n"
                                                   "t interpolateboundary 1/0/0 2\n"
                                                   "t creasemethod 0/0/1 chaikin\n"));
  mesh.normals.assign(9, {0.0F, 0.0F, 1.0F});
  EXPECT_THAT(text_of(mesh, {}), HasSubstr("\nvn 0 0 1\nf 1//1 2//2 3//3 4//4\n"));
  mesh.uvs = {{0.0F, 0.0F}, {0.5F, 0.0F}, {0.5F, 0.1F}};
  mesh.quad_uvs = {{0, 1, 2, 0}, {2, 2, 1, 0}};
  mesh.polygon_uvs = {0, 1, 1, 2, 2};
  EXPECT_THAT(text_of(mesh, {}), HasSubstr("\nvt 0 0\nvt 0.5 0\nvt 0.5 0.1\nvn 0 0 1\n"));
  EXPECT_THAT(text_of(mesh, {}), HasSubstr("\nf 1/1/1 2/2/2 3/3/3 4/1/4\n"));
  mesh.normals.clear();
  EXPECT_THAT(text_of(mesh, {}),
              HasSubstr("\nf 1/1 2/2 3/3 4/1\nf 6/3 5/3 8/2 9/1\nf 2/1 5/2 6/2 7/3 3/3\n"));
}

TEST(WriteObj, AttributesComeBackBitForBit) {
  std::vector<test::NamedShape> shapes = test::creased_shapes();
  for (test::NamedShape& shape : test::textured_shapes()) {
    shapes.push_back(std::move(shape));
  }
  test::Random random(7);
  for (int i = 0; i < 20; ++i) {
    const auto soup = test::with_mixed_faces(test::torus_soup(8, 7), random);
    const auto creased = test::with_random_creases(*test::control_mesh(soup), 0.3, 0.1, random);
    shapes.push_back(
        {"random " + std::to_string(i), test::with_random_charts(*creased, 4, random)});
  }
  for (const CornerRule rule : {CornerRule::kSharp, CornerRule::kSmooth}) {
    MeshAttributes attributes = test::grid(2)->attributes();
    attributes.corners = rule;
    shapes.push_back({"corner rule", std::make_shared<const ControlMesh>(
                                         test::grid(2)->with_attributes(attributes))});
  }
  for (const auto& [name, mesh] : shapes) {
    SCOPED_TRACE(name);
    const auto again = import_obj(text_of(*mesh, {}), "written");
    ASSERT_TRUE(again.has_value()) << to_string(again.error());
    EXPECT_THAT(again->report.sentences(), IsEmpty());
    EXPECT_EQ(faces_of(*again->mesh), faces_of(*mesh));
    EXPECT_EQ(again->mesh->creases(), mesh->creases());
    EXPECT_EQ(again->mesh->texture(), mesh->texture());
    EXPECT_EQ(again->mesh->attributes().corners, mesh->attributes().corners);
    EXPECT_EQ(text_of(*again->mesh, {}), text_of(*mesh, {}));
  }
}

TEST(WriteObj, AMeshWithAnOriginComesBackInWorldCoordinates) {
  RefinedMesh mesh = strip();
  mesh.origin = {1e9, -2e6, 0.0};
  mesh.positions[0] = {0.1F, 0.25F, -0.1F};
  const std::string text = text_of(mesh, {});
  EXPECT_THAT(text, testing::StartsWith("v 1000000000.1 -1999999.75 -0.10000000149011612\n"
                                        "v 1000000001 -2000000 0\n"));
  const auto again = import_obj(text, "written");
  ASSERT_TRUE(again.has_value());
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_EQ(again->mesh->positions()[v], mesh.position(v)) << "vertex " << v;
  }
}

class ExportObj : public testing::Test {
 protected:
  const test::ScratchFolder folder_;
};

TEST_F(ExportObj, WritesWhatWriteObjWrites) {
  const std::vector<std::uint8_t> depths = {1, 2, 3};
  ASSERT_TRUE(export_mesh(folder_ / "strip.obj", strip(), {.depths = depths}).has_value());
  EXPECT_EQ(test::read_file(folder_ / "strip.obj"), text_of(strip(), depths));

  const auto imported = import_mesh(folder_ / "strip.obj");
  ASSERT_TRUE(imported.has_value());
  ASSERT_TRUE(export_mesh(folder_ / "again.obj", *imported->mesh).has_value());
  const auto again = import_mesh(folder_ / "again.obj");
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(faces_of(*again->mesh), faces_of(*imported->mesh));
}

TEST_F(ExportObj, FailsWithThePath) {
  const auto written = export_mesh(folder_ / "missing" / "strip.obj", strip());
  ASSERT_FALSE(written.has_value());
  EXPECT_EQ(written.error().kind, ErrorKind::kFailed);
  EXPECT_THAT(to_string(written.error()), HasSubstr("missing/strip.obj: "));
}

TEST(RefinedMesh, BecomesAHalfedgeMeshWithTheSameNumbers) {
  const RefinedMesh mesh = strip();
  const HalfedgeMesh halfedges = to_halfedge_mesh(mesh);
  EXPECT_THAT(test::link_faults_of(halfedges), IsEmpty());
  ASSERT_EQ(halfedges.n_faces(), 3U);
  ASSERT_EQ(halfedges.n_vertices(), 9U);
  for (std::size_t f = 0; f < 3; ++f) {
    std::vector<std::uint32_t> vertices;
    for (const auto v : halfedges.fv_range(OpenMesh::FaceHandle(static_cast<int>(f)))) {
      vertices.push_back(static_cast<std::uint32_t>(v.idx()));
    }
    const auto face = mesh.face(f);
    EXPECT_EQ(vertices, std::vector<std::uint32_t>(face.begin(), face.end()));
  }
  EXPECT_EQ(halfedges.point(OpenMesh::VertexHandle(4))[2], double{0.1F});
  EXPECT_EQ(mesh.bytes(), 9 * 12 + 9 + 2 * 16 + 2 * 4 + 5 * 4 + 3 * 4 + 3U);
}

TEST(RefinedMesh, BecomesAControlMeshWithAllItCarries) {
  RefinedMesh mesh = strip();
  mesh.origin = {1e9, -2e6, 0.5};
  mesh.creases = {{{2, 1}, 0.7F}, {{4, 5}, kInfiniteSharpness}};
  mesh.corners = {{3, 1.5F}};
  mesh.creasing = CreasingMethod::kChaikin;
  mesh.corner_rule = CornerRule::kSmooth;
  mesh.uvs = {{0.0F, 0.0F}, {0.5F, 0.0F}, {0.5F, 0.1F}};
  mesh.quad_uvs = {{0, 1, 2, 0}, {2, 2, 1, 0}};
  mesh.polygon_uvs = {0, 1, 1, 2, 2};
  const auto control = to_control_mesh(mesh);
  EXPECT_THAT(test::faults_of(*control), IsEmpty());
  EXPECT_EQ(faces_of(*control),
            (std::vector<std::vector<std::uint32_t>>{{0, 1, 2, 3}, {5, 4, 7, 8}, {1, 4, 5, 6, 2}}));
  EXPECT_EQ(control->positions()[5], mesh.position(5));
  ASSERT_EQ(control->creases().edge_sharpness.size(), control->edge_count());
  for (std::size_t e = 0; e < control->edge_count(); ++e) {
    const auto [a, b] = control->topology().edge_vertices[e];
    const std::pair<std::uint32_t, std::uint32_t> ends = std::minmax(a, b);
    EXPECT_EQ(control->creases().edge_sharpness[e], ends == std::pair(1U, 2U)   ? 0.7F
                                                    : ends == std::pair(4U, 5U) ? kInfiniteSharpness
                                                                                : 0.0F);
  }
  EXPECT_THAT(control->creases().vertex_sharpness,
              testing::ElementsAre(0, 0, 0, 1.5F, 0, 0, 0, 0, 0));
  EXPECT_EQ(control->creases().method, CreasingMethod::kChaikin);
  EXPECT_EQ(control->attributes().corners, CornerRule::kSmooth);
  EXPECT_THAT(control->texture().corner_values,
              testing::ElementsAre(0, 1, 2, 0, 2, 2, 1, 0, 0, 1, 1, 2, 2));
  EXPECT_EQ(control->texture().values[2], glm::dvec2(0.5, double{0.1F}));
}

TEST(RefinedMesh, BecomesAHalfedgeMeshInWorldCoordinates) {
  RefinedMesh mesh = strip();
  mesh.origin = {1e9, -2e6, 0.5};
  const HalfedgeMesh halfedges = to_halfedge_mesh(mesh);
  const auto& point = halfedges.point(OpenMesh::VertexHandle(5));
  EXPECT_EQ(glm::dvec3(point[0], point[1], point[2]), glm::dvec3(1e9 + 2.5, -2e6 + 0.5, 0.5));
  EXPECT_EQ(mesh.position(5), glm::dvec3(1e9 + 2.5, -2e6 + 0.5, 0.5));
}

}  // namespace
}  // namespace limn
