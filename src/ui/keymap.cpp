// A keymap is the bindings that all share followed by its own. Lookup is a linear search: a hundred
// entries, once a key press.

#include "ui/keymap.h"

#include <array>
#include <cstddef>
#include <vector>

namespace limn::ui {
namespace {

constexpr Modifiers kPlain{};
constexpr Modifiers kShift{.shift = true};
constexpr Modifiers kCtrl{.ctrl = true};
constexpr Modifiers kCtrlShift{.shift = true, .ctrl = true};

struct KeyName {
  Key key;
  std::string_view name;
};

constexpr std::array<KeyName, 45> kOtherNames{{
    {Key::kNumpad0, "Numpad 0"},
    {Key::kNumpad1, "Numpad 1"},
    {Key::kNumpad2, "Numpad 2"},
    {Key::kNumpad3, "Numpad 3"},
    {Key::kNumpad4, "Numpad 4"},
    {Key::kNumpad5, "Numpad 5"},
    {Key::kNumpad6, "Numpad 6"},
    {Key::kNumpad7, "Numpad 7"},
    {Key::kNumpad8, "Numpad 8"},
    {Key::kNumpad9, "Numpad 9"},
    {Key::kNumpadDecimal, "Numpad ."},
    {Key::kNumpadDivide, "Numpad /"},
    {Key::kNumpadMultiply, "Numpad *"},
    {Key::kNumpadSubtract, "Numpad -"},
    {Key::kNumpadAdd, "Numpad +"},
    {Key::kNumpadEnter, "Numpad Enter"},
    {Key::kSpace, "Space"},
    {Key::kEnter, "Enter"},
    {Key::kEscape, "Esc"},
    {Key::kTab, "Tab"},
    {Key::kBackspace, "Backspace"},
    {Key::kDelete, "Delete"},
    {Key::kInsert, "Insert"},
    {Key::kHome, "Home"},
    {Key::kEnd, "End"},
    {Key::kPageUp, "Page Up"},
    {Key::kPageDown, "Page Down"},
    {Key::kLeftArrow, "Left"},
    {Key::kRightArrow, "Right"},
    {Key::kUpArrow, "Up"},
    {Key::kDownArrow, "Down"},
    {Key::kLeftBracket, "["},
    {Key::kRightBracket, "]"},
    {Key::kPeriod, "."},
    {Key::kComma, ","},
    {Key::kSlash, "/"},
    {Key::kMinus, "-"},
    {Key::kEqual, "="},
    {Key::kSemicolon, ";"},
    {Key::kApostrophe, "'"},
    {Key::kGrave, "`"},
    {Key::kBackslash, "\\"},
    {Key::kF10, "F10"},
    {Key::kF11, "F11"},
    {Key::kF12, "F12"},
}};

std::string key_name(Key key) {
  const auto index_from = [key](Key first) {
    return static_cast<int>(key) - static_cast<int>(first);
  };
  if (key <= Key::kZ) {
    return {static_cast<char>('A' + index_from(Key::kA))};
  }
  if (key <= Key::k9) {
    return {static_cast<char>('0' + index_from(Key::k0))};
  }
  if (key <= Key::kF9) {
    return {'F', static_cast<char>('1' + index_from(Key::kF1))};
  }
  for (const KeyName& entry : kOtherNames) {
    if (entry.key == key) {
      return std::string(entry.name);
    }
  }
  return {};
}

std::vector<Binding> shared_bindings() {
  using enum ActionId;
  std::vector<Binding> all{
      {{Key::kO, kCtrl}, kOpen},
      {{Key::kS, kCtrl}, kSaveProject},
      {{Key::kS, kCtrlShift}, kSaveProjectAs},
      {{Key::kE, kCtrl}, kExportRefined},
      {{Key::kF12, kPlain}, kScreenshot},
      {{Key::kQ, kCtrl}, kQuit},
      {{Key::kZ, kCtrl}, kUndo},
      {{Key::kZ, kCtrlShift}, kRedo},
      {{Key::kY, kCtrl}, kRedo},
      {{Key::kF1, kPlain}, kHelp},
      {{Key::kEscape, kPlain}, kCancel},

      {{Key::kP, kPlain}, kToolPaint},
      {{Key::kP, kShift}, kToolLower},
      {{Key::kU, kShift}, kToolSmartFill},
      {{Key::kQ, kPlain}, kToolRectangle},
      {{Key::kQ, kShift}, kToolLasso},
      {{Key::kI, kShift}, kToolPick},
      {{Key::kV, kPlain}, kToolOrbit},
      {{Key::kD, kShift}, kToolSplitEdge},
      {{Key::kF, kShift}, kToolFlipEdge},
      {{Key::kD, kPlain}, kSplitEdge},
      {{Key::kG, kPlain}, kFlipEdge},
      {{Key::kEqual, kShift}, kBrushAdds},
      {{Key::kEqual, kPlain}, kBrushSets},
      {{Key::kI, kPlain}, kPickDepth},
      {{Key::kLeftBracket, kPlain}, kBrushSmaller},
      {{Key::kRightBracket, kPlain}, kBrushBigger},
      {{Key::kH, kPlain}, kTogglePaintThrough},
      {{Key::kY, kPlain}, kToggleFine},
      {{Key::kX, kShift}, kToggleMirrorX},
      {{Key::kY, kShift}, kToggleMirrorY},
      {{Key::kZ, kShift}, kToggleMirrorZ},
      {{Key::kRightBracket, kShift}, kGrowPainting},
      {{Key::kLeftBracket, kShift}, kShrinkPainting},
      {{Key::kS, kShift}, kSmoothPainting},
      {{Key::kI, kCtrl}, kInvertPainting},
      {{Key::kM, kCtrl}, kMirrorPainting},
      {{Key::kD, kCtrl}, kChooseDepths},

      {{Key::kC, kShift}, kBackToControl},
      {{Key::kL, kShift}, kToggleLive},
      {{Key::kEnter, kCtrl}, kApply},
      {{Key::kF2, kPlain}, kShowControl},
      {{Key::kF3, kPlain}, kShowRefined},
      {{Key::kF4, kPlain}, kShowBoth},
      {{Key::kL, kPlain}, kToggleLight},
      {{Key::kN, kPlain}, kToggleLabels},
      {{Key::kM, kPlain}, kToggleIllegalMarks},
      {{Key::kM, kShift}, kToggleCreases},
      {{Key::kN, kShift}, kToggleValences},
      {{Key::kN, kCtrl}, kToggleNumbers},
      {{Key::kF5, kPlain}, kTintDepth},
      {{Key::kF6, kPlain}, kTintLevel},
      {{Key::kF7, kPlain}, kTintNone},
      {{Key::kF7, kShift}, kTintDistance},
      {{Key::kF8, kPlain}, kCompareUniform},
      {{Key::kRightArrow, kPlain}, kSchemeForward},
      {{Key::kLeftArrow, kPlain}, kSchemeBack},
      {{Key::kRightArrow, kShift}, kStepNext},
      {{Key::kLeftArrow, kShift}, kStepPrevious},
      {{Key::kUpArrow, kShift}, kStepFirst},
      {{Key::kDownArrow, kShift}, kStepLast},
      {{Key::kPeriod, kShift}, kFrameStep},
      {{Key::kJ, kShift}, kCreaseDihedral},

      {{Key::kHome, kPlain}, kFrameAll},
      {{Key::kHome, kShift}, kFramePainted},
      {{Key::kPeriod, kPlain}, kFrameHovered},
      {{Key::kNumpadDecimal, kPlain}, kFrameHovered},
      {{Key::kPageUp, kPlain}, kZoomIn},
      {{Key::kPageDown, kPlain}, kZoomOut},
      {{Key::kNumpadAdd, kPlain}, kZoomIn},
      {{Key::kNumpadSubtract, kPlain}, kZoomOut},
      {{Key::kNumpad1, kPlain}, kViewFront},
      {{Key::kNumpad1, kCtrl}, kViewBack},
      {{Key::kNumpad3, kPlain}, kViewRight},
      {{Key::kNumpad3, kCtrl}, kViewLeft},
      {{Key::kNumpad7, kPlain}, kViewTop},
      {{Key::kNumpad7, kCtrl}, kViewBottom},
      {{Key::kNumpad0, kPlain}, kViewIso},
      {{Key::kNumpad5, kPlain}, kToggleOrthographic},
  };
  for (int depth = 0; depth <= 9; ++depth) {
    all.push_back({{static_cast<Key>(static_cast<int>(Key::k0) + depth), kPlain},
                   Action(kSetTargetDepth, depth)});
  }
  all.push_back({{Key::k0, kShift}, Action(kSetTargetDepth, 10)});
  return all;
}

std::vector<Binding> make_original() {
  using enum ActionId;
  std::vector<Binding> all = shared_bindings();
  all.insert(all.end(), {
                            {{Key::kC, kPlain}, kSubdivide},
                            {{Key::kX, kPlain}, kSubdivideOneLevel},
                            {{Key::kZ, kPlain}, kZeroAll},
                            {{Key::kB, kPlain}, kUndo},
                            {{Key::kA, kPlain}, kRaiseAll},
                            {{Key::kF, kPlain}, kToolFill},
                            {{Key::kU, kPlain}, kToolFill},
                            {{Key::kSpace, kPlain}, kLowerAll},
                            {{Key::kJ, kPlain}, kRaiseDihedral},
                            {{Key::kK, kPlain}, kRaiseVisible},
                            {{Key::kO, kPlain}, kRevert},
                            {{Key::kS, kPlain}, kRemoveIllegal},
                            {{Key::kT, kPlain}, kToggleSmooth},
                            {{Key::kW, kPlain}, kToggleWireframe},
                            {{Key::kW, kShift}, kToggleFaces},
                        });
  return all;
}

std::vector<Binding> make_classroom() {
  using enum ActionId;
  std::vector<Binding> all = shared_bindings();
  all.insert(all.end(), {
                            {{Key::kC, kPlain}, kSubdivide},
                            {{Key::kX, kPlain}, kSubdivideOneLevel},
                            {{Key::kR, kPlain}, kRemoveIllegal},
                            {{Key::kS, kPlain}, kToggleSmooth},
                            {{Key::kF, kPlain}, kToggleFaces},
                            {{Key::kU, kPlain}, kToolFill},
                            {{Key::kE, kPlain}, kToggleWireframe},
                            {{Key::kW, kPlain}, kToggleWireframe},
                        });
  return all;
}

}  // namespace

std::span<const Binding> bindings(KeymapId keymap) {
  static const std::vector<Binding> original = make_original();
  static const std::vector<Binding> classroom = make_classroom();
  return keymap == KeymapId::kOriginal ? original : classroom;
}

std::optional<Action> action_for(KeymapId keymap, const Chord& chord) {
  for (const Binding& binding : bindings(keymap)) {
    if (binding.chord == chord) {
      return binding.action;
    }
  }
  return std::nullopt;
}

std::optional<Chord> chord_for(KeymapId keymap, const Action& action) {
  for (const Binding& binding : bindings(keymap)) {
    if (binding.action == action) {
      return binding.chord;
    }
  }
  return std::nullopt;
}

std::string to_text(const Chord& chord) {
  std::string text;
  if (chord.modifiers.ctrl) {
    text += "Ctrl+";
  }
  if (chord.modifiers.alt) {
    text += "Alt+";
  }
  if (chord.modifiers.shift) {
    text += "Shift+";
  }
  if (chord.modifiers.super) {
    text += "Super+";
  }
  return text + key_name(chord.key);
}

std::optional<Chord> chord_from_text(std::string_view text) {
  Chord chord;
  const auto take = [&text](std::string_view prefix) {
    if (!text.starts_with(prefix)) {
      return false;
    }
    text.remove_prefix(prefix.size());
    return true;
  };
  chord.modifiers.ctrl = take("Ctrl+");
  chord.modifiers.alt = take("Alt+");
  chord.modifiers.shift = take("Shift+");
  chord.modifiers.super = take("Super+");
  for (std::size_t k = 0; k < kKeyCount; ++k) {
    if (key_name(static_cast<Key>(k)) == text) {
      chord.key = static_cast<Key>(k);
      return chord;
    }
  }
  return std::nullopt;
}

std::string key_text(KeymapId keymap, const Action& action) {
  const std::optional<Chord> chord = chord_for(keymap, action);
  return chord ? to_text(*chord) : std::string();
}

std::string all_keys_text(KeymapId keymap, const Action& action) {
  std::string text;
  for (const Binding& binding : bindings(keymap)) {
    if (binding.action == action) {
      text += (text.empty() ? "" : " or ") + to_text(binding.chord);
    }
  }
  return text;
}

bool repeats(ActionId id) noexcept {
  using enum ActionId;
  return id == kUndo || id == kRedo || id == kBrushBigger || id == kBrushSmaller || id == kZoomIn ||
         id == kZoomOut || id == kStepNext || id == kStepPrevious;
}

}  // namespace limn::ui
