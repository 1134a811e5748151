// The interface as someone uses it: controls are found where they were drawn.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <set>
#include <utility>

#include "ui/action_table.h"
#include "ui/keymap.h"
#include "ui/scheme_text.h"
#include "ui/screen.h"

namespace limn::ui {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr WindowPoint kOverMesh{400, 300};

TEST(Panels, AButtonEmitsItsActionOnce) {
  Screen screen;
  screen.click("Raise all");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kRaiseAll)));
  screen.click("Subdivide");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kSubdivide)));
  screen.click("tool: Orbit tool");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kToolOrbit)));
}

TEST(Panels, AToggleEmitsTheOtherValue) {
  Screen screen({1280, 1800});
  screen.model.display.wireframe = true;
  screen.click("Wireframe");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kToggleWireframe, false)));
  screen.model.display.wireframe = false;
  screen.click("Wireframe");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kToggleWireframe, true)));
}

TEST(Panels, ASwatchSetsTheTargetDepthAndMakesTheBrushUseIt) {
  Screen screen;
  screen.click("depth 4");
  EXPECT_THAT(screen.take_actions(),
              ElementsAre(Action(ActionId::kSetTargetDepth, 4), Action(ActionId::kBrushSets)));
  screen.model.brush.sets_depth = true;
  screen.click("depth 10");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kSetTargetDepth, 10)));
}

TEST(Panels, TrianglesMayBePaintedByLoop) {
  Screen screen({1280, 1800});
  screen.statistics.faces_by_sides = {{3, 20}, {4, 1}};
  screen.click("Loop");  // One face is a quad.
  EXPECT_THAT(screen.take_actions(), IsEmpty());
  screen.statistics.faces_by_sides = {{3, 20}};
  screen.click("Loop");
  screen.click("Warren");
  EXPECT_THAT(screen.take_actions(),
              ElementsAre(Action(ActionId::kAdaptiveLoop), Action(ActionId::kAdaptiveLoopWarren)));
  screen.document.settings.scheme = RefinementScheme::kLoop;
  screen.click("Catmull-Clark");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kAdaptiveCatmullClark)));
}

TEST(Panels, TheWayToRemoveIllegalVerticesIsAChoice) {
  Screen screen({1280, 1800});
  screen.click("Greedy");
  screen.document.settings.legalisation = LegalisationMethod::kGreedy;
  screen.click("Greedy");  // That is so already.
  screen.click("Look ahead");
  EXPECT_THAT(screen.take_actions(),
              ElementsAre(Action(ActionId::kLegaliseGreedy), Action(ActionId::kLegaliseLookAhead)));
}

TEST(Panels, CreasesAreClearedOnlyWhereThereAreAny) {
  Screen screen({1280, 1800});
  screen.click("Clear creases");
  EXPECT_THAT(screen.take_actions(), IsEmpty());
  screen.statistics.sharp_vertices = 1;
  screen.click("Clear creases");
  screen.click("Crease sharp edges");
  screen.click("Creases");
  EXPECT_THAT(screen.take_actions(),
              ElementsAre(Action(ActionId::kClearCreases), Action(ActionId::kCreaseDihedral),
                          Action(ActionId::kToggleCreases, false)));
}

TEST(Panels, WhatCannotBeDoneCannotBePressed) {
  Screen screen;
  ASSERT_TRUE(screen.model.history.undo_name.empty());
  screen.click("tool: Undo");
  screen.key(Key::kZ, {.ctrl = true});
  EXPECT_THAT(screen.take_actions(), IsEmpty());
  screen.model.history.undo_name = "paint 3 faces";
  screen.click("tool: Undo");
  screen.key(Key::kB);
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kUndo), Action(ActionId::kUndo)));
}

TEST(Panels, AMenuEntryEmitsItsActionAndClosesTheMenu) {
  Screen screen;
  screen.click("menu: View");
  ASSERT_TRUE(screen.has("menu: Frame all"));
  screen.click("menu: Frame all");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kFrameAll)));
  screen.settle();
  EXPECT_FALSE(screen.has("menu: Frame all"));
}

TEST(Panels, BundledMeshesAreInTheFileMenu) {
  Screen screen;
  screen.click("menu: File");
  screen.click("menu: Open bundled mesh");
  screen.settle();
  screen.click("menu: teapot");
  EXPECT_THAT(screen.take_actions(),
              ElementsAre(Action(ActionId::kOpenBundled, std::string("teapot"))));
}

TEST(Panels, EscapeClosesAMenuAndCancelsNothing) {
  Screen screen;
  screen.click("menu: Edit");
  ASSERT_TRUE(screen.has("menu: Zero all"));
  screen.key(Key::kEscape);
  screen.settle();
  EXPECT_FALSE(screen.has("menu: Zero all"));
  EXPECT_THAT(screen.take_actions(), IsEmpty());
  screen.key(Key::kEscape);
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kCancel)));
}

TEST(Panels, AClickBesideAnOpenMenuDoesNotPaint) {
  Screen screen;
  screen.click("menu: Edit");
  screen.move({800, 500});
  screen.settle();
  screen.button(MouseButton::kLeft, true);
  EXPECT_FALSE(screen.frame().viewport_input.owns_drag);
}

TEST(Panels, ASliderEmitsValuesInItsRange) {
  Screen screen;
  const WindowRect slider = screen.rect("Brush radius");
  screen.move({slider.origin.x + 20, slider.origin.y + 10});
  screen.settle();
  screen.button(MouseButton::kLeft, true);
  screen.move({slider.origin.x + 2000, slider.origin.y + 10});
  screen.settle();
  const std::vector<Action> actions = screen.take_actions();
  ASSERT_FALSE(actions.empty());
  EXPECT_EQ(actions.back(), Action(ActionId::kSetBrushRadius, kMaxBrushRadius));
}

TEST(Panels, AValueTypedIntoASliderFiresNoKeys) {
  Screen screen;
  const WindowPoint slider = screen.middle("Sharpness threshold");
  screen.move(slider);
  screen.settle();
  InputEvent click;
  click.time = 5.0;
  click.modifiers.ctrl = true;
  for (const bool is_down : {true, false}) {
    click.what = ButtonChanged{MouseButton::kLeft, is_down};
    screen.push(click);
  }
  screen.settle();
  ASSERT_TRUE(screen.last().wants_text);
  (void)screen.take_actions();
  for (const auto& [key, character] : {std::pair{Key::k4, U'4'}, std::pair{Key::k5, U'5'}}) {
    InputEvent typed;
    typed.time = 6.0;
    typed.what = KeyChanged{key, true, false};
    screen.push(typed);
    typed.what = TextTyped{character};
    screen.push(typed);
    typed.what = KeyChanged{key, false, false};
    screen.push(typed);
  }
  screen.settle();
  screen.key(Key::kEnter);
  const std::vector<Action> actions = screen.take_actions();
  ASSERT_FALSE(actions.empty());
  for (const Action& action : actions) {
    EXPECT_EQ(action.id, ActionId::kSetDihedralThreshold);
  }
  EXPECT_EQ(actions.back(), Action(ActionId::kSetDihedralThreshold, 45.0));
}

TEST(Panels, AClickOnAThatIsFollowedByAMoveToBInTheSameSlowFramePressesA) {
  Screen screen;
  const WindowPoint a = screen.middle("Raise all");
  const WindowPoint b = screen.middle("Zero all");
  screen.model.depth_counts = {3, 3};
  screen.model.frame_seconds = 0.3;
  screen.move(a);
  screen.button(MouseButton::kLeft, true);
  screen.button(MouseButton::kLeft, false);
  screen.move(b);
  screen.settle();
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kRaiseAll)));
}

TEST(Panels, ADragFromTheViewportPressesNoButton) {
  Screen screen;
  screen.move(kOverMesh);
  screen.settle();
  screen.button(MouseButton::kLeft, true);
  EXPECT_TRUE(screen.frame().viewport_input.owns_drag);
  const WindowPoint target = screen.middle("Raise all");
  screen.move(target);
  const ViewportInput dragging = screen.frame().viewport_input;
  EXPECT_TRUE(dragging.owns_drag);
  EXPECT_THAT(dragging.path, ElementsAre(target));
  screen.button(MouseButton::kLeft, false);
  EXPECT_TRUE(screen.frame().viewport_input.button.has_value());
  screen.settle();
  EXPECT_THAT(screen.take_actions(), IsEmpty());
}

TEST(Panels, ADragFromAPanelNeverReachesTheViewport) {
  Screen screen;
  screen.move(screen.middle("Brush radius"));
  screen.settle();
  screen.button(MouseButton::kLeft, true);
  screen.frame();
  screen.move(kOverMesh);
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(screen.frame().viewport_input.owns_drag);
    EXPECT_FALSE(screen.last().viewport_input.is_hovered);
  }
  screen.button(MouseButton::kLeft, false);
  EXPECT_FALSE(screen.frame().viewport_input.button.has_value());
}

TEST(Panels, AButtonReleasedElsewhereIsNotPressed) {
  Screen screen;
  screen.move(screen.middle("Raise all"));
  screen.settle();
  screen.button(MouseButton::kLeft, true);
  screen.move(kOverMesh);
  screen.button(MouseButton::kLeft, false);
  screen.settle();
  EXPECT_THAT(screen.take_actions(), IsEmpty());
}

TEST(Panels, TheWheelOverThePanelScrollsItAndNotTheView) {
  Screen screen;
  const double before = screen.rect("SUBDIVIDE").origin.y;
  screen.move(screen.middle("Raise all"));
  screen.settle();
  InputEvent turn;
  turn.time = 10.0;
  turn.what = WheelTurned{0.0, -3.0};
  screen.push(turn);
  EXPECT_EQ(screen.frame().viewport_input.wheel, WheelTurned{});
  screen.settle();
  EXPECT_LT(screen.rect("SUBDIVIDE").origin.y, before);
}

TEST(Panels, KeysReachTheirActions) {
  Screen screen;
  screen.model.depth_counts = {3, 3};
  screen.key(Key::kSpace);
  screen.key(Key::k7);
  screen.key(Key::kE, {.ctrl = true});
  EXPECT_THAT(screen.take_actions(),
              ElementsAre(Action(ActionId::kLowerAll), Action(ActionId::kSetTargetDepth, 7),
                          Action(ActionId::kExportRefined)));
  screen.key(Key::kEnter, {.ctrl = true});
  EXPECT_THAT(screen.take_actions(), IsEmpty()) << "nothing is refined that could be applied";
  screen.model.refinement.result = RefinementResult{.levels = 1};
  screen.key(Key::kEnter, {.ctrl = true});
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kApply)));
}

TEST(Panels, AHeldKeyRepeatsOnlyWhatMayRepeat) {
  Screen screen;
  for (const Key key : {Key::kA, Key::kRightBracket}) {
    InputEvent press;
    press.time = 1.0;
    press.what = KeyChanged{key, true, false};
    screen.push(press);
    press.what = KeyChanged{key, true, true};
    screen.push(press);
    screen.push(press);
  }
  screen.settle();
  EXPECT_THAT(screen.take_actions(),
              ElementsAre(Action(ActionId::kRaiseAll), Action(ActionId::kBrushBigger),
                          Action(ActionId::kBrushBigger), Action(ActionId::kBrushBigger)));
}

TEST(Panels, ASectionFoldsAndTheLayoutRemembersIt) {
  Screen screen;
  screen.click("PAINT");
  EXPECT_FALSE(screen.gui().layout().paint_open);
  EXPECT_FALSE(screen.has("Raise all"));
  screen.click("PAINT");
  EXPECT_TRUE(screen.has("Raise all"));
}

TEST(Panels, ThePanelCanBeDraggedWider) {
  Screen screen;
  const WindowPoint edge = screen.middle("panel edge");
  const double before = screen.last().viewport.size.width;
  screen.move(edge);
  screen.settle();
  screen.button(MouseButton::kLeft, true);
  screen.frame();
  screen.move({edge.x - 60.0, edge.y});
  screen.settle();
  screen.button(MouseButton::kLeft, false);
  screen.settle();
  EXPECT_NEAR(screen.gui().layout().panel_width, 380.0, 1.0);
  EXPECT_NEAR(screen.last().viewport.size.width, before - 60.0, 1.0);
}

TEST(Panels, NothingMovesWhenNumbersGrow) {
  Screen screen({1280, 2200});
  const auto rects = [&screen] {
    const std::span<const ItemRect> items = screen.gui().items();
    std::vector<WindowRect> all;
    for (const ItemRect& item : items) {
      all.push_back(item.rect);
    }
    return all;
  };
  const std::vector<WindowRect> before = rects();
  screen.statistics.vertices = 123'456'789;
  screen.statistics.faces = 98'765'432'109;
  screen.statistics.faces_by_sides[4] = 98'765'432'109;
  screen.prediction.faces = 1'234'567'890'123;
  screen.prediction.uniform_faces = 9'234'567'890'123;
  screen.model.depth_counts.fill(123'456'789);
  screen.model.dihedral_faces = 98'765'432;
  RefinementResult result;
  result.faces = 123'456'789;
  result.uniform_faces = 1'123'456'789;
  result.cracks = &screen.cracks;
  result.bytes = 12'345'678'901;
  screen.model.refinement.result = result;
  screen.model.refinement.legality = LegalityStatus{1'000'000, 2'000'000, 3'000'000, 0, 0};
  screen.model.hover = HoverInfo{98'765'432, 7, 4};
  screen.model.history.bytes = 123'456'789;
  screen.settle();
  EXPECT_EQ(rects(), before);
}

TEST(Panels, AProgressBarTakesThePlaceOfTheButtons) {
  Screen screen;
  const WindowRect below = screen.rect("Remove illegal vertices");
  screen.model.refinement.running = RunningRefinement{0.4, "Refining level 3"};
  screen.settle();
  EXPECT_TRUE(screen.has("progress"));
  EXPECT_FALSE(screen.has("Subdivide"));
  EXPECT_EQ(screen.rect("Remove illegal vertices"), below);
  screen.click("Cancel");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kCancel)));
}

TEST(Panels, EveryActionIsReachable) {
  std::set<ActionId> reached;
  for (const KeymapId keymap : {KeymapId::kOriginal, KeymapId::kClassroom}) {
    for (const Binding& binding : bindings(keymap)) {
      reached.insert(binding.action.id);
    }
  }
  Screen screen({1280, 3200});
  PanelLayout layout;
  layout.schemes_open = true;
  layout.steps_open = true;
  layout.auto_depth_open = true;
  screen.gui().set_layout(layout);
  screen.recent = {"/tmp/a.obj"};
  std::set<std::string> names;
  const auto look = [&] {
    for (const ItemRect& item : screen.gui().items()) {
      names.insert(item.name);
    }
  };
  look();
  for (const char* menu : {"menu: File", "menu: Edit", "menu: View", "menu: Mesh", "menu: Help"}) {
    screen.click(menu);
    look();
    screen.key(Key::kEscape);
    screen.settle();
  }
  for (const auto& [menu, sub_menu] :
       {std::pair("menu: Mesh", "menu: Painted faces"),
        std::pair("menu: Edit", "menu: Whole painting"),
        std::pair("menu: Mesh", "menu: Illegal vertices"),
        std::pair("menu: Mesh", "menu: Faces that are not quads"),
        std::pair("menu: Mesh", "menu: Boundary corners"),
        std::pair("menu: Mesh", "menu: Vertices"),
        std::pair("menu: Mesh", "menu: Texture coordinates"),
        std::pair("menu: Mesh", "menu: Step by step"),
        std::pair("menu: View", "menu: Face colours"), std::pair("menu: View", "menu: Material"),
        std::pair("menu: View", "menu: Navigation")}) {
    screen.click(menu);
    screen.click(sub_menu);
    screen.settle();
    look();
    screen.key(Key::kEscape);
    screen.settle();
  }
  for (const char* word : {"loop", "linear"}) {
    screen.document.scheme = scheme_from_word(word);
    screen.settle();
    look();
  }
  for (const char* rule : {"screen=4px", "curve=curvature,5/0,40/3"}) {
    screen.model.auto_depth.settings.rules = {parse_paint_rule(rule).value()};
    screen.settle();
    look();
  }
  screen.model.auto_depth.outcome = AutoDepthOutcome{1, {}, 0.5, 0, FaceBudget{}};
  screen.model.brush.tool = Tool::kSmartFill;
  screen.settle();
  look();
  for (const Modal& modal :
       {Modal(OverBudgetQuestion{}), Modal(UnsavedQuestion{}), Modal(RecoveryQuestion{})}) {
    screen.model.modal = modal;
    screen.settle();
    look();
  }
  for (const ActionInfo& action : action_table()) {
    const std::string label(action.label);
    const bool is_drawn = names.contains(label) || names.contains("menu: " + label) ||
                          names.contains("tool: " + label);
    // Bundled meshes, folders, schemes, their levels, steps of the history, mended places, flaws
    // and what depths are chosen by are reached by their names, tested where those are.
    const bool is_by_name =
        action.value == ValueKind::kText || action.id == ActionId::kSetSchemeLevel ||
        action.id == ActionId::kGoToStep || action.id == ActionId::kNextMend ||
        action.id == ActionId::kPreviousMend || action.id == ActionId::kNextFlaw ||
        action.id == ActionId::kPreviousFlaw || action.id == ActionId::kSetDepthSource ||
        action.id == ActionId::kSetDepthUnit || action.id == ActionId::kSetBudgetGoal ||
        action.id == ActionId::kSetSilhouettes;
    EXPECT_TRUE(reached.contains(action.id) || is_drawn || is_by_name) << label;
  }
}

struct WindowCase {
  WindowSize window;
  Scale scale;
};

class Windows : public testing::TestWithParam<WindowCase> {};

TEST_P(Windows, FitWithAViewportLeft) {
  const auto& [window, scale] = GetParam();
  Screen screen(window, scale);
  const WindowRect viewport = screen.last().viewport;
  EXPECT_GE(viewport.size.width, 230.0 * scale.interface);
  EXPECT_GE(viewport.size.height, 400.0);
  EXPECT_NEAR(viewport.origin.x, 44.0 * scale.interface, 1.0);
  for (const ItemRect& item : screen.gui().items()) {
    EXPECT_GE(item.rect.origin.x, 0.0) << item.name;
    EXPECT_LE(item.rect.origin.x + item.rect.size.width, window.width) << item.name;
    if (item.name.starts_with("tool: ")) {
      EXPECT_LE(item.rect.origin.y + item.rect.size.height, window.height) << item.name;
    }
  }
  const ImDrawData& data = screen.gui().draw_data();
  EXPECT_EQ(data.DisplaySize.x, static_cast<float>(window.width));
  EXPECT_EQ(data.FramebufferScale.x, static_cast<float>(scale.density));
  EXPECT_GT(data.TotalVtxCount, 1000);
  screen.click("Raise all");
  EXPECT_THAT(screen.take_actions(), Contains(Action(ActionId::kRaiseAll)));
}

INSTANTIATE_TEST_SUITE_P(Sizes, Windows,
                         testing::Values(WindowCase{{800, 600}, {}}, WindowCase{{1280, 800}, {}},
                                         WindowCase{{3840, 2160}, {}},
                                         WindowCase{{3840, 2160}, {2.0, 1.0}},
                                         WindowCase{{1920, 1080}, {1.0, 2.0}},
                                         WindowCase{{1600, 1000}, {1.5, 1.0}}));

TEST(Windows, AMinimisedOneDrawsNothing) {
  Screen screen;
  screen.window = {0, 0};
  EXPECT_THAT(screen.frame().actions, IsEmpty());
  screen.window = {1280, 800};
  screen.settle();
  screen.click("Raise all");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kRaiseAll)));
}

TEST(Windows, AnotherScaleMakesAnotherAtlas) {
  Screen screen;
  const std::uint64_t before = screen.gui().atlas_revision();
  screen.gui().set_scale({});
  EXPECT_EQ(screen.gui().atlas_revision(), before);
  screen.gui().set_scale({2.0, 1.0});
  EXPECT_GT(screen.gui().atlas_revision(), before);
  screen.window = {2560, 1600};
  screen.settle();
  EXPECT_NEAR(screen.last().viewport.origin.x, 88.0, 1.0);
  screen.click("Raise all");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kRaiseAll)));
}

}  // namespace
}  // namespace limn::ui
