// One scrolling column of sections. Its left edge can be dragged.

#include <algorithm>

#include "limn/document/document.h"
#include "ui/panels.h"
#include "ui/widgets.h"

namespace limn::ui {
namespace {

void drag_edge(PanelContext& context, const WindowRect& place) {
  const auto x = static_cast<float>(place.origin.x);
  const auto y = static_cast<float>(place.origin.y);
  const auto height = static_cast<float>(place.size.height);
  const float width = context.px(6);
  ImGui::SetCursorScreenPos({x, y});
  ImGui::InvisibleButton("##edge", {width, height});
  const bool is_lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (is_lit) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    list.AddRectFilled({x, y}, {x + context.px(2), y + height}, context.colours.accent);
  } else {
    list.AddLine({x + 0.5F, y}, {x + 0.5F, y + height}, context.colours.hairline, 1.0F);
  }
  if (ImGui::IsItemActive()) {
    context.state.layout.panel_width -=
        static_cast<double>(ImGui::GetIO().MouseDelta.x / context.unit);
  }
  explain(context, "Panel width", "Drag to make the panel wider or narrower.");
  remember(context, "panel edge");
}

}  // namespace

void draw_side_panel(PanelContext& context, const WindowRect& place) {
  const ImVec2 origin{static_cast<float>(place.origin.x), static_cast<float>(place.origin.y)};
  const ImVec2 size{static_cast<float>(place.size.width), static_cast<float>(place.size.height)};
  const ImGuiWindowFlags fixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                 ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                 ImGuiWindowFlags_NoSavedSettings;
  ImGui::SetNextWindowPos(origin);
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
  ImGui::Begin("##panel", nullptr,
               fixed | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PopStyleVar();
  drag_edge(context, place);
  ImGui::SetCursorPos({context.px(6), 0.0F});
  // Its own scrollbar is always given room, so that nothing shifts when a section unfolds.
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {context.px(12), context.px(4)});
  ImGui::BeginChild(
      "##sections", {size.x - context.px(6), size.y}, false,
      ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_AlwaysVerticalScrollbar);
  PanelLayout& layout = context.state.layout;
  const auto section = [&context](const char* title, bool& is_open, auto&& draw) {
    ImGui::PushID(title);
    if (begin_section(context, title, is_open)) {
      draw(context);
      ImGui::Dummy({0.0F, context.px(6)});
    }
    ImGui::PopID();
  };
  const ImportReport& report = context.model.document.import_report;
  if (report.is_mended() || !report.unused_data.empty()) {
    section(report.is_mended() ? "MENDED ON OPENING" : "LEFT OUT ON OPENING", layout.report_open,
            draw_report_section);
  }
  section("PAINT", layout.paint_open, draw_paint_section);
  section("AUTO DEPTH", layout.auto_depth_open, draw_auto_depth_section);
  section("SUBDIVIDE", layout.subdivide_open, draw_subdivide_section);
  section("STEP BY STEP", layout.steps_open, draw_steps_section);
  section("SCHEMES", layout.schemes_open, draw_schemes_section);
  section("DISPLAY", layout.display_open, draw_display_section);
  section("NUMBERS", layout.numbers_open, draw_numbers_section);
  section("HISTORY", layout.history_open, draw_history_section);
  ImGui::EndChild();
  ImGui::PopStyleVar();
  ImGui::End();
}

}  // namespace limn::ui
