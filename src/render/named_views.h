#pragma once

#include <span>
#include <string_view>

#include <glm/vec3.hpp>

#include "limn/document/view_state.h"
#include "limn/error.h"
#include "limn/mesh/control_mesh.h"

namespace limn::render {

/// The directions to look from that have a name. "Front" looks along -Z, "right" stands at +X and
/// "top" at +Y.
enum class NamedView { kThreeQuarter, kFront, kBack, kLeft, kRight, kTop, kBottom, kIso };

/// Every named view, in the order menus show them.
[[nodiscard]] std::span<const NamedView> all_named_views();

/// Its name on the command line: "front", "three-quarter", ...
[[nodiscard]] std::string_view view_name(NamedView view);

/// The view of this name. Errors: kUsage for an unknown one, listing those there are.
[[nodiscard]] Result<NamedView> parse_view_name(std::string_view name);

/// `view` turned to look from there, with target, distance and projection kept.
[[nodiscard]] ViewState turn_to(const ViewState& view, NamedView direction);

/// From there, with all of the scene in the image. `aspect` is width over height.
[[nodiscard]] ViewState named_view(NamedView direction, const Bounds& scene, double aspect);

/// The same with the vertices of a mesh, which lets the image be filled better than its box does.
[[nodiscard]] ViewState named_view(NamedView direction, std::span<const glm::dvec3> points,
                                   double aspect);

/// What a mesh is first seen from: the three-quarter view, somewhat from above.
[[nodiscard]] ViewState default_view(const Bounds& scene, double aspect);
[[nodiscard]] ViewState default_view(std::span<const glm::dvec3> points, double aspect);

}  // namespace limn::render
