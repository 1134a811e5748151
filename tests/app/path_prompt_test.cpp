#include "app/path_prompt.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/scratch_folder.h"

namespace limn::app {
namespace {

namespace fs = std::filesystem;
using Purpose = ui::PathPrompt::Purpose;
using testing::ElementsAre;

class PathPromptTest : public testing::Test {
 protected:
  PathPromptTest() {
    fs::create_directories(folder_ / "zoo");
    fs::create_directories(folder_ / ".hidden");
    for (const char* name : {"b.obj", "A.OBJ", "c.limn", "notes.txt", ".secret.obj"}) {
      std::ofstream(folder_ / name) << "1234";
    }
  }

  static std::vector<std::string> names(const ui::PathPrompt& prompt) {
    std::vector<std::string> all;
    for (const ui::FolderEntry& entry : prompt.entries) {
      all.push_back(entry.name);
    }
    return all;
  }

  test::ScratchFolder scratch_;
  fs::path folder_ = scratch_.path();
};

TEST_F(PathPromptTest, ListsFoldersThenFilesThatFit) {
  EXPECT_THAT(names(list_folder(Purpose::kOpen, folder_)),
              ElementsAre("zoo", "A.OBJ", "b.obj", "c.limn"));
  EXPECT_THAT(names(list_folder(Purpose::kSaveProject, folder_)), ElementsAre("zoo", "c.limn"));
  EXPECT_THAT(names(list_folder(Purpose::kExportRefined, folder_)),
              ElementsAre("zoo", "A.OBJ", "b.obj"));
  EXPECT_EQ(list_folder(Purpose::kOpen, folder_).entries[1].bytes, 4u);
}

TEST_F(PathPromptTest, NamesFolderAndParent) {
  const auto prompt = list_folder(Purpose::kOpen, folder_ / "zoo" / "");
  EXPECT_EQ(prompt.folder, (folder_ / "zoo").string());
  EXPECT_EQ(prompt.parent, folder_.string());
  EXPECT_EQ(prompt.problem, "");
  EXPECT_EQ(list_folder(Purpose::kOpen, "/").parent, "");
  EXPECT_EQ(list_folder(Purpose::kOpen, "/").folder, "/");
}

TEST_F(PathPromptTest, FolderThatIsGoneGivesTheNearestThatIsThere) {
  EXPECT_EQ(list_folder(Purpose::kOpen, folder_ / "gone" / "away").folder, folder_.string());
}

TEST_F(PathPromptTest, EndingsAreAdded) {
  EXPECT_EQ(with_ending(Purpose::kSaveProject, "/a/b"), "/a/b.limn");
  EXPECT_EQ(with_ending(Purpose::kSaveProject, "/a/b.limn"), "/a/b.limn");
  EXPECT_EQ(with_ending(Purpose::kSaveProject, "/a/b.v2"), "/a/b.v2.limn");
  EXPECT_EQ(with_ending(Purpose::kExportRefined, "/a/b"), "/a/b.obj");
  EXPECT_EQ(with_ending(Purpose::kExportRefined, "/a/b.OBJ"), "/a/b.OBJ");
  EXPECT_EQ(with_ending(Purpose::kExportRefined, "/a/b.Ply"), "/a/b.Ply");
  EXPECT_EQ(with_ending(Purpose::kExportRefined, "/a/b.v2"), "/a/b.v2.obj");
}

}  // namespace
}  // namespace limn::app
