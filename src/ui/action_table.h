#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "ui/action.h"

namespace limn::ui {

/// What kind of value an action carries (action.h).
enum class ValueKind : std::uint8_t {
  kNone,
  kToggle,     ///< bool, or nothing to flip.
  kInt,        ///< Always.
  kDouble,     ///< Always.
  kText,       ///< Always.
  kPathOrAsk,  ///< std::string, or nothing to ask for it.
};

/// The heading under which the help sheet lists an action.
enum class ActionGroup : std::uint8_t {
  kFile,
  kEdit,
  kPaint,
  kRefine,
  kSchemes,
  kEdges,
  kDisplay,
  kCamera,
  kProgram,
  kAnswer,  ///< Answers to a dialog; not in the help sheet.
};

struct ActionInfo {
  ActionId id;
  ActionGroup group;
  ValueKind value;
  std::string_view label;    ///< "Remove illegal vertices": menus, buttons, help.
  std::string_view tooltip;  ///< One or two plain sentences.
};

/// Every action, in the order of ActionId.
[[nodiscard]] const std::array<ActionInfo, kActionCount>& action_table() noexcept;

[[nodiscard]] const ActionInfo& info(ActionId id) noexcept;

/// "Camera", for the help sheet.
[[nodiscard]] std::string_view heading(ActionGroup group) noexcept;

}  // namespace limn::ui
