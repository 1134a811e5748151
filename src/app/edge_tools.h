#pragma once

#include <cstdint>
#include <optional>

#include "render/coordinates.h"

namespace limn::app {

struct ViewportFrame;

/// The tools that split and flip an edge: the one nearest to the cursor when the button goes down.
namespace edge_tools {

void press(const ViewportFrame& frame, render::FramebufferPoint at);
/// The edge to take at a place that shows this control face.
[[nodiscard]] std::optional<std::uint32_t> edge_at(const ViewportFrame& frame, std::uint32_t face,
                                                   render::FramebufferPoint at);

}  // namespace edge_tools
}  // namespace limn::app
