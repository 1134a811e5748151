// What the second version of the project format brought: creases, corners, texture coordinates, and
// the settings that go with them.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "document/project_fixture.h"
#include "limn/document/commands.h"
#include "support/attribute_shapes.h"

namespace limn {
namespace {

using ProjectAttributes = test::ProjectFixture;
using test::expect_same_document;
using test::opened;
using test::read_file;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST_F(ProjectAttributes, AttributesComeBackBitForBit) {
  std::vector<test::NamedShape> shapes = test::creased_shapes();
  for (test::NamedShape& shape : test::textured_shapes()) {
    shapes.push_back(std::move(shape));
  }
  test::Random random(5);
  const auto creased = test::with_random_creases(*test::mixed_prism(), 0.5, 0.5, random);
  shapes.push_back({"random", test::with_random_charts(*creased, 3, random)});
  for (const auto& [name, mesh] : shapes) {
    SCOPED_TRACE(name);
    Document document = make_document({mesh, {}}, name);
    MeshAttributes smooth = mesh->attributes();
    smooth.corners = CornerRule::kSmooth;
    smooth.creases = {};
    attributes_command(std::make_shared<const ControlMesh>(mesh->with_attributes(smooth)), "other")
        ->apply(document);
    ASSERT_TRUE(save_project(path_, document, std::nullopt));
    EXPECT_THAT(read_file(path_), HasSubstr("\"version\": 2,"));
    const Result<Project> loaded = load_project(path_);
    ASSERT_TRUE(loaded) << to_string(loaded.error());
    expect_same_document(document, loaded->document);
  }
}

TEST_F(ProjectAttributes, SettingsOfLaterVersionsComeBack) {
  for (const SurfacePoints points : {SurfacePoints::kLevel, SurfacePoints::kLimit}) {
    for (const TextureRule texture : {TextureRule::kSmoothInside, TextureRule::kLinear}) {
      Document document = opened("cube");
      document.settings.legalisation = LegalisationMethod::kGreedy;
      document.settings.points = points;
      document.settings.texture = texture;
      ASSERT_TRUE(save_project(path_, document, std::nullopt));
      EXPECT_THAT(read_file(path_),
                  HasSubstr(points == SurfacePoints::kLevel && texture == TextureRule::kSmoothInside
                                ? "\"version\": 1,"
                                : "\"version\": 2,"));
      expect_same_document(document, load_project(path_).value().document);
    }
  }
  EXPECT_THAT(
      complaint_with("\"corners\": \"sharp\"", "\"corners\": \"sharp\", \"positions\": \"limbo\""),
      StartsWith("/settings/positions: must be one of"));
  EXPECT_THAT(complaint_with("\"corners\": \"sharp\"", "\"corners\": \"sharp\", \"texture\": 1"),
              StartsWith("/settings/texture: "));
}

TEST_F(ProjectAttributes, LookingAheadIsOfTheSecondVersion) {
  const Document document = opened("cube");
  ASSERT_EQ(document.settings.legalisation, LegalisationMethod::kLookAhead);
  ASSERT_TRUE(save_project(path_, document, std::nullopt));
  EXPECT_THAT(read_file(path_), HasSubstr("\"version\": 2,"));
  expect_same_document(document, load_project(path_).value().document);
}

TEST_F(ProjectAttributes, WithoutAttributesItIsWrittenForOlderProgramsToo) {
  EXPECT_THAT(cube_text(), HasSubstr("\"version\": 1,"));
}

TEST_F(ProjectAttributes, TheSavedBoundaryRuleWinsOverTheMeshs) {
  MeshAttributes attributes;
  attributes.corners = CornerRule::kSmooth;
  const auto mesh = std::make_shared<const ControlMesh>(test::grid(2)->with_attributes(attributes));
  Document document = make_document({mesh, {}}, "grid");
  EXPECT_EQ(document.settings.corners, CornerRule::kSmooth);
  document.settings.corners = CornerRule::kSharp;
  ASSERT_TRUE(save_project(path_, document, std::nullopt));
  EXPECT_EQ(load_project(path_).value().document.settings.corners, CornerRule::kSharp);
}

TEST_F(ProjectAttributes, NamesAndLooseVerticesComeBackByteForByte) {
  MeshAttributes attributes;
  attributes.names.objects = {{"a \"b\"", "", "B\xC3\xA4r"}, {0, 1, 2, kNone, 0, 0}};
  attributes.names.groups = {
      {"caf\xE9", "\xEF\x9E\x80\xEF\x9F\xBF", std::string("\0\n", 2), "\xF0\x9F"},
      {0, 1, 2, 3, kNone, kNone}};
  attributes.names.materials = {{"unused"}, std::vector<std::uint32_t>(6, kNone)};
  attributes.names.material_libraries = {"c d.mtl", "\x80\xFF"};
  attributes.loose_vertices = {{1, 2, 3}, {-0.0, 1e-300, 1.0 / 3.0}};
  const auto mesh = std::make_shared<const ControlMesh>(test::cube()->with_attributes(attributes));
  Document document = make_document({mesh, {}}, "cube");
  ASSERT_TRUE(save_project(path_, document, std::nullopt));
  EXPECT_THAT(read_file(path_), HasSubstr("\"version\": 4,"));
  const Result<Project> loaded = load_project(path_);
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  expect_same_document(document, loaded->document);
  // Only in the mesh that Revert goes back to.
  replace_control_command(test::grid(2), "apply")->apply(document);
  ASSERT_TRUE(save_project(path_, document, std::nullopt));
  EXPECT_THAT(read_file(path_), HasSubstr("\"version\": 4,"));
  expect_same_document(document, load_project(path_).value().document);
}

TEST_F(ProjectAttributes, NamesTheCulpritAmongTheNames) {
  const auto with = [&](std::string_view members) {
    return complaint_with("\"mesh\": {", "\"mesh\": {" + std::string(members) + ", ");
  };
  const std::string names = "\"group_names\": [\"a\", \"b\"]";
  EXPECT_EQ(with(names + ", \"face_groups\": [0, 1, -1, 0, 0, 1]"), "was loaded");
  EXPECT_THAT(with(names), StartsWith("/mesh/face_groups: is missing"));
  EXPECT_THAT(with("\"face_groups\": [-1, -1, -1, -1, -1, -1]"),
              StartsWith("/mesh/group_names: is missing"));
  EXPECT_THAT(with(names + ", \"face_groups\": [0, 1]"),
              StartsWith("/mesh/face_groups: has 2 entries for 6 faces"));
  EXPECT_THAT(with(names + ", \"face_groups\": [0, 1, 2, 0, 0, 0]"),
              StartsWith("/mesh/face_groups/2: there is no name 2"));
  EXPECT_THAT(with(names + ", \"face_groups\": [0, 1, -2, 0, 0, 0]"),
              StartsWith("/mesh/face_groups/2: must be the number of a name"));
  EXPECT_THAT(with(names + ", \"face_groups\": [0, [1], 0, 0, 0, 0]"),
              StartsWith("/mesh/face_groups/1: "));
  EXPECT_THAT(with("\"object_names\": [\"a\", 3]"), StartsWith("/mesh/object_names/1: must be a"));
  EXPECT_THAT(with("\"object_names\": \"a\""), StartsWith("/mesh/object_names: must be a list"));
  EXPECT_THAT(with("\"material_libraries\": [{\"a\": 1}]"),
              StartsWith("/mesh/material_libraries/0: must be a name"));
  EXPECT_THAT(with("\"loose_vertices\": [[1, 2]]"),
              StartsWith("/mesh/loose_vertices/0: has 2 coordinates"));
}

TEST_F(ProjectAttributes, NamesTheCulpritInTheAttributes) {
  const auto with = [&](std::string_view members) {
    return complaint_with("\"mesh\": {", "\"mesh\": {" + std::string(members) + ", ");
  };
  EXPECT_EQ(with("\"creases\": [[0, 1, 2.5]], \"corners\": [[7, 1]], \"creasing\": \"chaikin\", "
                 "\"boundary_corners\": \"sharp\""),
            "was loaded");
  EXPECT_EQ(with("\"creases\": [], \"corners\": [], \"other\": 3"), "was loaded");
  EXPECT_THAT(with("\"creases\": [[0, 1]]"), StartsWith("/mesh/creases/0: has 2 entries"));
  EXPECT_THAT(with("\"creases\": [0, 1, 2]"), StartsWith("/mesh/creases/0: must be a list of two"));
  EXPECT_THAT(with("\"creases\": 3"), StartsWith("/mesh/creases: must be a list"));
  EXPECT_THAT(with("\"creases\": [[0, 8, 1]]"), StartsWith("/mesh/creases/0/1: "));
  EXPECT_THAT(with("\"creases\": [[0, 1, 1], [0, 1.5, 1]]"), StartsWith("/mesh/creases/1/1: "));
  EXPECT_THAT(with("\"creases\": [[-1, 1, 1]]"), StartsWith("/mesh/creases/0/0: "));
  EXPECT_THAT(with("\"creases\": [[0, 1, -1]]"), StartsWith("/mesh/creases/0/2: must be a sharp"));
  EXPECT_THAT(with("\"creases\": [[0, 1, \"inf\"]]"),
              StartsWith("/mesh/creases/0/2: must be a num"));
  EXPECT_THAT(with("\"creases\": [[0, 6, 1]]"), HasSubstr("is damaged"));  // No edge.
  EXPECT_THAT(with("\"corners\": [[8, 1]]"), StartsWith("/mesh/corners/0/0: "));
  EXPECT_THAT(with("\"corners\": [[1, 1e39]]"), StartsWith("/mesh/corners/0/1: "));
  EXPECT_THAT(with("\"corners\": [[1, 1]], \"corners\": []"), HasSubstr("twice"));
  EXPECT_THAT(with("\"creasing\": \"other\""), StartsWith("/mesh/creasing: must be one of"));
  EXPECT_THAT(with("\"boundary_corners\": 1"), StartsWith("/mesh/boundary_corners: "));

  const std::string faces =
      "\"face_uvs\": [[0, 1, 2, 0], [0, 1, 2, 0], [0, 1, 2, 0], [0, 1, 2, 0], "
      "[0, 1, 2, 0], [0, 1, 2, 0]]";
  const std::string uvs = "\"uvs\": [[0, 0], [1, 0], [0, 1]]";
  EXPECT_EQ(with(uvs + ", " + faces), "was loaded");
  EXPECT_THAT(with(uvs), StartsWith("/mesh/face_uvs: is missing"));
  EXPECT_THAT(with(faces), StartsWith("/mesh/uvs: is missing"));
  EXPECT_THAT(with("\"uvs\": [[0, 0], [1, 0]], " + faces),
              StartsWith("/mesh/face_uvs/0/2: there is no texture point 2; the mesh has 2."));
  EXPECT_THAT(with("\"uvs\": [[0, 0], [1, 0], [0, -1e19]], " + faces),
              StartsWith("/mesh/uvs/2/1: lies too far out"));
  EXPECT_THAT(with("\"uvs\": [[0, 0], [1, 0, 0], [0, 1]], " + faces),
              StartsWith("/mesh/uvs/1: has 3 coordinates"));
  EXPECT_THAT(with(uvs + ", \"face_uvs\": [[0, 1, 2]]"),
              StartsWith("/mesh/face_uvs: does not have a texture point for each corner"));
}

}  // namespace
}  // namespace limn
