// Only the edges of the face under the cursor are looked at.
#include "app/edge_tools.h"

#include "app/session.h"
#include "app/viewport_frame.h"
#include "render/picking/edge_picking.h"

namespace limn::app::edge_tools {
namespace {

constexpr double kEdgeReach = 12.0;  // Window units.

}  // namespace

std::optional<std::uint32_t> edge_at(const ViewportFrame& frame, std::uint32_t face,
                                     render::FramebufferPoint at) {
  return render::nearest_edge(*frame.session.document().control, frame.camera(), face,
                              {at, kEdgeReach * frame.place.density()});
}

void press(const ViewportFrame& frame, render::FramebufferPoint at) {
  Session& session = frame.session;
  const auto face = frame.pick(at);
  const auto edge = face ? edge_at(frame, face->control_face, at) : std::nullopt;
  session.set_hover(face ? std::optional(face->control_face) : std::nullopt);
  session.set_hover_edge(edge);
  if (edge) {
    session.perform(session.brush().tool == ui::Tool::kSplitEdge ? ui::ActionId::kSplitEdge
                                                                 : ui::ActionId::kFlipEdge);
  }
}

}  // namespace limn::app::edge_tools
