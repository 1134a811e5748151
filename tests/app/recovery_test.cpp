// Copies of unsaved work: when they are made, what is left of them when the program is killed, and
// what the next run makes of that.
#include <algorithm>
#include <filesystem>
#include <numeric>
#include <random>
#include <string>
#include <system_error>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/recovery_store.h"
#include "app/session.h"
#include "support/scratch_folder.h"

namespace limn::app {
namespace {

namespace fs = std::filesystem;
using enum ui::ActionId;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

int painted(const Document& document) {
  const auto depths = document.depths.values();
  return std::accumulate(depths.begin(), depths.end(), 0);
}

/// Less than a minute, and so long that no disk is so slow that copies have to wait.
constexpr double kRest = 50.0;

class RecoveryTest : public testing::Test {
 protected:
  RecoveryTest() { session_.perform({kOpenBundled, std::string("cube")}); }

  void stroke(Session& session, std::uint32_t face) {
    session.begin_stroke(DepthChange::add(1));
    session.touch(std::vector<std::uint32_t>{face});
    session.end_stroke();
  }
  /// Lets this much time pass and whatever it brings be done.
  void pass(Session& session, double seconds) {
    now_ += seconds;
    session.update(now_);
    session.finish_refinement();
    session.finish_autosave();
    session.update(now_);  // What had to wait for another copy comes now.
    session.finish_autosave();
  }
  [[nodiscard]] std::vector<fs::path> copies() const {
    std::vector<fs::path> found;
    std::error_code error;
    for (auto at = fs::recursive_directory_iterator(common_, error);
         !error && at != fs::recursive_directory_iterator(); at.increment(error)) {
      if (at->path().extension() == ".limn") {
        found.push_back(at->path());
      }
    }
    std::ranges::sort(found);
    return found;
  }
  /// What is on disk now, as a kill would leave it: nobody holds the locks of the copy.
  [[nodiscard]] fs::path killed() {
    fs::path copy = scratch_ / ("killed" + std::to_string(++kills_));
    std::error_code ignored;  // A file may go while it is copied.
    fs::create_directory(copy);
    fs::copy(common_, copy, fs::copy_options::recursive, ignored);
    return copy;
  }
  static SessionHost host(const fs::path& common) {
    SessionHost host;
    host.wake = [] {};
    host.recovery_folder = common;
    return host;
  }

  const test::ScratchFolder scratch_;
  const fs::path common_ = scratch_ / "state" / "recovery";
  double now_ = 0.0;
  int kills_ = 0;
  Session session_{host(common_)};
};

TEST_F(RecoveryTest, NothingIsKeptOfADocumentThatWasNotChanged) {
  pass(session_, 1000.0);
  EXPECT_FALSE(fs::exists(common_));
}

TEST_F(RecoveryTest, ACopyIsMadeAfterEveryRefinementAndThreeAreKept) {
  session_.perform(kSubdivide);
  for (std::uint32_t i = 0; i < 6; ++i) {
    stroke(session_, i);
    pass(session_, kRest);
    EXPECT_THAT(copies(), SizeIs(std::min<std::size_t>(i + 1, 3)));
    EXPECT_EQ(painted(load_project(copies().back()).value().document), static_cast<int>(i) + 1);
  }
}

TEST_F(RecoveryTest, WithoutARefinementACopyIsMadeAfterAMinuteOfChanges) {
  session_.perform({kToggleLive, false});
  pass(session_, 5.0);
  stroke(session_, 3);
  pass(session_, 1.0);
  EXPECT_THAT(copies(), IsEmpty());
  EXPECT_DOUBLE_EQ(session_.next_update(), 6.0 + Autosave::kSeconds);
  pass(session_, 30.0);
  stroke(session_, 4);
  pass(session_, 29.9);
  EXPECT_THAT(copies(), IsEmpty());
  pass(session_, 0.2);
  ASSERT_THAT(copies(), SizeIs(1));
  EXPECT_EQ(painted(load_project(copies().back()).value().document), 2);
  pass(session_, 1000.0);
  EXPECT_THAT(copies(), SizeIs(1)) << "nothing has changed since";
}

TEST_F(RecoveryTest, NothingIsKeptOfWhatWasSavedUndoneOrClosed) {
  const auto change = [&] {
    stroke(session_, 0);
    pass(session_, 61.0);
    pass(session_, 61.0);
    ASSERT_THAT(copies(), SizeIs(1));
  };
  change();
  session_.perform({kSaveProject, scratch_.file("saved.limn")});
  session_.perform({kSaveProjectAs, scratch_.file("saved.limn")});
  pass(session_, 0.0);
  EXPECT_THAT(copies(), IsEmpty());
  change();
  session_.perform(kUndo);
  pass(session_, 0.0);
  EXPECT_THAT(copies(), IsEmpty());
  change();
  session_.perform({kOpenBundled, std::string("grid")});
  session_.perform(kDiscardChanges);
  pass(session_, 0.0);
  EXPECT_THAT(copies(), IsEmpty());
  change();
  session_.perform(kQuit);
  session_.perform(kDiscardChanges);
  EXPECT_TRUE(session_.wants_to_quit());
  pass(session_, 100.0);
  EXPECT_THAT(copies(), IsEmpty());
  EXPECT_TRUE(fs::is_empty(common_));
}

TEST_F(RecoveryTest, TheWindowTellsWhenACopyWasKeptAndWhyNone) {
  EXPECT_EQ(session_.copies(), ui::CopyStatus{});
  SessionHost with_clock = host(common_);
  std::string time = "14:05";
  with_clock.wall_clock = [&time] { return time; };
  Session session(std::move(with_clock));
  pass(session, 1.0);
  EXPECT_EQ(session.copies(), ui::CopyStatus{}) << "nothing was changed";
  stroke(session, 0);
  pass(session, 100.0);
  pass(session, 0.0);
  EXPECT_EQ(session.model().copies, (ui::CopyStatus{"14:05", ""}));
  time = "14:07";
  pass(session, 1000.0);
  EXPECT_EQ(session.copies().when, "14:05") << "nothing has changed since";
  stroke(session, 1);
  pass(session, 100.0);
  pass(session, 0.0);
  EXPECT_EQ(session.copies().when, "14:07");
  session.perform(kUndo);
  session.perform(kUndo);
  pass(session, 1.0);
  pass(session, 0.0);
  EXPECT_EQ(session.copies(), ui::CopyStatus{}) << "there is nothing to lose";
}

TEST_F(RecoveryTest, AStrokeIsNeverKeptHalfDone) {
  session_.begin_stroke(DepthChange::add(1));
  session_.touch(std::vector<std::uint32_t>{0});
  pass(session_, 200.0);
  EXPECT_THAT(copies(), IsEmpty());
  session_.end_stroke();
  pass(session_, 1.0);
  pass(session_, 100.0);
  EXPECT_THAT(copies(), SizeIs(1));
}

TEST_F(RecoveryTest, AnotherRunIsNotOfferedWhatALivingOneKeeps) {
  stroke(session_, 0);
  pass(session_, 1.0);
  pass(session_, 60.0);
  ASSERT_THAT(copies(), SizeIs(1));
  EXPECT_THAT(find_lost_work(common_), IsEmpty());
  EXPECT_THAT(copies(), SizeIs(1));
}

TEST_F(RecoveryTest, TheNextRunOffersWhatAKilledOneLeft) {
  session_.perform({kSaveProjectAs, scratch_.file("creature.limn")});
  stroke(session_, 2);
  pass(session_, 1.0);
  pass(session_, 60.0);
  const fs::path left = killed();
  Session next(host(left));
  std::vector<LostWork> lost = find_lost_work(left);
  ASSERT_THAT(lost, SizeIs(1));
  EXPECT_THAT(find_lost_work(left), IsEmpty()) << "one run at a time";
  next.offer(std::move(lost));
  next.update(0.0);
  const auto* question = std::get_if<ui::RecoveryQuestion>(&next.modal());
  ASSERT_NE(question, nullptr);
  EXPECT_EQ(question->document, "creature.limn");
  EXPECT_EQ(question->path, scratch_.file("creature.limn"));
  EXPECT_THAT(question->when, HasSubstr(":"));
  next.perform(kRecover);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(next.modal()));
  EXPECT_EQ(next.document().depths[2], 1);
  EXPECT_EQ(next.document().project_path, scratch_.file("creature.limn"));
  EXPECT_TRUE(next.history().is_modified());
  EXPECT_EQ(painted(load_project(scratch_ / "creature.limn").value().document), 0);

  // Killed again before anything else is kept: the same is offered again.
  next.update(1.0);
  next.finish_autosave();
  const fs::path again = scratch_ / "again";
  fs::copy(left, again, fs::copy_options::recursive);
  ASSERT_THAT(find_lost_work(again), SizeIs(1));
  EXPECT_EQ(painted(load_lost_work(find_lost_work(again).front()).value().document), 1);

  next.perform(kSaveProject);
  next.update(2.0);
  next.finish_autosave();
  EXPECT_TRUE(fs::is_empty(left));
  EXPECT_EQ(painted(load_project(scratch_ / "creature.limn").value().document), 1);
}

TEST_F(RecoveryTest, LaterKeepsAndDiscardRemoves) {
  stroke(session_, 2);
  pass(session_, 1.0);
  pass(session_, 60.0);
  const fs::path left = killed();
  Session next(host(left));
  next.offer(find_lost_work(left));
  next.update(0.0);
  next.perform(kCancel);
  next.update(1.0);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(next.modal()));
  std::vector<LostWork> lost = find_lost_work(left);
  ASSERT_THAT(lost, SizeIs(1));
  next.offer(std::move(lost));
  next.update(2.0);
  next.perform(kDiscardLost);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(next.modal()));
  EXPECT_THAT(find_lost_work(left), IsEmpty());
  EXPECT_TRUE(fs::is_empty(left));
  EXPECT_EQ(painted(next.document()), 0);
}

TEST_F(RecoveryTest, ADamagedCopyGivesWayToTheOneBefore) {
  session_.perform(kSubdivide);
  for (std::uint32_t i = 0; i < 3; ++i) {
    stroke(session_, i);
    pass(session_, kRest);
  }
  const fs::path left = killed();
  std::vector<LostWork> lost = find_lost_work(left);
  ASSERT_THAT(lost, SizeIs(1));
  ASSERT_THAT(lost.front().copies, SizeIs(3));
  fs::resize_file(lost.front().copies[0], fs::file_size(lost.front().copies[0]) / 2);
  EXPECT_EQ(painted(load_lost_work(lost.front()).value().document), 2);
  for (const fs::path& copy : lost.front().copies) {
    test::write_file(copy, "{}");
  }
  EXPECT_FALSE(load_lost_work(lost.front()));
  Session next(host(left));
  next.offer(std::move(lost));
  next.update(0.0);
  next.perform(kRecover);
  EXPECT_TRUE(std::holds_alternative<ui::ErrorDialog>(next.modal()));
  EXPECT_THAT(find_lost_work(left), SizeIs(1)) << "nothing is thrown away unasked";
}

TEST_F(RecoveryTest, AFolderThatCannotBeMadeIsSaidOnce) {
  const fs::path blocked = scratch_ / "file";
  test::write_file(blocked, "");
  SessionHost with_clock = host(blocked / "recovery");
  with_clock.wall_clock = [] { return std::string("14:05"); };
  Session session(std::move(with_clock));
  double now = 0.0;
  int said = 0;
  for (std::uint32_t face = 0; face < 5; ++face) {
    stroke(session, face);
    for (int i = 0; i < 3; ++i) {
      session.update(now += 70.0);
      session.finish_autosave();
      for (const ui::Toast& toast : session.toasts()) {
        said += toast.text.find("No copy of unsaved work") == 0 ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(said, 1);
  EXPECT_THAT(session.copies().problem, HasSubstr("recovery")) << "but stays to be seen";
  EXPECT_EQ(session.copies().when, "");
}

TEST_F(RecoveryTest, AKillAtAnyTimeLosesAMinuteOrOneOperation) {
  std::mt19937 random(12);
  session_.perform({kOpenBundled, std::string("grid")});
  struct Operation {
    double at;
    int painted;
  };
  std::vector<Operation> done{{0.0, 0}};
  for (int i = 0; i < 40; ++i) {
    if (random() % 4 == 0) {
      session_.perform(session_.document().stage.levels == 0 ? kSubdivide : kBackToControl);
    }
    const auto faces = static_cast<std::uint32_t>(session_.document().control->face_count());
    stroke(session_, static_cast<std::uint32_t>(random()) % faces);
    done.push_back({now_, painted(session_.document())});
    now_ += static_cast<double>(random() % 25);
    session_.update(now_);
    session_.finish_refinement();
    session_.update(now_);
    if (random() % 2 == 0) {
      session_.finish_autosave();
      session_.update(now_);
    }
    session_.finish_autosave();
    const auto lost = find_lost_work(killed());
    const int recovered = lost.empty() ? 0 : painted(load_lost_work(lost.front()).value().document);
    const auto state =
        std::ranges::find(done, recovered, [](const Operation& o) { return o.painted; });
    ASSERT_NE(state, done.end());
    const auto next_one = state + 1;
    const bool is_one_operation = next_one == done.end() || next_one + 1 == done.end();
    EXPECT_TRUE(is_one_operation || now_ - next_one->at <= Autosave::kSeconds)
        << i << ": " << now_ - next_one->at;
  }
}

}  // namespace
}  // namespace limn::app
