#include "document/project_fixture.h"

#include <algorithm>
#include <cmath>

#include "limn/mesh/bundled.h"

namespace limn::test {

Document opened(std::string_view name) {
  return make_document(load_bundled_mesh(name).value(), std::string(name));
}

namespace {

void expect_same_mesh(const ControlMesh& a, const ControlMesh& b) {
  ASSERT_EQ(a.vertex_count(), b.vertex_count());
  ASSERT_EQ(a.face_count(), b.face_count());
  for (std::size_t v = 0; v < a.vertex_count(); ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      const double x = a.positions()[v][axis];
      const double y = b.positions()[v][axis];
      // By bits, so that -0 and 0 differ.
      EXPECT_TRUE(x == y && std::signbit(x) == std::signbit(y)) << x << ' ' << y;
    }
  }
  for (std::size_t f = 0; f < a.face_count(); ++f) {
    EXPECT_TRUE(std::ranges::equal(a.face(f), b.face(f))) << f;
  }
  // The order around vertices decides how sums round, so it has to come back too.
  EXPECT_EQ(a.topology().vertex_corners, b.topology().vertex_corners);
  EXPECT_EQ(a.topology().edge_vertices, b.topology().edge_vertices);
  EXPECT_EQ(a.creases(), b.creases());
  EXPECT_EQ(a.texture(), b.texture());
  EXPECT_EQ(a.attributes().corners, b.attributes().corners);
  EXPECT_EQ(a.attributes().names, b.attributes().names);
  EXPECT_EQ(a.attributes().loose_vertices, b.attributes().loose_vertices);
}

}  // namespace

void expect_same_document(const Document& a, const Document& b) {
  expect_same_mesh(*a.control, *b.control);
  expect_same_mesh(*a.opened, *b.opened);
  EXPECT_EQ(a.opened == a.control, b.opened == b.control);
  EXPECT_EQ(a.depths, b.depths);
  EXPECT_EQ(a.demands, b.demands);
  EXPECT_EQ(a.settings, b.settings);
  EXPECT_EQ(a.scheme, b.scheme);
  EXPECT_EQ(a.stage, b.stage);
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.mesh_path, b.mesh_path);
}

std::string without_checksum(std::string text) {
  const std::size_t at = text.rfind(",\n  \"checksum\"");
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, std::string::npos, "\n}\n");
}

std::string ProjectFixture::complaint(std::string_view text) {
  write_file(path_, text);
  const Result<Project> project = load_project(path_);
  if (project) {
    return "was loaded";
  }
  EXPECT_EQ(project.error().kind, ErrorKind::kBadInput);
  EXPECT_EQ(project.error().path, path_.string());
  line_ = project.error().line;
  return project.error().message;
}

std::string ProjectFixture::cube_text() {
  Document document = opened("cube");
  document.settings.legalisation = LegalisationMethod::kGreedy;  // So that it is of version 1.
  document.depths.set(3, 5);
  EXPECT_TRUE(save_project(path_, document, ViewState{}));
  return without_checksum(read_file(path_));
}

std::string ProjectFixture::complaint_with(std::string_view piece, std::string_view other) {
  std::string text = cube_text();
  const std::size_t at = text.find(piece);
  EXPECT_NE(at, std::string::npos) << piece;
  return complaint(text.replace(at, piece.size(), other));
}

}  // namespace limn::test
