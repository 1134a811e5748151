#include "limn/document/memory_budget.h"

#include <filesystem>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/scratch_folder.h"

namespace limn {
namespace {

namespace fs = std::filesystem;
constexpr std::uint64_t kMegabyte = std::uint64_t{1} << 20U;

/// A file system with what Linux says about memory.
class MemoryBudget : public testing::Test {
 protected:
  void say(const std::string& file, const std::string& text) const {
    const fs::path path = root_.path() / file;
    fs::create_directories(path.parent_path());
    test::write_file(path, text);
  }
  [[nodiscard]] std::uint64_t available() const { return available_memory(root_.path()); }

  test::ScratchFolder root_;
};

TEST_F(MemoryBudget, IsUnlimitedWhereNothingSaysOtherwise) {
  EXPECT_EQ(available(), std::numeric_limits<std::uint64_t>::max());
}

TEST_F(MemoryBudget, IsWhatTheKernelHasAvailable) {
  say("proc/meminfo", "MemTotal:       16384 kB\nMemFree:   100 kB\nMemAvailable:    8192 kB\n");
  EXPECT_EQ(available(), 8 * kMegabyte);
}

TEST_F(MemoryBudget, IsLessWhereAControlGroupSaysSo) {
  say("proc/meminfo", "MemAvailable:    8388608 kB\n");
  say("proc/self/cgroup", "0::/user/limn\n");
  say("sys/fs/cgroup/user/limn/memory.max", "max\n");
  say("sys/fs/cgroup/user/limn/memory.current", std::to_string(100 * kMegabyte));
  EXPECT_EQ(available(), 8192 * kMegabyte);
  say("sys/fs/cgroup/user/limn/memory.max", std::to_string(500 * kMegabyte));
  EXPECT_EQ(available(), 400 * kMegabyte);
  say("sys/fs/cgroup/user/limn/memory.stat",
      "anon 3\ninactive_file " + std::to_string(30 * kMegabyte) + "\n");
  EXPECT_EQ(available(), 430 * kMegabyte);
  say("sys/fs/cgroup/user/memory.max", std::to_string(300 * kMegabyte));
  say("sys/fs/cgroup/user/memory.current", std::to_string(290 * kMegabyte));
  EXPECT_EQ(available(), 10 * kMegabyte);
  say("sys/fs/cgroup/user/memory.current", std::to_string(310 * kMegabyte));
  EXPECT_EQ(available(), 0U);
}

TEST_F(MemoryBudget, ReadsTheFirstVersionOfControlGroupsToo) {
  say("proc/meminfo", "MemAvailable:    8388608 kB\n");
  say("proc/self/cgroup", "5:cpu,cpuacct:/a\n4:memory:/b/c\n0::/\n");
  say("sys/fs/cgroup/memory/b/c/memory.limit_in_bytes", std::to_string(50 * kMegabyte));
  say("sys/fs/cgroup/memory/b/c/memory.usage_in_bytes", std::to_string(20 * kMegabyte));
  EXPECT_EQ(available(), 30 * kMegabyte);
  say("sys/fs/cgroup/memory/b/c/memory.limit_in_bytes", "9223372036854771712");
  EXPECT_EQ(available(), 8192 * kMegabyte);
}

TEST_F(MemoryBudget, SaysSizesForPeople) {
  EXPECT_EQ(memory_text(812), "812 bytes");
  EXPECT_EQ(memory_text(39272478), "39.3 MB");
  EXPECT_EQ(memory_text(999'949'999), "999.9 MB");
  EXPECT_EQ(memory_text(999'950'000), "1.0 GB");
  EXPECT_EQ(memory_text(std::numeric_limits<std::uint64_t>::max()), "18.4 EB");
}

TEST(Memory, SomeIsAvailableHere) {
  EXPECT_GT(memory_budget(), kMegabyte);
  EXPECT_LT(memory_budget(), available_memory("/"));
}

}  // namespace
}  // namespace limn
