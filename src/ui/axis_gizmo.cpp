// The axes of the mesh as they lie in the view, with a disc at both ends of each. Drawn and hit by
// the same list of ends, the nearest to the viewer last.

#include "ui/axis_gizmo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ui/action_table.h"
#include "ui/widgets.h"

namespace limn::ui {
namespace {

constexpr float kArm = 30.0F;  // Design units, as are the next ones.
constexpr float kDisc = 9.0F;
constexpr float kSmallDisc = 6.5F;
constexpr float kFromCorner = 58.0F;

struct Axis {
  const char* name;
  std::array<double, 3> direction;
  ImU32 colour;
  ActionId from_here;  ///< Looks at the mesh from this end.
  ActionId from_behind;
};

constexpr std::array<Axis, 3> kAxes{{
    {"X", {1, 0, 0}, IM_COL32(0xE0, 0x5A, 0x5A, 0xFF), ActionId::kViewRight, ActionId::kViewLeft},
    {"Y", {0, 1, 0}, IM_COL32(0x6F, 0xB0, 0x4A, 0xFF), ActionId::kViewTop, ActionId::kViewBottom},
    {"Z", {0, 0, 1}, IM_COL32(0x5B, 0x8D, 0xE0, 0xFF), ActionId::kViewFront, ActionId::kViewBack},
}};

struct End {
  const Axis* axis = nullptr;
  ActionId view{};
  bool is_positive = false;
  double nearness = 0.0;  ///< Towards the viewer, -1..1.
  ImVec2 tip;
  float radius = 0.0F;
};

/// Right, up and towards the viewer of a direction in the mesh's frame (ViewState's yaw, pitch).
std::array<double, 3> to_view(const ViewState& view, const std::array<double, 3>& d) {
  const double yaw = view.yaw * std::numbers::pi / 180.0;
  const double pitch = view.pitch * std::numbers::pi / 180.0;
  const double right = std::cos(yaw) * d[0] - std::sin(yaw) * d[2];
  const double ahead = std::sin(yaw) * d[0] + std::cos(yaw) * d[2];
  return {right, std::cos(pitch) * d[1] - std::sin(pitch) * ahead,
          std::sin(pitch) * d[1] + std::cos(pitch) * ahead};
}

ImVec2 centre_in(const PanelContext& context, const WindowRect& viewport) {
  return {static_cast<float>(viewport.origin.x + viewport.size.width) - context.px(kFromCorner),
          static_cast<float>(viewport.origin.y + viewport.size.height) - context.px(kFromCorner)};
}

/// All six, the farthest first.
std::array<End, 6> ends_in(const PanelContext& context, const WindowRect& viewport) {
  const ImVec2 centre = centre_in(context, viewport);
  std::array<End, 6> ends;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Axis& axis = kAxes[i / 2];
    const bool is_positive = i % 2 == 0;
    const std::array<double, 3> seen = to_view(context.model.view, axis.direction);
    const float reach = context.px(is_positive ? kArm : -kArm);
    ends[i] = {&axis,
               is_positive ? axis.from_here : axis.from_behind,
               is_positive,
               is_positive ? seen[2] : -seen[2],
               {centre.x + static_cast<float>(seen[0]) * reach,
                centre.y - static_cast<float>(seen[1]) * reach},
               context.px(is_positive ? kDisc : kSmallDisc)};
  }
  std::stable_sort(ends.begin(), ends.end(),
                   [](const End& a, const End& b) { return a.nearness < b.nearness; });
  return ends;
}

}  // namespace

std::optional<ActionId> axis_end_at(const PanelContext& context, const WindowRect& viewport,
                                    WindowPoint place) {
  std::optional<ActionId> hit;
  for (const End& end : ends_in(context, viewport)) {
    const double distance = std::hypot(place.x - static_cast<double>(end.tip.x),
                                       place.y - static_cast<double>(end.tip.y));
    if (distance <= static_cast<double>(end.radius)) {
      hit = end.view;
    }
  }
  return hit;
}

void draw_axis_gizmo(PanelContext& context, ImDrawList& list, const WindowRect& viewport,
                     std::optional<ActionId> lit) {
  const ImVec2 centre = centre_in(context, viewport);
  ImFont* font = context.fonts.head;
  const float size = font->FontSize * ImGui::GetIO().FontGlobalScale;
  for (const End& end : ends_in(context, viewport)) {
    const bool is_lit = lit == end.view;
    const ImU32 colour = faded(end.axis->colour, end.nearness < -0.1 && !is_lit ? 0.55F : 1.0F);
    if (end.is_positive) {
      list.AddLine(centre, end.tip, colour, context.px(2));
      list.AddCircleFilled(end.tip, end.radius, colour);
    } else {
      list.AddCircleFilled(end.tip, end.radius, faded(end.axis->colour, is_lit ? 1.0F : 0.25F));
      list.AddCircle(end.tip, end.radius, colour, 0, context.px(1.5F));
    }
    if (is_lit) {
      list.AddCircle(end.tip, end.radius + context.px(1), context.colours.text, 0,
                     context.px(1.5F));
    }
    if (end.is_positive || is_lit) {
      const ImVec2 text = font->CalcTextSizeA(size, 1.0e6F, 0.0F, end.axis->name);
      list.AddText(font, size,
                   {std::floor(end.tip.x - text.x / 2.0F), std::floor(end.tip.y - text.y / 2.0F)},
                   IM_COL32_WHITE, end.axis->name);
    }
    const auto side = static_cast<double>(2.0F * end.radius);
    context.items.push_back({"axis: " + std::string(info(end.view).label),
                             {{static_cast<double>(end.tip.x - end.radius),
                               static_cast<double>(end.tip.y - end.radius)},
                              {side, side}}});
  }
  if (lit) {
    explain_here(context, *lit);
  }
}

}  // namespace limn::ui
