// What can go wrong while a file is written: every call that can fail, a full disk, limits, folders
// that may not be written to or go away, and kills.
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sched.h>
#include <sys/file.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "files/failing_calls.h"
#include "limn/files/atomic_file.h"
#include "support/scratch_folder.h"

namespace limn {
namespace {

namespace fs = std::filesystem;
using std::chrono::microseconds;
using test::Call;
using test::FailingCall;
using test::read_file;
using testing::AnyOf;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr int kNotAllowed = 77;

Result<void> write(const fs::path& path, const std::string& text) {
  return write_file_atomically(path, [&](std::ostream& out) { out << text; });
}

/// Names in a folder, sorted: shows temporaries left behind.
std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator(folder)) {
    found.push_back(entry.path().filename().string());
  }
  std::ranges::sort(found);
  return found;
}

/// Runs `work` in a process of its own and gives what it returns.
int in_child(const std::function<int()>& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::_exit(work());
  }
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

pid_t dead_process() {
  const pid_t child = ::fork();
  if (child == 0) {
    ::_exit(0);
  }
  ::waitpid(child, nullptr, 0);
  return child;
}

class Trouble : public testing::Test {
 protected:
  Trouble() { test::write_file(file_, "old"); }

  /// What saving says while it must fail; the old file has to be there, alone.
  std::string failure(const std::string& text) {
    const Result<void> written = write(file_, text);
    EXPECT_EQ(read_file(file_), "old");
    EXPECT_THAT(names_in(folder_), ElementsAre("file"));
    if (written) {
      return "was written";
    }
    EXPECT_EQ(written.error().kind, ErrorKind::kFailed);
    EXPECT_EQ(written.error().path, file_.string());
    return written.error().message;
  }

  const test::ScratchFolder scratch_;
  const fs::path folder_ = scratch_.path();
  const fs::path file_ = folder_ / "file";
  const std::string long_text_ = std::string(300000, 'x');  ///< Longer than any buffer.
};

TEST_F(Trouble, EveryCallThatFailsIsToldAndLeavesTheOldFile) {
  test::forget_calls();
  ASSERT_TRUE(write(file_, long_text_));
  const auto calls = test::counted_calls();
  int failures = 0;
  for (std::size_t kind = 0; kind < calls.size(); ++kind) {
    const auto call = static_cast<Call>(kind);
    if (call == Call::kRename) {
      continue;  // Below, on a file system that needs it.
    }
    EXPECT_GT(calls.at(kind), 0) << kind;
    for (int nth = 1; nth <= calls.at(kind); ++nth) {
      if (call == Call::kClose && nth != 1) {
        continue;  // Of a folder, from which nothing can be lost.
      }
      test::write_file(file_, "old");
      const FailingCall fails(call, nth, ENOSPC);
      EXPECT_THAT(failure(long_text_), HasSubstr("No space left on device")) << kind << ' ' << nth;
      ++failures;
    }
  }
  EXPECT_GT(failures, 8);
}

TEST_F(Trouble, EveryCallThatFailsForANewFileLeavesNone) {
  for (const Call call : {Call::kOpen, Call::kWrite, Call::kFsync, Call::kClose, Call::kRename}) {
    for (int nth = 1; nth <= (call == Call::kFsync || call == Call::kOpen ? 2 : 1); ++nth) {
      const FailingCall fails(call, nth, EIO);
      const Result<void> written = write(folder_ / "new", long_text_);
      ASSERT_FALSE(written);
      EXPECT_THAT(written.error().message, HasSubstr("Input/output error"));
      EXPECT_THAT(names_in(folder_), ElementsAre("file"));
    }
  }
}

TEST_F(Trouble, WhereFilesCannotBeExchangedTheyAreRenamed) {
  const FailingCall no_exchange(Call::kExchange, 1, EINVAL, true);
  ASSERT_TRUE(write(file_, "new"));
  EXPECT_EQ(read_file(file_), "new");
  EXPECT_THAT(names_in(folder_), ElementsAre("file"));
}

TEST_F(Trouble, WritesThatHaltAreGoneOnWith) {
  std::string text;
  for (int i = 0; i < 20000; ++i) {
    text += std::to_string(i);
  }
  const test::HaltingWrites halts(1000);
  ASSERT_TRUE(write(file_, text));
  EXPECT_EQ(read_file(file_), text);
}

TEST_F(Trouble, FoldersThatCannotBeFlushedAreNoFault) {
  const FailingCall fails(Call::kFsync, 2, EINVAL);
  ASSERT_TRUE(write(file_, "new"));
  EXPECT_EQ(read_file(file_), "new");
  EXPECT_THAT(names_in(folder_), ElementsAre("file"));
}

TEST_F(Trouble, AFullDisk) {
  const int code = in_child([this] {
    const fs::path disk = folder_ / "disk";
    fs::create_directory(disk);
    if (::unshare(CLONE_NEWNS) != 0 ||
        ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
        ::mount("none", disk.c_str(), "tmpfs", 0, "size=128k") != 0) {
      return kNotAllowed;
    }
    test::write_file(disk / "file", "old");
    const Result<void> written = write(disk / "file", long_text_);
    const bool is_told =
        !written && written.error().message.find("No space left") != std::string::npos;
    const bool is_kept = read_file(disk / "file") == "old" && names_in(disk).size() == 1;
    return is_told && is_kept && write(disk / "file", "small") ? 0 : 1;
  });
  EXPECT_THAT(code,
              AnyOf(0, kNotAllowed));  // Without the right to mount, the calls above stand in.
}

TEST_F(Trouble, ALimitOnTheSizeOfFiles) {
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit small{200000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string said = failure(long_text_);
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_THAT(said, HasSubstr("File too large"));
}

TEST_F(Trouble, AFolderThatMayNotBeWrittenTo) {
  fs::permissions(folder_, fs::perms(0555));
  const int code = in_child([this] {
    constexpr uid_t nobody = 65534;
    if (::geteuid() == 0 && (::setgid(nobody) != 0 || ::setuid(nobody) != 0)) {
      return kNotAllowed;
    }
    const Result<void> written = write(file_, "new");
    return !written && written.error().message.find("Permission denied") != std::string::npos &&
                   read_file(file_) == "old"
               ? 0
               : 1;
  });
  fs::permissions(folder_, fs::perms(0755));
  EXPECT_EQ(code, 0);
  EXPECT_THAT(names_in(folder_), ElementsAre("file"));
  // Not even root may here.
  EXPECT_THAT(write("/proc/file", "new").error().message, HasSubstr("cannot write in this folder"));
}

TEST_F(Trouble, AFolderThatGoesAway) {
  const fs::path gone = folder_ / "gone";
  fs::create_directory(gone);
  const auto written = write_file_atomically(gone / "file", [&](std::ostream& out) {
    out << "new";
    fs::remove_all(gone);
  });
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message, HasSubstr("No such file or directory"));
  EXPECT_FALSE(fs::exists(gone));
}

TEST_F(Trouble, ALinkToItself) {
  fs::create_symlink("loop", folder_ / "loop");
  EXPECT_THAT(write(folder_ / "loop", "new").error().message, HasSubstr("symbolic links"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "loop"));
}

TEST_F(Trouble, SweepsWhatTheDeadHaveLeftAndNothingElse) {
  const std::string dead = std::to_string(dead_process());
  const std::vector<std::string> others = {
      ".limn-" + std::to_string(::getpid()) + "-70000.tmp",
      ".limn-1-0.tmp",
      ".limn--1-0.tmp",
      ".limn-0-0.tmp",
      ".limn-x-0.tmp",
      ".limn-" + dead + "-.tmp",
      ".limn-" + dead + "-0.tmp.txt",
      ".limn-" + dead + "-0-0.tmp",
      "limn-" + dead + "-0.tmp",
      ".other-" + dead + "-0.tmp",
      ".limn-" + dead + "-8.tmp",
  };
  for (const std::string& name : others) {
    test::write_file(folder_ / name, "x");
  }
  fs::create_directory(folder_ / (".limn-" + dead + "-5.tmp"));
  fs::create_symlink("file", folder_ / (".limn-" + dead + "-6.tmp"));
  const fs::path locked = folder_ / others.back();
  const int holder = ::open(locked.c_str(), O_RDONLY);
  ASSERT_EQ(::flock(holder, LOCK_EX), 0);
  test::write_file(folder_ / (".limn-" + dead + "-0.tmp"), "left");
  test::write_file(folder_ / (".limn-" + dead + "-123.tmp"), "left");

  ASSERT_TRUE(write(file_, "new"));
  std::vector<std::string> expected = others;
  expected.insert(expected.end(), {"file", ".limn-" + dead + "-5.tmp", ".limn-" + dead + "-6.tmp"});
  EXPECT_THAT(names_in(folder_), testing::UnorderedElementsAreArray(expected));
  ::close(holder);
  ASSERT_TRUE(write(file_, "new"));
  EXPECT_FALSE(fs::exists(locked));
}

TEST_F(Trouble, AKilledProcessLeavesOneOfTheFilesItWrote) {
  std::mt19937 random(11);
  for (int kill = 0; kill < 12; ++kill) {
    const pid_t child = ::fork();
    if (child == 0) {
      for (int round = 0;; ++round) {
        const std::string text(100000, static_cast<char>('a' + round % 26));
        if (!write(file_, text)) {
          ::_exit(1);
        }
      }
    }
    std::this_thread::sleep_for(microseconds(random() % 6000));
    ::kill(child, SIGKILL);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    const std::string text = read_file(file_);
    ASSERT_TRUE(text == "old" || text == std::string(100000, text.front())) << text.size();
  }
  ASSERT_TRUE(write(file_, "new"));
  EXPECT_THAT(names_in(folder_), ElementsAre("file"));
}

}  // namespace
}  // namespace limn
