#include <algorithm>
#include <cmath>
#include <string>

#include "ui/format.h"
#include "ui/panels.h"
#include "ui/widgets.h"

namespace limn::ui {

void draw_progress(PanelContext& context, const RunningRefinement& running,
                   std::optional<std::uint64_t> faces) {
  const ThemeColours& c = context.colours;
  const float width = room();
  const float height = context.px(28);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 high{low.x + width, low.y + height};
  ImGui::Dummy({width, height});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto fraction = static_cast<float>(std::clamp(running.fraction, 0.0, 1.0));
  list.AddRectFilled(low, high, c.field, context.px(4));
  const float bar = context.px(4);
  list.AddRectFilled({low.x, high.y - bar}, {low.x + width * fraction, high.y}, c.accent,
                     context.px(2));
  std::string percent = percent_text(running.fraction, 1.0);
  if (faces) {
    percent += " of " + grouped(*faces);
  }
  const float percent_width = ImGui::CalcTextSize(percent.c_str()).x;
  const float text_y = std::floor(low.y + (height - bar - ImGui::GetFontSize()) / 2.0F);
  const float pad = context.px(10);
  const std::string stage = fit_text(running.stage, width - percent_width - 3.0F * pad);
  list.AddText({low.x + pad, text_y}, c.text, stage.c_str());
  list.AddText({high.x - pad - percent_width, text_y}, c.dim_text, percent.c_str());
  explain(context, "Refining", "The last finished mesh stays visible until this is done.", "");
  remember(context, "progress");
  action_button(context, ActionId::kCancel);
}

}  // namespace limn::ui
