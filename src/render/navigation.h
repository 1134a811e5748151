#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "limn/document/view_state.h"
#include "limn/mesh/control_mesh.h"
#include "render/coordinates.h"

/// How the viewer moves: pure functions from a view to the next one. To switch between perspective
/// and orthographic flip `ViewState::orthographic`; what lies at the target keeps its size.
namespace limn::render {

/// Turns about the target. `dx`, `dy` are the mouse's way as parts of the viewport's height, right
/// and down positive: a drag over the whole height is half a turn, and the surface follows the
/// mouse. Pitch stops at straight up and down; yaw stays within -180..180.
[[nodiscard]] ViewState orbit(const ViewState& view, double dx, double dy);

/// The same about any point, which stays where it shows: the eye goes round it as if it were the
/// target. Distance and kind of projection stay.
[[nodiscard]] ViewState orbit_about(const ViewState& view, double dx, double dy,
                                    const glm::dvec3& pivot);

/// `view` turned so that the eye stands in this direction from the target; as it is where the
/// direction is none.
[[nodiscard]] ViewState turn_towards(const ViewState& view, const glm::dvec3& direction);

/// What a pan needs to know of the drag.
struct PanDrag {
  FramebufferPoint from;
  FramebufferPoint to;
  /// View depth of what was grabbed (Camera::target_depth where nothing was); it keeps to the mouse
  /// exactly.
  double view_depth = 1.0;
};

/// Shifts target and eye alike so that the point grabbed at `from` shows at `to`.
[[nodiscard]] ViewState pan(const ViewState& view, FramebufferSize size, const PanDrag& drag);

/// Multiplies the distance to `anchor` by `factor` (> 0; below 1 comes closer); the anchor stays
/// where it shows. The distance to the target stays within what makes sense for the scene, from
/// 1e-4 to 100 times its diagonal.
[[nodiscard]] ViewState dolly(const ViewState& view, double factor, const glm::dvec3& anchor,
                              const Bounds& scene);

/// The same towards the view's own target.
[[nodiscard]] ViewState dolly(const ViewState& view, double factor, const Bounds& scene);

/// Puts the target at the middle of `points` and comes as close as shows them all with a small
/// margin, in the direction the view has. `aspect` is width over height. No points, or only one
/// place: the distance stays.
[[nodiscard]] ViewState frame_points(const ViewState& view, std::span<const glm::dvec3> points,
                                     double aspect);

/// The same for a box.
[[nodiscard]] ViewState frame_bounds(const ViewState& view, const Bounds& bounds, double aspect);

/// The view at `t` (0..1, clamped) on the way from one to the other, starting and ending gently.
/// Turns the shorter way round; the distance changes by equal factors in equal times; the kind of
/// projection is that of `to` as soon as t > 0. Exactly `from` at 0 and `to` at 1.
[[nodiscard]] ViewState ease_view(const ViewState& from, const ViewState& to, double t);

}  // namespace limn::render
