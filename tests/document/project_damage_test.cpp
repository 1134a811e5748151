// However a project is damaged, loading it gives an error or the very document that was saved.
#include <algorithm>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "document/checksum.h"
#include "document/project_fixture.h"
#include "limn/mesh/bundled.h"
#include "support/attribute_shapes.h"

namespace limn {
namespace {

using testing::HasSubstr;

std::string text_of(const Document& document, const std::optional<ViewState>& view) {
  std::ostringstream out;
  write_project(out, document, view);
  return out.str();
}

/// Refused, or not a bit of the document differs.
testing::AssertionResult is_refused_or_right(const std::string& damaged, const std::string& text) {
  const Result<Project> project = parse_project(damaged, "damaged");
  if (project && text_of(project->document, project->view) != text) {
    return testing::AssertionFailure() << "wrong: " << damaged;
  }
  return testing::AssertionSuccess();
}

/// Something of everything that a project has, and small.
Document small_document() {
  PolygonSoup soup;
  soup.positions = {{0, 0, 0}, {1, 0, 0.25}, {1, 1e-3, 0}, {-1, 1, 1.0 / 3.0}};
  soup.add_face(std::vector<std::uint32_t>{0, 1, 2});
  soup.add_face(std::vector<std::uint32_t>{0, 2, 3});
  soup.uvs = {{0, 0}, {0.5, 1}, {1, 0.125}};
  soup.face_uvs = {0, 1, 2, 0, 1, 2};
  soup.creases = {{{0, 2}, 2.5F}};
  soup.corners = {{1, 1.0F}};
  ImportedMesh built = build_control_mesh(soup).value();
  MeshAttributes attributes = built.mesh->attributes();
  attributes.names.materials = {{"clay", "caf\xE9"}, {1, kNone}};
  attributes.names.material_libraries = {"a b.mtl"};
  attributes.loose_vertices = {{2, -0.0, 1e-9}};
  built.mesh = std::make_shared<const ControlMesh>(built.mesh->with_attributes(attributes));
  Document document = make_document(std::move(built), "a \"b\" \\", "/c d.obj");
  document.depths.set(1, 4);
  document.scheme = SchemeSettings{};
  document.stage.levels = 1;
  return document;
}

TEST(ProjectDamage, TheChecksumIsTheOneOfTheBooks) {
  JsonChecksum checksum;
  checksum.add("12345");
  checksum.add("6789");
  EXPECT_EQ(checksum.value(), 0x995DC9BBDF1939FAU);
}

TEST(ProjectDamage, EveryTruncationIsRefusedOrRight) {
  const std::string text = text_of(small_document(), ViewState{});
  int refused = 0;
  for (std::size_t length = 0; length < text.size(); ++length) {
    const std::string damaged = text.substr(0, length);
    ASSERT_TRUE(is_refused_or_right(damaged, text)) << length;
    refused += parse_project(damaged, "damaged") ? 0 : 1;
  }
  EXPECT_EQ(refused,
            static_cast<int>(text.size()) - 1);  // Without the last line's end it is whole.
}

TEST(ProjectDamage, EveryLostByteIsRefusedOrRight) {
  const std::string text = text_of(small_document(), ViewState{});
  for (std::size_t at = 0; at < text.size(); ++at) {
    std::string damaged = text;
    ASSERT_TRUE(is_refused_or_right(damaged.erase(at, 1), text)) << at;
  }
}

TEST(ProjectDamage, EveryFlippedBitIsRefusedOrRight) {
  const std::string text = text_of(small_document(), ViewState{});
  ASSERT_TRUE(is_refused_or_right(text, text));
  ASSERT_TRUE(parse_project(text, "whole"));
  for (std::size_t bit = 0; bit < 8 * text.size(); ++bit) {
    std::string damaged = text;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
    ASSERT_TRUE(is_refused_or_right(damaged, text)) << bit;
  }
}

TEST(ProjectDamage, OtherIndentationAndLineEndsAreNoDamage) {
  const std::string text = text_of(small_document(), ViewState{});
  std::string other = "\xEF\xBB\xBF";
  for (const char c : text) {
    other += c == '\n' ? "\r\n\t" : std::string(1, c);
  }
  const Result<Project> project = parse_project(other, "other");
  ASSERT_TRUE(project) << project.error().message;
  EXPECT_EQ(text_of(project->document, project->view), text);
}

TEST(ProjectDamage, SaysWhatToDoAboutAChangeOnPurpose) {
  const std::string text = text_of(small_document(), std::nullopt);
  std::string changed = text;
  changed.replace(changed.find("\"depths\": [0, 4]"), 16, "\"depths\": [1, 4]");
  const Result<Project> refused = parse_project(changed, "changed");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kBadInput);
  EXPECT_THAT(refused.error().message, HasSubstr("/checksum: does not fit"));
  EXPECT_THAT(refused.error().message, HasSubstr("remove the checksum"));
  EXPECT_TRUE(parse_project(test::without_checksum(changed), "changed"));
  // What comes behind it is not summed up, and so must not be there.
  std::string longer = text;
  longer.replace(longer.rfind("\n}"), 2, ",\n  \"name\": \"x\"\n}");
  EXPECT_FALSE(parse_project(longer, "longer"));
  std::string null = test::without_checksum(text);
  null.replace(null.rfind("\n}"), 2, ",\n  \"checksum\": null\n}");
  EXPECT_FALSE(parse_project(null, "null"));
}

}  // namespace
}  // namespace limn
