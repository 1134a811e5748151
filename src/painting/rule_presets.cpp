#include "limn/painting/rule_presets.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace limn {
namespace {

constexpr std::size_t kLongestName = 40;

bool is_name_sign(char sign) {
  return (sign >= 'a' && sign <= 'z') || (sign >= 'A' && sign <= 'Z') ||
         (sign >= '0' && sign <= '9') ||
         std::string_view(" -_.").find(sign) != std::string_view::npos;
}

const RulePreset* find(std::span<const RulePreset> presets, std::string_view name) {
  const auto found = std::ranges::find(presets, name, &RulePreset::name);
  return found == presets.end() ? nullptr : &*found;
}

}  // namespace

std::span<const RulePreset> bundled_presets() {
  static const std::array<RulePreset, 8> presets{{
      {"draft", "At most 5,000 faces, where they count most.", "budget=5000\n"},
      {"game", "At most 20,000 triangles, where they count most.", "budget=20000t\n"},
      {"print", "Within 0.05 % of the diagonal: no facets on a 3D print of 20 cm.",
       "tolerance=0.0005d,measured\n"},
      {"exact", "Within 0.01 % of the diagonal, for measuring and milling.", "tolerance=0.0001d\n"},
      {"still", "For a picture from this view: nowhere half a pixel beside the limit surface.",
       "tolerance=0.5px\n"},
      {"screen", "For this view: edges of at most 6 pixels, and a level more at silhouettes.",
       "screen=6px\n"},
      {"curved", "Finer where the surface bends within a face, flat places left alone.",
       "curve=curvature,5/0,20/1,45/2,90/3\n"},
      {"even", "Faces of about one size: each doubling of their edges is a level.",
       "curve=edge,0.01/0,0.02/1,0.04/2,0.08/3,0.16/4\n"},
  }};
  return presets;
}

Result<void> check_preset_name(std::string_view name) {
  if (name.empty() || name.size() > kLongestName || name.front() == ' ' || name.back() == ' ' ||
      !std::ranges::all_of(name, is_name_sign)) {
    return fail(ErrorKind::kUsage,
                fmt::format("\"{}\" is no name for a preset: it has letters, digits, blanks, - _ "
                            "and . in it, up to {} of them.",
                            name, kLongestName));
  }
  if (find(bundled_presets(), name) != nullptr) {
    return fail(ErrorKind::kUsage,
                fmt::format("\"{}\" is a preset that comes with Limn; take another name.", name));
  }
  return {};
}

Result<std::vector<PaintRule>> rules_of_preset(std::span<const RulePreset> own,
                                               std::string_view name) {
  const RulePreset* preset = find(own, name);
  if (preset == nullptr) {
    preset = find(bundled_presets(), name);
  }
  if (preset == nullptr) {
    std::vector<std::string_view> names;
    for (const std::span<const RulePreset> presets : {bundled_presets(), own}) {
      std::ranges::transform(presets, std::back_inserter(names), &RulePreset::name);
    }
    return fail(ErrorKind::kUsage, fmt::format("There is no preset \"{}\". There are: {}.", name,
                                               fmt::join(names, ", ")));
  }
  return parse_paint_rules(preset->rules, fmt::format("preset {}", preset->name));
}

}  // namespace limn
