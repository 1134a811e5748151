#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "limn/error.h"
#include "limn/painting/auto_depth/screen_view.h"
#include "limn/progress.h"
#include "limn/subdivision/settings.h"

namespace limn {

class FineDemands;

/// Answers `SelectVisible`: the control faces that show, ascending. Supplied by whoever can draw.
using VisibleFaces = std::function<Result<std::vector<std::uint32_t>>()>;

/// What rules may ask for besides the mesh and its painting.
struct PaintContext {
  SubdivisionSettings settings;          ///< How the painting will be refined.
  VisibleFaces visible;                  ///< May be empty: then nobody can say what is visible,
  ScreenViews views;                     ///< and there are no cameras.
  const FineDemands* demands = nullptr;  ///< What is painted on finer faces, which a budget counts.
  Progress* progress = nullptr;          ///< May be null: nobody watches.
};

}  // namespace limn
