#include "limn/document/history.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace limn {
namespace {

/// Changes the document's name, and weighs as much as it is told to.
class Rename final : public Command {
 public:
  struct Weights {
    std::size_t applied = 1;
    std::size_t reverted = 1;
  };

  Rename(std::string name, Weights weights) : other_(std::move(name)), weights_(weights) {}
  explicit Rename(std::string name) : Rename(std::move(name), Weights{}) {}
  Rename(std::string name, std::size_t weight) : Rename(std::move(name), Weights{weight, weight}) {}

  void apply(Document& document) override {
    std::swap(document.name, other_);
    is_applied_ = true;
  }
  void revert(Document& document) override {
    std::swap(document.name, other_);
    is_applied_ = false;
  }
  [[nodiscard]] std::size_t bytes() const noexcept override {
    return is_applied_ ? weights_.applied : weights_.reverted;
  }
  [[nodiscard]] std::string name() const override {
    return is_applied_ ? "rename from " + other_ : "rename to " + other_;
  }

 private:
  std::string other_;
  Weights weights_;
  bool is_applied_ = false;
};

Document named(std::string name) {
  Document document;
  document.name = std::move(name);
  return document;
}

TEST(History, UndoesInReverseAndRedoesInOrder) {
  Document document = named("a");
  History history;
  EXPECT_FALSE(history.can_undo());
  EXPECT_FALSE(history.can_redo());
  history.execute(document, std::make_unique<Rename>("b"));
  history.execute(document, std::make_unique<Rename>("c"));
  EXPECT_EQ(document.name, "c");
  EXPECT_EQ(history.undo_name(), "rename from b");
  EXPECT_EQ(history.redo_name(), "");
  history.undo(document);
  EXPECT_EQ(document.name, "b");
  EXPECT_EQ(history.redo_name(), "rename to c");
  history.undo(document);
  EXPECT_EQ(document.name, "a");
  EXPECT_FALSE(history.can_undo());
  EXPECT_EQ(history.undo_name(), "");
  history.redo(document);
  history.redo(document);
  EXPECT_EQ(document.name, "c");
  EXPECT_FALSE(history.can_redo());
}

TEST(History, UndoAndRedoWithNothingThereDoNothing) {
  Document document = named("a");
  History history;
  history.undo(document);
  history.redo(document);
  EXPECT_EQ(document.name, "a");
  EXPECT_FALSE(history.is_modified());
}

TEST(History, ANewCommandForgetsWhatCouldBeRedone) {
  Document document = named("a");
  History history;
  history.execute(document, std::make_unique<Rename>("b", 100));
  history.undo(document);
  history.execute(document, std::make_unique<Rename>("c", 1));
  EXPECT_FALSE(history.can_redo());
  EXPECT_EQ(history.bytes(), 1U);
  history.undo(document);
  EXPECT_EQ(document.name, "a");
}

TEST(History, RecordDoesNotApplyAgain) {
  Document document = named("a");
  auto live = std::make_unique<Rename>("b");
  live->apply(document);
  History history;
  history.record(std::move(live));
  EXPECT_EQ(document.name, "b");
  history.undo(document);
  EXPECT_EQ(document.name, "a");
}

TEST(History, ForgetsTheOldestWhenOverBudget) {
  Document document = named("0");
  History history(10);
  for (const char* name : {"1", "2", "3", "4"}) {
    history.execute(document, std::make_unique<Rename>(name, 4));
  }
  EXPECT_EQ(history.bytes(), 8U);
  history.undo(document);
  history.undo(document);
  EXPECT_FALSE(history.can_undo());
  EXPECT_EQ(document.name, "2");
}

TEST(History, KeepsTheNewestHoweverBig) {
  Document document = named("0");
  History history(10);
  history.execute(document, std::make_unique<Rename>("1", 4));
  history.execute(document, std::make_unique<Rename>("2", 1000));
  EXPECT_EQ(history.bytes(), 1000U);
  history.undo(document);
  EXPECT_EQ(document.name, "1");
  EXPECT_FALSE(history.can_undo());
  history.redo(document);
  EXPECT_EQ(document.name, "2");
}

TEST(History, MeasuresACommandAgainWhenItIsUndone) {
  Document document = named("0");
  History history(20);
  history.execute(document, std::make_unique<Rename>("1", 4));
  history.execute(document, std::make_unique<Rename>("2", Rename::Weights{3, 18}));
  EXPECT_EQ(history.bytes(), 7U);
  history.undo(document);  // 4 + 18 is over the budget: the older one goes.
  EXPECT_EQ(history.bytes(), 18U);
  EXPECT_FALSE(history.can_undo());
  history.redo(document);
  EXPECT_EQ(history.bytes(), 3U);
  EXPECT_EQ(document.name, "2");
}

TEST(History, DropsTheFarthestRedoWhereNothingOlderIsLeft) {
  Document document = named("0");
  History history(20);
  history.execute(document, std::make_unique<Rename>("1", Rename::Weights{3, 18}));
  history.execute(document, std::make_unique<Rename>("2", 4));
  history.undo(document);
  history.undo(document);
  EXPECT_EQ(history.bytes(), 18U);
  history.redo(document);
  EXPECT_EQ(document.name, "1");
  EXPECT_FALSE(history.can_redo());
}

TEST(History, IsModifiedUntilSavedAndBackAtTheSavedState) {
  Document document = named("0");
  History history;
  EXPECT_FALSE(history.is_modified());
  history.execute(document, std::make_unique<Rename>("1"));
  EXPECT_TRUE(history.is_modified());
  history.undo(document);
  EXPECT_FALSE(history.is_modified());
  history.redo(document);
  history.mark_saved();
  EXPECT_FALSE(history.is_modified());
  history.undo(document);
  EXPECT_TRUE(history.is_modified());
  history.redo(document);
  EXPECT_FALSE(history.is_modified());
  history.clear();
  EXPECT_FALSE(history.is_modified());
  EXPECT_FALSE(history.can_undo());
  EXPECT_EQ(history.bytes(), 0U);
}

TEST(History, ASavedStateOnACutBranchCannotComeBack) {
  Document document = named("0");
  History history;
  history.execute(document, std::make_unique<Rename>("1"));
  history.mark_saved();
  history.undo(document);
  history.execute(document, std::make_unique<Rename>("2"));
  // As many steps from the beginning as when it was saved, but another state.
  EXPECT_TRUE(history.is_modified());
  history.undo(document);
  EXPECT_TRUE(history.is_modified());
}

TEST(History, ASavedStateBeforeAForgottenCommandCannotComeBack) {
  Document document = named("0");
  History history(8);
  for (const char* name : {"1", "2", "3"}) {
    history.execute(document, std::make_unique<Rename>(name, 4));
  }
  history.undo(document);
  history.undo(document);
  EXPECT_EQ(document.name, "1");
  EXPECT_FALSE(history.can_undo());
  EXPECT_TRUE(history.is_modified());
}

/// Against a list of states that is never trimmed: the state after every step, the saved mark and
/// the bound must agree with it.
void walk_at_random(std::uint32_t seed, std::size_t budget) {
  const bool is_bounded = budget < std::numeric_limits<std::size_t>::max();
  std::mt19937 random(seed);
  Document document = named("start");
  History history(budget);
  std::vector<std::string> states{"start"};
  std::size_t at = 0;
  std::ptrdiff_t saved = 0;  // -1 where the saved state is no longer in the list.
  for (int step = 0; step < 300; ++step) {
    const auto choice = random() % 10;
    if (choice < 4) {
      const Rename::Weights weights{1 + random() % 20, 1 + random() % 20};
      const std::string name = "state " + std::to_string(step);
      history.execute(document, std::make_unique<Rename>(name, weights));
      states.resize(at + 1);
      saved = saved > static_cast<std::ptrdiff_t>(at) ? -1 : saved;
      states.push_back(name);
      ++at;
    } else if (choice < 7 && history.can_undo()) {
      history.undo(document);
      ASSERT_GT(at, 0U);
      --at;
    } else if (choice < 9 && history.can_redo()) {
      history.redo(document);
      ++at;
      ASSERT_LT(at, states.size());
    } else if (choice == 9) {
      history.mark_saved();
      saved = static_cast<std::ptrdiff_t>(at);
      ASSERT_FALSE(history.is_modified());
    }
    ASSERT_EQ(document.name, states[at]);
    if (is_bounded) {
      // A single command may be over the budget; then there is no second one.
      ASSERT_TRUE(history.bytes() <= budget || !history.can_undo() || !history.can_redo());
      ASSERT_TRUE(history.is_modified() || saved == static_cast<std::ptrdiff_t>(at));
    } else {
      ASSERT_EQ(history.can_undo(), at > 0);
      ASSERT_EQ(history.can_redo(), at + 1 < states.size());
      ASSERT_EQ(history.is_modified(), saved != static_cast<std::ptrdiff_t>(at));
    }
  }
}

TEST(History, RandomWalksAgreeWithAListOfStates) {
  for (std::uint32_t seed = 1; seed <= 60; ++seed) {
    walk_at_random(seed, std::numeric_limits<std::size_t>::max());
    walk_at_random(seed, 60);
    walk_at_random(seed, 5);
    if (HasFatalFailure()) {
      return;
    }
  }
}

TEST(History, GoesToAnyStep) {
  Document document = named("0");
  History history;
  for (int i = 1; i <= 5; ++i) {
    history.execute(document, std::make_unique<Rename>(std::to_string(i)));
  }
  for (const std::size_t step : {2u, 5u, 0u, 3u, 3u, 99u}) {
    history.go_to(document, step);
    EXPECT_EQ(history.position(), std::min<std::size_t>(step, 5));
    EXPECT_EQ(document.name, std::to_string(history.position()));
  }
}

TEST(History, KnowsWhereItWasSavedAndWhatItForgot) {
  Document document = named("0");
  History history(3);
  EXPECT_EQ(history.saved_position(), 0u);
  history.execute(document, std::make_unique<Rename>("1"));
  history.mark_saved();
  history.execute(document, std::make_unique<Rename>("2"));
  EXPECT_EQ(history.saved_position(), 1u);
  EXPECT_FALSE(history.has_forgotten());
  history.execute(document, std::make_unique<Rename>("3"));
  history.execute(document, std::make_unique<Rename>("4"));
  EXPECT_TRUE(history.has_forgotten());
  EXPECT_EQ(history.saved_position(), 0u) << "one is forgotten";
  history.go_to(document, 0);
  EXPECT_EQ(document.name, "1") << "the earliest that can be reached";
}

}  // namespace
}  // namespace limn
