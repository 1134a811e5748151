// The measure to the right, depth upwards. Behind the curve stand bars, a part of the faces each,
// in the colours of the depths that the curve gives them.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "ui/auto_depth_model.h"
#include "ui/format.h"
#include "ui/panels.h"
#include "ui/widgets.h"

namespace limn::ui {
namespace {

constexpr float kPlotHeight = 168.0F;  // Design units.
constexpr float kPointRadius = 5.0F;

/// Where values and depths lie on the screen.
struct CurveAxes {
  ImVec2 low;  ///< Upper left of the plot proper.
  ImVec2 high;
  double first = 0.0;  ///< Values at the left,
  double last = 1.0;   ///< and at the right.
  bool is_logarithmic = false;

  [[nodiscard]] double part(double value) const {
    const double part = is_logarithmic
                            ? std::log(std::max(value, first) / first) / std::log(last / first)
                            : (value - first) / (last - first);
    return std::clamp(part, 0.0, 1.0);
  }
  [[nodiscard]] double value(double part) const {
    return is_logarithmic ? first * std::pow(last / first, part) : first + (last - first) * part;
  }
  [[nodiscard]] float x(double value) const {
    return low.x + (high.x - low.x) * static_cast<float>(part(value));
  }
  [[nodiscard]] double value_at(float x) const {
    return value(std::clamp(static_cast<double>((x - low.x) / (high.x - low.x)), 0.0, 1.0));
  }
  [[nodiscard]] float y(double depth) const {
    return high.y - (high.y - low.y) * static_cast<float>(depth / kMaxDepth);
  }
  [[nodiscard]] int depth_at(float y) const {
    return std::clamp(static_cast<int>(std::lround((high.y - y) / (high.y - low.y) * kMaxDepth)), 0,
                      kMaxDepth);
  }
};

/// Both the faces and the curve are to be seen. An axis that cannot begin at 0 is logarithmic.
CurveAxes make_curve_axes(const ChooseByCurve& choice, const MeasureHistogram* faces, ImVec2 low,
                          ImVec2 high) {
  const auto points = choice.curve.points();
  CurveAxes axes{low, high};
  const bool is_angle =
      choice.measure == FaceMeasure::kCurvature || choice.measure == FaceMeasure::kDihedral;
  axes.is_logarithmic = faces != nullptr ? faces->is_logarithmic : !is_angle;
  axes.first = faces != nullptr ? faces->low : (is_angle ? 0.0 : points.front().value / 2.0);
  axes.last = faces != nullptr ? faces->high : 2.0 * points.back().value;
  for (const DepthCurvePoint& point : points) {
    if (!axes.is_logarithmic || point.value > 0.0) {
      axes.first = std::min(axes.first, point.value);
    }
    axes.last = std::max(axes.last, point.value);
  }
  if (axes.is_logarithmic) {
    axes.last = axes.last > 0.0 ? axes.last : 1.0;
    axes.first = axes.first > 0.0 ? axes.first : axes.last / 1e4;
  }
  if (!(axes.last > axes.first)) {
    axes.last = axes.is_logarithmic ? 2.0 * axes.first : axes.first + 1.0;
  }
  return axes;
}

/// Bars stand for a third of the height at least where they are the highest: heights are roots, so
/// that few faces among many can be seen.
void draw_bars(const PanelContext& context, const CurveAxes& axes, const ChooseByCurve& choice,
               const MeasureHistogram& faces) {
  const std::size_t most = faces.counts.empty() ? 0 : *std::ranges::max_element(faces.counts);
  if (most == 0) {
    return;
  }
  CurveAxes own = axes;
  own.first = faces.low;
  own.last = faces.high;
  own.is_logarithmic = faces.is_logarithmic;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float height = 0.9F * (axes.high.y - axes.low.y);
  const auto bins = static_cast<double>(faces.counts.size());
  for (std::size_t i = 0; i < faces.counts.size(); ++i) {
    if (faces.counts[i] == 0) {
      continue;
    }
    const double begin = own.value(static_cast<double>(i) / bins);
    const double end = own.value(static_cast<double>(i + 1) / bins);
    const double middle = own.value((static_cast<double>(i) + 0.5) / bins);
    const float part = std::sqrt(static_cast<float>(faces.counts[i]) / static_cast<float>(most));
    const float left = axes.x(begin);
    const float right = std::max(axes.x(end) - context.px(1), left + 1.0F);
    list.AddRectFilled({left, axes.high.y - std::max(part * height, context.px(2))},
                       {right, axes.high.y}, faded(swatch_colour(choice.curve(middle)), 0.55F));
  }
}

std::string value_text(const FaceMeasureInfo& measure, double value) {
  return measure.unit == "deg" ? fmt::format("{:.0f}°", value)
                               : fmt::format("{:.3g} {}", value, measure.unit);
}

void draw_curve_axes(const PanelContext& context, const CurveAxes& axes,
                     const FaceMeasureInfo& measure) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ThemeColours& c = context.colours;
  const float size = ImGui::GetFontSize();
  for (int depth = 0; depth <= kMaxDepth; depth += 2) {
    const float y = std::floor(axes.y(depth)) + 0.5F;
    list.AddLine({axes.low.x, y}, {axes.high.x, y}, c.hairline, 1.0F);
    const std::string text = std::to_string(depth);
    list.AddText({std::floor(axes.low.x - context.px(6) - ImGui::CalcTextSize(text.c_str()).x),
                  std::floor(y - size / 2.0F)},
                 c.dim_text, text.c_str());
  }
  constexpr std::array kMarks{0.0, 0.5, 1.0};
  for (const double part : kMarks) {
    const std::string text = value_text(measure, axes.value(part));
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    const float x = axes.low.x + (axes.high.x - axes.low.x - width) * static_cast<float>(part);
    list.AddText({std::floor(x), std::floor(axes.high.y + context.px(4))}, c.dim_text,
                 text.c_str());
  }
}

/// The depths that faces get, which are whole, and under them what they are rounded from.
void draw_line(const PanelContext& context, const CurveAxes& axes, const ChooseByCurve& choice) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto points = choice.curve.points();
  std::vector<ImVec2> line{{axes.low.x, axes.y(points.front().depth)}};
  constexpr int kPieces = 24;  // A straight line in values is none on a logarithmic axis.
  for (std::size_t i = 0; i < points.size(); ++i) {
    line.emplace_back(axes.x(points[i].value), axes.y(points[i].depth));
    for (int k = 1; i + 1 < points.size() && k < kPieces; ++k) {
      const double t = static_cast<double>(k) / kPieces;
      line.emplace_back(axes.x(std::lerp(points[i].value, points[i + 1].value, t)),
                        axes.y(std::lerp(points[i].depth, points[i + 1].depth, t)));
    }
  }
  line.emplace_back(axes.high.x, axes.y(points.back().depth));
  list.AddPolyline(line.data(), static_cast<int>(line.size()), context.colours.text,
                   ImDrawFlags_None, context.px(2));
}

void emit_curve(PanelContext& context, const ChooseByCurve& choice,
                std::vector<DepthCurvePoint> points) {
  Result<DepthCurve> curve = DepthCurve::through(std::move(points));
  if (!curve) {
    return;
  }
  std::vector<PaintRule> rules = context.model.auto_depth.settings.rules;
  const DepthMerge merge = std::get<ChooseDepths>(rules.front().action).merge;
  ChooseByCurve changed = choice;
  changed.curve = *std::move(curve);
  rules.front().action = ChooseDepths{changed, merge};
  context.emit(Action(ActionId::kSetDepthRules, text_of(rules)));
}

/// Three digits are as many as a mouse can mean.
double rounded(double value) {
  if (!(value > 0.0)) {
    return 0.0;
  }
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
  return unit < 1.0 ? std::round(value / unit) / std::round(1.0 / unit)
                    : std::round(value / unit) * unit;
}

/// Points can be dragged between their neighbours; true where the mouse is on one.
bool handle_points(PanelContext& context, const CurveAxes& axes, const ChooseByCurve& choice,
                   const FaceMeasureInfo& measure) {
  const std::vector<DepthCurvePoint> points(choice.curve.points().begin(),
                                            choice.curve.points().end());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float reach = context.px(9);
  const float radius = context.px(kPointRadius);
  bool is_on_one = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ImVec2 at{axes.x(points[i].value), axes.y(points[i].depth)};
    ImGui::PushID(static_cast<int>(i));
    ImGui::SetCursorScreenPos({at.x - reach, at.y - reach});
    ImGui::InvisibleButton("##point", {2.0F * reach, 2.0F * reach},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    const bool is_hot = ImGui::IsItemHovered() || ImGui::IsItemActive();
    is_on_one = is_on_one || is_hot;
    list.AddCircleFilled(at, radius + context.px(1.5F), context.colours.panel);
    list.AddCircleFilled(at, radius, is_hot ? context.colours.accent : context.colours.text);
    explain(
        context,
        value_text(measure, points[i].value) + ": depth " + std::to_string(points[i].depth),
        "Drag to move the point. A right click takes it away; a click beside it makes another.");
    remember(context, "curve point " + std::to_string(i));
    std::vector<DepthCurvePoint> changed = points;
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1.0F)) {
      const ImVec2 mouse = ImGui::GetIO().MousePos;
      DepthCurvePoint& point = changed[i];
      const double value = rounded(axes.value_at(mouse.x));
      const bool is_between = (i == 0 || value > points[i - 1].value) &&
                              (i + 1 == points.size() || value < points[i + 1].value);
      point.value = is_between ? value : point.value;
      point.depth = axes.depth_at(mouse.y);
      if (changed != points) {
        emit_curve(context, choice, std::move(changed));
      }
    } else if (ImGui::IsItemClicked(ImGuiMouseButton_Right) && points.size() > 1) {
      changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(i));
      emit_curve(context, choice, std::move(changed));
    }
    ImGui::PopID();
  }
  return is_on_one;
}

void add_point(PanelContext& context, const CurveAxes& axes, const ChooseByCurve& choice) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  std::vector<DepthCurvePoint> points(choice.curve.points().begin(), choice.curve.points().end());
  const DepthCurvePoint point{rounded(axes.value_at(mouse.x)), axes.depth_at(mouse.y)};
  points.insert(std::ranges::upper_bound(points, point.value, {}, &DepthCurvePoint::value), point);
  emit_curve(context, choice, std::move(points));
}

}  // namespace

void draw_depth_curve(PanelContext& context, const ChooseByCurve& choice) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float width = room();
  const float height = context.px(kPlotHeight);
  ImGui::PushFont(context.fonts.small);
  const float text = ImGui::GetFontSize();
  const MeasureHistogram* faces = context.model.auto_depth.histogram;
  const FaceMeasureInfo& measure = info(choice.measure);
  const CurveAxes axes =
      make_curve_axes(choice, faces, {origin.x + context.px(24), origin.y + context.px(8)},
                      {origin.x + width - context.px(8), origin.y + height - text - context.px(8)});
  ImGui::PushID("curve");
  // Points first: where two items overlap, ImGui gives the mouse to the one drawn first.
  draw_curve_axes(context, axes, measure);
  if (faces != nullptr) {
    draw_bars(context, axes, choice, *faces);
  }
  draw_line(context, axes, choice);
  ImGui::PopFont();
  const bool is_on_point = handle_points(context, axes, choice, measure);
  ImGui::SetCursorScreenPos(origin);
  const bool is_pressed = ImGui::InvisibleButton("##plot", {width, height});
  if (!is_on_point) {
    explain(
        context, "Depth by " + std::string(measure.title),
        std::string(measure.meaning) +
            " Bars are faces, in the colour of the depth that they get. A click makes a point.");
    if (is_pressed) {
      add_point(context, axes, choice);
    }
  }
  remember(context, "depth curve");
  ImGui::PopID();
}

}  // namespace limn::ui
