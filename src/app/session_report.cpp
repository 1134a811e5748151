// From one mended element of the opened mesh to the next.
#include <algorithm>
#include <array>

#include "app/session.h"
#include "render/navigation.h"

namespace limn::app {

using enum ui::ActionId;

namespace {

/// So much of the mesh's diagonal is seen to either side of an element.
constexpr double kSurroundings = 0.03;

/// The corners of a box around the element, and of its face where it has one.
std::vector<glm::dvec3> neighbourhood(const ControlMesh& mesh, const MendedElement& element) {
  const double reach = kSurroundings * mesh.bounds().diagonal();
  std::vector<glm::dvec3> points;
  for (const double sign : {-1.0, 1.0}) {
    points.push_back(element.position + sign * glm::dvec3(reach));
  }
  if (element.face != kNone) {
    for (const std::uint32_t v : mesh.face(element.face)) {
      points.push_back(mesh.positions()[v]);
    }
  }
  return points;
}

}  // namespace

bool Session::perform_report(const ui::Action& action) {
  if (action.id != kNextMend && action.id != kPreviousMend) {
    return false;
  }
  const auto kind = static_cast<MendKind>(std::get<int>(action.value));
  const std::vector<Mend>& mends = document_.import_report.mends;
  const auto mend = std::ranges::find(mends, kind, &Mend::kind);
  if (mend == mends.end() || mend->elements.empty()) {
    return true;
  }
  const std::size_t count = mend->elements.size();
  const bool is_forward = action.id == kNextMend;
  std::size_t element = is_forward ? 0 : count - 1;
  if (mend_focus_ && mend_focus_->kind == kind) {
    element = (mend_focus_->element + (is_forward ? 1 : count - 1)) % count;
  }
  mend_focus_ = ui::MendFocus{kind, element, mend->elements[element].position};
  // Numbers of faces are those of the mesh as it was opened.
  camera_.glide_to(
      render::frame_points(camera_.goal(),
                           neighbourhood(*document_.opened, mend->elements[element]), aspect_),
      now_);
  return true;
}

}  // namespace limn::app
