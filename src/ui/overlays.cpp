// What lies over the viewport: legend, captions, axes, toasts. The axes alone take clicks.

#include <algorithm>
#include <cmath>
#include <string>

#include "limn/document/document.h"
#include "limn/mesh/statistics.h"
#include "ui/availability.h"
#include "ui/axis_gizmo.h"
#include "ui/format.h"
#include "ui/panels.h"
#include "ui/scheme_text.h"
#include "ui/widgets.h"

namespace limn::ui {
namespace {

constexpr float kToastWidth = 640.0F;  // Design units, of its text.
constexpr float kAxesRoom = 84.0F;     // Design units, lower right.

/// Whether a column of eight lines would stand before the mesh.
bool is_small(const PanelContext& context, const WindowRect& place) {
  return place.size.width < static_cast<double>(context.px(640)) &&
         place.size.height < static_cast<double>(context.px(640));
}

/// Side by side, lower left in the first half of the viewport, as many as there is room for.
void draw_legends(PanelContext& context, ImDrawList& list, const LegendLook& look,
                  const WindowRect& place) {
  const Model& model = context.model;
  const float margin = context.px(16);
  const float foot = static_cast<float>(place.origin.y + place.size.height) - margin;
  const float end = static_cast<float>(place.origin.x + place.size.width) - margin;
  float x = static_cast<float>(place.origin.x) + margin;
  const auto next = [&](const WindowSize& size, auto&& draw) {
    const auto width = static_cast<float>(size.width);
    const auto height = static_cast<float>(size.height);
    const bool fits =
        x + width <= end && foot - height >= static_cast<float>(place.origin.y) + margin;
    if (fits) {
      draw(ImVec2{x, foot - height});
      context.items.push_back(
          {"legend", {{static_cast<double>(x), static_cast<double>(foot - height)}, size}});
      x += width + margin / 2.0F;
    }
  };
  // A scheme has no use for depths, unless there are some to be kept in mind.
  const bool is_painted = model.depth_counts[0] < model.document.depths.size();
  const Tint tint = model.display.tint;
  if (tint == Tint::kLevel || (tint == Tint::kDepth && (!model.document.scheme || is_painted))) {
    LegendCounts counts;
    counts.tint = tint;
    counts.depths = tint == Tint::kLevel ? model.level_counts : painted_counts(model);
    const WindowSize compact = compact_legend_size(look);
    const bool has_room_beside_axes =
        x + static_cast<float>(compact.width) + context.px(kAxesRoom) <= end;
    if (is_small(context, place) && has_room_beside_axes) {
      next(compact, [&](ImVec2 at) { draw_compact_legend(list, look, counts, at); });
    } else {
      next(legend_size(look, tint), [&](ImVec2 at) { draw_legend(list, look, counts, at); });
    }
  }
  if (tint == Tint::kDistance && model.distance.figures) {
    next(distance_legend_size(look),
         [&](ImVec2 at) { draw_distance_legend(list, look, *model.distance.figures, at); });
  }
  if (model.display.creases && has_creases(model.crease_counts)) {
    next(crease_legend_size(look),
         [&](ImVec2 at) { draw_crease_legend(list, look, model.crease_counts, at); });
  }
  if (model.display.valences && has_valences(model.valence_counts)) {
    next(valence_legend_size(look),
         [&](ImVec2 at) { draw_valence_legend(list, look, model.valence_counts, at); });
  }
}

/// What a picture shows: "Loop, Warren's weights", and below "Level 3 · 1,280 faces".
void draw_caption(PanelContext& context, ImDrawList& list, const WindowRect& place,
                  const std::string& title, const std::string& facts) {
  const float pad = context.px(10);
  const ImVec2 low{static_cast<float>(place.origin.x) + context.px(16),
                   static_cast<float>(place.origin.y) + context.px(16)};
  const float most = static_cast<float>(place.size.width) - context.px(32) - 2.0F * pad;
  const std::string name = fit_text(title, most);
  ImFont* small = context.fonts.small;
  const float scale = ImGui::GetIO().FontGlobalScale;
  const float small_size = small->FontSize * scale;
  const float width = std::max(ImGui::CalcTextSize(name.c_str()).x,
                               small->CalcTextSizeA(small_size, 1.0e6F, 0.0F, facts.c_str()).x);
  const float line = ImGui::GetFontSize() + context.px(4);
  const ImVec2 high{low.x + std::min(width, most) + 2.0F * pad,
                    low.y + line + small_size + 1.6F * pad};
  list.AddRectFilled(low, high, context.colours.overlay, context.px(6));
  list.AddText({low.x + pad, low.y + 0.8F * pad}, context.colours.text, name.c_str());
  list.AddText(small, small_size, {low.x + pad, low.y + 0.8F * pad + line},
               context.colours.dim_text, facts.c_str());
}

void draw_captions(PanelContext& context, ImDrawList& list, const WindowRect& viewport) {
  const Model& model = context.model;
  const ViewportHalves halves = viewport_halves(viewport, is_split(model));
  if (!model.document.scheme && !halves.second) {
    return;
  }
  const int levels = model.refinement.result ? model.refinement.result->levels : 0;
  const std::size_t faces =
      model.refinement.result ? model.refinement.result->faces : model.statistics.faces;
  const auto facts = [](int level, std::size_t count) {
    return "Level " + std::to_string(level) + " · " + counted(count, "face");
  };
  std::string first = facts(levels, faces);
  if (model.display.is_second_uniform && model.second.faces && !model.second.is_over_budget) {
    first += ", " +
             percent_text(static_cast<double>(faces), static_cast<double>(*model.second.faces)) +
             " of uniform";
  }
  draw_caption(context, list, halves.first,
               model.document.scheme ? scheme_title(*model.document.scheme) : "As painted", first);
  if (!halves.second) {
    return;
  }
  const SecondStatus& second = model.second;
  draw_caption(
      context, list, *halves.second,
      (model.display.is_second_uniform ? "Uniform " : "") + scheme_title(*model.display.second),
      second.misfit           ? "Does not take this mesh"
      : second.is_over_budget ? "Too many faces for the budget"
      : second.faces          ? facts(second.levels, *second.faces)
                              : "…");
  const auto x = std::floor(static_cast<float>(halves.second->origin.x)) + 0.5F;
  list.AddLine({x, static_cast<float>(viewport.origin.y)},
               {x, static_cast<float>(viewport.origin.y + viewport.size.height)},
               context.colours.hairline, context.px(2));
}

/// A ring around the mended place that the person was led to.
void draw_mend_marker(PanelContext& context, ImDrawList& list, const WindowPoint& at) {
  const ImVec2 centre{static_cast<float>(at.x), static_cast<float>(at.y)};
  list.AddCircle(centre, context.px(18), context.colours.overlay, 0, context.px(6));
  list.AddCircle(centre, context.px(18), context.colours.problem, 0, context.px(2.5F));
  list.AddCircleFilled(centre, context.px(3), context.colours.problem);
}

/// Upper middle, below each other; a text too long for one line takes more. `card` is what they
/// must not hide.
void draw_toasts(PanelContext& context, ImDrawList& list, const WindowRect& viewport,
                 const std::optional<WindowRect>& card) {
  const ThemeColours& c = context.colours;
  const auto left = static_cast<float>(viewport.origin.x);
  const auto width = static_cast<float>(viewport.size.width);
  float y = static_cast<float>(viewport.origin.y) + context.px(16);
  const float pad = context.px(14);
  const float mark_room = context.px(16);
  const float font = ImGui::GetFontSize();
  const float widest =
      std::max(std::min(width - 4.0F * pad - mark_room, context.px(kToastWidth)), context.px(40));
  for (const Toast& toast : context.model.toasts) {
    const ImVec2 size = ImGui::CalcTextSize(toast.text.data(),
                                            toast.text.data() + toast.text.size(), false, widest);
    const float box = std::ceil(size.x) + 2.0F * pad + mark_room;
    const float height = std::ceil(size.y) + context.px(36) - font;
    const float x = std::floor(left + (width - box) / 2.0F);
    if (card) {
      const auto card_end = static_cast<float>(card->origin.x + card->size.width);
      const auto card_foot = static_cast<float>(card->origin.y + card->size.height);
      if (x < card_end + context.px(8)) {
        y = std::max(y, card_foot + context.px(8));
      }
    }
    const ImVec2 low{x, y};
    const ImVec2 high{low.x + box, low.y + height};
    list.AddRectFilled(low, high, c.popup, context.px(6));
    list.AddRect(low, high, c.hairline, context.px(6));
    const ImU32 mark = toast.kind == Toast::Kind::kProblem
                           ? c.problem
                           : (toast.kind == Toast::Kind::kDone ? swatch_colour(2) : c.dim_text);
    const float top = std::floor(low.y + (height - size.y) / 2.0F);
    list.AddCircleFilled({low.x + pad + context.px(3), top + font / 2.0F}, context.px(4), mark);
    list.AddText(ImGui::GetFont(), font, {low.x + pad + mark_room, top}, c.text, toast.text.data(),
                 toast.text.data() + toast.text.size(), widest);
    context.items.push_back({"toast: " + toast.text,
                             {{static_cast<double>(low.x), static_cast<double>(low.y)},
                              {static_cast<double>(box), static_cast<double>(height)}}});
    y += height + context.px(8);
  }
}

}  // namespace

void draw_overlays(PanelContext& context, const WindowRect& viewport,
                   std::optional<ActionId> lit_axis) {
  // The background list lies under every window and over the picture.
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 low{static_cast<float>(viewport.origin.x), static_cast<float>(viewport.origin.y)};
  const ImVec2 high{low.x + static_cast<float>(viewport.size.width),
                    low.y + static_cast<float>(viewport.size.height)};
  list.PushClipRect(low, high);
  const WindowRect first = viewport_halves(viewport, is_split(context.model)).first;
  const LegendLook look{context.fonts, context.colours, context.unit};
  draw_legends(context, list, look, first);
  draw_captions(context, list, viewport);
  if (context.model.mend_marker) {
    draw_mend_marker(context, list, *context.model.mend_marker);
  }
  draw_axis_gizmo(context, list, viewport, lit_axis);
  const std::optional<WindowRect> card = hint_card_place(context, first);
  if (card) {
    draw_hint_card(context, list, *card);
  }
  draw_toasts(context, list, viewport, card);
  list.PopClipRect();
}

}  // namespace limn::ui
