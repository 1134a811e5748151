#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "limn/error.h"
#include "limn/painting/paint_rule.h"

namespace limn {

/// Paint rules under a name.
struct RulePreset {
  std::string name;         ///< What follows `preset=`: see `check_preset_name`.
  std::string description;  ///< A sentence; may be empty.
  std::string rules;        ///< As `parse_paint_rules` reads them, one a line.

  [[nodiscard]] bool operator==(const RulePreset&) const = default;
};

/// Those that come with Limn, in the order lists show them.
[[nodiscard]] std::span<const RulePreset> bundled_presets();

/// Letters, digits, blanks, `-`, `_` and `.`, one to 40 of them, no blank at either end; and not
/// the name of a bundled preset, which cannot be replaced. Errors: kUsage, saying which it is.
[[nodiscard]] Result<void> check_preset_name(std::string_view name);

/// The rules of the preset with this name, of `own` ones or of the bundled ones.
/// Errors: kUsage where there is none, naming those that are, and where its rules cannot be read.
[[nodiscard]] Result<std::vector<PaintRule>> rules_of_preset(std::span<const RulePreset> own,
                                                             std::string_view name);

}  // namespace limn
