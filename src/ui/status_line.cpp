// Left: what the mouse will do now, which follows the tool and the keys held. Right: the face under
// the cursor, what a click would cost, and how many faces the mesh costs against uniform
// subdivision.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>

#include "limn/document/document.h"
#include "limn/subdivision/prediction.h"
#include "ui/availability.h"
#include "ui/format.h"
#include "ui/mouse_map.h"
#include "ui/panels.h"
#include "ui/widgets.h"

namespace limn::ui {
namespace {

/// "12 – 45", its vertices.
std::string edge_text(const EdgeHover& edge) {
  return grouped(edge.vertices[0]) + " – " + grouped(edge.vertices[1]);
}

/// Whether faces of the refined mesh are painted, as far as is told of them.
bool is_fine(const Model& model) {
  return model.brush.is_fine && why_not_fine(model).empty() && !is_fill(model.brush.tool);
}

/// "depth +1" or "set depth 3".
std::string change_text(const BrushSettings& brush) {
  return brush.sets_depth ? "set depth " + std::to_string(brush.target_depth)
                          : std::string("depth +1");
}

std::string tool_hint(const Model& model) {
  const BrushSettings& brush = model.brush;
  switch (brush.tool) {
    case Tool::kPaint:
      return "Left drag: " + change_text(brush) + (is_fine(model) ? " on finer faces" : "") +
             (brush.shift_draws_lines ? " · Shift + click: line · Ctrl: −1" : " · Shift: −1");
    case Tool::kLower:
      return "Left drag: depth −1" + std::string(is_fine(model) ? " on finer faces" : "") +
             " · Shift + click: line";
    case Tool::kFill:
      return "Click: fill this depth's region, " + change_text(brush) + " · Shift: −1";
    case Tool::kSmartFill:
      return "Click: fill up to the angle, " + change_text(brush) + " · Shift: −1";
    case Tool::kRectangle:
      return "Left drag: rectangle, " + change_text(brush) +
             (is_fine(model) ? " on finer faces" : "") + " · Shift: −1";
    case Tool::kLasso:
      return "Left drag: lasso, " + change_text(brush) + (is_fine(model) ? " on finer faces" : "") +
             " · Shift: −1";
    case Tool::kPick:
      return "Click: pick the depth of this face";
    case Tool::kSplitEdge:
      return model.hover_edge ? "Click: split edge " + edge_text(*model.hover_edge)
                              : "Point at an edge and click to split it";
    case Tool::kFlipEdge:
      return model.hover_edge ? "Click: flip edge " + edge_text(*model.hover_edge)
                              : "Point at an edge and click to flip it";
    case Tool::kOrbit:
      break;
  }
  return {};
}

std::string drag_hint(const Model& model) {
  if (!model.is_stroking) {
    return "Moving the view";
  }
  if (is_area(model.brush.tool)) {
    return "Release: paint these faces · Esc: give it up";
  }
  return is_fine(model)
             ? "Painting finer faces: each changes once, on release · Esc: give it up"
             : "Painting: each face changes once a stroke · Release: done · Esc: give it up";
}

/// What the left button does with Shift or Ctrl held.
std::string lowering_hint(const Model& model, const Modifiers& held) {
  const BrushSettings& brush = model.brush;
  const std::string keys = held.ctrl ? "Ctrl + " : "Shift + ";
  const bool draws_line = held.shift && (brush.tool == Tool::kLower ||
                                         (brush.tool == Tool::kPaint && brush.shift_draws_lines));
  if (draws_line) {
    const bool lowers = held.ctrl || brush.tool == Tool::kLower;
    return "Click: straight line from the last stroke, " +
           (lowers ? std::string("depth −1") : change_text(brush));
  }
  const std::string how = is_fill(brush.tool) ? "click" : "left drag";
  const bool pans_by_shift = model.navigation.preset == NavigationPreset::kOriginal;
  const char* more = "";
  if (held.ctrl) {
    more = brush.tool == Tool::kSmartFill ? " · Ctrl + wheel: fill angle"
                                          : " · Ctrl + wheel: brush size";
  } else if (pans_by_shift) {
    more = " · Shift + middle drag: pan";
  }
  return keys + how + ": depth −1" + more;
}

/// "12,480 faces, 31 % of uniform"; of the mesh to come while there is none.
std::string cost_text(const Model& model) {
  const RefinementStatus& refinement = model.refinement;
  const auto text = [](std::uint64_t faces, std::uint64_t uniform, const char* note) {
    std::string cost = counted(faces, "face") + note;
    if (uniform > 0) {
      cost += ", " + percent_text(static_cast<double>(faces), static_cast<double>(uniform)) +
              " of uniform";
    }
    return cost;
  };
  if (refinement.result) {
    return text(refinement.result->faces, refinement.result->uniform_faces, "");
  }
  if (refinement.prediction != nullptr && !model.document.scheme) {
    return text(refinement.prediction->faces, refinement.prediction->uniform_faces, " to come");
  }
  return {};
}

float width_of(const std::string& text) {
  return ImGui::CalcTextSize(text.c_str()).x;
}

/// As many of the parts between dots as there is room for, the first at the least.
std::string fit_clauses(std::string text, float width) {
  constexpr std::string_view kDot = " · ";
  while (width_of(text) > width) {
    const std::size_t last = text.rfind(kDot);
    if (last == std::string::npos) {
      return fit_text(text, width);
    }
    text.resize(last);
  }
  return text;
}

/// Further calls within the frame go on in the same window. ImGui::End follows.
void begin_window(PanelContext& context, const WindowRect& place) {
  ImGui::SetNextWindowPos({static_cast<float>(place.origin.x), static_cast<float>(place.origin.y)});
  ImGui::SetNextWindowSize(
      {static_cast<float>(place.size.width), static_cast<float>(place.size.height)});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, context.colours.chrome);
  ImGui::Begin("##status", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoScrollWithMouse |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PopStyleColor();
}

}  // namespace

std::string forecast_text(const PaintForecast& forecast) {
  if (forecast.faces == 0) {
    return "no face changes";
  }
  const std::string sign = forecast.amount < 0 ? "−" : "+";
  const std::string target = forecast.depth
                                 ? " to depth " + std::to_string(*forecast.depth)
                                 : " by " + sign + std::to_string(std::abs(forecast.amount));
  const std::string added =
      (forecast.added_faces < 0 ? "−" : "+") +
      counted(static_cast<std::uint64_t>(std::abs(forecast.added_faces)), "face");
  return counted(forecast.faces, "face") + target + ": " + added;
}

std::string mouse_hint(const Model& model, const ViewportInput& input) {
  if (input.owns_drag) {
    return drag_hint(model);
  }
  const Modifiers& held = input.modifiers;
  if (held.alt) {
    return "Alt + left drag: orbit · Middle: pan · Right: zoom";
  }
  if ((held.ctrl || held.shift) && is_painting(model.brush.tool)) {
    return lowering_hint(model, held);
  }
  const bool is_orbit = model.brush.tool == Tool::kOrbit;
  const std::string camera(
      navigation_hint(model.navigation.preset, is_orbit, is_area(model.brush.tool)));
  return is_orbit ? camera : tool_hint(model) + " · " + camera;
}

void reserve_status_line(PanelContext& context, const WindowRect& place) {
  begin_window(context, place);
  ImGui::End();
}

void draw_status_line(PanelContext& context, const WindowRect& place, const ViewportInput& input) {
  const ImVec2 origin{static_cast<float>(place.origin.x), static_cast<float>(place.origin.y)};
  const auto width = static_cast<float>(place.size.width);
  const auto height = static_cast<float>(place.size.height);
  begin_window(context, place);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddLine({origin.x, origin.y + 0.5F}, {origin.x + width, origin.y + 0.5F},
               context.colours.hairline, 1.0F);
  ImGui::PushFont(context.fonts.small);
  const float y = std::floor(origin.y + (height - ImGui::GetFontSize()) / 2.0F);
  const float pad = context.px(12);
  const bool is_over_control = !context.hint.empty() && !input.owns_drag;
  const std::string wanted = is_over_control ? context.hint : mouse_hint(context.model, input);
  const std::string cost = cost_text(context.model);
  float right = origin.x + width - pad - width_of(cost);
  list.AddText({std::floor(right), y}, context.colours.text, cost.c_str());
  right -= context.px(20);
  if (is_painting(context.model.brush.tool) && !context.model.document.scheme) {
    // The place is kept while nothing is known, so that nothing else moves when it is.
    const std::string text =
        context.model.forecast ? forecast_text(*context.model.forecast) : std::string();
    const float slot = width_of("88 faces to depth 8: +88,888 faces");
    right -= std::max(slot, width_of(text));
    list.AddText({std::floor(right), y}, context.colours.text, text.c_str());
    right -= context.px(20);
  }
  if (const std::optional<HoverInfo>& hover = context.model.hover) {
    std::string face = "Face " + grouped(hover->face);
    if (hover->fine) {
      face += ", level " + std::to_string(hover->fine->level) + ", depth " +
              std::to_string(hover->fine->depth);
    } else {
      face += ", depth " + std::to_string(hover->depth);
    }
    const float left = right - width_of(face);
    if (left - context.px(20) > origin.x + pad + width_of(wanted)) {
      list.AddText({std::floor(left), y}, context.colours.dim_text, face.c_str());
      right = left - context.px(20);
    }
  }
  const std::string hint = fit_clauses(wanted, right - origin.x - pad);
  list.AddText({origin.x + pad, y}, context.colours.dim_text, hint.c_str());
  context.items.push_back(
      {"status: " + hint,
       {{static_cast<double>(origin.x + pad), static_cast<double>(y)},
        {static_cast<double>(width_of(hint)), static_cast<double>(ImGui::GetFontSize())}}});
  ImGui::PopFont();
  ImGui::End();
}

}  // namespace limn::ui
