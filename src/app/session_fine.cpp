// Painting on faces of the refined mesh. A stroke changes the document when it ends: until then the
// refined mesh that it goes by stays in view, and what was touched is lit.
#include <new>
#include <utility>

#include <fmt/format.h>

#include "app/session.h"
#include "limn/document/commands.h"
#include "limn/painting/fine_mirror.h"
#include "limn/painting/fine_paint.h"
#include "ui/format.h"

namespace limn::app {

using enum ui::ActionId;
using Kind = ui::Toast::Kind;

bool Session::perform_fine(const ui::Action& action) {
  switch (action.id) {
    case kToggleFine: {
      const auto* value = std::get_if<bool>(&action.value);
      end_stroke();
      brush_.is_fine = value != nullptr ? *value : !brush_.is_fine;
      if (brush_.is_fine && display_.show == ui::ShowMode::kControl) {
        display_.show = ui::ShowMode::kRefined;
      }
      return true;
    }
    case kClearFine:
      clear_fine();
      return true;
    default:
      return false;
  }
}

void Session::clear_fine() {
  end_stroke();
  const std::size_t count = document_.demands.size();
  if (count == 0) {
    toast(Kind::kNote, "Nothing is painted finer than control faces.");
    return;
  }
  execute(paint_command({}, "clear fine painting", FineDemands().edits_from(document_.demands)));
  toast(Kind::kDone, fmt::format("Clear fine painting: {} gone. Control faces keep their depths.",
                                 ui::counted(count, "demand")));
}

bool Session::paints_fine() const noexcept {
  return brush_.is_fine && (ui::is_brush(brush_.tool) || ui::is_area(brush_.tool)) &&
         !document_.scheme && document_.settings.scheme == RefinementScheme::kCatmullClark &&
         shows_refined() && has_fine_faces(*refinement_.refined());
}

Painting Session::painting() const {
  return {*document_.control, document_.depths, document_.demands, document_.settings.non_quads};
}

void Session::begin_fine_stroke(DepthChange change, std::string name) {
  end_stroke();
  fine_stroke_.emplace(change, std::move(name));
}

bool Session::touch(const ShownFaces& shown) {
  return fine_stroke_ && fine_stroke_->touch(shown);
}

/// The names of faces and, where the brush mirrors, of their images. None where the faces are those
/// of another mesh than the document's.
std::vector<FineFace> Session::fine_faces(const ShownFaces& shown) {
  if (shown.refined != nullptr &&
      &shown.refined->control->topology() != &document_.control->topology()) {
    return {};
  }
  std::vector<FineFace> names = names_of(shown);
  return brush_.mirror.any()
             ? limn::with_images(*document_.control, aids_.mirror(document_.control, brush_.mirror),
                                 names)
             : names;
}

ShownFaces Session::with_images(const ShownFaces& shown) {
  if (!brush_.mirror.any() || shown.refined == nullptr) {
    return shown;
  }
  return {shown.refined, faces_named(*shown.refined, fine_faces(shown))};
}

void Session::end_fine_stroke() {
  const FineStroke stroke = *std::move(fine_stroke_);
  fine_stroke_.reset();
  if (stroke.touched().faces.empty()) {
    return;
  }
  try {
    FineEdits edits = plan_fine_edits(painting(), fine_faces(stroke.touched()), stroke.change());
    if (!edits.empty()) {
      history_.execute(document_,
                       paint_command(std::move(edits.depths),
                                     fmt::format("{} {} finer face{}", stroke.name(), edits.faces,
                                                 edits.faces == 1 ? "" : "s"),
                                     std::move(edits.demands)));
      learn(&ui::HintCard::has_painted);
    }
  } catch (const std::bad_alloc&) {
    toast(Kind::kProblem, "There is not enough memory for this stroke. Nothing was changed.");
  }
}

void Session::propose(const ShownFaces& shown, DepthChange change) {
  FineEdits edits = plan_fine_edits(painting(), fine_faces(shown), change);
  ui::PaintForecast proposal{edits.faces};
  proposal.depth = edits.depth;
  proposal.amount = change.amount;
  proposal_ = proposal;
  if (edits.empty()) {
    forecast_.forget();
    return;
  }
  forecast_.ask({document_.control, document_.depths, std::move(edits.depths), document_.settings,
                 shown_levels(), document_.demands, std::move(edits.demands)});
}

std::optional<ui::FineHover> Session::fine_hover() const {
  if (!hover_name_ || !paints_fine()) {
    return std::nullopt;
  }
  return ui::FineHover{hover_name_->level, depth_asked(painting(), *hover_name_)};
}

}  // namespace limn::app
