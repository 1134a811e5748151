#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include "ui/screen.h"

namespace limn::ui {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr WindowPoint kInViewport{200, 100};

PathPrompt prompt_to(PathPrompt::Purpose purpose, std::string suggested_name = {}) {
  PathPrompt prompt;
  prompt.purpose = purpose;
  prompt.serial = 1;
  prompt.folder = "/home/anna";
  prompt.parent = "/home";
  prompt.entries = {{"models", true, 0}, {"cube.limn", false, 4096}, {"spot.obj", false, 99}};
  prompt.suggested_name = std::move(suggested_name);
  return prompt;
}

TEST(Dialogs, AnErrorIsDismissedByItsButtonByEnterAndByEscape) {
  Screen screen;
  ErrorDialog dialog;
  dialog.title = "Cannot open spot.obj";
  dialog.error = {ErrorKind::kBadInput, "Vertex 9 does not exist.", "spot.obj", 12};
  screen.model.modal = dialog;
  screen.settle();
  screen.click("OK");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kCancel)));
  screen.key(Key::kEnter);
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kCancel)));
  screen.key(Key::kEscape);
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kCancel)));
}

TEST(Dialogs, OneCanBeThereFromTheFirstFrameOn) {
  Screen screen;
  screen.model.modal =
      RecoveryQuestion{"creature.limn", "/home/anna/creature.limn", "22 November, 14:05", 1};
  screen.settle();
  screen.key(Key::kEnter);
  screen.click("Discard");
  screen.click("Later");
  EXPECT_THAT(screen.take_actions(),
              ElementsAre(Action(ActionId::kRecover), Action(ActionId::kDiscardLost),
                          Action(ActionId::kCancel)));
}

TEST(Dialogs, TheStatusLineLiesBelowOneThatIsThereFromTheFirstFrameOn) {
  Screen screen;  // Lends its model.
  screen.model.modal = UnsavedQuestion{"cube", "quit"};
  Gui gui({}, {});
  for (int frame = 0; frame < 2; ++frame) {
    static_cast<void>(gui.frame(screen.model, {}, {1280, 800}));
  }
  const ImDrawData& drawn = gui.draw_data();
  const auto index_of = [&drawn](std::string_view name) {
    for (int i = 0; i < drawn.CmdListsCount; ++i) {
      const char* const owner = drawn.CmdLists[i]->_OwnerName;
      if (owner != nullptr && owner == name) {
        return i;
      }
    }
    return -1;
  };
  EXPECT_GE(index_of("##status"), 0);
  EXPECT_LT(index_of("##status"), index_of("##modal"));
}

TEST(Dialogs, NothingBehindADialogReacts) {
  Screen screen;
  const WindowPoint button = screen.middle("Raise all");
  screen.model.modal = UnsavedQuestion{"cube", "quit"};
  screen.settle();
  screen.click(button);
  screen.key(Key::kA);
  screen.key(Key::kZ, {.ctrl = true});
  EXPECT_THAT(screen.take_actions(), IsEmpty());
  screen.move(kInViewport);
  screen.button(MouseButton::kLeft, true);
  screen.frame();
  EXPECT_FALSE(screen.last().viewport_input.owns_drag);
}

TEST(Dialogs, ADialogThatIsGoneLeavesEverythingAlive) {
  Screen screen;
  screen.model.modal = HelpSheet{};
  screen.settle();
  ASSERT_TRUE(screen.has("Close"));
  screen.model.modal = std::monostate{};
  screen.settle();
  screen.click("Raise all");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kRaiseAll)));
}

TEST(Dialogs, F1OpensTheHelpSheetAndClosesIt) {
  Screen screen;
  screen.key(Key::kF1);
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kHelp)));
  screen.model.modal = HelpSheet{};
  screen.settle();
  screen.key(Key::kF1);
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kCancel)));
}

TEST(Dialogs, OneDialogCanFollowAnother) {
  Screen screen;
  screen.model.modal = OverBudgetQuestion{48'000'000, 3'000'000'000, 20'000'000};
  screen.settle();
  screen.click("Refine anyway");
  screen.model.modal = UnsavedQuestion{"cube", "quit"};
  screen.settle();
  EXPECT_FALSE(screen.has("Refine anyway"));
  screen.click("Discard changes");
  EXPECT_THAT(screen.take_actions(),
              ElementsAre(Action(ActionId::kRefineAnyway), Action(ActionId::kDiscardChanges)));
}

TEST(Dialogs, EnterTakesTheAnswerThatLosesNothing) {
  Screen screen;
  screen.model.modal = OverBudgetQuestion{48'000'000, 3'000'000'000, 20'000'000};
  screen.settle();
  screen.key(Key::kEnter);
  screen.model.modal = UnsavedQuestion{"cube", "quit"};
  screen.settle();
  screen.key(Key::kEnter);
  EXPECT_THAT(screen.take_actions(),
              ElementsAre(Action(ActionId::kCancel), Action(ActionId::kSaveFirst)));
}

TEST(Dialogs, AMenuThatIsOpenGivesWayToADialog) {
  Screen screen;
  screen.click("menu: File");
  screen.model.modal = HelpSheet{};
  screen.settle();
  EXPECT_FALSE(screen.has("menu: Quit"));
  screen.click("Close");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kCancel)));
}

TEST(PathPromptDialog, TypingANameAndEnterAnswersAndFiresNoKeys) {
  Screen screen;
  screen.model.modal = prompt_to(PathPrompt::Purpose::kSaveProject);
  screen.settle();
  screen.type(U"cab");
  EXPECT_TRUE(screen.last().wants_text);
  EXPECT_THAT(screen.take_actions(), IsEmpty());
  screen.key(Key::kEnter);
  EXPECT_THAT(screen.take_actions(),
              ElementsAre(Action(ActionId::kSaveProjectAs, std::string("/home/anna/cab.limn"))));
}

TEST(PathPromptDialog, TheSuggestedNameIsReplacedByTyping) {
  Screen screen;
  screen.model.modal = prompt_to(PathPrompt::Purpose::kExportRefined, "cube.obj");
  screen.settle();
  screen.type(U"xyz");
  screen.click("Export");
  EXPECT_THAT(screen.take_actions(),
              ElementsAre(Action(ActionId::kExportRefined, std::string("/home/anna/xyz.obj"))));
}

TEST(PathPromptDialog, AFormatChangesTheEnding) {
  Screen screen;
  PathPrompt prompt = prompt_to(PathPrompt::Purpose::kExportRefined, "cube.v2");
  prompt.losses[static_cast<std::size_t>(MeshFormat::kStl)] = "STL files do not hold: 3 creases.";
  screen.model.modal = prompt;
  screen.settle();
  const auto answer = [&](const char* format) {
    screen.click(std::string("format: ") + format);
    screen.click("Export");
    return std::get<std::string>(screen.take_actions().at(0).value);
  };
  EXPECT_EQ(answer("STL"), "/home/anna/cube.v2.stl");
  EXPECT_EQ(answer("PLY"), "/home/anna/cube.v2.ply");
  EXPECT_EQ(answer("OBJ"), "/home/anna/cube.v2.obj");
}

TEST(PathPromptDialog, TheButtonSaysWhenItWouldReplaceAFile) {
  Screen screen;
  screen.model.modal = prompt_to(PathPrompt::Purpose::kSaveProject, "cube.limn");
  screen.settle();
  EXPECT_FALSE(screen.has("Save"));
  screen.click("Replace");
  EXPECT_THAT(screen.take_actions(),
              ElementsAre(Action(ActionId::kSaveProjectAs, std::string("/home/anna/cube.limn"))));
}

TEST(PathPromptDialog, AFileIsOpenedByNameAndByDoubleClick) {
  Screen screen;
  screen.model.modal = prompt_to(PathPrompt::Purpose::kOpen);
  screen.settle();
  screen.click("entry: spot.obj");
  EXPECT_THAT(screen.take_actions(), IsEmpty());
  screen.click("Open");
  const Action open(ActionId::kOpen, std::string("/home/anna/spot.obj"));
  EXPECT_THAT(screen.take_actions(), ElementsAre(open));

  Screen other;
  other.model.modal = prompt_to(PathPrompt::Purpose::kOpen);
  other.settle();
  other.click("entry: spot.obj");
  other.click("entry: spot.obj");
  EXPECT_THAT(other.take_actions(), ElementsAre(open));
}

TEST(PathPromptDialog, FoldersAreBrowsed) {
  Screen screen;
  PathPrompt prompt = prompt_to(PathPrompt::Purpose::kOpen);
  screen.model.modal = prompt;
  screen.settle();
  screen.click("entry: models");
  screen.click("entry: models");
  screen.click("tool: Open folder");
  EXPECT_THAT(screen.take_actions(),
              ElementsAre(Action(ActionId::kBrowse, std::string("/home/anna/models")),
                          Action(ActionId::kBrowse, std::string("/home"))));
}

TEST(PathPromptDialog, AtTheRootThereIsNoWayUp) {
  Screen screen;
  PathPrompt prompt = prompt_to(PathPrompt::Purpose::kOpen);
  prompt.folder = "/";
  prompt.parent.clear();
  screen.model.modal = prompt;
  screen.settle();
  screen.click("tool: Open folder");
  EXPECT_THAT(screen.take_actions(), IsEmpty());
  screen.click("entry: spot.obj");
  screen.click("Open");
  EXPECT_THAT(screen.take_actions(),
              ElementsAre(Action(ActionId::kOpen, std::string("/spot.obj"))));
}

TEST(PathPromptDialog, EscapeCancelsEvenWhileTyping) {
  Screen screen;
  screen.model.modal = prompt_to(PathPrompt::Purpose::kSaveProject);
  screen.settle();
  screen.type(U"ab");
  screen.key(Key::kEscape);
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kCancel)));
}

TEST(PathPromptDialog, AnotherPromptStartsAfresh) {
  Screen screen;
  screen.model.modal = prompt_to(PathPrompt::Purpose::kSaveProject);
  screen.settle();
  screen.type(U"ab");
  screen.model.modal = std::monostate{};
  screen.settle();
  PathPrompt second = prompt_to(PathPrompt::Purpose::kSaveProject, "new.limn");
  second.serial = 2;
  screen.model.modal = second;
  screen.settle();
  screen.click("Save");
  EXPECT_THAT(screen.take_actions(),
              ElementsAre(Action(ActionId::kSaveProjectAs, std::string("/home/anna/new.limn"))));
}

}  // namespace
}  // namespace limn::ui
