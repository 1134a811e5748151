// Opening, saving and exporting in a session, with files in a folder of the test's own.
#include "app/session_fixture.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/mesh/import.h"

namespace limn::app {
namespace {

namespace fs = std::filesystem;
using enum ui::ActionId;
using testing::HasSubstr;
using testing::IsEmpty;

TEST_F(SessionTest, AMeshsBoundaryRuleIsHonoured) {
  const std::string path = folder_.file("round.obj");
  std::ofstream(path) << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nt interpolateboundary "
                         "1/0/0 2\n";
  session_.perform({kOpen, path});
  EXPECT_EQ(session_.document().settings.corners, CornerRule::kSmooth);
}

TEST_F(SessionTest, BadFileLeavesTheDocumentAndSaysWhy) {
  const fs::path bad = folder_ / "bad.obj";
  std::ofstream(bad) << "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 9\n";
  session_.perform({kOpen, bad.string()});
  EXPECT_EQ(session_.document().name, "cube");
  ASSERT_NE(modal<ui::ErrorDialog>(), nullptr);
  EXPECT_THAT(modal<ui::ErrorDialog>()->title, HasSubstr("bad.obj"));
  EXPECT_EQ(modal<ui::ErrorDialog>()->error.kind, ErrorKind::kBadInput);
  EXPECT_EQ(modal<ui::ErrorDialog>()->error.line, 4u);
  session_.perform(kCancel);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(session_.modal()));
  EXPECT_THAT(session_.recent_files(), IsEmpty());
}

TEST_F(SessionTest, SavedProjectOpensAgainAsItWas) {
  stroke({1, 2}, DepthChange::set(4));
  session_.perform(kSubdivide);
  EXPECT_THAT(session_.title(), HasSubstr("*"));
  const fs::path path = folder_ / "painted";
  session_.perform({kSaveProjectAs, path.string()});
  EXPECT_TRUE(fs::exists(folder_ / "painted.limn")) << "the ending is added";
  EXPECT_FALSE(session_.history().is_modified());
  EXPECT_EQ(session_.title(), "painted.limn - Limn");

  session_.perform({kOpenBundled, std::string("icosahedron")});
  EXPECT_EQ(session_.document().control->face_count(), 20u);
  session_.perform({kOpen, (folder_ / "painted.limn").string()});
  EXPECT_EQ(depths(), (std::vector<int>{0, 4, 4, 0, 0, 0}));
  EXPECT_EQ(session_.document().stage, (Stage{true, kAllLevels}));
  ASSERT_EQ(session_.recent_files().size(), 1u);
}

TEST_F(SessionTest, UnsavedChangesAreAskedAbout) {
  stroke({1});
  session_.perform(kQuit);
  EXPECT_FALSE(session_.wants_to_quit());
  ASSERT_NE(modal<ui::UnsavedQuestion>(), nullptr);
  session_.perform(kCancel);
  EXPECT_FALSE(session_.wants_to_quit());

  session_.perform({kOpenBundled, std::string("icosahedron")});
  ASSERT_NE(modal<ui::UnsavedQuestion>(), nullptr);
  session_.perform(kDiscardChanges);
  EXPECT_EQ(session_.document().control->face_count(), 20u);
  session_.perform(kQuit);
  EXPECT_TRUE(session_.wants_to_quit()) << "nothing was changed since";
}

TEST_F(SessionTest, SaveFirstSavesAndGoesOn) {
  stroke({1});
  session_.perform(kQuit);
  session_.perform(kSaveFirst);
  EXPECT_FALSE(session_.wants_to_quit()) << "it has no name yet";
  ASSERT_NE(modal<ui::PathPrompt>(), nullptr);
  session_.perform({kSaveProjectAs, (folder_ / "x.limn").string()});
  EXPECT_TRUE(fs::exists(folder_ / "x.limn"));
  EXPECT_TRUE(session_.wants_to_quit());
}

TEST_F(SessionTest, FailedSaveDoesNotGoOn) {
  stroke({1});
  session_.perform(kQuit);
  session_.perform(kSaveFirst);
  session_.perform({kSaveProjectAs, (folder_ / "nowhere" / "x.limn").string()});
  EXPECT_FALSE(session_.wants_to_quit());
  EXPECT_NE(modal<ui::ErrorDialog>(), nullptr);
  EXPECT_TRUE(session_.history().is_modified());
}

TEST_F(SessionTest, ExportWaitsForTheRefinement) {
  stroke({0}, DepthChange::set(2));
  const fs::path path = folder_ / "out.obj";
  session_.perform({kExportRefined, path.string()});
  session_.finish_refinement();
  const auto mesh = import_mesh(path);
  ASSERT_TRUE(mesh.has_value()) << to_string(mesh.error());
  EXPECT_EQ(mesh->mesh->face_count(), 76u);
  EXPECT_EQ(session_.document().stage.levels, 0) << "exporting does not subdivide the view";
}

TEST_F(SessionTest, ExportsAreWrittenInAnyFormatOrSayWhyNot) {
  for (const char* name : {"a.ply", "b.OFF", "c.stl"}) {
    session_.perform({kExportRefined, (folder_ / name).string()});
    session_.finish_refinement();
    EXPECT_FALSE(session_.is_busy());
    EXPECT_TRUE(import_mesh(folder_ / name).has_value()) << name;
  }
  session_.perform({kExportRefined, (folder_ / "nowhere" / "d.ply").string()});
  session_.finish_refinement();
  const auto* error = modal<ui::ErrorDialog>();
  ASSERT_NE(error, nullptr);
  EXPECT_EQ(error->title, "Cannot write d.ply");
}

TEST_F(SessionTest, TheExportPromptSaysWhatIsLost) {
  stroke({0}, DepthChange::set(2));
  session_.finish_refinement();
  session_.perform(kExportRefined);
  const auto* prompt = modal<ui::PathPrompt>();
  ASSERT_NE(prompt, nullptr);
  EXPECT_EQ(prompt->losses[static_cast<std::size_t>(MeshFormat::kObj)], "");
  EXPECT_EQ(prompt->losses[static_cast<std::size_t>(MeshFormat::kOff)],
            "OFF files do not hold: the painted depths and normals of the limit surface.");
}

TEST_F(SessionTest, ReplacingTheMeshKeepsThePainting) {
  stroke({0, 5});
  test::write_file(folder_ / "three.obj",
                   "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nf 1 2 3 4\n");
  session_.perform({kReplaceMesh, folder_.file("missing.obj")});
  EXPECT_NE(modal<ui::ErrorDialog>(), nullptr);
  session_.perform(kCancel);
  EXPECT_EQ(session_.document().control->face_count(), 6U);
  session_.perform({kReplaceMesh, folder_.file("three.obj")});
  EXPECT_EQ(session_.document().control->face_count(), 1U);
  EXPECT_THAT(last_toast(), HasSubstr("gone"));
  session_.perform(kUndo);
  EXPECT_EQ(depths(), (std::vector<int>{1, 0, 0, 0, 0, 1}));
}

TEST_F(SessionTest, AFailedLoadChangesNothing) {
  stroke({1});
  session_.perform({kSaveProject, folder_.file("kept.limn")});
  session_.perform({kSaveProjectAs, folder_.file("kept.limn")});
  stroke({2});
  stroke({3});
  session_.perform(kUndo);
  const Document& document = session_.document();
  const auto control = document.control;
  const auto revisions = document.revisions;
  const auto before = depths();
  test::write_file(folder_ / "bad.obj", "v 0 0 0\nf 1 2 3\n");
  test::write_file(folder_ / "bad.limn", "{\"format\": \"limn-project\", \"version\": 99}");
  for (const std::string& bad : {folder_.file("bad.obj"), folder_.file("bad.limn"),
                                 folder_.file("missing.obj"), folder_.path().string()}) {
    session_.perform({kOpen, bad});
    session_.perform(kDiscardChanges);
    ASSERT_NE(modal<ui::ErrorDialog>(), nullptr) << bad;
    session_.perform(kCancel);
    EXPECT_EQ(document.control, control);
    EXPECT_EQ(document.revisions.control, revisions.control);
    EXPECT_EQ(document.revisions.depths, revisions.depths);
    EXPECT_EQ(document.project_path, folder_.file("kept.limn"));
    EXPECT_EQ(depths(), before);
    EXPECT_TRUE(session_.history().is_modified()) << bad;
    EXPECT_TRUE(session_.history().can_undo());
    EXPECT_TRUE(session_.history().can_redo());
  }
}

}  // namespace
}  // namespace limn::app
