// Left: what the mouse will do now, which follows the tool and the keys held. Right: the face under
// the cursor, and how many faces the mesh costs against uniform subdivision.

#include <cmath>
#include <string>

#include "limn/document/document.h"
#include "limn/subdivision/prediction.h"
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

std::string tool_hint(const Model& model) {
  const BrushSettings& brush = model.brush;
  switch (brush.tool) {
    case Tool::kPaint:
      return (brush.sets_depth ? "Left drag: set depth " + std::to_string(brush.target_depth)
                               : std::string("Left drag: depth +1")) +
             " · Shift: −1";
    case Tool::kLower:
      return "Left drag: depth −1";
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
  if (model.is_stroking) {
    return "Painting: each face changes once a stroke · Release: done · Esc: give it up";
  }
  return "Moving the view";
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

}  // namespace

std::string mouse_hint(const Model& model, const ViewportInput& input) {
  if (input.owns_drag) {
    return drag_hint(model);
  }
  const Modifiers& held = input.modifiers;
  if (held.alt) {
    return "Alt + left drag: orbit · Middle: pan · Right: zoom";
  }
  const bool is_brush = model.brush.tool == Tool::kPaint || model.brush.tool == Tool::kLower;
  if (held.ctrl && is_brush) {
    return "Ctrl + left drag: depth −1 · Ctrl + wheel: brush size";
  }
  if (held.shift && is_brush) {
    return model.navigation.preset == NavigationPreset::kOriginal
               ? "Shift + left drag: depth −1 · Shift + middle drag: pan"
               : "Shift + left drag: depth −1";
  }
  const bool is_orbit = model.brush.tool == Tool::kOrbit;
  const std::string camera(navigation_hint(model.navigation.preset, is_orbit));
  return is_orbit ? camera : tool_hint(model) + " · " + camera;
}

void draw_status_line(PanelContext& context, const WindowRect& place, const ViewportInput& input) {
  const ImVec2 origin{static_cast<float>(place.origin.x), static_cast<float>(place.origin.y)};
  const auto width = static_cast<float>(place.size.width);
  const auto height = static_cast<float>(place.size.height);
  ImGui::SetNextWindowPos(origin);
  ImGui::SetNextWindowSize({width, height});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, context.colours.chrome);
  ImGui::Begin("##status", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoScrollWithMouse |
                   ImGuiWindowFlags_NoFocusOnAppearing);
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
  if (const std::optional<HoverInfo>& hover = context.model.hover) {
    const std::string face =
        "Face " + grouped(hover->face) + ", depth " + std::to_string(hover->depth);
    const float left = right - width_of(face);
    if (left - context.px(20) > origin.x + pad + width_of(wanted)) {
      list.AddText({std::floor(left), y}, context.colours.dim_text, face.c_str());
      right = left - context.px(20);
    }
  }
  const std::string hint = fit_text(wanted, right - origin.x - pad);
  list.AddText({origin.x + pad, y}, context.colours.dim_text, hint.c_str());
  ImGui::PopFont();
  ImGui::End();
  ImGui::PopStyleColor();
}

}  // namespace limn::ui
