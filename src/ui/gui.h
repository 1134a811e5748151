#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/action.h"
#include "ui/input.h"
#include "ui/model.h"
#include "ui/window_geometry.h"

struct ImDrawData;
struct ImFontAtlas;

namespace limn::ui {

/// Paths where a fitting typeface may be found, best first (Inter, then DejaVu Sans). Whoever may
/// read files takes the first pair that exists.
struct FontPaths {
  std::string_view regular;
  std::string_view semi_bold;
};
[[nodiscard]] std::span<const FontPaths> font_candidates() noexcept;

/// The contents of two font files (TrueType or OpenType). Empty: ImGui's built-in font.
struct FontFiles {
  std::vector<std::byte> regular;
  std::vector<std::byte> semi_bold;
};

/// How big things are.
struct Scale {
  double interface = 1.0;  ///< Window units per design unit: 2 on an X11 display at 200 %.
  double density = 1.0;    ///< Framebuffer pixels per window unit: 2 on a Wayland display at 200 %.

  [[nodiscard]] bool operator==(const Scale&) const = default;
};

/// Widths and foldings a person has chosen; the program keeps them from run to run.
struct PanelLayout {
  double panel_width = 320.0;  ///< Design units.
  bool paint_open = true;
  bool auto_depth_open = false;
  bool subdivide_open = true;
  bool steps_open = false;
  bool schemes_open = false;
  bool history_open = false;
  bool display_open = true;
  bool numbers_open = true;
  bool report_open = true;

  [[nodiscard]] bool operator==(const PanelLayout&) const = default;
};

/// The shape the cursor shall have.
enum class CursorShape : std::uint8_t { kArrow, kText, kResizeHorizontal };

/// Where a control was drawn, by the name of what it does. Tests press buttons by it.
struct ItemRect {
  std::string name;
  WindowRect rect;
};

/// What came of one frame.
struct GuiFrame {
  std::vector<Action> actions;   ///< In the order they were asked for: keys, then widgets.
  WindowRect viewport;           ///< The part of the window that the panels leave free.
  ViewportInput viewport_input;  ///< The mouse, as far as it is the viewport's.
  bool wants_text = false;       ///< A text field has the keyboard.
  CursorShape cursor = CursorShape::kArrow;
  bool needs_another_frame = false;  ///< The interface has not settled: draw again at once.
};

/// The whole user interface: one ImGui context with its fonts and style. Draws nothing itself; the
/// program renders `draw_data()` after each frame.
class Gui {
 public:
  Gui(FontFiles fonts, Scale scale);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;
  Gui(Gui&&) = delete;
  Gui& operator=(Gui&&) = delete;

  /// Rebuilds the fonts for another scale (the window moved to another monitor).
  void set_scale(Scale scale);

  /// Runs one frame: keys to actions, panels, routing of the mouse. `window` is the window's size;
  /// zero while it is minimised, which gives an empty frame.
  [[nodiscard]] GuiFrame frame(const Model& model, const InputFrame& input, WindowSize window);

  /// What to draw after `frame`: vertices in window units, `FramebufferScale` = density. Owned by
  /// the Gui, valid until the next frame.
  [[nodiscard]] ImDrawData& draw_data() const;

  /// The fonts' texture (RGBA or alpha). Upload it when `atlas_revision` changes, then SetTexID.
  [[nodiscard]] ImFontAtlas& atlas() const;
  [[nodiscard]] std::uint64_t atlas_revision() const noexcept;

  /// Text fields copy and paste through these.
  void set_clipboard(std::function<std::string()> read, std::function<void(std::string)> write);

  /// Draws the legend alone, lower left in an image of this size, for pictures made without a
  /// window.
  void frame_legend(const LegendCounts& counts, Theme theme, WindowSize image);

  /// Controls of the last frame.
  [[nodiscard]] std::span<const ItemRect> items() const;

  [[nodiscard]] PanelLayout layout() const;
  void set_layout(const PanelLayout& layout);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace limn::ui
