// Legalisation, played move by move. It shows and changes nothing of the document.
#include <vector>

#include <glm/geometric.hpp>

#include "app/session.h"
#include "render/navigation.h"

namespace limn::app {

using enum ui::ActionId;
using Kind = ui::Toast::Kind;

bool Session::perform_steps(const ui::Action& action) {
  switch (action.id) {
    case kToggleSteps: {
      const auto* value = std::get_if<bool>(&action.value);
      steps_.show(value != nullptr ? *value : !steps_.is_shown());
      break;
    }
    case kStepFirst:
      seek_step(0);
      break;
    case kStepLast:
      seek_step(steps_.size());
      break;
    case kStepNext:
      seek_step(steps_.position() + 1);
      break;
    case kStepPrevious:
      seek_step(steps_.position() - (steps_.position() > 0 ? 1 : 0));
      break;
    case kFrameStep:
      look_at_step();
      break;
    default:
      return false;
  }
  return true;
}

void Session::look_at_step() {
  const LegalisationStepper::Moment* moment = steps_.moment();
  if (moment == nullptr || (moment->candidates.empty() && moment->falling.empty())) {
    toast(Kind::kNote, "There is no step to look at.");
    return;
  }
  const std::uint32_t vertex =
      moment->candidates.empty() ? moment->falling.front() : moment->candidates.front().vertex;
  const ControlMesh& mesh = *document_.control;
  const FlatTopology& topology = mesh.topology();
  const std::span<const glm::dvec3> positions = mesh.positions();
  std::vector<glm::dvec3> around;
  glm::dvec3 outwards(0.0);
  for (std::uint32_t i = topology.vertex_offsets[vertex]; i < topology.vertex_offsets[vertex + 1];
       ++i) {
    const auto face = mesh.face(topology.corner_faces[topology.vertex_corners[i]]);
    for (std::size_t side = 0; side < face.size(); ++side) {
      const glm::dvec3 here = positions[face[side]] - positions[vertex];
      const glm::dvec3 next = positions[face[(side + 1) % face.size()]] - positions[vertex];
      outwards += glm::cross(here, next);
      // Twice as far, so that what is around is seen as well.
      around.push_back(positions[vertex] + 2.0 * here);
    }
  }
  camera_.glide_to(
      render::frame_points(render::turn_towards(camera_.goal(), outwards), around, aspect_), now_);
}

void Session::seek_step(std::size_t position) {
  if (!steps_.is_shown()) {
    steps_.show(true);  // The first press shows where it begins.
    return;
  }
  if (steps_.moment() != nullptr && position > steps_.size()) {
    toast(Kind::kNote, "That was the last step: nothing is illegal any more.");
  }
  steps_.seek(position);
}

void Session::follow_steps() {
  steps_.update(document_, refinement_.labels(), refinement_.labels_revision());
}

}  // namespace limn::app
