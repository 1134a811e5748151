// From the painting to the refined mesh. While a refinement runs, its progress stands where the
// buttons were, so that nothing below moves.

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

/// What Catmull-Clark's labels want.
void legalisation(PanelContext& context) {
  sub_heading(context, "Illegal vertices");
  const RefinementStatus& refinement = context.model.refinement;
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
}

/// What Loop's depths want.
void balance(PanelContext& context) {
  const std::optional<LegalityStatus>& legality = context.model.refinement.legality;
  sub_heading(context, "Steps between faces");
  value_row(context, {.label = "Deepened to one level",
                      .value = legality ? counted(legality->deepened, "face") : std::string("…"),
                      .meaning = "Faces beside deeper ones that are refined further than they are "
                                 "painted, so that faces sharing an edge differ by one level."});
}

}  // namespace

void draw_subdivide_section(PanelContext& context) {
  const RefinementStatus& refinement = context.model.refinement;
  value_row(context, {.label = "To the end",
                      .value = prediction_text(refinement.prediction),
                      .meaning = "What subdividing gives for the painting as it is, known exactly "
                                 "beforehand, and its part of what uniform subdivision to the same "
                                 "depth would give."});
  if (refinement.running && !context.model.document.scheme) {
    draw_progress(context, *refinement.running,
                  refinement.prediction != nullptr ? std::optional(refinement.prediction->faces)
                                                   : std::nullopt);
  } else {
    steps(context);
  }
  action_toggle(context, kToggleLive, room());

  sub_heading(context, "Painted faces by");
  action_choice(context,
                std::array{Choice{kAdaptiveCatmullClark, "Catmull-Clark"},
                           Choice{kAdaptiveLoop, "Loop"}, Choice{kAdaptiveLoopWarren, "Warren"}});
  const bool is_loop = context.model.document.settings.scheme == RefinementScheme::kLoop;
  if (is_loop) {
    balance(context);
  } else {
    legalisation(context);
  }
  sub_heading(context, "Boundary corners");
  action_choice(context,
                std::array{Choice{kCornersSharp, "Stay"}, Choice{kCornersSmooth, "Round off"}});

  if (!is_loop) {
    sub_heading(context, "Vertices");
    action_choice(context, std::array{Choice{kPointsLevel, "At their level"},
                                      Choice{kPointsLimit, "On the limit"}});
    sub_heading(context, "Texture coordinates");
    action_choice(context, std::array{Choice{kTextureSmoothInside, "Smooth inside"},
                                      Choice{kTextureLinear, "Linear"}});
  }

  sub_heading(context, "Control mesh");
  const float gap = context.px(6);
  const float width = std::floor((room() - gap) * 0.4F);
  action_button(context, kApply, {.label = "Apply", .width = width});
  ImGui::SameLine(0.0F, gap);
  action_button(context, kRevert, {.label = "Revert to opened"});
}

}  // namespace limn::ui
