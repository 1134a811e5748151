#pragma once

#include <imgui.h>

#include <cstdint>
#include <optional>
#include <string>

#include "ui/panel_context.h"

/// The parts of the window, one file each. Those without a return value draw into a window of
/// their own at the place given.
namespace limn::ui {

/// Returns its height in window units.
float draw_menu_bar(PanelContext& context);
void draw_tool_strip(PanelContext& context, const WindowRect& place);
void draw_side_panel(PanelContext& context, const WindowRect& place);
void draw_status_line(PanelContext& context, const WindowRect& place, const ViewportInput& input);
/// Makes the status line's window without anything in it: before the dialogs', so that it lies
/// below them from the first frame on.
void reserve_status_line(PanelContext& context, const WindowRect& place);
/// `lit_axis`: the end of an axis under the cursor.
void draw_overlays(PanelContext& context, const WindowRect& viewport,
                   std::optional<ActionId> lit_axis);
/// Where the card with the first things to know goes, upper left in the viewport; nothing where the
/// model does not want it.
[[nodiscard]] std::optional<WindowRect> hint_card_place(const PanelContext& context,
                                                        const WindowRect& viewport);
/// Its button alone takes clicks: what lies beneath the rest can be painted.
void draw_hint_card(PanelContext& context, ImDrawList& list, const WindowRect& place);
/// Dialogs, help sheet and path prompt: whatever Model::modal holds.
void draw_modal(PanelContext& context, WindowSize window);
/// Enter of either block went down in this frame.
[[nodiscard]] bool is_enter_pressed();
/// Closes every menu and dialog ImGui has open.
void close_popups();

/// Sections of the side panel.
void draw_paint_section(PanelContext& context);
void draw_auto_depth_section(PanelContext& context);
void draw_subdivide_section(PanelContext& context);
void draw_steps_section(PanelContext& context);
void draw_schemes_section(PanelContext& context);
void draw_display_section(PanelContext& context);
void draw_numbers_section(PanelContext& context);
void draw_history_section(PanelContext& context);
void draw_report_section(PanelContext& context);

/// How many faces measure how much, and the curve that gives them their depths, whose points can be
/// dragged.
void draw_depth_curve(PanelContext& context, const ChooseByCurve& choice);

/// Errors against levels, one line a series, in a box of the width there is.
void draw_sphere_plot(PanelContext& context);

/// Contents of dialogs, within the modal window.
void draw_help_sheet(PanelContext& context);
void draw_path_prompt(PanelContext& context, const PathPrompt& prompt);

/// A bar with the stage, how far it is and Cancel below, in place of the buttons that started it.
/// `faces` to come, where known.
void draw_progress(PanelContext& context, const RunningRefinement& running,
                   std::optional<std::uint64_t> faces);

/// "4 faces to depth 3: +912 faces".
[[nodiscard]] std::string forecast_text(const PaintForecast& forecast);

/// What the mouse does now in the viewport: "Left drag: depth +1 · Shift: depth −1 · ...".
[[nodiscard]] std::string mouse_hint(const Model& model, const ViewportInput& input);

/// The legends: a swatch, a depth or band of sharpness, and a count per line. Sizes are in window
/// units.
struct LegendLook {
  const Fonts& fonts;
  const ThemeColours& colours;
  float unit;
};
/// Of depths, or under a title of levels.
[[nodiscard]] WindowSize legend_size(const LegendLook& look, Tint tint);
void draw_legend(ImDrawList& list, const LegendLook& look, const LegendCounts& counts,
                 ImVec2 origin);
/// Of distances: the colours from nothing to the greatest, in units of the mesh and as parts of its
/// diagonal.
[[nodiscard]] WindowSize distance_legend_size(const LegendLook& look);
void draw_distance_legend(ImDrawList& list, const LegendLook& look, const DistanceFigures& figures,
                          ImVec2 origin);
/// The same in two rows, for a viewport too small for a column.
[[nodiscard]] WindowSize compact_legend_size(const LegendLook& look);
void draw_compact_legend(ImDrawList& list, const LegendLook& look, const LegendCounts& counts,
                         ImVec2 origin);
[[nodiscard]] WindowSize crease_legend_size(const LegendLook& look);
void draw_crease_legend(ImDrawList& list, const LegendLook& look, const CreaseCounts& counts,
                        ImVec2 origin);
[[nodiscard]] WindowSize valence_legend_size(const LegendLook& look);
void draw_valence_legend(ImDrawList& list, const LegendLook& look, const ValenceCounts& counts,
                         ImVec2 origin);
/// Whether there is anything to explain.
[[nodiscard]] bool has_valences(const ValenceCounts& counts) noexcept;
[[nodiscard]] bool has_creases(const CreaseCounts& counts) noexcept;

}  // namespace limn::ui
