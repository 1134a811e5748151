// The distance of the refined mesh from its limit surface: measured when a person asks, and
// whenever it colours the faces. The document does not change.
#include "app/session.h"

namespace limn::app {

using enum ui::ActionId;

bool Session::perform_measurement(const ui::Action& action) {
  if (action.id != kMeasureDistance) {
    return false;
  }
  if (auto question = distance_question()) {
    distance_.start(*std::move(question));
  } else {
    toast(
        ui::Toast::Kind::kNote,
        "Only the control mesh and what Catmull-Clark makes of it have a limit surface to measure "
        "from here.");
  }
  return true;
}

std::optional<DistanceJob::Question> Session::distance_question() const {
  SubdivisionSettings settings = document_.settings;
  if (!shows_refined()) {
    if (document_.scheme || settings.scheme != RefinementScheme::kCatmullClark) {
      return std::nullopt;
    }
    settings.points = SurfacePoints::kLevel;  // Its vertices are where they are.
    return DistanceJob::Question{document_.control, nullptr, nullptr, settings, 0};
  }
  const JobResult* refined = refinement_.refined();
  if (refined->refinement == nullptr || refined->mesh->face_control_faces.empty() ||
      !refined->labels->face_depths.empty()) {
    return std::nullopt;  // Made by another scheme.
  }
  settings.scheme = RefinementScheme::kCatmullClark;
  settings.corners = refined->mesh->corner_rule.value_or(settings.corners);
  return DistanceJob::Question{refined->control, refined->labels, refined->mesh, settings,
                               refined->prediction.levels};
}

ui::DistanceStatus Session::distance_status() const {
  const std::optional<DistanceJob::Question> question = distance_question();
  if (!question) {
    return {};
  }
  ui::DistanceStatus status = distance_.status(*question);
  status.can_measure = true;
  return status;
}

/// Measured are the faces that it colours, and what was chosen for a distance. While one paints
/// there is no end to it: a stroke's last refined mesh is measured.
void Session::follow_distance() {
  const bool is_wanted =
      display_.tint == ui::Tint::kDistance || (shows_chosen() && chosen_->outcome.expected_error);
  if (!is_wanted || is_stroking() || refinement_.is_busy() || auto_depth_.is_choosing()) {
    return;
  }
  auto question = distance_question();
  if (question && !distance_.has_been_asked(*question)) {
    distance_.start(*std::move(question));
  }
}

}  // namespace limn::app
