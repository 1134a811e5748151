// The steps of legalisation: to and fro, what is illegal now, who is picked and why. Every line is
// always there, so that the buttons stay under the cursor.

#include <array>
#include <cmath>
#include <string>

#include "ui/format.h"
#include "ui/panels.h"
#include "ui/step_text.h"
#include "ui/widgets.h"

namespace limn::ui {
namespace {

constexpr std::size_t kShownCandidates = 5;
constexpr int kReasonLines = 6;

void buttons(PanelContext& context) {
  using enum ActionId;
  const float gap = context.px(6);
  const float width = std::floor((room() - 3.0F * gap) / 4.0F);
  const std::array choices{Choice{kStepFirst, "Before"}, Choice{kStepPrevious, "Back"},
                           Choice{kStepNext, "Next"}, Choice{kStepLast, "After"}};
  for (const Choice& choice : choices) {
    if (&choice != &choices.front()) {
      ImGui::SameLine(0.0F, gap);
    }
    action_button(
        context, choice.action,
        {.label = choice.label, .width = width, .is_primary = choice.action.id == kStepNext});
    remember(context, "step: " + std::string(choice.label));
  }
}

void reason(PanelContext& context, const StepperStatus& steps) {
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float width = room();
  const std::string text = step_reason(steps);
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  remember(context, "step reason");
  const float height = static_cast<float>(kReasonLines) * ImGui::GetTextLineHeight();
  ImGui::SetCursorScreenPos({start.x, start.y + height});
  ImGui::Dummy({width, context.px(2)});
}

void candidates(PanelContext& context, const StepperStatus& steps) {
  const bool is_greedy = steps.order == LegalisationMethod::kGreedy;
  sub_heading(context, is_greedy ? "Candidates: illegal neighbours / cost" : "Candidates: score");
  for (std::size_t i = 0; i < kShownCandidates; ++i) {
    const bool is_there = i < steps.candidates.size();
    const bool is_last = i + 1 == kShownCandidates && steps.candidates.size() > kShownCandidates;
    if (is_last) {
      value_row(context, {.label = "…and more",
                          .value = grouped(steps.candidates.size() - kShownCandidates + 1),
                          .meaning = "Further candidates, none better than those above."});
    } else {
      const std::string label = is_there ? (i == 0 ? "Picked: " : "") + std::string("vertex ") +
                                               grouped(steps.candidates[i].vertex)
                                         : std::string("–");
      value_row(
          context,
          {.label = label,
           .value = is_there ? step_key(steps, steps.candidates[i]) : std::string(),
           .meaning = is_greedy ? "Its illegal neighbours along edges, of which more are better, "
                                  "and the quads around it with three zeros, of which fewer are."
                                : "Quads mended less quads made illegal, plus 0.6 of what the best "
                                  "further step would mend, less 1 for every face it adds."});
    }
  }
}

}  // namespace

void draw_steps_section(PanelContext& context) {
  const StepperStatus& steps = context.model.steps;
  action_toggle(context, ActionId::kToggleSteps, room());
  ImGui::BeginDisabled(!steps.is_shown);
  buttons(context);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {context.px(8), context.px(1)});
  value_row(context,
            {.label = step_count_text(steps),
             .value = steps.has_trace && steps.order == LegalisationMethod::kGreedy ? "greedy order"
                      : steps.has_trace ? "looking ahead"
                                        : "",
             .meaning = "How many steps are made, and in whose order. Where the greedy "
                        "order gives fewer faces, looking ahead takes it."});
  const auto count = [&](std::size_t number) {
    return steps.has_trace ? grouped(number) : std::string("–");
  };
  value_row(context, {.label = "Illegal faces",
                      .value = count(steps.illegal_faces),
                      .meaning = "Quads that could not be split without a crack; hatched."});
  value_row(context, {.label = "Illegal vertices",
                      .value = count(steps.illegal_vertices),
                      .meaning = "Their corners labelled 0; dots in the same colour."});
  value_row(context, {.label = "Raised so far",
                      .value = count(steps.raised),
                      .meaning = "Vertices that have gone from 0 to 1; amber dots."});
  reason(context, steps);
  action_button(context, ActionId::kFrameStep);
  candidates(context, steps);
  ImGui::PopStyleVar();
  ImGui::EndDisabled();
}

}  // namespace limn::ui
