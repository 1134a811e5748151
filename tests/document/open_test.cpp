#include "limn/document/open.h"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/mesh/bundled.h"
#include "support/scratch_folder.h"

namespace limn {
namespace {

using test::ScratchFolder;
using test::write_file;
using ::testing::HasSubstr;

TEST(OpenDocument, BundledMeshesByName) {
  for (const BundledMesh& bundled : bundled_meshes()) {
    const Result<Project> opened = open_document(std::string(bundled.name));
    ASSERT_TRUE(opened) << bundled.name;
    EXPECT_EQ(opened->document.name, bundled.name);
    EXPECT_TRUE(opened->document.mesh_path.empty());
    EXPECT_EQ(opened->document.depths.deepest(), 0);
    EXPECT_FALSE(opened->view);
  }
}

TEST(OpenDocument, MeshFiles) {
  const ScratchFolder folder;
  const std::filesystem::path path = folder / "triangle.obj";
  write_file(path, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nf 1 2 3\n");
  const Result<Project> opened = open_document(path.string());
  ASSERT_TRUE(opened) << to_string(opened.error());
  EXPECT_EQ(opened->document.name, "triangle.obj");
  EXPECT_EQ(opened->document.mesh_path, path);
  EXPECT_TRUE(opened->document.project_path.empty());
  EXPECT_EQ(opened->document.control->face_count(), 1U);
  EXPECT_EQ(opened->document.import_report.count(MendKind::kLooseVertex), 1U);
}

TEST(OpenDocument, Projects) {
  const ScratchFolder folder;
  Document cube = open_document("cube").value().document;
  cube.depths.set(2, 7);
  const ViewState view{{1, 2, 3}, 4, 5, 6, 7, false};
  const std::filesystem::path path = folder / "cube.limn";
  ASSERT_TRUE(save_project(path, cube, view));
  const Result<Project> opened = open_document(path.string());
  ASSERT_TRUE(opened) << to_string(opened.error());
  EXPECT_EQ(opened->document.depths, cube.depths);
  EXPECT_EQ(opened->document.project_path, path);
  EXPECT_EQ(opened->view, view);
}

TEST(OpenDocument, AFileWinsOverABundledMesh) {
  const ScratchFolder folder;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  std::filesystem::create_directory("cube");
  const Result<Project> opened = open_document("cube");
  std::filesystem::current_path(before);
  ASSERT_FALSE(opened);  // A folder of that name is what was asked for, and cannot be opened.
  EXPECT_EQ(opened.error().kind, ErrorKind::kBadInput);
}

TEST(OpenDocument, NamesTheBundledMeshesWhereNothingFits) {
  const Result<Project> opened = open_document("no such thing");
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().kind, ErrorKind::kBadInput);
  EXPECT_EQ(opened.error().path, "no such thing");
  EXPECT_THAT(opened.error().message, HasSubstr("icosahedron"));
}

TEST(OpenDocument, PassesOnWhatIsWrongWithAFile) {
  const ScratchFolder folder;
  write_file(folder / "bad.limn", "{");
  const Result<Project> project = open_document((folder / "bad.limn").string());
  ASSERT_FALSE(project);
  EXPECT_THAT(project.error().message, HasSubstr("JSON"));
  write_file(folder / "bad.obj", "v 0 0 0\n");
  EXPECT_FALSE(open_document((folder / "bad.obj").string()));
}

}  // namespace
}  // namespace limn
