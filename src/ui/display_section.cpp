// What is drawn and how.

#include <array>
#include <cmath>

#include "ui/panels.h"
#include "ui/widgets.h"

namespace limn::ui {

void draw_display_section(PanelContext& context) {
  using enum ActionId;
  action_choice(context, std::array<Action, 3>{kShowControl, kShowRefined, kShowBoth});
  constexpr std::array<ActionId, 6> kToggles{kToggleWireframe,    kToggleSmooth,
                                             kToggleLight,        kToggleLabels,
                                             kToggleIllegalMarks, kToggleOrthographic};
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {context.px(8), context.px(2)});
  const float width = std::floor((room() - context.px(8)) / 2.0F);
  for (std::size_t i = 0; i < kToggles.size(); ++i) {
    if (i % 2 == 1) {
      ImGui::SameLine();
    }
    action_toggle(context, kToggles[i], width);
  }
  ImGui::PopStyleVar();
  action_choice(context, std::array<Action, 2>{kThemeDark, kThemeLight});
}

}  // namespace limn::ui
