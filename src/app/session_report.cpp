// From one mended element of the opened mesh to the next, and from one flaw of the mesh to the
// next.
#include <algorithm>
#include <array>

#include "app/flaws.h"
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
  flaw_focus_.reset();
  mend_focus_ = ui::MendFocus{kind, element, mend->elements[element].position};
  // Numbers of faces are those of the mesh as it was opened.
  camera_.glide_to(
      render::frame_points(camera_.goal(),
                           neighbourhood(*document_.opened, mend->elements[element]), aspect_),
      now_);
  return true;
}

bool Session::perform_flaw(const ui::Action& action) {
  if (action.id != kNextFlaw && action.id != kPreviousFlaw) {
    return false;
  }
  const int wanted = std::get<int>(action.value);
  if (wanted < 0 || wanted >= static_cast<int>(ui::kFlawKinds)) {
    return true;
  }
  const auto kind = static_cast<ui::FlawKind>(wanted);
  FlawSource source{*document_.control};
  if (const JobResult* refined = refinement_.refined();
      refined != nullptr && refined->refinement != nullptr) {
    source.refined = refined->mesh.get();
    source.cracks = &refined->refinement->cracks;
  }
  const bool is_forward = action.id == kNextFlaw;
  std::size_t element = 0;
  if (flaw_focus_ && flaw_focus_->kind == kind) {
    element = flaw_focus_->element + (is_forward ? 1 : flaw_focus_->count - 1);
  }
  const std::optional<FlawPlace> place = flaw_place(kind, element, source);
  if (!place) {
    flaw_focus_.reset();
    return true;
  }
  mend_focus_.reset();
  flaw_focus_ = ui::FlawFocus{kind, place->element, place->count, place->position};
  if (kind == ui::FlawKind::kCrack && display_.show == ui::ShowMode::kControl) {
    display_.show = ui::ShowMode::kRefined;
  }
  camera_.glide_to(render::frame_points(camera_.goal(), place->around, aspect_), now_);
  return true;
}

}  // namespace limn::app
