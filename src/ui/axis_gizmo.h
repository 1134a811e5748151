#pragma once

#include <imgui.h>

#include <optional>

#include "ui/action.h"
#include "ui/panel_context.h"
#include "ui/window_geometry.h"

namespace limn::ui {

/// The axes in the lower right corner of the viewport: a click on an end looks from there.

/// The action of the end under the cursor; nothing beside them.
[[nodiscard]] std::optional<ActionId> axis_end_at(const PanelContext& context,
                                                  const WindowRect& viewport, WindowPoint place);

/// `lit` is the end under the cursor, if it would take a click.
void draw_axis_gizmo(PanelContext& context, ImDrawList& list, const WindowRect& viewport,
                     std::optional<ActionId> lit);

}  // namespace limn::ui
