#pragma once

#include <cstdint>
#include <optional>

#include "limn/mesh/control_mesh.h"
#include "render/camera.h"

namespace limn::render {

/// A place on the screen and how far from it, in pixels, an edge may be.
struct EdgeAim {
  FramebufferPoint point;
  double reach = 12.0;
};

/// The edge of a control face that shows nearest to a place; nothing where all are out of reach.
/// Takes the face that is known to be there, so nothing but its own edges is looked at. Edges that
/// run before the near plane are left out.
[[nodiscard]] std::optional<std::uint32_t> nearest_edge(const ControlMesh& mesh,
                                                        const Camera& camera, std::uint32_t face,
                                                        const EdgeAim& aim);

}  // namespace limn::render
