// Drawn over the picture like the legend; only its button is a window, so that nobody paints into a
// wall. The lines follow keys, tool and buttons in force.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "limn/document/document.h"
#include "ui/keymap.h"
#include "ui/mouse_map.h"
#include "ui/panels.h"
#include "ui/widgets.h"

namespace limn::ui {
namespace {

struct HintLine {
  const char* what;
  std::string how;
  bool is_done = false;
};

std::array<HintLine, 3> lines_of(const Model& model) {
  const HintCard& card = *model.hints;
  const std::string key = key_text(model.keymap, ActionId::kToolPaint);
  const bool is_ready = model.brush.tool == Tool::kPaint || key.empty();
  const char* const lowering =
      model.brush.shift_draws_lines ? "Ctrl + left drag" : "Shift + left drag";
  const auto orbit = static_cast<std::size_t>(CameraGesture::kOrbit);
  return {HintLine{"Paint", is_ready ? "Left drag over the mesh" : key + ", then left drag",
                   card.has_painted},
          HintLine{"Lower", lowering},
          HintLine{"Orbit", std::string(gesture_lines(model.navigation.preset)[orbit].how),
                   card.has_orbited}};
}

constexpr const char* kFoot = "F1 shows all keys";
constexpr float kPad = 14.0F;  // Design units, as what follows.
constexpr float kLine = 23.0F;
constexpr float kMark = 22.0F;  // From the edge of a line to its text.
constexpr float kWhat = 54.0F;  // And from there to what the hand does.
constexpr float kButton = 72.0F;
constexpr float kButtonHeight = 28.0F;

float width_of(const char* text) {
  return ImGui::CalcTextSize(text).x;
}

/// A ring, and a tick where it has been done.
void draw_mark(const PanelContext& context, ImDrawList& list, ImVec2 centre, bool is_done) {
  const float r = context.px(5);
  if (!is_done) {
    list.AddCircle(centre, r, context.colours.dim_text, 0, context.px(1.5F));
    return;
  }
  const std::array<ImVec2, 3> tick{ImVec2{centre.x - r, centre.y},
                                   ImVec2{centre.x - 0.25F * r, centre.y + 0.75F * r},
                                   ImVec2{centre.x + r, centre.y - 0.75F * r}};
  list.AddPolyline(tick.data(), static_cast<int>(tick.size()), context.colours.accent,
                   ImDrawFlags_None, context.px(2));
}

void draw_close_button(PanelContext& context, ImVec2 at) {
  ImGui::SetNextWindowPos(at);
  ImGui::SetNextWindowSize({context.px(kButton), context.px(kButtonHeight)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1.0F, 1.0F});
  ImGui::Begin("##hints", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBackground |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  action_button(context, Action(ActionId::kToggleHints, false), {.label = "Got it"});
  ImGui::End();
  ImGui::PopStyleVar(2);
}

}  // namespace

std::optional<WindowRect> hint_card_place(const PanelContext& context, const WindowRect& viewport) {
  if (!context.model.hints) {
    return std::nullopt;
  }
  const float pad = context.px(kPad);
  float widest = width_of(kFoot) + context.px(16.0F + kButton);
  for (const HintLine& line : lines_of(context.model)) {
    widest = std::max(widest, context.px(kMark + kWhat) + width_of(line.how.c_str()));
  }
  const double margin = static_cast<double>(context.px(16));
  const double width = std::min(static_cast<double>(widest + 2.0F * pad),
                                std::max(viewport.size.width - 2.0 * margin, 1.0));
  const double height = static_cast<double>(2.0F * pad + context.px(3.0F * kLine + 12.0F) +
                                            context.px(kButtonHeight));
  // Below the captions, where there are some.
  const bool has_caption = context.model.document.scheme || is_split(context.model);
  const double top = margin + (has_caption ? static_cast<double>(context.px(60)) : 0.0);
  return WindowRect{{std::floor(viewport.origin.x + margin), std::floor(viewport.origin.y + top)},
                    {std::floor(width), std::floor(height)}};
}

void draw_hint_card(PanelContext& context, ImDrawList& list, const WindowRect& place) {
  const ThemeColours& c = context.colours;
  const ImVec2 low{static_cast<float>(place.origin.x), static_cast<float>(place.origin.y)};
  const ImVec2 high{low.x + static_cast<float>(place.size.width),
                    low.y + static_cast<float>(place.size.height)};
  list.AddRectFilled(low, high, c.popup, context.px(6));
  list.AddRect(low, high, c.hairline, context.px(6));
  const float pad = context.px(kPad);
  float y = low.y + pad;
  const float font = ImGui::GetFontSize();
  for (const HintLine& line : lines_of(context.model)) {
    const float text_y = std::floor(y + (context.px(kLine) - font) / 2.0F);
    const float x = low.x + pad + context.px(kMark);
    draw_mark(context, list, {low.x + pad + context.px(6), y + context.px(kLine) / 2.0F},
              line.is_done);
    list.AddText({x, text_y}, line.is_done ? c.dim_text : c.text, line.what);
    const float left = x + context.px(kWhat);
    list.AddText({left, text_y}, c.dim_text, fit_text(line.how, high.x - pad - left).c_str());
    y += context.px(kLine);
  }
  const float button_y = high.y - pad - context.px(kButtonHeight);
  list.AddText({low.x + pad, std::floor(button_y + (context.px(kButtonHeight) - font) / 2.0F)},
               c.dim_text, kFoot);
  context.items.push_back({"hints", place});
  draw_close_button(context, {high.x - pad - context.px(kButton), button_y});
}

}  // namespace limn::ui
