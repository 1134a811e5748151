// Depths that come about by themselves. They are chosen on another thread from the document as it
// is when asked; when they come and it still is so, they are painted as one step.
#include "app/session.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "limn/document/commands.h"
#include "ui/format.h"

namespace limn::app {

using enum ui::ActionId;
using Kind = ui::Toast::Kind;

namespace {

bool is_same_painting(const Revisions& a, const Revisions& b) {
  return a.control == b.control && a.depths == b.depths;
}

/// Of a tolerance that is a length, in mesh units.
std::optional<double> tolerance_of(const DepthChoice& choice, double diagonal) {
  const auto* tolerance = std::get_if<ChooseByTolerance>(&choice);
  if (tolerance == nullptr || tolerance->unit == ChooseByTolerance::Unit::kPixels) {
    return std::nullopt;
  }
  return tolerance->unit == ChooseByTolerance::Unit::kDiagonals ? tolerance->distance * diagonal
                                                                : tolerance->distance;
}

bool aim_at_limit(const std::vector<PaintRule>& rules) {
  return std::ranges::any_of(rules, aims_at_limit);
}

/// "tolerance=0.001d", "3 rules".
std::string name_of(const std::vector<PaintRule>& rules) {
  return rules.size() == 1 ? to_string(rules.front()) : ui::counted(rules.size(), "rule");
}

}  // namespace

void Session::restore(ui::AutoDepthSettings settings, std::vector<RulePreset> presets) {
  auto_depth_.restore(std::move(settings));
  auto_depth_.set_presets(std::move(presets));
}

bool Session::perform_auto_depth(const ui::Action& action) {
  const ui::AutoDepthSettings& settings = auto_depth_.settings();
  const auto wanted = [&](bool is_on) {
    const auto* value = std::get_if<bool>(&action.value);
    return value != nullptr ? *value : !is_on;
  };
  switch (action.id) {
    case kChooseDepths:
      choose_depths();
      return true;
    case kSetDepthSource: {
      const int source = std::get<int>(action.value);
      if (source >= 0 && source < static_cast<int>(ui::kDepthSources)) {
        auto_depth_.set_source(static_cast<ui::DepthSource>(source));
        auto_depth_changed();
      }
      return true;
    }
    case kSetDepthRules:
      if (auto rules = parse_paint_rules(std::get<std::string>(action.value), "the rules")) {
        auto_depth_.set_rules(*std::move(rules));
        auto_depth_changed();
      } else {
        toast(Kind::kProblem, rules.error().message);
      }
      return true;
    case kSetDepthWithin:
      set_depth_within(std::get<std::string>(action.value));
      return true;
    case kToggleLiveDepths:
      auto_depth_.set_live(wanted(settings.is_live));
      auto_depth_changed();
      return true;
    case kToggleLimitDepths:
      auto_depth_.set_moves_to_limit(wanted(settings.moves_to_limit));
      auto_depth_changed();
      return true;
    case kCompareBudget:
      if (shows_chosen() && chosen_->outcome.budget) {
        auto_depth_.compare(document_, *chosen_->outcome.budget);
      }
      return true;
    default:
      return false;
  }
}

/// Changes the one rule that controls can set.
void Session::set_depth_rule(ChooseDepths choose) {
  std::vector<PaintRule> rules = auto_depth_.settings().rules;
  rules.front().action = std::move(choose);
  auto_depth_.set_rules(std::move(rules));
  auto_depth_changed();
}

void Session::set_depth_within(const std::string& selection) {
  std::vector<PaintRule> rules = auto_depth_.settings().rules;
  std::optional<Selection> within;
  if (!selection.empty()) {
    const Result<PaintRule> any = parse_paint_rule(selection + ":+1");
    const auto* change = any ? std::get_if<ChangeFaces>(&any->action) : nullptr;
    if (change == nullptr) {
      toast(Kind::kProblem, fmt::format("\"{}\" is no selection of faces.", selection));
      return;
    }
    within = change->selection;
  }
  for (PaintRule& rule : rules) {
    rule.within = within;
  }
  auto_depth_.set_rules(std::move(rules));
  auto_depth_changed();
}

bool Session::perform_depth_choice(const ui::Action& action) {
  const ChooseDepths* present = auto_depth_.settings().choice();
  const double diagonal = document_.control->bounds().diagonal();
  const auto number = [&](int end) {
    const int value = std::get<int>(action.value);
    return value >= 0 && value < end ? std::optional(value) : std::nullopt;
  };
  std::optional<int> value;
  ChooseDepths choose = present != nullptr ? *present : ChooseDepths{};
  switch (action.id) {
    case kSetDepthAmount:
      choose.choice = ui::with_amount(choose.choice, std::get<double>(action.value), diagonal);
      value = 0;
      break;
    case kSetDepthUnit:
      value = number(std::holds_alternative<ChooseByTolerance>(choose.choice) ? 3 : 2);
      choose.choice = ui::with_unit(choose.choice, value.value_or(0), diagonal);
      break;
    case kToggleMeasuredDepths:
      if (auto* tolerance = std::get_if<ChooseByTolerance>(&choose.choice)) {
        const auto* wanted = std::get_if<bool>(&action.value);
        tolerance->is_measured = wanted != nullptr ? *wanted : !tolerance->is_measured;
        value = 0;
      }
      break;
    case kSetBudgetGoal:
      value = number(3);
      if (auto* budget = std::get_if<FaceBudget>(&choose.choice)) {
        budget->goal = static_cast<FaceBudget::Goal>(value.value_or(0));
      }
      break;
    case kSetSilhouettes:
      value = number(ui::kMostSilhouettes + 1);
      if (auto* screen = std::get_if<ChooseByScreen>(&choose.choice)) {
        screen->size.silhouettes = value.value_or(0);
      }
      break;
    case kSetCurveMeasure:
      value = number(static_cast<int>(face_measures().size()));
      if (value && std::holds_alternative<ChooseByCurve>(choose.choice)) {
        choose.choice = ui::curve_over(static_cast<FaceMeasure>(*value));
      }
      break;
    case kSetDepthMerge:
      value = number(4);
      choose.merge = static_cast<DepthMerge>(value.value_or(0));
      break;
    default:
      return false;
  }
  if (present != nullptr && value) {
    set_depth_rule(std::move(choose));
  }
  return true;
}

bool Session::perform_preset(const ui::Action& action) {
  switch (action.id) {
    case kUsePreset:
      if (auto rules =
              rules_of_preset(auto_depth_.presets(), std::get<std::string>(action.value))) {
        auto_depth_.set_rules(*std::move(rules));
        auto_depth_changed();
      } else {
        toast(Kind::kProblem, to_string(rules.error()));
      }
      return true;
    case kSavePreset: {
      const auto& name = std::get<std::string>(action.value);
      if (const auto saved = auto_depth_.save_preset(name)) {
        toast(Kind::kDone, fmt::format("Preset \"{}\" is kept.", name));
      } else {
        toast(Kind::kProblem, saved.error().message);
      }
      return true;
    }
    case kDeletePreset: {
      const auto& name = std::get<std::string>(action.value);
      if (auto_depth_.delete_preset(name)) {
        toast(Kind::kDone, fmt::format("Preset \"{}\" is gone.", name));
      }
      return true;
    }
    case kKeepView:
      if (const ChooseDepths* choose = auto_depth_.settings().choice();
          choose != nullptr && ui::views_of(choose->choice) != nullptr) {
        auto_depth_.keep_view(view());
        ViewNames names = *ui::views_of(choose->choice);
        names.push_back(AutoDepth::view_name(auto_depth_.views().size() - 1));
        set_depth_rule({ui::with_views(choose->choice, names), choose->merge});
      }
      return true;
    case kForgetViews:
      auto_depth_.forget_views();
      auto_depth_changed();
      return true;
    default:
      return false;
  }
}

/// The document shows what was chosen.
bool Session::shows_chosen() const noexcept {
  return chosen_ && is_same_painting(chosen_->revisions, document_.revisions);
}

bool Session::replaces_chosen() const noexcept {
  return auto_depth_.settings().is_live && shows_chosen() && chosen_->is_replaceable &&
         chosen_->position == history_.position();
}

std::map<std::string, ScreenView> Session::screen_views() const {
  std::map<std::string, ScreenView> views;
  if (host_.screen_view) {
    views.emplace(std::string(), host_.screen_view(view()));
    for (std::size_t i = 0; i < auto_depth_.views().size(); ++i) {
      views.emplace(AutoDepth::view_name(i), host_.screen_view(auto_depth_.views()[i]));
    }
  }
  return views;
}

void Session::choose_depths() {
  end_stroke();
  wants_depths_ = false;
  const ui::AutoDepthSettings& settings = auto_depth_.settings();
  AutoDepth::Question question;
  question.control = document_.control;
  question.settings = document_.settings;
  question.replaces_last = replaces_chosen();
  question.depths = question.replaces_last ? chosen_->before : document_.depths;
  question.demands = document_.demands;
  question.revisions = document_.revisions;
  question.rules = settings.rules;
  question.views = screen_views();
  if (settings.moves_to_limit && aim_at_limit(settings.rules)) {
    question.settings.points = SurfacePoints::kLimit;
  }
  if (std::ranges::any_of(settings.rules, asks_what_is_visible)) {
    if (!host_.visible_faces) {
      toast(Kind::kProblem, "Nobody can say here what is visible.");
      return;
    }
    Result<std::vector<std::uint32_t>> visible = host_.visible_faces();
    if (!visible) {
      toast(Kind::kProblem, visible.error().message);
      return;
    }
    question.visible_faces = *std::move(visible);
  }
  auto_depth_.choose(std::move(question));
}

bool Session::follow_auto_depth() {
  bool has_news = false;
  if (std::optional<Result<PlannedPaint>> plan = auto_depth_.take_choice()) {
    has_news = true;
    if (!*plan) {
      toast(Kind::kProblem, plan->error().message);
    } else if (!is_stroking() && auto_depth_.question().revisions == document_.revisions) {
      paint_chosen(**std::move(plan));
    } else if (auto_depth_.settings().is_live) {
      wants_depths_ = true;
    } else {
      toast(Kind::kNote, "The painting has changed meanwhile. Choose depths again.");
    }
  }
  if (wants_depths_ && !auto_depth_.is_choosing() && !is_stroking()) {
    choose_depths();
  }
  if (const auto measured = measured_faces()) {
    auto_depth_.follow(*measured, measured->view ? std::optional(host_.screen_view(*measured->view))
                                                 : std::nullopt);
  }
  return has_news;
}

void Session::paint_chosen(PlannedPaint plan) {
  const AutoDepth::Question& question = auto_depth_.question();
  const bool is_live = auto_depth_.settings().is_live;
  if (question.replaces_last) {
    history_.undo(document_);
  }
  Chosen chosen;
  chosen.before = question.depths;
  chosen.outcome = {.changed_faces = plan.edits.size(),
                    .expected_error = plan.expected_error,
                    .short_faces = plan.short_faces};
  if (question.rules.size() == 1) {
    if (const auto* choose = std::get_if<ChooseDepths>(&question.rules.front().action)) {
      chosen.outcome.tolerance =
          tolerance_of(choose->choice, document_.control->bounds().diagonal());
      if (const auto* budget = std::get_if<FaceBudget>(&choose->choice)) {
        chosen.outcome.budget = *budget;
      }
    }
  }
  DemandEdits demands;
  if (plan.drops_demands) {
    demands = FineDemands().edits_from(document_.demands);
  }
  std::optional<SubdivisionSettings> settings;
  if (question.settings != document_.settings) {
    settings = question.settings;
  }
  const std::size_t faces = plan.edits.size();
  const bool is_step = faces > 0 || !demands.empty() || settings;
  const std::string name = name_of(question.rules);
  if (is_step) {
    execute(paint_command(std::move(plan.edits),
                          fmt::format("choose {} ({})", name, ui::counted(faces, "face")),
                          std::move(demands), settings));
  }
  if (!is_live) {
    toast(is_step ? Kind::kDone : Kind::kNote,
          faces == 0 ? fmt::format("{}: no face changes by this.", name)
                     : fmt::format("{}: {} changed.", name, ui::counted(faces, "face")));
  }
  chosen.revisions = document_.revisions;
  chosen.position = history_.position();
  chosen.is_replaceable = is_live && is_step;
  chosen_ = std::move(chosen);
}

std::optional<AutoDepth::Measured> Session::measured_faces() const {
  const ChooseDepths* choose = auto_depth_.settings().choice();
  const auto* curve = choose != nullptr ? std::get_if<ChooseByCurve>(&choose->choice) : nullptr;
  if (curve == nullptr || (info(curve->measure).needs_view && !host_.screen_view)) {
    return std::nullopt;
  }
  AutoDepth::Measured measured{document_.control, document_.settings, curve->measure, std::nullopt};
  if (info(curve->measure).needs_view) {
    measured.view = view();
  }
  return measured;
}

ui::AutoDepthStatus Session::auto_depth_status() const {
  ui::AutoDepthStatus status;
  status.settings = auto_depth_.settings();
  status.running = auto_depth_.running();
  if (const auto measured = measured_faces()) {
    status.histogram = auto_depth_.histogram(*measured);
  }
  if (shows_chosen()) {
    status.outcome = chosen_->outcome;
    if (chosen_->outcome.budget) {
      status.baselines = auto_depth_.baselines(document_, *chosen_->outcome.budget);
    }
  }
  status.own_presets = auto_depth_.presets();
  status.kept_views = auto_depth_.views().size();
  return status;
}

}  // namespace limn::app
