// What was mended or left out when the mesh was opened, a paragraph for each kind; where elements
// are told one by one, buttons lead from one to the next.

#include <string>

#include "limn/document/document.h"
#include "ui/format.h"
#include "ui/panels.h"
#include "ui/widgets.h"

namespace limn::ui {
namespace {

void paragraph(PanelContext& context, const std::string& text, ImU32 colour) {
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + room());
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  remember(context, text);
}

bool is_shown(const PanelContext& context, const Mend& mend) {
  return context.model.mend_focus && context.model.mend_focus->kind == mend.kind;
}

/// "2 of 3 · line 41", or how many there are to be shown where that is not all.
std::string where(const PanelContext& context, const Mend& mend) {
  const std::size_t told = mend.elements.size();
  if (!is_shown(context, mend)) {
    return told < mend.count ? "the first " + grouped(told) : std::string();
  }
  const std::size_t element = context.model.mend_focus->element;
  return grouped(element + 1) + " of " + grouped(told) + " · " +
         place_of(context.model.document.import_report, mend, mend.elements[element]);
}

/// The way onwards stays in its place, so that whoever presses it again goes on.
void way_to_elements(PanelContext& context, const Mend& mend) {
  const auto kind = static_cast<int>(mend.kind);
  const std::string name(name_of(mend.kind));
  const bool has_ends = is_shown(context, mend) && mend.elements.size() > 1;
  action_button(context, Action(ActionId::kNextMend, kind),
                {.label = has_ends ? "Next" : "Show", .width = context.px(56)});
  remember(context, "next of " + name);
  if (has_ends) {
    ImGui::SameLine();
    action_button(context, Action(ActionId::kPreviousMend, kind),
                  {.label = "Back", .width = context.px(56)});
    remember(context, "previous of " + name);
  }
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, context.colours.dim_text);
  const std::string text = where(context, mend);
  ImGui::TextUnformatted(fit_text(text, room()).c_str());
  ImGui::PopStyleColor();
  if (!text.empty()) {
    explain(context, "Place", text);
  }
}

}  // namespace

void draw_report_section(PanelContext& context) {
  const ImportReport& report = context.model.document.import_report;
  for (const Mend& mend : report.mends) {
    ImGui::PushID(static_cast<int>(mend.kind));
    paragraph(context, sentence_of(mend.kind, mend.count), context.colours.text);
    if (!mend.elements.empty()) {
      way_to_elements(context, mend);
    }
    ImGui::Dummy({0.0F, context.px(4)});
    ImGui::PopID();
  }
  if (!report.unused_data.empty()) {
    std::string text = "Not used:";
    for (const std::string& data : report.unused_data) {
      text += (&data == &report.unused_data.front() ? " " : ", ") + data;
    }
    paragraph(context, text + ".", context.colours.dim_text);
  }
}

}  // namespace limn::ui
