// Level to the right, error upwards by powers of ten. A series is a colour; its greatest error is a
// thin line with rings, its root mean square a strong one with dots.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "ui/panels.h"
#include "ui/scheme_text.h"
#include "ui/widgets.h"

namespace limn::ui {
namespace {

/// Told apart by people with any of the three colour-vision deficiencies, on dark and on light.
constexpr std::array<ImU32, 2> kSeriesColours{IM_COL32(0x3A, 0x9B, 0xDC, 0xFF),
                                              IM_COL32(0xD9, 0x6A, 0x1B, 0xFF)};
/// Errors below are roundings.
constexpr double kLeastError = 1.0e-12;

double greatest_error(const SphereFit& fit) {
  return std::max(std::abs(fit.least), std::abs(fit.greatest));
}

/// Where levels and errors lie on the screen.
struct Axes {
  ImVec2 low;  ///< Upper left of the plot proper.
  ImVec2 high;
  int levels = 1;
  int first_power = -1;  ///< Of ten, at the foot.
  int last_power = 0;    ///< At the head.

  [[nodiscard]] float x(int level) const {
    return low.x + (high.x - low.x) * static_cast<float>(level) / static_cast<float>(levels);
  }
  [[nodiscard]] float y(double error) const {
    const double power = std::log10(std::max(error, kLeastError));
    const double part = (power - first_power) / (last_power - first_power);
    return high.y - (high.y - low.y) * static_cast<float>(std::clamp(part, 0.0, 1.0));
  }
};

/// The powers of ten that hold the errors of all levels made. The first mesh may lie on a sphere to
/// the last digit: then its errors are drawn at the foot, and do not press all others together.
Axes make_axes(std::span<const SphereSeries> all, ImVec2 low, ImVec2 high) {
  constexpr double kTooFarBelow = 0.05;
  double least = std::numeric_limits<double>::max();
  double first_least = least;
  double most = kLeastError;
  Axes axes{low, high};
  for (const SphereSeries& series : all) {
    for (const SphereComparison& row : series.rows) {
      axes.levels = std::max(axes.levels, row.level);
      for (const double error : {row.fit.root_mean_square, greatest_error(row.fit)}) {
        double& lower = row.level == 0 ? first_least : least;
        lower = std::min(lower, std::max(error, kLeastError));
        most = std::max(most, error);
      }
    }
  }
  if (least > most || first_least > kTooFarBelow * least) {
    least = std::min(least, first_least);
  }
  axes.first_power = static_cast<int>(std::floor(std::log10(std::min(least, most))));
  axes.last_power = std::max(axes.first_power + 1, static_cast<int>(std::ceil(std::log10(most))));
  return axes;
}

void draw_grid(const PanelContext& context, const Axes& axes) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ThemeColours& c = context.colours;
  const float size = ImGui::GetFontSize();
  const int every = std::max(1, (axes.last_power - axes.first_power + 4) / 5);
  for (int power = axes.first_power; power <= axes.last_power; power += every) {
    const float y = std::floor(axes.y(std::pow(10.0, power))) + 0.5F;
    list.AddLine({axes.low.x, y}, {axes.high.x, y}, c.hairline, 1.0F);
    const std::string text = power == 0 ? "1" : fmt::format("1e{}", power);
    list.AddText({std::floor(axes.low.x - context.px(6) - ImGui::CalcTextSize(text.c_str()).x),
                  std::floor(y - size / 2.0F)},
                 c.dim_text, text.c_str());
  }
  for (int level = 0; level <= axes.levels; ++level) {
    const float x = std::floor(axes.x(level)) + 0.5F;
    list.AddLine({x, axes.low.y}, {x, axes.high.y}, faded(c.hairline, 0.6F), 1.0F);
    const std::string text = std::to_string(level);
    list.AddText(
        {std::floor(x - ImGui::CalcTextSize(text.c_str()).x / 2.0F), axes.high.y + context.px(4)},
        c.dim_text, text.c_str());
  }
  list.AddText({std::floor(axes.low.x - context.px(36)), axes.low.y - context.px(12) - size},
               c.dim_text, "Radius error, in units of the mesh");
  const char* below = "Level";
  list.AddText({std::floor((axes.low.x + axes.high.x - ImGui::CalcTextSize(below).x) / 2.0F),
                axes.high.y + context.px(4) + size},
               c.dim_text, below);
}

struct Curve {
  ImU32 colour;
  bool is_strong;  ///< Root mean square.
};

void draw_curve(const PanelContext& context, const Axes& axes, const SphereSeries& series,
                const Curve& curve) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  std::vector<ImVec2> points;
  for (const SphereComparison& row : series.rows) {
    points.push_back({axes.x(row.level), axes.y(curve.is_strong ? row.fit.root_mean_square
                                                                : greatest_error(row.fit))});
  }
  list.AddPolyline(points.data(), static_cast<int>(points.size()),
                   faded(curve.colour, curve.is_strong ? 1.0F : 0.7F), ImDrawFlags_None,
                   context.px(curve.is_strong ? 2.0F : 1.2F));
  for (const ImVec2& point : points) {
    list.AddCircleFilled(point, context.px(3),
                         curve.is_strong ? curve.colour : context.colours.field);
    list.AddCircle(point, context.px(3), curve.colour, 0, context.px(1.2F));
  }
}

/// The figures of the point nearest to the cursor.
void explain_point(PanelContext& context, const Axes& axes) {
  const std::string title = "Radius error";
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  float nearest = context.px(14);
  std::string text =
      "Dots: root mean square. Rings: greatest. Point at one to read it. In units of the mesh, by "
      "powers of ten.";
  for (const SphereSeries& series : context.model.sphere.series) {
    for (const SphereComparison& row : series.rows) {
      for (const double error : {row.fit.root_mean_square, greatest_error(row.fit)}) {
        const float away = std::hypot(mouse.x - axes.x(row.level), mouse.y - axes.y(error));
        if (away < nearest) {
          nearest = away;
          text =
              fmt::format("{}, level {}\nRoot mean square {:.4g}\nGreatest {:.4g}\nRadius {:.6g}",
                          scheme_title(series.settings), row.level, row.fit.root_mean_square,
                          greatest_error(row.fit), row.fit.radius);
        }
      }
    }
  }
  explain(context, title, text);
  remember(context, "sphere plot");
  for (const SphereSeries& series : context.model.sphere.series) {
    for (const SphereComparison& row : series.rows) {
      const WindowPoint at{static_cast<double>(axes.x(row.level)),
                           static_cast<double>(axes.y(row.fit.root_mean_square))};
      context.items.push_back(
          {fmt::format("r.m.s. of {}, level {}", scheme_title(series.settings), row.level),
           {at, {}}});
    }
  }
}

void draw_keys(const PanelContext& context, std::span<const SphereSeries> all) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = context.px(18);
    ImGui::Dummy({room(), height});
    const float y = std::floor(at.y + height / 2.0F);
    const ImU32 colour = kSeriesColours[i % kSeriesColours.size()];
    list.AddLine({at.x, y}, {at.x + context.px(18), y}, colour, context.px(2));
    list.AddCircleFilled({at.x + context.px(9), y}, context.px(3), colour);
    list.AddText({at.x + context.px(26), std::floor(y - ImGui::GetFontSize() / 2.0F)},
                 context.colours.dim_text, scheme_title(all[i].settings).c_str());
  }
}

}  // namespace

void draw_sphere_plot(PanelContext& context) {
  const std::span<const SphereSeries> all = context.model.sphere.series;
  ImGui::PushFont(context.fonts.small);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, context.px(2)});
  const float width = room();
  const float height = context.px(208);
  ImGui::Dummy({width, height});
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  ImGui::GetWindowDrawList()->AddRectFilled(low, high, context.colours.field, context.px(4));
  const Axes axes =
      make_axes(all, {low.x + context.px(46), low.y + context.px(32)},
                {high.x - context.px(14), high.y - 2.0F * ImGui::GetFontSize() - context.px(10)});
  draw_grid(context, axes);
  for (const bool is_strong : {false, true}) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      draw_curve(context, axes, all[i], {kSeriesColours[i % kSeriesColours.size()], is_strong});
    }
  }
  ImGui::PushFont(context.fonts.body);
  explain_point(context, axes);
  ImGui::PopFont();
  draw_keys(context, all);
  ImGui::PopStyleVar();
  ImGui::PopFont();
}

}  // namespace limn::ui
