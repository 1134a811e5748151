// The panel that steps through a legalisation, and what it says of each step.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "ui/screen.h"
#include "ui/step_text.h"

namespace limn::ui {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class StepsSection : public testing::Test {
 protected:
  StepsSection() : screen_({1280, 2000}) {
    PanelLayout layout;
    layout.steps_open = true;
    screen_.gui().set_layout(layout);
    screen_.settle();
  }
  /// Two steps are made of five, and these are the candidates.
  void show(std::vector<LegalisationCandidate> candidates,
            LegalisationMethod order = LegalisationMethod::kGreedy) {
    candidates_ = std::move(candidates);
    StepperStatus& steps = screen_.model.steps;
    steps = {};
    steps.is_shown = steps.has_trace = true;
    steps.order = order;
    steps.position = 2;
    steps.size = 5;
    steps.candidates = candidates_;
    screen_.settle();
  }
  [[nodiscard]] std::string reason() const { return step_reason(screen_.model.steps); }

  Screen screen_;
  std::vector<LegalisationCandidate> candidates_;
  std::vector<std::uint32_t> falling_;
};

TEST_F(StepsSection, ButtonsStep) {
  screen_.click("Show the steps");
  EXPECT_THAT(screen_.take_actions(), ElementsAre(Action(ActionId::kToggleSteps, true)));
  screen_.click("step: Next");
  EXPECT_THAT(screen_.take_actions(), IsEmpty()) << "not before they are shown";
  show({{.vertex = 7, .valence = 2, .cost = 1}});
  for (const char* name : {"step: Before", "step: Back", "step: Next", "step: After"}) {
    screen_.click(name);
  }
  EXPECT_THAT(screen_.take_actions(),
              ElementsAre(Action(ActionId::kStepFirst), Action(ActionId::kStepPrevious),
                          Action(ActionId::kStepNext), Action(ActionId::kStepLast)));
  screen_.model.steps.position = 5;
  screen_.click("step: Next");
  EXPECT_THAT(screen_.take_actions(), IsEmpty()) << "there is none after the last";
}

TEST_F(StepsSection, KeysStepToo) {
  show({{.vertex = 7, .valence = 2, .cost = 1}});
  screen_.key(Key::kRightArrow, {.shift = true});
  screen_.key(Key::kLeftArrow, {.shift = true});
  EXPECT_THAT(screen_.take_actions(),
              ElementsAre(Action(ActionId::kStepNext), Action(ActionId::kStepPrevious)));
}

TEST_F(StepsSection, NothingJumpsFromStepToStep) {
  show({{.vertex = 7, .valence = 2, .cost = 1}});
  const WindowRect before = screen_.rect("step: Next");
  const WindowRect below = screen_.rect("SCHEMES");
  show({{.vertex = 1, .is_beside_leaf = true, .valence = 2, .cost = 1},
        {.vertex = 2, .is_beside_leaf = true, .valence = 2, .cost = 1},
        {.vertex = 3, .is_beside_leaf = true, .valence = 2, .cost = 1},
        {.vertex = 4, .is_beside_leaf = true, .valence = 1, .cost = 1},
        {.vertex = 5, .is_beside_leaf = true, .valence = 1, .cost = 1},
        {.vertex = 6, .is_beside_leaf = true, .valence = 1, .cost = 1}});
  EXPECT_EQ(screen_.rect("step: Next"), before);
  EXPECT_EQ(screen_.rect("SCHEMES"), below);
}

TEST_F(StepsSection, ItSaysInWhichKeyThePickedOneWins) {
  show({{.vertex = 7, .valence = 2, .cost = 1}});
  EXPECT_EQ(reason(), "Vertex 7 rises from 0 to 1 next. It is the only one.");
  show({{.vertex = 7, .valence = 3, .cost = 1}, {.vertex = 2, .valence = 2, .cost = 0}});
  EXPECT_THAT(reason(), HasSubstr("Of 2 candidates it has the most illegal neighbours (3)."));
  show({{.vertex = 7, .valence = 3, .cost = 1}, {.vertex = 2, .valence = 3, .cost = 2}});
  EXPECT_THAT(reason(), HasSubstr("the fewest quads with three zeros (1)"));
  show({{.vertex = 2, .valence = 3, .cost = 2}, {.vertex = 7, .valence = 3, .cost = 2}});
  EXPECT_THAT(reason(), HasSubstr("of equals the lowest number is taken"));
  show({{.vertex = 2, .is_beside_leaf = true, .valence = 1, .cost = 2}});
  EXPECT_THAT(reason(), HasSubstr("a single illegal neighbour"));
}

TEST_F(StepsSection, ItSaysScoresOfLookAhead) {
  show({{.vertex = 7, .score = 1.6F}, {.vertex = 2, .score = -2.0F}},
       LegalisationMethod::kLookAhead);
  EXPECT_THAT(reason(), HasSubstr("Its score of 1.6 is the highest of 2 candidates"));
  EXPECT_EQ(step_key(screen_.model.steps, candidates_[1]), "−2.0");
  show({{.vertex = 7, .score = 1.6F}, {.vertex = 2, .score = 1.6F}},
       LegalisationMethod::kLookAhead);
  EXPECT_THAT(reason(), HasSubstr("is not exceeded"));
}

TEST_F(StepsSection, ItSaysWhatGoesBackAndWhatHasBecome) {
  show({});
  falling_ = {4};
  screen_.model.steps.falling = falling_;
  EXPECT_THAT(reason(), HasSubstr("Vertex 4 goes back to 0 next"));
  falling_ = {4, 9};
  screen_.model.steps.falling = falling_;
  EXPECT_THAT(reason(), HasSubstr("Vertices 4 and 9 go back to 0 together"));
  show({});
  screen_.model.steps.position = 5;
  screen_.model.steps.raised = 5;
  EXPECT_THAT(reason(), HasSubstr("Nothing is illegal any more: 5 vertices"));
  screen_.model.steps.position = screen_.model.steps.size = 0;
  EXPECT_THAT(reason(), HasSubstr("nothing is illegal"));
}

TEST_F(StepsSection, TheCountTellsWhereItStands) {
  show({});
  EXPECT_EQ(step_count_text(screen_.model.steps), "Step 2 of 5");
  screen_.model.steps.position = 0;
  EXPECT_EQ(step_count_text(screen_.model.steps), "Before 5 steps");
  screen_.model.steps.size = 0;
  EXPECT_EQ(step_count_text(screen_.model.steps), "No step is needed");
}

}  // namespace
}  // namespace limn::ui
