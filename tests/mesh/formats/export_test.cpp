// What goes out with a mesh, and what is said to stay behind.
#include <cstdint>
#include <filesystem>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/mesh/export.h"
#include "limn/mesh/import.h"
#include "support/mesh_difference.h"
#include "support/scratch_folder.h"
#include "support/shapes.h"

namespace limn {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A waved grid of 12 x 9 quads with everything a mesh can have, at places that need all digits.
test::MeshPointer rich_mesh() {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> numbers(-1.0, 1.0);
  PolygonSoup soup = test::grid_soup(12, 9);
  for (glm::dvec3& p : soup.positions) {
    p += glm::dvec3(0.1 * numbers(random), 0.1 * numbers(random), numbers(random));
  }
  for (std::size_t c = 0; c < soup.face_vertices.size(); ++c) {
    soup.uvs.emplace_back(numbers(random), numbers(random));
    soup.face_uvs.push_back(static_cast<std::uint32_t>(c));
  }
  soup.positions.emplace_back(0.1, 0.2, 7.3);  // In no face.
  soup.creases = {{{0, 1}, 2.5f}, {{1, 2}, 10.0f}};
  soup.corners = {{5, 0.3f}};
  soup.corner_rule = CornerRule::kSmooth;
  soup.creasing = CreasingMethod::kChaikin;
  soup.names.objects = {{"box", "lid"}, {}};
  soup.names.groups = {{"left side"}, {}};
  soup.names.material_libraries = {"some where.mtl"};
  for (std::uint32_t f = 0; f < soup.face_count(); ++f) {
    soup.names.objects.of_faces.push_back(f < 20 ? 0 : 1);
    soup.names.groups.of_faces.push_back(f % 3 == 0 ? 0 : kNone);
  }
  return build_control_mesh(soup).value().mesh;
}

test::MeshPointer with_materials(const ControlMesh& mesh) {
  MeshAttributes attributes = mesh.attributes();
  attributes.names.materials = {{"red", "depth_red"}, {}};
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    attributes.names.materials.of_faces.push_back(f < 50 ? 0 : 1);
  }
  return std::make_shared<const ControlMesh>(mesh.with_attributes(std::move(attributes)));
}

std::vector<std::uint8_t> banded_depths(const ControlMesh& mesh) {
  std::vector<std::uint8_t> depths(mesh.face_count());
  for (std::size_t f = 0; f < depths.size(); ++f) {
    depths[f] = static_cast<std::uint8_t>(f / 5 % 3);
  }
  return depths;
}

template <class Mesh>
std::string exported(MeshFormat format, const Mesh& mesh, const ExportSettings& settings) {
  std::ostringstream out;
  write_mesh(out, format, mesh, settings);
  return out.str();
}

TEST(Export, EverythingComesBackThroughObj) {
  const test::MeshPointer plain = rich_mesh();
  for (const test::MeshPointer& mesh : {plain, with_materials(*plain)}) {
    const std::vector<std::uint8_t> depths = banded_depths(*mesh);
    const std::string text = exported(MeshFormat::kObj, *mesh, {.depths = depths});
    const bool has_materials = mesh != plain;
    EXPECT_EQ(text.find("usemtl depth_2") == std::string::npos, has_materials);
    EXPECT_EQ(text.find("t limn_depth 1/0/0 2") == std::string::npos, !has_materials);
    const auto again = import_bytes(text, MeshFormat::kObj, "written");
    ASSERT_TRUE(again.has_value()) << to_string(again.error());
    EXPECT_EQ(test::difference(*mesh, *again->mesh), "");
    EXPECT_THAT(again->depths, testing::ElementsAreArray(depths));
    EXPECT_THAT(again->report.unused_data, IsEmpty());
    EXPECT_THAT(lost_in(MeshFormat::kObj, *mesh, {.depths = depths}), IsEmpty());
  }
}

TEST(Export, EverythingButNamesComesBackThroughPly) {
  const test::MeshPointer mesh = rich_mesh();
  const std::vector<std::uint8_t> depths = banded_depths(*mesh);
  ExportSettings settings{.depths = depths};
  for (const bool is_text : {false, true}) {
    settings.is_text = is_text;
    const auto again =
        import_bytes(exported(MeshFormat::kPly, *mesh, settings), MeshFormat::kPly, "written");
    ASSERT_TRUE(again.has_value()) << to_string(again.error());
    EXPECT_EQ(test::difference(*mesh, *again->mesh, {.names = false}), "");
    EXPECT_THAT(again->depths, testing::ElementsAreArray(depths));
    EXPECT_THAT(again->report.unused_data, IsEmpty());
  }
  EXPECT_THAT(lost_in(MeshFormat::kPly, *mesh, settings), ElementsAre("2 object names", "1 group"));
}

TEST(Export, WhatIsLostIsSaid) {
  const test::MeshPointer mesh = rich_mesh();
  const std::vector<std::uint8_t> depths = banded_depths(*mesh);
  const ExportSettings settings{.depths = depths};
  EXPECT_THAT(lost_in(MeshFormat::kOff, *mesh, settings),
              ElementsAre("2 object names", "1 group", "2 creases", "1 sharp corner",
                          "the rule for boundary corners", "the painted depths",
                          "texture coordinates, which have seams"));
  EXPECT_EQ(loss_sentence(MeshFormat::kStl, lost_in(MeshFormat::kStl, *mesh, settings)),
            "STL files do not hold: 2 object names, 1 group, 2 creases, 1 sharp corner, the rule "
            "for boundary corners, the painted depths, texture coordinates, 1 vertex in no face, "
            "108 faces that are no triangles (they are cut into triangles) and digits of "
            "coordinates beyond single precision.");
  EXPECT_EQ(loss_sentence(MeshFormat::kObj, {}), "");
  const auto cube = test::control_mesh(test::cube_soup());
  EXPECT_THAT(lost_in(MeshFormat::kPly, *cube), IsEmpty());
  EXPECT_THAT(lost_in(MeshFormat::kOff, *cube), IsEmpty());
  EXPECT_THAT(lost_in(MeshFormat::kStl, *cube).size(), 1U);
}

/// Two quads of the first face of a cube and a triangle of its second.
RefinedMesh refined_piece() {
  RefinedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0.1F}, {2, 1, 0}};
  mesh.quads = {{0, 1, 2, 3}, {1, 4, 5, 2}};
  mesh.polygon_offsets = {0, 3};
  mesh.polygon_vertices = {3, 2, 5};
  mesh.face_control_faces = {0, 0, 1};
  return mesh;
}

TEST(Export, RefinedFacesAreCalledAsTheirControlFaces) {
  PolygonSoup soup = test::cube_soup();
  soup.names.groups = {{"floor", "walls"}, {0, 1, 1, 1, 1, 1}};
  soup.positions.emplace_back(9.0, 9.0, 9.0);
  const auto control = test::control_mesh(soup);
  const std::vector<std::uint8_t> depths{3, 0, 0, 0, 0, 0};
  const ExportSettings settings{.depths = depths, .control = control.get()};
  EXPECT_EQ(exported(MeshFormat::kObj, refined_piece(), settings),
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0.1\nv 2 1 0\nv 9 9 9\n"
            "g floor\nusemtl depth_3\nf 1 2 3 4\nf 2 5 6 3\ng walls\nusemtl depth_0\nf 4 3 6\n");
  EXPECT_THAT(lost_in(MeshFormat::kOff, refined_piece(), settings),
              ElementsAre("2 groups", "the painted depths"));
  EXPECT_EQ(exported(MeshFormat::kOff, refined_piece(), settings),
            "OFF\n7 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0.1\n2 1 0\n9 9 9\n"
            "4 0 1 2 3\n4 1 4 5 2\n3 3 2 5\n");
}

TEST(Export, TheEndingTellsTheFormat) {
  const test::ScratchFolder scratch;
  const auto cube = test::control_mesh(test::cube_soup());
  for (const char* name : {"a.obj", "a.PLY", "a.Off", "a.stl"}) {
    const auto path = scratch.path() / name;
    ASSERT_TRUE(export_mesh(path, *cube).has_value());
    const auto again = import_mesh(path);
    ASSERT_TRUE(again.has_value()) << to_string(again.error());
    EXPECT_EQ(again->mesh->vertex_count(), 8U);
  }
  ASSERT_TRUE(export_mesh(scratch.path() / "a.mesh", *cube, {}, MeshFormat::kOff).has_value());
  EXPECT_THAT(test::read_file(scratch.path() / "a.mesh"), testing::StartsWith("OFF\n8 6 0\n"));
  const auto refused = export_mesh(scratch.path() / "a.fbx", *cube);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().kind, ErrorKind::kUsage);
  EXPECT_THAT(refused.error().message, HasSubstr("\".fbx\""));
}

TEST(Export, MaterialsOfDepthsComeWithTheirColours) {
  const test::ScratchFolder scratch;
  const auto cube = test::control_mesh(test::cube_soup());
  const std::vector<glm::u8vec3> colours{{255, 255, 255}, {0, 51, 255}};
  const std::vector<std::uint8_t> depths{0, 2, 0, 0, 0, 0};
  const auto library = scratch.path() / "limn_depths.mtl";
  const ExportSettings settings{.depths = depths, .depth_colours = colours};
  ASSERT_TRUE(export_mesh(scratch.path() / "a.ply", *cube, settings).has_value());
  EXPECT_FALSE(std::filesystem::exists(library));
  ASSERT_TRUE(export_mesh(scratch.path() / "a.obj", *cube, settings).has_value());
  EXPECT_EQ(test::read_file(library),
            "newmtl depth_0\nKd 1.000 1.000 1.000\nnewmtl depth_1\nKd 0.000 0.200 1.000\n"
            "newmtl depth_2\nKd 0.000 0.200 1.000\n");
  EXPECT_THAT(test::read_file(scratch.path() / "a.obj"),
              testing::StartsWith("mtllib limn_depths.mtl\nv "));
  // Limn's own library is no library of the mesh.
  const auto again = import_mesh(scratch.path() / "a.obj");
  EXPECT_TRUE(again->mesh->attributes().names.empty());
  EXPECT_THAT(again->depths, testing::ElementsAreArray(depths));
}

}  // namespace
}  // namespace limn
