// Whatever wants an answer first. The model says what is asked; ImGui's popup is opened and closed
// to follow it. Enter takes the answer that loses nothing, Esc cancels (keys.cpp).

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <imgui_internal.h>

#include "ui/format.h"
#include "ui/panels.h"
#include "ui/widgets.h"

namespace limn::ui {
namespace {

using enum ActionId;

void title(const PanelContext& context, const std::string& text) {
  ImGui::PushFont(context.fonts.body_strong);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopFont();
}

void paragraph(const std::string& text) {
  ImGui::PushTextWrapPos(0.0F);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
}

struct Answer {
  Action action;
  std::string_view label;
  bool is_default = false;
};

/// Buttons at the lower right, the default one last; Enter presses it.
void answers(PanelContext& context, std::span<const Answer> all) {
  ImGui::Dummy({0.0F, context.px(4)});
  const float gap = context.px(8);
  const auto width_of = [&](const Answer& answer) {
    const std::string_view label = answer.label;
    return std::max(
        context.px(96),
        ImGui::CalcTextSize(label.data(), label.data() + label.size()).x + context.px(32));
  };
  float width = -gap;
  for (const Answer& answer : all) {
    width += width_of(answer) + gap;
  }
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, room() - width));
  bool is_first = true;
  for (const Answer& answer : all) {
    if (!is_first) {
      ImGui::SameLine(0.0F, gap);
    }
    is_first = false;
    action_button(
        context, answer.action,
        {.label = answer.label, .width = width_of(answer), .is_primary = answer.is_default});
    if (answer.is_default && is_enter_pressed()) {
      context.emit(answer.action);
    }
  }
}

void draw(PanelContext&, const std::monostate&) {}

void draw(PanelContext& context, const ErrorDialog& dialog) {
  title(context, dialog.title);
  if (!dialog.error.path.empty()) {
    std::string place = dialog.error.path;
    if (dialog.error.line > 0) {
      place += ", line " + std::to_string(dialog.error.line);
    }
    ImGui::PushStyleColor(ImGuiCol_Text, context.colours.dim_text);
    paragraph(place);
    ImGui::PopStyleColor();
  }
  paragraph(dialog.error.message);
  answers(context, std::array{Answer{kCancel, "OK", true}});
}

void draw(PanelContext& context, const OverBudgetQuestion& question) {
  if (question.memory > 0) {
    title(context, "Not enough memory for " + counted(question.faces, "face"));
    paragraph("The mesh would take " + bytes_text(question.bytes) + "; this machine has " +
              bytes_text(question.memory) + " to spare. Lower some depths to get fewer faces.");
    answers(context, std::array{Answer{kCancel, "OK", true}});
    return;
  }
  title(context, "Refine to " + counted(question.faces, "face") + "?");
  paragraph("That is more than the budget of " + grouped(question.budget) +
            ". The mesh would take " + bytes_text(question.bytes) +
            ". Lower some depths to get fewer faces.");
  answers(context,
          std::array{Answer{kRefineAnyway, "Refine anyway"}, Answer{kCancel, "Cancel", true}});
}

void draw(PanelContext& context, const UnsavedQuestion& question) {
  title(context, "Save changes to " + question.document + "?");
  paragraph("What was painted since the last save is lost if you " + question.next +
            " without saving.");
  answers(context, std::array{Answer{kDiscardChanges, "Discard changes"}, Answer{kCancel, "Cancel"},
                              Answer{kSaveFirst, "Save", true}});
}

void draw(PanelContext& context, const RecoveryQuestion& question) {
  title(context, "Recover " + question.document + "?");
  if (!question.path.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, context.colours.dim_text);
    paragraph(question.path);
    ImGui::PopStyleColor();
  }
  std::string text =
      "Limn ended before this was saved. The newest copy of it is of " + question.when + ".";
  if (question.others > 0) {
    text += " There is more from other runs.";
  }
  paragraph(text);
  answers(context, std::array{Answer{kDiscardLost, "Discard"}, Answer{kCancel, "Later"},
                              Answer{kRecover, "Recover", true}});
}

void draw(PanelContext& context, const HelpSheet&) {
  draw_help_sheet(context);
}

void draw(PanelContext& context, const PathPrompt& prompt) {
  draw_path_prompt(context, prompt);
}

void draw(PanelContext& context, const DesktopDialogNote& note) {
  title(context, "Choose a file");
  paragraph(
      "A dialog of your desktop asks for it. If you do not see it, it lies behind this window.");
  answers(context, std::array{Answer{Action(kBrowse, note.folder), "Use Limn's own instead"},
                              Answer{kCancel, "Cancel", true}});
}

/// Design units. Height 0: as high as the contents.
ImVec2 wanted_size(const Modal& modal) {
  if (std::holds_alternative<HelpSheet>(modal)) {
    return {880.0F, 740.0F};
  }
  if (std::holds_alternative<PathPrompt>(modal)) {
    return {620.0F, 520.0F};
  }
  return {460.0F, 0.0F};
}

}  // namespace

bool is_enter_pressed() {
  return ImGui::IsKeyPressed(static_cast<int>(Key::kEnter), false) ||
         ImGui::IsKeyPressed(static_cast<int>(Key::kNumpadEnter), false);
}

void close_popups() {
  if (ImGui::GetCurrentContext()->OpenPopupStack.Size > 0) {
    ImGui::ClosePopupToLevel(0, true);
  }
}

void draw_modal(PanelContext& context, WindowSize window) {
  const Modal& modal = context.model.modal;
  std::size_t& open = context.state.open_modal;
  if (open != modal.index()) {
    close_popups();
    open = modal.index();
  }
  if (open == 0) {
    return;
  }
  constexpr const char* kId = "##modal";
  if (!ImGui::IsPopupOpen(kId)) {
    ImGui::OpenPopup(kId);
  }
  const auto width = static_cast<float>(window.width);
  const auto height = static_cast<float>(window.height);
  const ImVec2 wanted = wanted_size(modal);
  const float margin = context.px(32);
  ImGui::SetNextWindowPos({std::floor(width / 2.0F), std::floor(height * 0.46F)}, ImGuiCond_Always,
                          {0.5F, wanted.y > 0.0F ? 0.46F : 0.5F});
  ImGui::SetNextWindowSize(
      {std::min(context.px(wanted.x), width - margin),
       wanted.y > 0.0F ? std::min(context.px(wanted.y), height - margin) : 0.0F});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {context.px(24), context.px(20)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, context.px(6));
  ImGui::PushStyleVar(ImGuiStyleVar_PopupRounding, context.px(6));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {context.px(8), context.px(10)});
  if (ImGui::BeginPopupModal(kId, nullptr,
                             ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                 ImGuiWindowFlags_NoSavedSettings)) {
    std::visit([&context](const auto& which) { draw(context, which); }, modal);
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(4);
  // No fading in: the ground is dimmed at once.
  ImGui::GetCurrentContext()->DimBgRatio = 1.0F;
}

}  // namespace limn::ui
