// Dialogs of the desktop, shown by programs that are made here and stand first on the PATH.
#include "app/desktop_dialog.h"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session.h"
#include "support/scratch_folder.h"

namespace limn::app {
namespace {

using enum ui::ActionId;
using Purpose = ui::PathPrompt::Purpose;
using testing::Contains;
using testing::HasSubstr;
namespace fs = std::filesystem;

class DesktopDialogTest : public testing::Test {
 protected:
  DesktopDialogTest() : path_(std::getenv("PATH")) {
    unsetenv("LIMN_DIALOGS");
    unsetenv("XDG_CURRENT_DESKTOP");
    setenv("PATH", folder_.path().c_str(), 1);
  }
  ~DesktopDialogTest() override { setenv("PATH", path_.c_str(), 1); }

  void install(const std::string& name, const std::string& script) {
    const fs::path file = folder_ / name;
    std::ofstream(file) << "#!/bin/sh\n" << script << "\n";
    fs::permissions(file, fs::perms::owner_all);
  }
  std::optional<DesktopDialog::Answer> wait_for_answer() {
    for (int i = 0; i < 2000; ++i) {
      if (auto answer = dialog_.take_answer()) {
        return answer;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return std::nullopt;
  }

  test::ScratchFolder folder_;
  std::string path_;
  DesktopDialog dialog_{[] {}};
};

TEST_F(DesktopDialogTest, FindsWhatFitsTheDesktop) {
  EXPECT_EQ(find_dialog_program(), std::nullopt);
  install("zenity", "");
  EXPECT_EQ(find_dialog_program(), DialogProgram::kZenity);
  install("kdialog", "");
  EXPECT_EQ(find_dialog_program(), DialogProgram::kZenity);
  setenv("XDG_CURRENT_DESKTOP", "KDE", 1);
  EXPECT_EQ(find_dialog_program(), DialogProgram::kKdialog);
  setenv("LIMN_DIALOGS", "own", 1);
  EXPECT_EQ(find_dialog_program(), std::nullopt);
  unsetenv("LIMN_DIALOGS");
}

TEST_F(DesktopDialogTest, GivesThePathThatWasChosenWhateverIsInIt) {
  install("zenity", "printf '/tmp/a b\\nc.obj\\n'");
  ASSERT_TRUE(dialog_.open(DialogProgram::kZenity, {Purpose::kOpen, "/tmp", {}}));
  const auto answer = wait_for_answer();
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->purpose, Purpose::kOpen);
  EXPECT_EQ(answer->path, "/tmp/a b\nc.obj");
}

TEST_F(DesktopDialogTest, SaysWhatItIsFor) {
  install("kdialog",
          "for word in \"$@\"; do echo \"$word\"; done > " + (folder_ / "words").string());
  ASSERT_TRUE(
      dialog_.open(DialogProgram::kKdialog, {Purpose::kSaveProject, "/tmp/here", "creature.limn"}));
  ASSERT_TRUE(wait_for_answer());
  std::ifstream file(folder_ / "words");
  const std::string words(std::istreambuf_iterator<char>(file), {});
  EXPECT_THAT(words, HasSubstr("--getsavefilename\n/tmp/here/creature.limn\n"));
  EXPECT_THAT(words, HasSubstr("Projects (*.limn)"));
  EXPECT_THAT(dialog_command(DialogProgram::kZenity, {Purpose::kOpen, "/tmp/here", {}}),
              Contains("--filename=/tmp/here/"));
}

TEST_F(DesktopDialogTest, NothingChosenIsAnAnswerToo) {
  install("zenity", "echo /tmp/x.obj; exit 1");
  ASSERT_TRUE(dialog_.open(DialogProgram::kZenity, {}));
  const auto answer = wait_for_answer();
  ASSERT_TRUE(answer);
  EXPECT_TRUE(answer->path.empty());
}

TEST_F(DesktopDialogTest, ClosesWhatIsOpen) {
  install("zenity", "exec /bin/sleep 600");
  ASSERT_TRUE(dialog_.open(DialogProgram::kZenity, {}));
  dialog_.close();
  EXPECT_FALSE(dialog_.take_answer());
}

TEST_F(DesktopDialogTest, WhatIsNotThereCannotBeOpened) {
  EXPECT_FALSE(dialog_.open(DialogProgram::kZenity, {}));
}

/// A session under a desktop whose dialogs are answered by hand.
class DesktopSession : public testing::Test {
 protected:
  DesktopSession() {
    session_.perform({kOpenBundled, std::string("cube")});
    session_.perform(kRaiseAll);
  }

  test::ScratchFolder folder_;
  std::optional<DialogRequest> asked_;
  int closed_ = 0;
  Session session_{{.wake = [] {},
                    .visible_faces = {},
                    .ask_desktop =
                        [this](const DialogRequest& request) {
                          asked_ = request;
                          return true;
                        },
                    .close_desktop_dialog = [this] { ++closed_; }}};
};

TEST_F(DesktopSession, AsksTheDesktopAndTakesItsAnswer) {
  session_.perform(kSaveProject);
  ASSERT_TRUE(asked_);
  EXPECT_EQ(asked_->purpose, Purpose::kSaveProject);
  EXPECT_EQ(asked_->name, "cube.limn");
  EXPECT_TRUE(std::holds_alternative<ui::DesktopDialogNote>(session_.modal()));
  session_.answer_dialog(Purpose::kSaveProject, folder_ / "mine.limn");
  EXPECT_TRUE(std::holds_alternative<std::monostate>(session_.modal()));
  EXPECT_TRUE(fs::exists(folder_ / "mine.limn"));
}

TEST_F(DesktopSession, AsksItselfAboutAFileThatTheDesktopDidNotAskAbout) {
  session_.perform(kSaveProject);
  session_.answer_dialog(Purpose::kSaveProject, folder_ / "mine");
  const auto* prompt = std::get_if<ui::PathPrompt>(&session_.modal());
  ASSERT_NE(prompt, nullptr) << "mine.limn could be there";
  EXPECT_EQ(prompt->suggested_name, "mine.limn");
  EXPECT_EQ(prompt->folder, folder_.path());
}

TEST_F(DesktopSession, CancellingClosesItAndALateAnswerChangesNothing) {
  session_.perform(kSaveProject);
  session_.perform(kCancel);
  EXPECT_EQ(closed_, 1);
  session_.answer_dialog(Purpose::kSaveProject, folder_ / "late.limn");
  EXPECT_FALSE(fs::exists(folder_ / "late.limn"));
}

TEST_F(DesktopSession, OurOwnPromptIsThereForWhoWantsIt) {
  session_.perform(kOpen);
  const auto folder = std::get<ui::DesktopDialogNote>(session_.modal()).folder;
  session_.perform({kBrowse, folder});
  EXPECT_EQ(closed_, 1);
  EXPECT_TRUE(std::holds_alternative<ui::PathPrompt>(session_.modal()));
  session_.perform(kCancel);
  session_.perform({kToggleDesktopDialogs, false});
  asked_.reset();
  session_.perform(kOpen);
  EXPECT_FALSE(asked_);
  EXPECT_TRUE(std::holds_alternative<ui::PathPrompt>(session_.modal()));
}

TEST_F(DesktopSession, SavingFirstGoesOnAfterTheDialog) {
  session_.perform(kQuit);
  session_.perform(kSaveFirst);
  session_.answer_dialog(Purpose::kSaveProject, folder_ / "mine.limn");
  EXPECT_TRUE(session_.wants_to_quit());
}

}  // namespace
}  // namespace limn::app
