// From the painting to the refined mesh. While a refinement runs, its progress stands where the
// buttons were, so that nothing below moves.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "limn/document/document.h"
#include "limn/subdivision/prediction.h"
#include "ui/format.h"
#include "ui/panels.h"
#include "ui/widgets.h"

namespace limn::ui {
namespace {

using enum ActionId;

void progress(PanelContext& context, const RunningRefinement& running) {
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
  if (const RefinementPrediction* prediction = context.model.refinement.prediction) {
    percent += " of " + grouped(prediction->faces);
  }
  const float percent_width = ImGui::CalcTextSize(percent.c_str()).x;
  const float text_y = std::floor(low.y + (height - bar - ImGui::GetFontSize()) / 2.0F);
  const float pad = context.px(10);
  const std::string stage = fit_text(running.stage, width - percent_width - 3.0F * pad);
  list.AddText({low.x + pad, text_y}, c.text, stage.c_str());
  list.AddText({high.x - pad - percent_width, text_y}, c.dim_text, percent.c_str());
  explain(context, "Refining", "The last finished mesh stays visible until this is done.", "");
  remember(context, "progress");
  action_button(context, kCancel);
}

void steps(PanelContext& context) {
  const float gap = context.px(6);
  const float width = std::floor((room() - gap) * 0.6F);
  action_button(context, kSubdivide, {.width = width, .is_primary = true});
  ImGui::SameLine(0.0F, gap);
  action_button(context, kSubdivideOneLevel, {.label = "One level"});
  action_button(context, kBackToControl);
}

std::string prediction_text(const RefinementPrediction* prediction) {
  if (prediction == nullptr) {
    return "…";
  }
  return counted(prediction->faces, "face") + ", " +
         percent_text(static_cast<double>(prediction->faces),
                      static_cast<double>(prediction->uniform_faces));
}

}  // namespace

void draw_subdivide_section(PanelContext& context) {
  const RefinementStatus& refinement = context.model.refinement;
  value_row(context, {.label = "To the end",
                      .value = prediction_text(refinement.prediction),
                      .meaning = "What subdividing gives for the painting as it is, known exactly "
                                 "beforehand, and its part of what uniform subdivision to the same "
                                 "depth would give."});
  if (refinement.running) {
    progress(context, *refinement.running);
  } else {
    steps(context);
  }

  sub_heading(context, "Illegal vertices");
  const LegalityStatus legality = refinement.legality.value_or(LegalityStatus{});
  value_row(context,
            {.label = "As painted",
             .value = refinement.legality ? counted(legality.illegal_vertices, "vertex", "vertices")
                                          : std::string("…"),
             .meaning = "Corners labelled 0 of quads with two labels 0 that could not be "
                        "split without a crack."});
  value_row(context,
            {.label = "Raised to mend them",
             .value = refinement.legality ? counted(legality.relabelled, "vertex", "vertices")
                                          : std::string("…"),
             .meaning = "Vertices whose label goes from 0 to 1 before subdividing, so that "
                        "no illegal quad is left."});
  action_choice(context, std::array{Choice{kLegaliseLookAhead, "Look ahead"},
                                    Choice{kLegaliseGreedy, "Greedy"}});
  action_button(context, kRemoveIllegal);

  sub_heading(context, "Faces that are not quads");
  action_choice(context, std::array{Choice{kNonQuadsUniformFirstStep, "Split all once"},
                                    Choice{kNonQuadsWherePainted, "Where painted"}});
  sub_heading(context, "Boundary corners");
  action_choice(context,
                std::array{Choice{kCornersSharp, "Stay"}, Choice{kCornersSmooth, "Round off"}});

  sub_heading(context, "Vertices");
  action_choice(context, std::array{Choice{kPointsLevel, "At their level"},
                                    Choice{kPointsLimit, "On the limit"}});
  sub_heading(context, "Texture coordinates");
  action_choice(context, std::array{Choice{kTextureSmoothInside, "Smooth inside"},
                                    Choice{kTextureLinear, "Linear"}});

  sub_heading(context, "Control mesh");
  const float gap = context.px(6);
  const float width = std::floor((room() - gap) * 0.4F);
  action_button(context, kApply, {.label = "Apply", .width = width});
  ImGui::SameLine(0.0F, gap);
  action_button(context, kRevert, {.label = "Revert to opened"});
}

}  // namespace limn::ui
