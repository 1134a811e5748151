#pragma once

#include <string>
#include <variant>
#include <vector>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/painting/auto_depth/budget.h"
#include "limn/painting/auto_depth/depth_curve.h"
#include "limn/painting/auto_depth/face_measure.h"
#include "limn/painting/auto_depth/screen_size.h"
#include "limn/painting/auto_depth/tolerance.h"
#include "limn/painting/face_depths.h"
#include "limn/painting/paint_context.h"

namespace limn {

/// Names of cameras, for `ScreenViews`; none: the one in force.
using ViewNames = std::vector<std::string>;

/// Depths for a distance to the limit surface (`depths_for_tolerance`, or
/// `depths_for_measured_tolerance`).
struct ChooseByTolerance {
  enum class Unit {
    kDiagonals,  ///< Of the control mesh's bounds.
    kLength,     ///< Mesh units.
    kPixels,     ///< As seen by the views; what none of them sees gets 0.
  };
  double distance = 0.001;
  Unit unit = Unit::kDiagonals;
  ViewNames views;
  bool is_measured = false;  ///< Slower, and with fewer faces.

  [[nodiscard]] bool operator==(const ChooseByTolerance&) const = default;
};

/// Depths for a size on the screen (`depths_for_screen`).
struct ChooseByScreen {
  ScreenSize size;
  ViewNames views;

  [[nodiscard]] bool operator==(const ChooseByScreen&) const = default;
};

/// Depths that a curve gives for a measure.
struct ChooseByCurve {
  FaceMeasure measure = FaceMeasure::kCurvature;
  DepthCurve curve;
  ViewNames views;

  [[nodiscard]] bool operator==(const ChooseByCurve&) const = default;
};

/// How a depth comes about by itself. FaceBudget: `depths_for_budget`.
using DepthChoice = std::variant<ChooseByTolerance, FaceBudget, ChooseByScreen, ChooseByCurve>;

/// How chosen depths go together with those that are painted.
enum class DepthMerge {
  kSet,  ///< In place of them,
  kMax,  ///< where they are greater,
  kMin,  ///< where they are less,
  kAdd,  ///< or on top of them, up to kMaxDepth.
};

/// What `painted` becomes; faces that are not `chosen_faces` stay. `is_chosen_face` has one entry a
/// face or is empty for all.
[[nodiscard]] FaceDepths merged_depths(const FaceDepths& painted, const FaceDepths& chosen,
                                       DepthMerge merge, const std::vector<bool>& is_chosen_face);

/// Chooses depths and merges them. `expected_error` is that of the chosen depths; it is 0 for
/// choices that are no distances. A budget is held by the merged depths.
/// Errors: those of the choice; kUsage where there is no camera to see from.
[[nodiscard]] Result<ChosenDepths> choose_depths(const ControlMesh& mesh, const DepthChoice& choice,
                                                 DepthMerge merge, const PaintContext& context,
                                                 const FaceDepths& painted,
                                                 const std::vector<bool>& is_chosen_face);

/// The cameras of these names; the one in force where there are none. Errors: kUsage where nobody
/// has cameras, and those of reading their files.
[[nodiscard]] Result<std::vector<ScreenView>> find_views(const PaintContext& context,
                                                         const ViewNames& names);

}  // namespace limn
