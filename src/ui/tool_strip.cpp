// The tools, then the things one reaches for all the time; help at the foot. In a low window all of
// them are smaller.

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/panels.h"
#include "ui/widgets.h"

namespace limn::ui {
namespace {

struct Entry {
  ActionId id;
  Icon icon;
};

constexpr std::array<Entry, 10> kTools{{{ActionId::kToolPaint, Icon::kRingPlus},
                                        {ActionId::kToolLower, Icon::kRingMinus},
                                        {ActionId::kToolFill, Icon::kBucket},
                                        {ActionId::kToolSmartFill, Icon::kWand},
                                        {ActionId::kToolRectangle, Icon::kRectangle},
                                        {ActionId::kToolLasso, Icon::kLasso},
                                        {ActionId::kToolPick, Icon::kDropper},
                                        {ActionId::kToolOrbit, Icon::kOrbit},
                                        {ActionId::kToolSplitEdge, Icon::kSplitEdge},
                                        {ActionId::kToolFlipEdge, Icon::kFlipEdge}}};
constexpr std::array<Entry, 4> kOften{{{ActionId::kToggleFine, Icon::kFine},
                                       {ActionId::kUndo, Icon::kUndo},
                                       {ActionId::kRedo, Icon::kRedo},
                                       {ActionId::kFrameAll, Icon::kFrame}}};

/// As large as lets all of them stand below each other.
float button_side(const PanelContext& context, float height) {
  constexpr auto kRows = static_cast<float>(kTools.size() + kOften.size() + 1);
  // The rim above and below, the line between, and a gap below each button.
  const float taken = context.px(2 * 8) + context.px(2 * 4 + 2 * 4) + kRows * context.px(4);
  return std::floor(std::clamp((height - taken) / kRows, context.px(24), context.px(36)));
}

}  // namespace

void draw_tool_strip(PanelContext& context, const WindowRect& place) {
  const auto width = static_cast<float>(place.size.width);
  const auto height = static_cast<float>(place.size.height);
  const float side = button_side(context, height);
  const ImVec2 origin{static_cast<float>(place.origin.x), static_cast<float>(place.origin.y)};
  ImGui::SetNextWindowPos(origin);
  ImGui::SetNextWindowSize({width, height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {(width - side) / 2.0F, context.px(8)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, context.px(4)});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, context.colours.chrome);
  ImGui::Begin("##tools", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoScrollWithMouse |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  for (const Entry& tool : kTools) {
    icon_button(context, tool.id, tool.icon, side);
  }
  ImGui::Dummy({side, context.px(4)});
  const ImVec2 line = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddLine({line.x + context.px(6), line.y}, {line.x + side - context.px(6), line.y},
               context.colours.hairline, 1.0F);
  ImGui::Dummy({side, context.px(4)});
  for (const Entry& entry : kOften) {
    icon_button(context, entry.id, entry.icon, side);
  }
  const float foot = height - side - context.px(8);
  if (ImGui::GetCursorPosY() < foot) {
    ImGui::SetCursorPosY(foot);
  }
  icon_button(context, ActionId::kHelp, Icon::kQuestion, side);
  const float edge = origin.x + width - 0.5F;
  list.AddLine({edge, origin.y}, {edge, origin.y + height}, context.colours.hairline, 1.0F);
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
}

}  // namespace limn::ui
