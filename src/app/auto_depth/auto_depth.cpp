#include "app/auto_depth/auto_depth.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "limn/painting/auto_depth/depth_curve.h"
#include "limn/painting/auto_depth/face_measure.h"

namespace limn::app {
namespace {

constexpr std::size_t kBins = 48;
/// A logarithmic axis is no longer than this.
constexpr double kWidestRange = 1e4;

bool is_angle(FaceMeasure measure) {
  return measure == FaceMeasure::kCurvature || measure == FaceMeasure::kDihedral;
}

ui::MeasureHistogram count(FaceMeasure measure, std::vector<double> values) {
  ui::MeasureHistogram result;
  result.measure = measure;
  const double most = values.empty() ? 0.0 : *std::ranges::max_element(values);
  if (is_angle(measure)) {
    constexpr double kStep = 10.0;
    result.high = std::max(kStep, kStep * std::ceil(most / kStep));
    result.counts = histogram(values, result.low, result.high, kBins);
    return result;
  }
  result.is_logarithmic = true;
  result.high = most > 0.0 && std::isfinite(most) ? most : 1.0;
  result.low = result.high;
  for (const double value : values) {
    result.low = value > 0.0 ? std::min(result.low, value) : result.low;
  }
  result.low = std::max(std::min(result.low, result.high / 2.0), result.high / kWidestRange);
  for (double& value : values) {
    value = std::log(std::max(value, result.low));
  }
  result.counts = histogram(values, std::log(result.low), std::log(result.high), kBins);
  return result;
}

Result<PlannedPaint> carry_out(const AutoDepth::Question& question, Progress& progress) {
  PaintContext context;
  context.settings = question.settings;
  context.demands = &question.demands;
  context.progress = &progress;
  context.visible = [&]() -> Result<std::vector<std::uint32_t>> { return question.visible_faces; };
  if (!question.views.empty()) {
    context.views = [&](const std::string& name) -> Result<ScreenView> {
      const auto found = question.views.find(name);
      if (found == question.views.end()) {
        return fail(ErrorKind::kUsage,
                    fmt::format("There is no view \"{}\". Keep this view first, or leave the name "
                                "out.",
                                name));
      }
      return found->second;
    };
  }
  return plan_paint_rules(*question.control, question.rules, context, question.depths);
}

}  // namespace

AutoDepth::AutoDepth(const std::function<void()>& wake, Arrivals* arrivals)
    : choosing_("auto depth", wake, arrivals),
      measuring_("depth measure", wake, arrivals),
      comparing_("budget baselines", wake, arrivals) {}

void AutoDepth::set_rules(std::vector<PaintRule> rules) {
  settings_.rules = std::move(rules);
  if (const ChooseDepths* choose = settings_.choice()) {
    settings_.choices.at(choose->choice.index()) = choose->choice;
  }
}

void AutoDepth::set_source(ui::DepthSource source) {
  const DepthChoice& choice = settings_.choices.at(static_cast<std::size_t>(source));
  if (const ChooseDepths* before = settings_.choice()) {
    settings_.rules.front().action = ChooseDepths{choice, before->merge};
  } else {
    settings_.rules = {ChooseDepths{choice}};
  }
}

Result<void> AutoDepth::save_preset(const std::string& name) {
  if (auto checked = check_preset_name(name); !checked) {
    return checked;
  }
  for (const PaintRule& rule : settings_.rules) {
    const auto* choose = std::get_if<ChooseDepths>(&rule.action);
    const ViewNames* names = choose != nullptr ? ui::views_of(choose->choice) : nullptr;
    if (names != nullptr && !names->empty()) {
      return fail(ErrorKind::kUsage,
                  "A preset cannot hold views that are kept for this run alone. Forget them first; "
                  "it then looks through the view in force.");
    }
  }
  RulePreset preset{name, {}, ui::text_of(settings_.rules)};
  const auto found = std::ranges::find(presets_, name, &RulePreset::name);
  if (found != presets_.end()) {
    *found = std::move(preset);
  } else {
    presets_.push_back(std::move(preset));
  }
  return {};
}

bool AutoDepth::delete_preset(std::string_view name) {
  return std::erase_if(presets_, [&](const RulePreset& preset) { return preset.name == name; }) > 0;
}

std::string AutoDepth::view_name(std::size_t index) {
  return fmt::format("view{}", index + 1);
}

void AutoDepth::forget_views() {
  views_.clear();
  for (DepthChoice& choice : settings_.choices) {
    choice = ui::with_views(std::move(choice), {});
  }
  for (PaintRule& rule : settings_.rules) {
    if (auto* choose = std::get_if<ChooseDepths>(&rule.action)) {
      choose->choice = ui::with_views(std::move(choose->choice), {});
    }
  }
}

void AutoDepth::choose(Question question) {
  question_ = std::move(question);
  choosing_.start([asked = question_](Progress& progress) { return carry_out(asked, progress); });
}

void AutoDepth::follow(const Measured& measured, const std::optional<ScreenView>& view) {
  if (measured == measured_ && (histogram_ || measuring_.is_busy())) {
    return;
  }
  if (measuring_.is_busy() && measured.control == measured_.control) {
    return;  // A camera that moves would never let it come to an end.
  }
  if (measured.control != measured_.control || measured.measure != measured_.measure) {
    histogram_.reset();
  }
  measured_ = measured;
  measuring_.start([measured, view](Progress& progress) {
    const std::vector<ScreenView> views = view ? std::vector{*view} : std::vector<ScreenView>();
    return measure_faces(*measured.control, measured.settings, measured.measure, views, progress)
        .map(
            [&](std::vector<double> values) { return count(measured.measure, std::move(values)); });
  });
}

const ui::MeasureHistogram* AutoDepth::histogram(const Measured& measured) const noexcept {
  return histogram_ && measured.control == measured_.control &&
                 measured.measure == histogram_->measure
             ? &*histogram_
             : nullptr;
}

void AutoDepth::compare(const Document& document, const FaceBudget& budget) {
  compared_ = {document.control, document.settings, budget};
  baselines_ = {};
  Document asked;
  asked.control = document.control;
  asked.settings = document.settings;
  comparing_.start([asked = std::move(asked), budget](Progress& progress) {
    return measure_budget_baselines(asked, budget, progress);
  });
}

ui::BaselineStatus AutoDepth::baselines(const Document& document, const FaceBudget& budget) const {
  if (compared_ != Compared{document.control, document.settings, budget}) {
    return {};
  }
  ui::BaselineStatus status = baselines_;
  status.running = comparing_.running();
  return status;
}

bool AutoDepth::update() {
  bool has_news = false;
  if (std::optional<Result<ui::MeasureHistogram>> found = measuring_.take()) {
    // Without bars where memory ran out: asking again would not help.
    histogram_ = *found ? **std::move(found) : ui::MeasureHistogram{measured_.measure};
    has_news = true;
  }
  if (std::optional<Result<BudgetBaselines>> found = comparing_.take()) {
    if (*found) {
      baselines_.found = **found;
    } else {
      baselines_.problem = std::move(found->error().message);
    }
    has_news = true;
  }
  return has_news;
}

void AutoDepth::wait() {
  choosing_.wait();
  measuring_.wait();
  comparing_.wait();
}

}  // namespace limn::app
