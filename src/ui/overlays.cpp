// What lies over the viewport and takes no clicks: legend, axes, toasts.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ui/panels.h"
#include "ui/widgets.h"

namespace limn::ui {
namespace {

struct Axis {
  const char* name;
  std::array<double, 3> direction;
  ImU32 colour;
};

constexpr std::array<Axis, 3> kAxes{{{"X", {1, 0, 0}, IM_COL32(0xE0, 0x5A, 0x5A, 0xFF)},
                                     {"Y", {0, 1, 0}, IM_COL32(0x6F, 0xB0, 0x4A, 0xFF)},
                                     {"Z", {0, 0, 1}, IM_COL32(0x5B, 0x8D, 0xE0, 0xFF)}}};

/// Right, up and towards the viewer of a direction in the mesh's frame (ViewState's yaw, pitch).
std::array<double, 3> to_view(const ViewState& view, const std::array<double, 3>& d) {
  const double yaw = view.yaw * std::numbers::pi / 180.0;
  const double pitch = view.pitch * std::numbers::pi / 180.0;
  const double right = std::cos(yaw) * d[0] - std::sin(yaw) * d[2];
  const double ahead = std::sin(yaw) * d[0] + std::cos(yaw) * d[2];
  return {right, std::cos(pitch) * d[1] - std::sin(pitch) * ahead,
          std::sin(pitch) * d[1] + std::cos(pitch) * ahead};
}

void draw_axes(PanelContext& context, ImDrawList& list, ImVec2 centre) {
  struct Arm {
    const Axis* axis;
    std::array<double, 3> seen;
  };
  std::array<Arm, 3> arms{};
  for (std::size_t i = 0; i < arms.size(); ++i) {
    arms[i] = {&kAxes[i], to_view(context.model.view, kAxes[i].direction)};
  }
  std::sort(arms.begin(), arms.end(),
            [](const Arm& a, const Arm& b) { return a.seen[2] < b.seen[2]; });
  ImFont* font = context.fonts.head;
  const float size = font->FontSize * ImGui::GetIO().FontGlobalScale;
  const float length = context.px(24);
  for (const Arm& arm : arms) {
    const ImVec2 tip{centre.x + static_cast<float>(arm.seen[0]) * length,
                     centre.y - static_cast<float>(arm.seen[1]) * length};
    const ImU32 colour = faded(arm.axis->colour, arm.seen[2] < -0.1 ? 0.55F : 1.0F);
    list.AddLine(centre, tip, colour, context.px(2));
    list.AddCircleFilled(tip, context.px(8), colour);
    const ImVec2 text = font->CalcTextSizeA(size, 1.0e6F, 0.0F, arm.axis->name);
    list.AddText(font, size, {std::floor(tip.x - text.x / 2.0F), std::floor(tip.y - text.y / 2.0F)},
                 IM_COL32_WHITE, arm.axis->name);
  }
}

void draw_toasts(PanelContext& context, ImDrawList& list, const WindowRect& viewport) {
  const ThemeColours& c = context.colours;
  const auto left = static_cast<float>(viewport.origin.x);
  const auto width = static_cast<float>(viewport.size.width);
  float y = static_cast<float>(viewport.origin.y) + context.px(16);
  const float height = context.px(36);
  const float pad = context.px(14);
  for (const Toast& toast : context.model.toasts) {
    const std::string text = fit_text(toast.text, width - 4.0F * pad - context.px(16));
    const float box = ImGui::CalcTextSize(text.c_str()).x + 2.0F * pad + context.px(16);
    const ImVec2 low{std::floor(left + (width - box) / 2.0F), y};
    const ImVec2 high{low.x + box, low.y + height};
    list.AddRectFilled(low, high, c.popup, context.px(6));
    list.AddRect(low, high, c.hairline, context.px(6));
    const ImU32 mark = toast.kind == Toast::Kind::kProblem
                           ? c.problem
                           : (toast.kind == Toast::Kind::kDone ? swatch_colour(2) : c.dim_text);
    list.AddCircleFilled({low.x + pad + context.px(3), low.y + height / 2.0F}, context.px(4), mark);
    list.AddText(
        {low.x + pad + context.px(16), std::floor(low.y + (height - ImGui::GetFontSize()) / 2.0F)},
        c.text, text.c_str());
    y += height + context.px(8);
  }
}

}  // namespace

void draw_overlays(PanelContext& context, const WindowRect& viewport) {
  // The background list lies under every window and over the picture.
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 low{static_cast<float>(viewport.origin.x), static_cast<float>(viewport.origin.y)};
  const ImVec2 high{low.x + static_cast<float>(viewport.size.width),
                    low.y + static_cast<float>(viewport.size.height)};
  list.PushClipRect(low, high);
  const float margin = context.px(16);
  const LegendLook look{context.fonts, context.colours, context.unit};
  const WindowSize legend = legend_size(look);
  if (legend.height + 2.0 * static_cast<double>(margin) < viewport.size.height) {
    draw_legend(list, look, context.model.depth_counts,
                {low.x + margin, high.y - margin - static_cast<float>(legend.height)});
    const WindowSize creases = crease_legend_size(look);
    const double both = legend.width + creases.width + 8.0 * static_cast<double>(margin);
    if (context.model.display.creases && has_creases(context.model.crease_counts) &&
        both < viewport.size.width) {
      draw_crease_legend(list, look, context.model.crease_counts,
                         {low.x + 1.5F * margin + static_cast<float>(legend.width),
                          high.y - margin - static_cast<float>(creases.height)});
    }
  }
  draw_axes(context, list, {high.x - margin - context.px(32), high.y - margin - context.px(32)});
  draw_toasts(context, list, viewport);
  list.PopClipRect();
}

}  // namespace limn::ui
