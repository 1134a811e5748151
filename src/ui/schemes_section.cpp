// A uniform scheme level by level, beside another, and against a sphere.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "limn/document/document.h"
#include "ui/action_table.h"
#include "ui/availability.h"
#include "ui/format.h"
#include "ui/panels.h"
#include "ui/scheme_text.h"
#include "ui/widgets.h"

namespace limn::ui {
namespace {

using enum ActionId;

/// Rows the table has at the least, so that nothing moves while one steps to and fro.
constexpr std::size_t kFewestRows = 6;

/// All digits where they fit into `width`, otherwise "84 k", "83.9 M", "5.4e+12".
std::string count_text(std::uint64_t count, float width) {
  std::string text = grouped(count);
  if (ImGui::CalcTextSize(text.c_str()).x <= width) {
    return text;
  }
  const auto value = static_cast<double>(count);
  if (count < 1'000'000) {
    return fmt::format("{:.0f} k", value / 1.0e3);
  }
  return count < 1'000'000'000 ? fmt::format("{:.1f} M", value / 1.0e6)
                               : fmt::format("{:.1e}", value);
}

/// Every scheme once, with the choices it has now; what stands for none first.
std::vector<ComboEntry> scheme_entries(const Model& model) {
  std::vector<ComboEntry> entries{
      {Action(kSetScheme, std::string()), "As painted",
       "Catmull-Clark, adaptively: every face as deep as it is painted."}};
  for (const SchemeInfo& scheme : schemes()) {
    SchemeSettings settings{.scheme = scheme.scheme};
    if (model.document.scheme && model.document.scheme->scheme == scheme.scheme) {
      settings = *model.document.scheme;
    }
    entries.push_back({Action(kSetScheme, scheme_word(settings)), std::string(scheme.title),
                       scheme_description(settings)});
  }
  return entries;
}

std::vector<ComboEntry> second_entries() {
  std::vector<ComboEntry> entries{
      {Action(kSetSecondScheme, std::string()), "Nothing", "One view over the whole place."}};
  for (const SchemeSettings& settings : scheme_variants()) {
    entries.push_back({Action(kSetSecondScheme, scheme_word(settings)), scheme_title(settings),
                       scheme_description(settings)});
  }
  return entries;
}

void scheme_choices(PanelContext& context, const SchemeSettings& settings) {
  if (settings.scheme == Scheme::kLoop) {
    action_choice(context, std::array{Choice{kLoopOriginal, "Original weights"},
                                      Choice{kLoopWarren, "Warren's weights"}});
  } else if (settings.scheme == Scheme::kLinear) {
    action_choice(context, std::array{Choice{kLinearSplits, "Split only"},
                                      Choice{kLinearAverages, "Then average"}});
  }
}

void level_buttons(PanelContext& context) {
  const float gap = context.px(6);
  const float width = std::floor((room() - 2.0F * gap) * 0.36F);
  const float middle = room() - 2.0F * (width + gap);
  action_button(context, kSchemeBack, {.width = width});
  ImGui::SameLine(0.0F, gap);
  const std::string level = "Level " + std::to_string(context.model.document.stage.levels);
  ImGui::Dummy({middle, context.px(28)});
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 size = ImGui::CalcTextSize(level.c_str());
  ImGui::GetWindowDrawList()->AddText({std::floor(low.x + (middle - size.x) / 2.0F),
                                       std::floor(low.y + (context.px(28) - size.y) / 2.0F)},
                                      context.colours.text, level.c_str());
  explain(context, "Level", "How many times every face has been subdivided.");
  remember(context, "scheme level");
  ImGui::SameLine(0.0F, gap);
  action_button(context, kSchemeForward, {.width = width, .is_primary = true});
}

/// Lines of figures in columns, flush right.
class Columns {
 public:
  /// `ends` of the columns are parts of the room there is.
  Columns(PanelContext& context, std::span<const float> ends)
      : context_(context), ends_(ends), width_(room()), height_(context.px(20)) {}

  [[nodiscard]] float width() const { return width_; }
  [[nodiscard]] float height() const { return height_; }

  /// As it fits into a column of this part of the room.
  [[nodiscard]] std::string count(std::uint64_t count, float part) const {
    ImGui::PushFont(context_.fonts.small);
    std::string text = count_text(count, width_ * part - context_.px(8));
    ImGui::PopFont();
    return text;
  }
  /// Over the item drawn last.
  void figures(std::span<const std::string> texts, ImU32 colour) const {
    ImGui::PushFont(context_.fonts.small);
    const ImVec2 low = ImGui::GetItemRectMin();
    const float y = std::floor(low.y + (height_ - ImGui::GetFontSize()) / 2.0F);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (std::size_t i = 0; i < texts.size(); ++i) {
      const float end = low.x + std::floor(width_ * ends_[i]) - context_.px(4);
      list.AddText({std::floor(end - ImGui::CalcTextSize(texts[i].c_str()).x), y}, colour,
                   texts[i].c_str());
    }
    ImGui::PopFont();
  }
  void head(std::span<const std::string> names) const {
    ImGui::Dummy({width_, height_});
    figures(names, context_.colours.dim_text);
  }

 private:
  PanelContext& context_;
  std::span<const float> ends_;
  float width_;
  float height_;
};

/// A line a level: those made with their time, those to come dimmer. Pressing one goes there.
void level_table(PanelContext& context) {
  const SchemeStatus& scheme = context.model.scheme;
  const auto shown = static_cast<std::size_t>(context.model.document.stage.levels);
  const std::size_t rows = std::min(scheme.counts.size(), std::max(kFewestRows, shown + 1));
  constexpr std::array<float, 5> kEnds{0.14F, 0.375F, 0.59F, 0.785F, 1.0F};
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, 0.0F});
  const Columns columns(context, kEnds);
  const ThemeColours& c = context.colours;
  const bool is_narrow = columns.width() < context.px(250);
  columns.head(
      std::array<std::string, 5>{is_narrow ? "" : "Level", "Vertices", "Edges", "Faces", "Time"});
  for (std::size_t level = 0; level < rows; ++level) {
    const Action action(kSetSchemeLevel, static_cast<int>(level));
    ImGui::PushID(static_cast<int>(level));
    const bool is_pressed = ImGui::InvisibleButton("##level", {columns.width(), columns.height()});
    ImGui::PopID();
    if (level == shown || ImGui::IsItemHovered()) {
      ImGui::GetWindowDrawList()->AddRectFilled(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                                level == shown ? c.control : faded(c.control, 0.5F),
                                                context.px(3));
    }
    const SchemeCounts& counts = scheme.counts[level];
    const bool is_made = level < scheme.steps.size() && level <= shown;
    const bool is_awaited = level > 0 && level <= shown && !is_made;
    const std::string time = level > 0 && is_made ? seconds_text(scheme.steps[level].seconds)
                             : is_awaited         ? "…"
                                                  : "";
    const auto text = [&](std::uint64_t count) { return columns.count(count, 0.195F); };
    columns.figures(std::array<std::string, 5>{std::to_string(level), text(counts.vertices),
                                               text(counts.edges), text(counts.faces), time},
                    level <= shown ? c.text : faded(c.dim_text, 0.75F));
    explain(context, "Level " + std::to_string(level),
            "Press to show this level. Time is what making it of the level before took.");
    remember(context, "level " + std::to_string(level));
    if (is_pressed && level != shown) {
      context.emit(action);
    }
  }
  ImGui::PopStyleVar();
}

void misfit_offer(PanelContext& context, const SchemeMisfit& misfit) {
  wrapped_text(context, context.colours.text, misfit.reason);
  if (misfit.fitting) {
    action_button(context, kMakeFit, {.label = fitting_label(*misfit.fitting), .is_primary = true});
  }
}

void sphere_table(PanelContext& context, const SphereSeries& series) {
  constexpr std::array<float, 5> kEnds{0.135F, 0.35F, 0.565F, 0.78F, 1.0F};
  sub_heading(context, scheme_title(series.settings));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, 0.0F});
  const Columns columns(context, kEnds);
  columns.head(std::array<std::string, 5>{"Level", "Radius", "Least", "Greatest", "R.m.s."});
  for (const SphereComparison& row : series.rows) {
    ImGui::Dummy({columns.width(), columns.height()});
    columns.figures(std::array<std::string, 5>{std::to_string(row.level),
                                               fmt::format("{:#.4g}", row.fit.radius),
                                               fmt::format("{:#.2g}", row.fit.least),
                                               fmt::format("{:#.2g}", row.fit.greatest),
                                               fmt::format("{:#.2g}", row.fit.root_mean_square)},
                    context.colours.text);
    explain(context, "Level " + std::to_string(row.level),
            fmt::format("{} vertices lie between {:.6g} and {:.6g} from a sphere of radius {:.8g}; "
                        "the root of the mean square is {:.6g}. In units of the mesh.",
                        grouped(row.vertices), row.fit.least, row.fit.greatest, row.fit.radius,
                        row.fit.root_mean_square));
  }
  ImGui::PopStyleVar();
}

void sphere_part(PanelContext& context) {
  const SphereStatus& status = context.model.sphere;
  sub_heading(context, "How round it becomes");
  if (status.running) {
    draw_progress(context, {*status.running, "Fitting spheres"}, std::nullopt);
    return;
  }
  action_button(context, kCompareSphere);
  if (!status.problem.empty()) {
    wrapped_text(context, context.colours.problem, status.problem);
  }
  if (!status.series.empty()) {
    draw_sphere_plot(context);
  }
  for (const SphereSeries& series : status.series) {
    sphere_table(context, series);
  }
}

}  // namespace

void draw_schemes_section(PanelContext& context) {
  const Model& model = context.model;
  const std::optional<SchemeSettings>& scheme = model.document.scheme;
  action_combo(context, kSetScheme, scheme_entries(model));
  if (scheme) {
    scheme_choices(context, *scheme);
    if (model.scheme.misfit) {
      misfit_offer(context, *model.scheme.misfit);
    } else {
      if (model.refinement.running) {
        const auto level = static_cast<std::size_t>(model.document.stage.levels);
        draw_progress(context, *model.refinement.running,
                      level < model.scheme.counts.size()
                          ? std::optional(model.scheme.counts[level].faces)
                          : std::nullopt);
      } else {
        level_buttons(context);
      }
      level_table(context);
    }
  } else {
    wrapped_text(context, context.colours.dim_text,
                 "Choose a scheme to see every face subdivided, level by level.");
  }
  sub_heading(context, "Beside it");
  action_combo(context, kSetSecondScheme, second_entries());
  if (model.second.misfit && model.display.second) {
    wrapped_text(context, context.colours.dim_text, model.second.misfit->reason);
  }
  if (scheme && !model.scheme.misfit) {
    sphere_part(context);
  }
}

}  // namespace limn::ui
