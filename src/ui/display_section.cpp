// What is drawn and how.

#include <array>
#include <cmath>

#include "ui/panels.h"
#include "ui/widgets.h"

namespace limn::ui {

void draw_display_section(PanelContext& context) {
  using enum ActionId;
  action_choice(context, std::array{Choice{kShowControl, "Control"},
                                    Choice{kShowRefined, "Refined"}, Choice{kShowBoth, "Both"}});
  constexpr std::array<ActionId, 10> kToggles{
      kToggleFaces,  kToggleWireframe,    kToggleSmooth,  kToggleLight,    kToggleNumbers,
      kToggleLabels, kToggleIllegalMarks, kToggleCreases, kToggleValences, kToggleOrthographic};
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {context.px(8), context.px(2)});
  const float width = std::floor((room() - context.px(8)) / 2.0F);
  for (std::size_t i = 0; i < kToggles.size(); ++i) {
    if (i % 2 == 1) {
      ImGui::SameLine();
    }
    action_toggle(context, kToggles[i], width);
  }
  ImGui::PopStyleVar();
  action_toggle(context, kCompareUniform, room());
  sub_heading(context, "Face colours");
  action_choice(context, std::array{Choice{kTintDepth, "Depth"}, Choice{kTintLevel, "Level"},
                                    Choice{kTintDistance, "Distance"}, Choice{kTintNone, "None"}});
  sub_heading(context, "Material");
  action_choice(context,
                std::array{Choice{kMaterialStudio, "Studio"}, Choice{kMaterialClay, "Clay"},
                           Choice{kMaterialDark, "Dark stone"}, Choice{kMaterialShiny, "Polish"}});
  sub_heading(context, "Theme");
  action_choice(context, std::array{Choice{kThemeDark, "Dark"}, Choice{kThemeLight, "Light"}});
}

}  // namespace limn::ui
