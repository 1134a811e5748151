// Cameras are split off first, then the choice's options at commas. Numbers go through
// std::from_chars, so no locale can change what a rule means.
#include "painting/choice_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "limn/contract.h"
#include "painting/rule_text.h"

namespace limn::rule_text {
namespace {

constexpr std::array<std::string_view, 4> kChoiceWords{"tolerance", "budget", "screen", "curve"};
constexpr std::array<std::string_view, 4> kMergeWords{"set", "max", "min", "add"};
constexpr std::array<std::string_view, 3> kGoalWords{"rms", "greatest", "random"};
constexpr std::string_view kMeasured = "measured";
constexpr int kMostSilhouetteLevels = 3;

/// A choice cut into its parts.
struct Parts {
  std::string_view word;
  std::vector<std::string_view> values;  ///< Between commas.
  ViewNames views;                       ///< After each @.
};

std::vector<std::string_view> split(std::string_view text, char sign) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(sign);
    parts.push_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos) {
      return parts;
    }
    text.remove_prefix(end + 1);
  }
}

Parts parts_of(std::string_view text) {
  const std::size_t sign = text.find('=');
  const std::vector<std::string_view> views = split(text.substr(sign + 1), '@');
  Parts parts{trimmed(text.substr(0, sign)), split(views.front(), ','), {}};
  for (std::size_t i = 1; i < views.size(); ++i) {
    parts.views.emplace_back(views[i]);
  }
  return parts;
}

/// A number and what follows it.
struct Quantity {
  double value = 0.0;
  std::string_view unit;
};

std::optional<Quantity> read_quantity(std::string_view text) {
  Quantity quantity;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), quantity.value);
  if (error != std::errc{} || !std::isfinite(quantity.value) || quantity.value < 0.0) {
    return std::nullopt;
  }
  quantity.value = std::abs(quantity.value);  // "-0" is 0.
  quantity.unit = trimmed(text.substr(static_cast<std::size_t>(end - text.data())));
  return quantity;
}

std::string shown(std::string_view text) {
  return text.empty() ? "Nothing" : quoted(text);
}

Result<void> check_views(const Parts& parts) {
  if (std::ranges::find(parts.views, "") != parts.views.end()) {
    return misread(
        fmt::format("After the @ of \"{}=\" stands the name of a camera file, as in "
                    "\"screen=4px@camera.json\".",
                    parts.word));
  }
  return {};
}

Result<void> expect_no_views(const Parts& parts) {
  return parts.views.empty()
             ? Result<void>{}
             : misread(fmt::format("\"{}={}\" does not look through a camera; leave out {}.",
                                   parts.word, parts.values.front(),
                                   quoted("@" + parts.views.front())));
}

Result<void> expect_values(const Parts& parts, std::size_t most) {
  return parts.values.size() <= most
             ? Result<void>{}
             : misread(fmt::format("{} in \"{}={},...\" is not understood.",
                                   shown(parts.values[most]), parts.word, parts.values.front()));
}

Result<DepthChoice> parse_tolerance(const Parts& parts) {
  if (auto sound = expect_values(parts, 2); !sound) {
    return tl::unexpected(std::move(sound.error()));
  }
  const bool is_measured = parts.values.size() == 2;
  if (is_measured && parts.values[1] != kMeasured) {
    return misread(
        fmt::format("{} after \"tolerance={}\" is no word for how; write \"{}\", or nothing.",
                    shown(parts.values[1]), parts.values.front(), kMeasured));
  }
  using Unit = ChooseByTolerance::Unit;
  const auto quantity = read_quantity(parts.values.front());
  const bool is_known = quantity && quantity->value > 0.0 &&
                        (quantity->unit.empty() || quantity->unit == "d" || quantity->unit == "px");
  if (!is_known) {
    return misread(
        fmt::format("{} after \"tolerance=\" is no distance; write a number above 0 in mesh units, "
                    "in diagonals "
                    "as in \"tolerance=0.001d\", or in pixels as in \"tolerance=0.5px\".",
                    shown(parts.values.front())));
  }
  const Unit unit = quantity->unit.empty()  ? Unit::kLength
                    : quantity->unit == "d" ? Unit::kDiagonals
                                            : Unit::kPixels;
  if (unit != Unit::kPixels) {
    if (auto sound = expect_no_views(parts); !sound) {
      return tl::unexpected(std::move(sound.error()));
    }
  }
  return DepthChoice(ChooseByTolerance{quantity->value, unit, parts.views, is_measured});
}

Result<DepthChoice> parse_budget(const Parts& parts) {
  if (auto sound = expect_no_views(parts).and_then([&] { return expect_values(parts, 2); });
      !sound) {
    return tl::unexpected(std::move(sound.error()));
  }
  FaceBudget budget;
  std::string_view number = parts.values.front();
  if (number.ends_with('t')) {
    budget.unit = FaceBudget::Unit::kTriangles;
    number = trimmed(number.substr(0, number.size() - 1));
  }
  const auto [end, error] =
      std::from_chars(number.data(), number.data() + number.size(), budget.most);
  if (number.empty() || error != std::errc{} || end != number.data() + number.size() ||
      budget.most == 0) {
    return misread(fmt::format(
        "{} after \"budget=\" is no number of faces; write one from 1 on, with a t behind it for "
        "triangles, as in \"budget=50000\" or \"budget=50000t\".",
        shown(parts.values.front())));
  }
  if (parts.values.size() == 2) {
    const auto goal = std::ranges::find(kGoalWords, parts.values[1]);
    if (goal == kGoalWords.end()) {
      return misread(
          fmt::format("{} is no goal of a budget; write \"rms\" or \"greatest\", the error that "
                      "shall be least, or \"random\" to compare with.",
                      shown(parts.values[1])));
    }
    budget.goal = static_cast<FaceBudget::Goal>(goal - kGoalWords.begin());
  }
  return DepthChoice(budget);
}

Result<DepthChoice> parse_screen(const Parts& parts) {
  if (auto sound = expect_values(parts, 2); !sound) {
    return tl::unexpected(std::move(sound.error()));
  }
  const auto quantity = read_quantity(parts.values.front());
  if (!quantity || !(quantity->value > 0.0) ||
      (quantity->unit != "px" && quantity->unit != "px2")) {
    return misread(fmt::format(
        "{} after \"screen=\" is no size; write the longest edge as in \"screen=4px\" or the "
        "largest area as in \"screen=16px2\".",
        shown(parts.values.front())));
  }
  ChooseByScreen choice{{quantity->unit == "px" ? ScreenSize::Of::kEdge : ScreenSize::Of::kArea,
                         quantity->value, ScreenSize{}.silhouettes},
                        parts.views};
  if (parts.values.size() == 2) {
    constexpr std::string_view kSilhouettes = "silhouettes=";
    const std::string_view option = parts.values[1];
    const auto levels = option.starts_with(kSilhouettes)
                            ? read_whole_number(trimmed(option.substr(kSilhouettes.size())))
                            : std::nullopt;
    if (!levels || *levels > std::uint32_t{kMostSilhouetteLevels}) {
      return misread(fmt::format(
          "{} in \"screen=\" is not understood; write how many levels silhouettes get on top, 0 to "
          "{}, as in \"silhouettes=1\".",
          shown(option), kMostSilhouetteLevels));
    }
    choice.size.silhouettes = static_cast<int>(*levels);
  }
  return DepthChoice(std::move(choice));
}

std::string measure_words() {
  std::string words;
  for (const FaceMeasureInfo& measure : face_measures()) {
    words += words.empty() ? "" : measure.measure == face_measures().back().measure ? " or " : ", ";
    words += measure.word;
  }
  return words;
}

Result<DepthCurvePoint> parse_point(FaceMeasure measure, std::string_view text) {
  const std::size_t slash = text.find('/');
  const auto value = read_measure(measure, trimmed(text.substr(0, slash)));
  const auto depth = slash == std::string_view::npos
                         ? std::nullopt
                         : read_whole_number(trimmed(text.substr(slash + 1)));
  if (!value || !depth || *depth > std::uint32_t{kMaxDepth}) {
    return misread(
        fmt::format("{} is no point of a depth curve; write VALUE/DEPTH, as in "
                    "\"curve=curvature,5/0,40/3\".",
                    shown(text)));
  }
  return DepthCurvePoint{*value, static_cast<int>(*depth)};
}

Result<DepthChoice> parse_curve(const Parts& parts) {
  const auto found =
      std::ranges::find(face_measures(), parts.values.front(), &FaceMeasureInfo::word);
  if (found == face_measures().end()) {
    return misread(fmt::format("{} after \"curve=\" is no measure of faces; write {}.",
                               shown(parts.values.front()), measure_words()));
  }
  if (!found->needs_view) {
    if (auto sound = expect_no_views(parts); !sound) {
      return tl::unexpected(std::move(sound.error()));
    }
  }
  std::vector<DepthCurvePoint> points;
  for (std::size_t i = 1; i < parts.values.size(); ++i) {
    const Result<DepthCurvePoint> point = parse_point(found->measure, parts.values[i]);
    if (!point) {
      return tl::unexpected(point.error());
    }
    points.push_back(*point);
  }
  return DepthCurve::through(std::move(points)).map([&](DepthCurve curve) {
    return DepthChoice(ChooseByCurve{found->measure, std::move(curve), parts.views});
  });
}

std::string view_text(const ViewNames& views) {
  std::string text;
  for (const std::string& view : views) {
    text += "@" + view;
  }
  return text;
}

struct ChoiceText {
  std::string operator()(const ChooseByTolerance& choice) const {
    using Unit = ChooseByTolerance::Unit;
    const char* unit = choice.unit == Unit::kLength      ? ""
                       : choice.unit == Unit::kDiagonals ? "d"
                                                         : "px";
    return fmt::format("tolerance={}{}{}{}", choice.distance, unit,
                       choice.is_measured ? fmt::format(",{}", kMeasured) : std::string{},
                       view_text(choice.views));
  }
  std::string operator()(const FaceBudget& budget) const {
    return fmt::format("budget={}{}{}", budget.most,
                       budget.unit == FaceBudget::Unit::kTriangles ? "t" : "",
                       budget.goal == FaceBudget{}.goal
                           ? std::string{}
                           : fmt::format(",{}", kGoalWords[static_cast<std::size_t>(budget.goal)]));
  }
  std::string operator()(const ChooseByScreen& choice) const {
    return fmt::format("screen={}{}{}{}", choice.size.pixels,
                       choice.size.of == ScreenSize::Of::kEdge ? "px" : "px2",
                       choice.size.silhouettes == ScreenSize{}.silhouettes
                           ? std::string{}
                           : fmt::format(",silhouettes={}", choice.size.silhouettes),
                       view_text(choice.views));
  }
  std::string operator()(const ChooseByCurve& choice) const {
    std::string text = fmt::format("curve={}", info(choice.measure).word);
    for (const DepthCurvePoint& point : choice.curve.points()) {
      text += fmt::format(",{}/{}", point.value, point.depth);
    }
    return text + view_text(choice.views);
  }
};

}  // namespace

bool is_choice(std::string_view text) {
  const std::size_t sign = text.find('=');
  return sign != std::string_view::npos &&
         std::ranges::find(kChoiceWords, trimmed(text.substr(0, sign))) != kChoiceWords.end();
}

Result<DepthChoice> parse_choice(std::string_view text) {
  const Parts parts = parts_of(text);
  if (auto sound = check_views(parts); !sound) {
    return tl::unexpected(std::move(sound.error()));
  }
  if (parts.word == "tolerance") {
    return parse_tolerance(parts);
  }
  if (parts.word == "budget") {
    return parse_budget(parts);
  }
  LIMN_EXPECTS(is_choice(text));
  return parts.word == "screen" ? parse_screen(parts) : parse_curve(parts);
}

std::optional<DepthMerge> parse_merge(std::string_view word) {
  const auto found = std::ranges::find(kMergeWords, word);
  return found == kMergeWords.end()
             ? std::nullopt
             : std::optional(static_cast<DepthMerge>(found - kMergeWords.begin()));
}

std::string to_text(const DepthChoice& choice) {
  return std::visit(ChoiceText{}, choice);
}

std::string_view to_text(DepthMerge merge) {
  return kMergeWords[static_cast<std::size_t>(merge)];
}

std::optional<double> read_measure(FaceMeasure measure, std::string_view text) {
  const auto quantity = read_quantity(text);
  if (!quantity || (!quantity->unit.empty() && quantity->unit != info(measure).unit)) {
    return std::nullopt;
  }
  return quantity->value;
}

}  // namespace limn::rule_text
