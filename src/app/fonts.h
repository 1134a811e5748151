#pragma once

#include "ui/gui.h"

namespace limn::app {

/// The first typeface of ui::font_candidates() that this machine has; empty where it has none.
[[nodiscard]] ui::FontFiles load_fonts();

}  // namespace limn::app
