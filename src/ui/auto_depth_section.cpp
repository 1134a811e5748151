// Depths by a rule: what it goes by, how its depths meet those that are painted, then the one
// button and what came of it.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "limn/document/document.h"
#include "limn/mesh/control_mesh.h"
#include "ui/action_table.h"
#include "ui/availability.h"
#include "ui/format.h"
#include "ui/panels.h"
#include "ui/widgets.h"

namespace limn::ui {
namespace {

using enum ActionId;

constexpr const char* kUnknown = "–";

template <class T>
Action number_action(ActionId id, T value) {
  return {id, static_cast<int>(value)};
}

double diagonal_of(const PanelContext& context) {
  return context.model.document.control->bounds().diagonal();
}

void amount_slider(PanelContext& context, const DepthChoice& choice) {
  const std::optional<MainAmount> amount = main_amount(choice, diagonal_of(context));
  if (!amount) {
    return;
  }
  const bool counts = std::holds_alternative<FaceBudget>(choice);
  action_slider(context, kSetDepthAmount, amount->value,
                {.label = "At most",
                 .format = counts ? "%.0f" : "%.3g",
                 .low = amount->low,
                 .high = amount->high,
                 .is_logarithmic = true,
                 .digits = 3});
}

void tolerance_controls(PanelContext& context) {
  using Unit = ChooseByTolerance::Unit;
  action_choice(context,
                std::array{Choice{number_action(kSetDepthUnit, Unit::kDiagonals), "Diagonals"},
                           Choice{number_action(kSetDepthUnit, Unit::kLength), "Units"},
                           Choice{number_action(kSetDepthUnit, Unit::kPixels), "Pixels"}});
  action_toggle(context, kToggleMeasuredDepths, room());
}

void budget_controls(PanelContext& context) {
  using Unit = FaceBudget::Unit;
  using Goal = FaceBudget::Goal;
  action_choice(context,
                std::array{Choice{number_action(kSetDepthUnit, Unit::kFaces), "Faces"},
                           Choice{number_action(kSetDepthUnit, Unit::kTriangles), "Triangles"}});
  action_choice(context,
                std::array{Choice{number_action(kSetBudgetGoal, Goal::kMeanSquare), "Mean error"},
                           Choice{number_action(kSetBudgetGoal, Goal::kGreatest), "Worst"},
                           Choice{number_action(kSetBudgetGoal, Goal::kRandom), "Random"}});
}

void screen_controls(PanelContext& context) {
  using Of = ScreenSize::Of;
  action_choice(context, std::array{Choice{number_action(kSetDepthUnit, Of::kEdge), "Edge, px"},
                                    Choice{number_action(kSetDepthUnit, Of::kArea), "Area, px²"}});
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, context.colours.dim_text);
  ImGui::TextUnformatted("Silhouettes");
  ImGui::PopStyleColor();
  ImGui::SameLine(context.px(108) + ImGui::GetStyle().WindowPadding.x);
  action_choice(context, std::array{Choice{number_action(kSetSilhouettes, 0), "+0"},
                                    Choice{number_action(kSetSilhouettes, 1), "+1"},
                                    Choice{number_action(kSetSilhouettes, 2), "+2"},
                                    Choice{number_action(kSetSilhouettes, 3), "+3"}});
}

void curve_controls(PanelContext& context, const ChooseByCurve& curve) {
  std::vector<ComboEntry> entries;
  for (const FaceMeasureInfo& measure : face_measures()) {
    entries.push_back({number_action(kSetCurveMeasure, measure.measure), std::string(measure.title),
                       std::string(measure.meaning)});
  }
  action_combo(context, kSetCurveMeasure, entries);
  draw_depth_curve(context, curve);
}

/// From where sizes on the screen are seen.
void view_row(PanelContext& context, const ViewNames& names) {
  wrapped_text(context, context.colours.dim_text,
               names.empty() ? "As seen from the view in force when depths are chosen."
                             : "As seen from " + counted(names.size(), "kept view") + ".");
  const float gap = context.px(6);
  const float width = std::floor((room() - gap) / 2.0F);
  action_button(context, kKeepView, {.width = width});
  ImGui::SameLine(0.0F, gap);
  action_button(context, kForgetViews);
}

void source_controls(PanelContext& context, const ChooseDepths& choose) {
  amount_slider(context, choose.choice);
  if (std::holds_alternative<ChooseByTolerance>(choose.choice)) {
    tolerance_controls(context);
  } else if (std::holds_alternative<FaceBudget>(choose.choice)) {
    budget_controls(context);
  } else if (std::holds_alternative<ChooseByScreen>(choose.choice)) {
    screen_controls(context);
  } else if (const auto* curve = std::get_if<ChooseByCurve>(&choose.choice)) {
    curve_controls(context, *curve);
  }
  if (const ViewNames* names = views_of(choose.choice)) {
    view_row(context, *names);
  }
}

void combination(PanelContext& context) {
  action_combo(
      context, kSetDepthMerge,
      std::array{
          ComboEntry{number_action(kSetDepthMerge, DepthMerge::kSet), "Replace what is painted",
                     "Each face gets the depth that is chosen for it."},
          ComboEntry{number_action(kSetDepthMerge, DepthMerge::kMax), "Raise what is painted",
                     "Each face gets the greater of the two depths: nothing is lowered."},
          ComboEntry{number_action(kSetDepthMerge, DepthMerge::kMin), "Lower what is painted",
                     "Each face gets the lesser of the two depths: nothing is raised."},
          ComboEntry{number_action(kSetDepthMerge, DepthMerge::kAdd), "Add to what is painted",
                     "Each face gets as many levels more as are chosen for it."}});
  std::vector<ComboEntry> entries{
      {Action(kSetDepthWithin, std::string()), "On all faces", "Every face may change."},
      {Action(kSetDepthWithin, std::string("painted")), "On painted faces",
       "Unpainted faces stay unpainted."},
      {Action(kSetDepthWithin, std::string("unpainted")), "On unpainted faces",
       "What is painted by hand stays as it is."},
      {Action(kSetDepthWithin, std::string("visible")), "On visible faces",
       "Faces of which at least one pixel shows in the view in force."}};
  const std::string within = within_text(context.model.auto_depth.settings);
  if (std::ranges::none_of(entries, [&](const ComboEntry& entry) {
        return entry.action.value == ActionValue(within);
      })) {
    entries.push_back({Action(kSetDepthWithin, within), "On " + within, "As a rule says."});
  }
  action_combo(context, kSetDepthWithin, entries);
}

std::string first_line(const std::string& rules) {
  return rules.substr(0, rules.find('\n'));
}

/// Lists, saves and forgets rules under names.
void presets(PanelContext& context) {
  std::vector<ComboEntry> entries;
  const AutoDepthStatus& status = context.model.auto_depth;
  for (const std::span<const RulePreset> list : {bundled_presets(), status.own_presets}) {
    for (const RulePreset& preset : list) {
      entries.push_back(
          {Action(kUsePreset, preset.name), preset.name,
           preset.description.empty() ? first_line(preset.rules) : preset.description});
    }
  }
  action_combo(context, kUsePreset, entries);

  const float gap = context.px(6);
  const float width = context.px(66);
  std::string& name = context.state.preset_name;
  ImGui::SetNextItemWidth(room() - 2.0F * (width + gap));
  const bool is_entered =
      ImGui::InputTextWithHint("##preset", "Name", &name, ImGuiInputTextFlags_EnterReturnsTrue);
  explain(context, "Name of a preset", "Under this name what is set above is kept, or forgotten.");
  remember(context, "preset name");
  ImGui::SameLine(0.0F, gap);
  const Action save(kSavePreset, name);
  action_button(context, save, {.label = "Save", .width = width});
  if (is_entered && is_available(context.model, save)) {
    context.emit(save);
  }
  ImGui::SameLine(0.0F, gap);
  action_button(context, Action(kDeletePreset, name), {.label = "Delete", .width = width});
}

/// "0.0012 · 0.05 %".
std::string length_text(const PanelContext& context, std::optional<double> length) {
  return length ? distance_text(*length) + " · " + diagonal_text(*length, diagonal_of(context))
                : std::string(kUnknown);
}

void baseline_rows(PanelContext& context) {
  const BaselineStatus& baselines = context.model.auto_depth.baselines;
  if (baselines.running) {
    draw_progress(context, {*baselines.running, "Comparing"}, std::nullopt);
    return;
  }
  const auto row = [&](std::string_view label, std::string_view meaning,
                       const BudgetBaseline& baseline) {
    value_row(
        context,
        {label, distance_text(baseline.root_mean_square) + " · " + counted(baseline.faces, "face"),
         meaning});
  };
  if (baselines.found) {
    row("Uniform",
        "R.m.s. distance and faces of the finest uniform mesh that the budget has room for.",
        baselines.found->uniform);
    row("At random",
        "R.m.s. distance and faces where they are painted at random until the budget is used up.",
        baselines.found->random);
  }
  if (!baselines.problem.empty()) {
    wrapped_text(context, context.colours.problem, baselines.problem);
  }
  action_button(context, kCompareBudget, {.width = context.px(120)});
}

/// What was chosen last, while that is what is painted.
void outcome_rows(PanelContext& context, const AutoDepthOutcome& outcome) {
  sub_heading(context, "What came of it");
  value_row(context, {"Faces changed", grouped(outcome.changed_faces),
                      "Faces of the control mesh whose depth changed."});
  if (!outcome.expected_error) {
    return;
  }
  const DistanceStatus& distance = context.model.distance;
  const bool is_over =
      outcome.tolerance && distance.figures && distance.figures->greatest() > *outcome.tolerance;
  if (outcome.tolerance) {
    value_row(context, {"Asked for", length_text(context, outcome.tolerance),
                        "The tolerance, in units of the mesh and as a part of its diagonal."});
  }
  if (!outcome.budget) {  // Which counts on neighbours that refine what it leaves coarse.
    value_row(context, {"Expected", length_text(context, outcome.expected_error),
                        "The greatest distance to the limit surface by which depths were chosen."});
  }
  if (distance.running) {
    draw_progress(context, {*distance.running, "Measuring"}, std::nullopt);
  } else {
    const auto figure = [&](double value) { return std::optional(value); };
    value_row(context,
              {"Measured",
               length_text(context,
                           distance.figures ? figure(distance.figures->greatest()) : std::nullopt),
               "The greatest distance between the refined mesh and the limit surface.", is_over});
    value_row(context,
              {"R.m.s.",
               length_text(context, distance.figures ? figure(distance.figures->root_mean_square())
                                                     : std::nullopt),
               "The root of the mean square of the distances over all of the surface."});
  }
  if (outcome.short_faces > 0) {
    wrapped_text(context, context.colours.problem,
                 counted(outcome.short_faces, "face") +
                     (outcome.short_faces == 1 ? " needs" : " need") +
                     " more levels than can be painted. Apply the refined mesh and choose again.");
  }
  if (outcome.budget) {
    baseline_rows(context);
  }
}

}  // namespace

void draw_auto_depth_section(PanelContext& context) {
  const AutoDepthStatus& status = context.model.auto_depth;
  action_choice(
      context,
      std::array{Choice{number_action(kSetDepthSource, DepthSource::kTolerance), "Tolerance"},
                 Choice{number_action(kSetDepthSource, DepthSource::kBudget), "Budget"},
                 Choice{number_action(kSetDepthSource, DepthSource::kScreen), "Screen"},
                 Choice{number_action(kSetDepthSource, DepthSource::kCurve), "Curve"}});
  if (const ChooseDepths* choose = status.settings.choice()) {
    source_controls(context, *choose);
    combination(context);
  } else {
    for (const PaintRule& rule : status.settings.rules) {
      wrapped_text(context, context.colours.text, to_string(rule));
    }
  }
  const float half = std::floor(room() / 2.0F);
  action_toggle(context, kToggleLiveDepths, half);
  ImGui::SameLine(0.0F, 0.0F);
  action_toggle(context, kToggleLimitDepths, room());
  // A live choice is too short to be worth a bar, and would make everything below jump.
  if (status.running && !status.settings.is_live) {
    draw_progress(context, {*status.running, "Choosing"}, std::nullopt);
  } else {
    action_button(context, kChooseDepths, {.is_primary = true});
  }
  if (status.outcome) {
    outcome_rows(context, *status.outcome);
  }
  sub_heading(context, "Presets");
  presets(context);
}

}  // namespace limn::ui
