// Legalisation, played move by move. It shows and changes nothing of the document.
#include "app/session.h"

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
    default:
      return false;
  }
  return true;
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
