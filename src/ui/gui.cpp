// Owns the ImGui context. A frame feeds it the input of one InputFrame, runs the panels, and asks
// it afterwards whose the mouse was.

#include "ui/gui.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <utility>

#include <imgui.h>
#include <imgui_internal.h>

#include "ui/axis_gizmo.h"
#include "ui/keys.h"
#include "ui/panels.h"

namespace limn::ui {
namespace {

constexpr double kMinPanelWidth = 300.0;
constexpr double kMaxPanelWidth = 560.0;
constexpr double kMinViewportWidth = 240.0;
constexpr double kStripWidth = 44.0;
constexpr double kStatusHeight = 26.0;

void map_keys(ImGuiIO& io) {
  const auto map = [&io](ImGuiKey_ which, Key key) { io.KeyMap[which] = static_cast<int>(key); };
  map(ImGuiKey_Tab, Key::kTab);
  map(ImGuiKey_LeftArrow, Key::kLeftArrow);
  map(ImGuiKey_RightArrow, Key::kRightArrow);
  map(ImGuiKey_UpArrow, Key::kUpArrow);
  map(ImGuiKey_DownArrow, Key::kDownArrow);
  map(ImGuiKey_PageUp, Key::kPageUp);
  map(ImGuiKey_PageDown, Key::kPageDown);
  map(ImGuiKey_Home, Key::kHome);
  map(ImGuiKey_End, Key::kEnd);
  map(ImGuiKey_Insert, Key::kInsert);
  map(ImGuiKey_Delete, Key::kDelete);
  map(ImGuiKey_Backspace, Key::kBackspace);
  map(ImGuiKey_Space, Key::kSpace);
  map(ImGuiKey_Enter, Key::kEnter);
  map(ImGuiKey_Escape, Key::kEscape);
  map(ImGuiKey_KeyPadEnter, Key::kNumpadEnter);
  map(ImGuiKey_A, Key::kA);
  map(ImGuiKey_C, Key::kC);
  map(ImGuiKey_V, Key::kV);
  map(ImGuiKey_X, Key::kX);
  map(ImGuiKey_Y, Key::kY);
  map(ImGuiKey_Z, Key::kZ);
}

void feed(ImGuiIO& io, const InputFrame& input) {
  io.MousePos = input.cursor ? ImVec2(static_cast<float>(input.cursor->x),
                                      static_cast<float>(input.cursor->y))
                             : ImVec2(-FLT_MAX, -FLT_MAX);
  for (std::size_t b = 0; b < kMouseButtonCount; ++b) {
    io.MouseDown[b] = input.buttons_down[b];
  }
  io.MouseWheel = static_cast<float>(input.wheel.y);
  io.MouseWheelH = static_cast<float>(input.wheel.x);
  for (std::size_t k = 0; k < kKeyCount; ++k) {
    io.KeysDown[k] = input.keys_down.test(k);
  }
  io.KeyCtrl = input.modifiers.ctrl;
  io.KeyShift = input.modifiers.shift;
  io.KeyAlt = input.modifiers.alt;
  io.KeySuper = input.modifiers.super;
  for (const char32_t character : input.text) {
    io.AddInputCharacter(static_cast<unsigned>(character));
  }
}

CursorShape cursor_shape() {
  switch (ImGui::GetMouseCursor()) {
    case ImGuiMouseCursor_TextInput:
      return CursorShape::kText;
    case ImGuiMouseCursor_ResizeEW:
      return CursorShape::kResizeHorizontal;
    default:
      return CursorShape::kArrow;
  }
}

/// Whether ImGui needs more frames to show what it was told: new windows stay hidden until their
/// size is known, and the ground behind a dialog darkens by and by. A part of a panel that is
/// scrolled out of sight is hidden for as long as it is there, and needs nothing.
bool is_unsettled() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  const bool is_fading = context.DimBgRatio > 0.0F && context.DimBgRatio < 1.0F;
  return is_fading ||
         std::any_of(context.Windows.begin(), context.Windows.end(), [](const ImGuiWindow* window) {
           const bool is_part = (window->Flags & ImGuiWindowFlags_ChildWindow) != 0;
           const bool is_hidden =
               window->HiddenFramesCannotSkipItems > 0 || window->HiddenFramesCanSkipItems > 0;
           return window->Active && (window->Appearing || (is_hidden && !is_part));
         });
}

struct ContextDeleter {
  void operator()(ImGuiContext* context) const { ImGui::DestroyContext(context); }
};

}  // namespace

struct Gui::State {
  FontFiles font_files;
  Scale scale;
  ImFontAtlas atlas;  // Outlives the context, which only borrows it.
  Fonts fonts;
  std::uint64_t atlas_revision = 0;
  std::unique_ptr<ImGuiContext, ContextDeleter> context;

  UiState ui;
  InputRouter router;
  std::vector<ItemRect> items;
  std::optional<Theme> styled_theme;
  std::function<std::string()> read_clipboard;
  std::function<void(std::string)> write_clipboard;
  std::string clipboard;  // What ImGui was given last.

  [[nodiscard]] float unit() const { return static_cast<float>(scale.interface); }
  void rebuild_fonts();
  void restyle(Theme theme);
  void begin(WindowSize window, double seconds);
};

void Gui::State::rebuild_fonts() {
  fonts = build_fonts(atlas, font_files, scale);
  ++atlas_revision;
  styled_theme.reset();
}

void Gui::State::restyle(Theme theme) {
  if (styled_theme == theme) {
    return;
  }
  apply_style(ImGui::GetStyle(), theme, unit());
  styled_theme = theme;
}

void Gui::State::begin(WindowSize window, double seconds) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(window.width), static_cast<float>(window.height)};
  const auto density = static_cast<float>(scale.density);
  io.DisplayFramebufferScale = {density, density};
  io.FontGlobalScale = 1.0F / density;
  io.DeltaTime = static_cast<float>(std::clamp(seconds, 1.0e-4, 10.0));
}

Gui::Gui(FontFiles fonts, Scale scale) : state_(std::make_unique<State>()) {
  state_->font_files = std::move(fonts);
  state_->scale = scale;
  state_->rebuild_fonts();
  ImGuiContext* before = ImGui::GetCurrentContext();
  state_->context.reset(ImGui::CreateContext(&state_->atlas));
  ImGui::SetCurrentContext(state_->context.get());
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors | ImGuiBackendFlags_RendererHasVtxOffset;
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  map_keys(io);
  ImGui::SetCurrentContext(before);
}

Gui::~Gui() = default;

void Gui::set_scale(Scale scale) {
  if (state_->scale == scale) {
    return;
  }
  state_->scale = scale;
  state_->rebuild_fonts();
}

GuiFrame Gui::frame(const Model& model, const InputFrame& input, WindowSize window) {
  State& state = *state_;
  GuiFrame out;
  ImGui::SetCurrentContext(state.context.get());
  state.items.clear();
  if (window.width < 1.0 || window.height < 1.0) {
    out.viewport_input = state.router.route(input, false);
    ImGui::GetDrawData()->Clear();
    return out;
  }
  state.restyle(model.display.theme);
  state.begin(window, model.frame_seconds);
  ImGuiIO& io = ImGui::GetIO();
  feed(io, input);
  ImGui::NewFrame();
  ImGui::PushFont(state.fonts.body);

  // Esc belongs to an open menu first.
  const bool is_modal = !std::holds_alternative<std::monostate>(model.modal);
  const bool has_menu = !is_modal && ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId |
                                                                ImGuiPopupFlags_AnyPopupLevel);
  const bool is_escaping = std::any_of(input.presses.begin(), input.presses.end(),
                                       [](const KeyPress& p) { return p.key == Key::kEscape; });
  if (has_menu && is_escaping) {
    close_popups();
  } else if (!has_menu) {
    out.actions = key_actions(input, model, io.WantTextInput);
  }

  PanelContext context{
      model,        input,       state.ui,    state.fonts, theme_colours(model.display.theme),
      state.unit(), out.actions, state.items, {},          {}};
  const double unit = state.scale.interface;
  state.ui.awaits_tooltip = false;
  const double top = static_cast<double>(draw_menu_bar(context));
  const double strip = kStripWidth * unit;
  const double status = kStatusHeight * unit;
  const double middle = std::max(1.0, window.height - top - status);
  PanelLayout& layout = state.ui.layout;
  const double widest = window.width / unit - kStripWidth - kMinViewportWidth;
  layout.panel_width = std::clamp(layout.panel_width, kMinPanelWidth,
                                  std::max(kMinPanelWidth, std::min(kMaxPanelWidth, widest)));
  const double panel = std::round(layout.panel_width * unit);
  out.viewport = {{strip, top}, {std::max(1.0, window.width - strip - panel), middle}};

  const bool is_over_viewport = input.cursor && out.viewport.contains(*input.cursor) &&
                                !io.WantCaptureMouse && !is_modal && !has_menu;
  // The axes lie over the viewport: what begins on them is theirs.
  const bool is_pressed = input.button && input.button->is_down;
  std::optional<ActionId> axis;
  if (is_over_viewport && (is_pressed || !input.any_button_down())) {
    axis = axis_end_at(context, out.viewport, *input.cursor);
  }
  out.viewport_input = state.router.route(input, is_over_viewport && !axis);
  if (axis && is_pressed && input.button->button == MouseButton::kLeft &&
      !out.viewport_input.owns_drag) {
    out.actions.emplace_back(*axis);
  }

  draw_overlays(context, out.viewport, out.viewport_input.owns_drag ? std::nullopt : axis);
  draw_tool_strip(context, {{0.0, top}, {strip, middle}});
  draw_side_panel(context, {{window.width - panel, top}, {panel, middle}});
  const WindowRect foot{{0.0, window.height - status}, {window.width, status}};
  reserve_status_line(context, foot);
  draw_modal(context, window);
  if (context.hint.empty()) {
    state.ui.hovered_control = 0;
  }
  draw_status_line(context, foot, out.viewport_input);
  ImGui::PopFont();
  ImGui::Render();

  out.wants_text = io.WantTextInput;
  out.cursor = out.viewport_input.is_hovered ? CursorShape::kArrow : cursor_shape();
  const bool had_input = !input.path.empty() || input.button || !input.presses.empty() ||
                         !input.text.empty() || input.wheel != WheelTurned{};
  out.needs_another_frame =
      had_input || !out.actions.empty() || state.ui.awaits_tooltip || is_unsettled();
  return out;
}

void Gui::frame_legend(const LegendCounts& counts, Theme theme, WindowSize image) {
  State& state = *state_;
  ImGui::SetCurrentContext(state.context.get());
  state.restyle(theme);
  state.begin(image, 1.0 / 60.0);
  ImGui::NewFrame();
  const LegendLook look{state.fonts, theme_colours(theme), state.unit()};
  const float margin = 16.0F * state.unit();
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float bottom = static_cast<float>(image.height) - margin;
  float left = margin;
  if (counts.tint == Tint::kDistance) {
    if (counts.distance) {
      const WindowSize size = distance_legend_size(look);
      draw_distance_legend(list, look, *counts.distance,
                           {left, bottom - static_cast<float>(size.height)});
      left += static_cast<float>(size.width) + margin / 2.0F;
    }
  } else if (counts.tint != Tint::kNone) {
    const WindowSize size = legend_size(look, counts.tint);
    draw_legend(list, look, counts, {left, bottom - static_cast<float>(size.height)});
    left += static_cast<float>(size.width) + margin / 2.0F;
  }
  if (has_creases(counts.creases)) {
    draw_crease_legend(list, look, counts.creases,
                       {left, bottom - static_cast<float>(crease_legend_size(look).height)});
  }
  ImGui::Render();
}

ImDrawData& Gui::draw_data() const {
  ImGui::SetCurrentContext(state_->context.get());
  return *ImGui::GetDrawData();
}

ImFontAtlas& Gui::atlas() const {
  return state_->atlas;
}

std::uint64_t Gui::atlas_revision() const noexcept {
  return state_->atlas_revision;
}

void Gui::set_clipboard(std::function<std::string()> read, std::function<void(std::string)> write) {
  ImGui::SetCurrentContext(state_->context.get());
  state_->read_clipboard = std::move(read);
  state_->write_clipboard = std::move(write);
  ImGuiIO& io = ImGui::GetIO();
  io.ClipboardUserData = state_.get();
  io.GetClipboardTextFn = [](void* user) -> const char* {
    State& state = *static_cast<State*>(user);
    state.clipboard = state.read_clipboard ? state.read_clipboard() : std::string();
    return state.clipboard.c_str();
  };
  io.SetClipboardTextFn = [](void* user, const char* text) {
    State& state = *static_cast<State*>(user);
    if (state.write_clipboard) {
      state.write_clipboard(text);
    }
  };
}

std::span<const ItemRect> Gui::items() const {
  return state_->items;
}

PanelLayout Gui::layout() const {
  return state_->ui.layout;
}

void Gui::set_layout(const PanelLayout& layout) {
  state_->ui.layout = layout;
}

}  // namespace limn::ui
