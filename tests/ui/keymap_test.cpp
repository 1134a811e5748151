#include "ui/keymap.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "ui/action_table.h"

namespace limn::ui {
namespace {

using testing::Optional;

constexpr KeymapId kKeymaps[] = {KeymapId::kOriginal, KeymapId::kClassroom};

TEST(Keymap, NoChordStandsTwice) {
  for (const KeymapId keymap : kKeymaps) {
    std::set<std::string> seen;
    for (const Binding& binding : bindings(keymap)) {
      EXPECT_TRUE(seen.insert(to_text(binding.chord)).second) << to_text(binding.chord);
    }
    EXPECT_GT(seen.size(), 40U);
  }
}

TEST(Keymap, ChordTextGoesThereAndBack) {
  const Modifiers all_modifiers[] = {{},
                                     {.shift = true},
                                     {.ctrl = true},
                                     {.alt = true},
                                     {.super = true},
                                     {.shift = true, .ctrl = true, .alt = true, .super = true}};
  for (std::size_t k = 0; k < kKeyCount; ++k) {
    for (const Modifiers& modifiers : all_modifiers) {
      const Chord chord{static_cast<Key>(k), modifiers};
      EXPECT_THAT(chord_from_text(to_text(chord)), Optional(chord)) << to_text(chord);
    }
  }
}

TEST(Keymap, EveryKeyHasANameOfItsOwn) {
  std::set<std::string> names;
  for (std::size_t k = 0; k < kKeyCount; ++k) {
    const std::string name = to_text({static_cast<Key>(k), {}});
    EXPECT_FALSE(name.empty()) << k;
    EXPECT_TRUE(names.insert(name).second) << name;
  }
}

TEST(Keymap, ForeignTextIsNoChord) {
  EXPECT_EQ(chord_from_text(""), std::nullopt);
  EXPECT_EQ(chord_from_text("Ctrl+"), std::nullopt);
  EXPECT_EQ(chord_from_text("Hyper+A"), std::nullopt);
  EXPECT_EQ(chord_from_text("a"), std::nullopt);
}

TEST(Keymap, OriginalKeepsTheKeysOfTheSeed) {
  const std::pair<const char*, ActionId> expected[] = {
      {"C", ActionId::kSubdivide},     {"X", ActionId::kSubdivideOneLevel},
      {"Z", ActionId::kZeroAll},       {"B", ActionId::kUndo},
      {"A", ActionId::kRaiseAll},      {"Space", ActionId::kLowerAll},
      {"J", ActionId::kRaiseDihedral}, {"K", ActionId::kRaiseVisible},
      {"O", ActionId::kRevert},        {"S", ActionId::kRemoveIllegal},
      {"T", ActionId::kToggleSmooth},  {"W", ActionId::kToggleWireframe}};
  for (const auto& [text, id] : expected) {
    EXPECT_THAT(action_for(KeymapId::kOriginal, *chord_from_text(text)), Optional(Action(id)))
        << text;
  }
}

TEST(Keymap, SharedKeysAreInEveryKeymap) {
  const std::pair<const char*, ActionId> expected[] = {{"Ctrl+Z", ActionId::kUndo},
                                                       {"Ctrl+Shift+Z", ActionId::kRedo},
                                                       {"Ctrl+O", ActionId::kOpen},
                                                       {"Ctrl+S", ActionId::kSaveProject},
                                                       {"Ctrl+E", ActionId::kExportRefined},
                                                       {"Ctrl+Shift+S", ActionId::kSaveProjectAs},
                                                       {"F1", ActionId::kHelp},
                                                       {"F12", ActionId::kScreenshot},
                                                       {"Esc", ActionId::kCancel},
                                                       {"Ctrl+Q", ActionId::kQuit},
                                                       {"[", ActionId::kBrushSmaller},
                                                       {"]", ActionId::kBrushBigger},
                                                       {"I", ActionId::kPickDepth},
                                                       {"Right", ActionId::kSchemeForward},
                                                       {"Left", ActionId::kSchemeBack},
                                                       {"Home", ActionId::kFrameAll},
                                                       {".", ActionId::kFrameHovered}};
  for (const KeymapId keymap : kKeymaps) {
    for (const auto& [text, id] : expected) {
      EXPECT_THAT(action_for(keymap, *chord_from_text(text)), Optional(Action(id))) << text;
    }
    for (int depth = 0; depth <= 9; ++depth) {
      EXPECT_THAT(action_for(keymap, *chord_from_text(std::to_string(depth))),
                  Optional(Action(ActionId::kSetTargetDepth, depth)));
    }
  }
}

TEST(Keymap, ClassroomHasItsOwnDisplayKeys) {
  const auto at = [](const char* text) {
    return action_for(KeymapId::kClassroom, *chord_from_text(text));
  };
  EXPECT_THAT(at("S"), Optional(Action(ActionId::kToggleSmooth)));
  EXPECT_THAT(at("F"), Optional(Action(ActionId::kToggleFaces)));
  EXPECT_THAT(at("E"), Optional(Action(ActionId::kToggleWireframe)));
  EXPECT_THAT(at("W"), Optional(Action(ActionId::kToggleWireframe)));
  EXPECT_THAT(at("L"), Optional(Action(ActionId::kToggleLight)));
  EXPECT_THAT(at("Page Up"), Optional(Action(ActionId::kZoomIn)));
}

TEST(Keymap, FirstChordIsTheOneInMenusAndAllAreInTooltips) {
  EXPECT_EQ(key_text(KeymapId::kOriginal, ActionId::kUndo), "Ctrl+Z");
  EXPECT_EQ(all_keys_text(KeymapId::kOriginal, ActionId::kUndo), "Ctrl+Z or B");
  EXPECT_EQ(key_text(KeymapId::kClassroom, ActionId::kRaiseAll), "");
  EXPECT_EQ(key_text(KeymapId::kOriginal, Action(ActionId::kSetTargetDepth, 10)), "Shift+0");
}

TEST(Keymap, BoundActionsCarryTheValueTheirKindNeeds) {
  for (const KeymapId keymap : kKeymaps) {
    for (const Binding& binding : bindings(keymap)) {
      const ValueKind kind = info(binding.action.id).value;
      EXPECT_NE(kind, ValueKind::kDouble);
      EXPECT_NE(kind, ValueKind::kText);
      EXPECT_EQ(kind == ValueKind::kInt, std::holds_alternative<int>(binding.action.value));
    }
  }
}

TEST(ActionTable, EveryActionHasALabelAndATooltipSentence) {
  std::set<std::string_view> labels;
  for (const ActionInfo& action : action_table()) {
    EXPECT_FALSE(action.label.empty());
    EXPECT_TRUE(labels.insert(action.label).second) << action.label;
    ASSERT_GT(action.tooltip.size(), 10U) << action.label;
    EXPECT_TRUE(action.tooltip.ends_with(".")) << action.label;
    EXPECT_FALSE(heading(action.group).empty());
  }
}

}  // namespace
}  // namespace limn::ui
