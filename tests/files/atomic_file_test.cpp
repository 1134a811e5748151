#include "limn/files/atomic_file.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/stat.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/scratch_folder.h"

namespace limn {
namespace {

namespace fs = std::filesystem;
using test::read_file;
using testing::ElementsAre;
using testing::HasSubstr;

class AtomicFile : public testing::Test {
 protected:
  AtomicFile() { test::write_file(file(), "old"); }
  ~AtomicFile() override { fs::permissions(folder_, fs::perms::owner_all); }

  [[nodiscard]] fs::path file() const { return folder_ / "file"; }
  static Result<void> write(const fs::path& path, const std::string& text) {
    return write_file_atomically(path, [&](std::ostream& out) { out << text; });
  }
  /// Names in the folder, sorted: shows temporaries left behind.
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      found.push_back(entry.path().filename().string());
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  const test::ScratchFolder scratch_;
  const fs::path folder_ = scratch_.path();
};

TEST_F(AtomicFile, ReplacesTheOldContents) {
  ASSERT_TRUE(write(file(), "new").has_value());
  EXPECT_EQ(read_file(file()), "new");
  EXPECT_THAT(names(), ElementsAre("file"));
}

TEST_F(AtomicFile, MakesANewFileWithTheRightsOfTheUmask) {
  const mode_t before = ::umask(027);
  ASSERT_TRUE(write(folder_ / "made", "text").has_value());
  ::umask(before);
  EXPECT_EQ(read_file(folder_ / "made"), "text");
  EXPECT_EQ(fs::status(folder_ / "made").permissions(), fs::perms(0640));
}

TEST_F(AtomicFile, KeepsThePermissions) {
  fs::permissions(file(), fs::perms(0604));
  ASSERT_TRUE(write(file(), "new").has_value());
  EXPECT_EQ(fs::status(file()).permissions(), fs::perms(0604));
}

TEST_F(AtomicFile, WritesMoreThanItsBuffer) {
  std::string text;
  for (int i = 0; i < 100000; ++i) {
    text += std::to_string(i) + "\n";
  }
  ASSERT_TRUE(write(file(), text).has_value());
  EXPECT_EQ(read_file(file()), text);
  ASSERT_TRUE(write_file_atomically(file(), [&](std::ostream& out) {
                for (const char c : text) {
                  out.put(c);
                }
              }).has_value());
  EXPECT_EQ(read_file(file()), text);
}

TEST_F(AtomicFile, WritesThroughASymbolicLink) {
  fs::create_directory(folder_ / "elsewhere");
  std::ofstream(folder_ / "elsewhere" / "real") << "old";
  fs::create_symlink("elsewhere/real", folder_ / "link");
  ASSERT_TRUE(write(folder_ / "link", "new").has_value());
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(read_file(folder_ / "elsewhere" / "real"), "new");
  EXPECT_THAT(names(), ElementsAre("elsewhere", "file", "link"));
}

TEST_F(AtomicFile, WritesThroughALinkToWhatIsNotThereYet) {
  fs::create_symlink("target", folder_ / "link");
  ASSERT_TRUE(write(folder_ / "link", "new").has_value());
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(read_file(folder_ / "target"), "new");
}

TEST_F(AtomicFile, WritesToAPlainNameInTheWorkingFolder) {
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  const auto written = write("file", "new");
  fs::current_path(before);
  ASSERT_TRUE(written.has_value()) << to_string(written.error());
  EXPECT_EQ(read_file(file()), "new");
  EXPECT_THAT(names(), ElementsAre("file"));
}

TEST_F(AtomicFile, KeepsTheOldFileWhereTheWriterFails) {
  const auto written = write_file_atomically(file(), [](std::ostream& out) {
    out << "half";
    out.setstate(std::ios::failbit);
  });
  ASSERT_FALSE(written.has_value());
  EXPECT_EQ(read_file(file()), "old");
  EXPECT_THAT(names(), ElementsAre("file"));
}

TEST_F(AtomicFile, KeepsTheOldFileWhereTheWriterThrows) {
  EXPECT_THROW(static_cast<void>(write_file_atomically(file(),
                                                       [](std::ostream& out) {
                                                         out << "half";
                                                         throw std::runtime_error("no");
                                                       })),
               std::runtime_error);
  EXPECT_EQ(read_file(file()), "old");
  EXPECT_THAT(names(), ElementsAre("file"));
}

TEST_F(AtomicFile, RefusesFoldersDevicesAndMissingFolders) {
  fs::create_directory(folder_ / "sub");
  EXPECT_THAT(write(folder_ / "sub", "x").error().message, HasSubstr("not a regular file"));
  EXPECT_THAT(write("/dev/full", "x").error().message, HasSubstr("not a regular file"));
  const auto missing = write(folder_ / "none" / "file", "x");
  ASSERT_FALSE(missing.has_value());
  EXPECT_THAT(missing.error().message, HasSubstr("No such file or directory"));
  EXPECT_EQ(missing.error().path, (folder_ / "none" / "file").string());
}

}  // namespace
}  // namespace limn
