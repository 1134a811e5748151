#include "ui/auto_depth_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limn::ui {
namespace {

/// Of the diagonal.
constexpr double kSmallestPart = 1e-6;
constexpr double kGreatestPart = 0.1;
constexpr double kFewestFaces = 10.0;
constexpr double kMostFaces = 1e7;

MainAmount amount_of(const ChooseByTolerance& tolerance, double diagonal) {
  switch (tolerance.unit) {
    case ChooseByTolerance::Unit::kPixels:
      return {tolerance.distance, 0.05, 50.0};
    case ChooseByTolerance::Unit::kDiagonals:
      return {tolerance.distance, kSmallestPart, kGreatestPart};
    case ChooseByTolerance::Unit::kLength:
      break;
  }
  return {tolerance.distance, kSmallestPart * diagonal, kGreatestPart * diagonal};
}

}  // namespace

AutoDepthSettings::AutoDepthSettings()
    : rules{ChooseDepths{ChooseByTolerance{}}},
      choices{ChooseByTolerance{}, FaceBudget{}, ChooseByScreen{},
              curve_over(FaceMeasure::kCurvature)} {}

const ChooseDepths* AutoDepthSettings::choice() const noexcept {
  return rules.size() == 1 ? std::get_if<ChooseDepths>(&rules.front().action) : nullptr;
}

std::optional<DepthSource> AutoDepthSettings::source() const noexcept {
  const ChooseDepths* chosen = choice();
  return chosen != nullptr ? std::optional(static_cast<DepthSource>(chosen->choice.index()))
                           : std::nullopt;
}

std::string text_of(std::span<const PaintRule> rules) {
  std::string text;
  for (const PaintRule& rule : rules) {
    text += to_string(rule) + "\n";
  }
  return text;
}

std::optional<MainAmount> main_amount(const DepthChoice& choice, double diagonal) {
  if (const auto* tolerance = std::get_if<ChooseByTolerance>(&choice)) {
    return amount_of(*tolerance, diagonal);
  }
  if (const auto* budget = std::get_if<FaceBudget>(&choice)) {
    return MainAmount{static_cast<double>(budget->most), kFewestFaces, kMostFaces};
  }
  if (const auto* screen = std::get_if<ChooseByScreen>(&choice)) {
    return screen->size.of == ScreenSize::Of::kArea ? MainAmount{screen->size.pixels, 1.0, 40000.0}
                                                    : MainAmount{screen->size.pixels, 1.0, 200.0};
  }
  return std::nullopt;
}

DepthChoice with_amount(DepthChoice choice, double value, double diagonal) {
  const std::optional<MainAmount> amount = main_amount(choice, diagonal);
  if (!amount || !std::isfinite(value)) {
    return choice;
  }
  value = std::clamp(value, amount->low, amount->high);
  if (auto* tolerance = std::get_if<ChooseByTolerance>(&choice)) {
    tolerance->distance = value;
  } else if (auto* budget = std::get_if<FaceBudget>(&choice)) {
    budget->most = static_cast<std::uint64_t>(std::llround(value));
  } else if (auto* screen = std::get_if<ChooseByScreen>(&choice)) {
    screen->size.pixels = value;
  }
  return choice;
}

std::optional<int> unit_of(const DepthChoice& choice) {
  if (const auto* tolerance = std::get_if<ChooseByTolerance>(&choice)) {
    return static_cast<int>(tolerance->unit);
  }
  if (const auto* budget = std::get_if<FaceBudget>(&choice)) {
    return static_cast<int>(budget->unit);
  }
  if (const auto* screen = std::get_if<ChooseByScreen>(&choice)) {
    return static_cast<int>(screen->size.of);
  }
  return std::nullopt;
}

DepthChoice with_unit(DepthChoice choice, int unit, double diagonal) {
  using Unit = ChooseByTolerance::Unit;
  if (auto* tolerance = std::get_if<ChooseByTolerance>(&choice)) {
    const auto wanted = static_cast<Unit>(unit);
    if (tolerance->unit == Unit::kDiagonals && wanted == Unit::kLength) {
      tolerance->distance *= diagonal;
    } else if (tolerance->unit == Unit::kLength && wanted == Unit::kDiagonals) {
      tolerance->distance /= diagonal;
    } else if (tolerance->unit != wanted) {
      tolerance->distance = wanted == Unit::kPixels      ? 0.5
                            : wanted == Unit::kDiagonals ? 0.001
                                                         : 0.001 * diagonal;
    }
    tolerance->unit = wanted;
    if (wanted != Unit::kPixels) {
      tolerance->views.clear();
    }
  } else if (auto* budget = std::get_if<FaceBudget>(&choice)) {
    budget->unit = static_cast<FaceBudget::Unit>(unit);
  } else if (auto* screen = std::get_if<ChooseByScreen>(&choice)) {
    const auto wanted = static_cast<ScreenSize::Of>(unit);
    if (wanted != screen->size.of) {
      const double pixels = screen->size.pixels;
      screen->size.pixels =
          wanted == ScreenSize::Of::kArea ? pixels * pixels : std::max(std::sqrt(pixels), 1.0);
    }
    screen->size.of = wanted;
  }
  return choice;
}

ChooseByCurve curve_over(FaceMeasure measure) {
  const auto curve = [measure](std::vector<DepthCurvePoint> points) {
    return ChooseByCurve{measure, DepthCurve::through(std::move(points)).value(), {}};
  };
  switch (measure) {
    case FaceMeasure::kDihedral:
      return curve({{20.0, 0}, {60.0, 2}});
    case FaceMeasure::kDistance:
      return curve({{0.0005, 0}, {0.002, 1}, {0.008, 2}});
    case FaceMeasure::kEdge:
      return curve({{0.02, 0}, {0.04, 1}, {0.08, 2}});
    case FaceMeasure::kScreen:
      return curve({{8.0, 0}, {16.0, 1}, {64.0, 3}});
    case FaceMeasure::kCurvature:
      break;
  }
  return curve({{5.0, 0}, {20.0, 1}, {60.0, 3}});
}

std::string within_text(const AutoDepthSettings& settings) {
  const std::optional<Selection>& within = settings.rules.front().within;
  if (!within) {
    return {};
  }
  // A rule that changes these faces begins with their name.
  std::string text = to_string(PaintRule(ChangeFaces{*within, DepthChange::add(1)}));
  text.resize(text.rfind(':'));
  return text;
}

const ViewNames* views_of(const DepthChoice& choice) {
  if (const auto* tolerance = std::get_if<ChooseByTolerance>(&choice)) {
    return tolerance->unit == ChooseByTolerance::Unit::kPixels ? &tolerance->views : nullptr;
  }
  if (const auto* screen = std::get_if<ChooseByScreen>(&choice)) {
    return &screen->views;
  }
  const auto* curve = std::get_if<ChooseByCurve>(&choice);
  return curve != nullptr && info(curve->measure).needs_view ? &curve->views : nullptr;
}

DepthChoice with_views(DepthChoice choice, const ViewNames& names) {
  if (auto* tolerance = std::get_if<ChooseByTolerance>(&choice)) {
    tolerance->views = names;
  } else if (auto* screen = std::get_if<ChooseByScreen>(&choice)) {
    screen->views = names;
  } else if (auto* curve = std::get_if<ChooseByCurve>(&choice)) {
    curve->views = names;
  }
  return choice;
}

}  // namespace limn::ui
