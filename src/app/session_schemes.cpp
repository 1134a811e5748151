// Uniform schemes and the edges of triangle meshes: each action that changes the document makes one
// command. The second half of the viewport and the comparison with spheres change nothing.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "app/session.h"
#include "limn/document/commands.h"
#include "render/navigation.h"
#include "ui/format.h"
#include "ui/scheme_text.h"

namespace limn::app {

using enum ui::ActionId;
using Kind = ui::Toast::Kind;

namespace {

/// Five steps, as the exercise asks for, but not more faces than a picture needs.
constexpr int kSphereLevels = 5;
constexpr std::uint64_t kMostSphereFaces = 2'000'000;

/// What the painting is subdivided by, everywhere.
SchemeSettings painted_scheme(const Document& document) {
  SchemeSettings scheme;
  scheme.scheme =
      document.settings.scheme == RefinementScheme::kLoop ? Scheme::kLoop : Scheme::kCatmullClark;
  scheme.weights = document.settings.weights;
  return scheme;
}

}  // namespace

bool Session::perform_scheme(const ui::Action& action) {
  const int level = document_.stage.levels;
  switch (action.id) {
    case kSetScheme: {
      const auto& word = std::get<std::string>(action.value);
      const std::optional<SchemeSettings> scheme = ui::scheme_from_word(word);
      if (scheme || word.empty()) {
        refinement_.restart();
        show_scheme(scheme);
      } else {
        toast(Kind::kProblem, fmt::format("There is no scheme \"{}\".", word));
      }
      return true;
    }
    case kSetSchemeLevel:
      step_to(std::get<int>(action.value));
      return true;
    case kSchemeForward:
      step_to(level + 1);
      return true;
    case kSchemeBack:
      step_to(level - 1);
      return true;
    case kSetSecondScheme:
      show_second(ui::scheme_from_word(std::get<std::string>(action.value)), false);
      return true;
    case kCompareUniform: {
      const bool is_shown = is_split() && display_.is_second_uniform;
      const auto* wanted = std::get_if<bool>(&action.value);
      if (wanted != nullptr ? *wanted : !is_shown) {
        show_second(painted_scheme(document_), true);
      } else if (is_shown) {
        show_second(std::nullopt, false);
      }
      return true;
    }
    case kCompareSphere:
      compare_with_sphere();
      return true;
    default:
      return false;
  }
}

bool Session::perform_scheme_choice(const ui::Action& action) {
  SchemeSettings scheme = document_.scheme.value_or(SchemeSettings{});
  switch (action.id) {
    case kLoopOriginal:
      scheme.weights = LoopWeights::kOriginal;
      break;
    case kLoopWarren:
      scheme.weights = LoopWeights::kWarren;
      break;
    case kLinearSplits:
      scheme.averages = false;
      break;
    case kLinearAverages:
      scheme.averages = true;
      break;
    case kMakeFit:
      if (scheme_facts_.misfit() && scheme_facts_.misfit()->fitting) {
        const std::size_t finer = document_.demands.size();
        execute(fit_command(document_, *scheme_facts_.misfit()->fitting));
        if (finer > 0) {
          toast(Kind::kNote, fmt::format("{} on finer faces gone.", ui::counted(finer, "demand")));
        }
      } else {
        toast(Kind::kNote, "The faces are of the kind that the scheme takes.");
      }
      return true;
    default:
      return false;
  }
  if (document_.scheme) {
    change_scheme(scheme);
  }
  return true;
}

void Session::show_second(std::optional<SchemeSettings> scheme, bool is_uniform) {
  const bool was_split = is_split();
  display_.second = scheme;
  display_.is_second_uniform = is_uniform;
  if (is_split()) {
    second_.restart();
  } else {
    second_.cancel();
  }
  if (is_split() && !was_split) {
    // Half as wide: what was in view would be cut off.
    camera_.glide_to(
        render::frame_points(camera_.goal(), document_.control->positions(), aspect_ / 2.0), now_);
  }
}

void Session::show_scheme(std::optional<SchemeSettings> scheme) {
  end_stroke();
  const int before = document_.stage.levels;
  Stage stage = document_.stage;
  if (!scheme) {
    stage.levels = before > 0 ? kAllLevels : 0;
  } else {
    stage.levels = before == kAllLevels ? deepest_painting(document_) : before;
    stage.levels = std::min(stage.levels, kMostSchemeLevels);
    if (!check_fits(*document_.control, scheme->scheme)) {
      stage.levels = 0;
    }
  }
  if (stage.levels > 0 && display_.show == ui::ShowMode::kControl) {
    display_.show = ui::ShowMode::kRefined;
  }
  if (scheme != document_.scheme || stage != document_.stage) {
    execute(scheme_command(scheme, stage,
                           scheme ? fmt::format("show {}", scheme_info(scheme->scheme).title)
                                  : std::string("show what is painted")));
  }
}

void Session::change_scheme(const SchemeSettings& scheme) {
  if (scheme != *document_.scheme) {
    execute(
        scheme_command(scheme, document_.stage, fmt::format("show {}", ui::scheme_title(scheme))));
  }
}

void Session::step_to(int level) {
  if (!document_.scheme) {
    toast(Kind::kNote, "Choose a scheme first: its levels are what one steps through.");
  } else if (scheme_facts_.misfit()) {
    toast(Kind::kNote, scheme_facts_.misfit()->reason);
  } else if (level < 0) {
    toast(Kind::kNote, "This is the control mesh: there is no level before it.");
  } else if (level > kMostSchemeLevels) {
    toast(Kind::kNote, fmt::format("{} levels are the most.", kMostSchemeLevels));
  } else {
    refinement_.restart();
    const bool is_back = level < document_.stage.levels;
    set_stage({document_.stage.is_legalised, level},
              fmt::format("{} to level {}", is_back ? "back" : "forward", level));
  }
}

void Session::step_back_to_shown() {
  if (!document_.scheme) {
    return;  // The painting asks for more than is shown, and goes on being painted.
  }
  const JobResult* const shown = refinement_.refined();
  const bool is_same = shown != nullptr && shown->scheme == shown_scheme(document_);
  const int level = is_same ? shown->prediction.levels : 0;
  if (level != document_.stage.levels) {
    set_stage({document_.stage.is_legalised, level}, fmt::format("back to level {}", level));
  }
}

bool Session::perform_edge(const ui::Action& action) {
  if (action.id != kSplitEdge && action.id != kFlipEdge) {
    return false;
  }
  if (!hover_edge_) {
    toast(Kind::kNote, "Take up a tool for edges and point at one.");
  } else if (action.id == kSplitEdge) {
    edit_edge(split_edge_command(document_, *hover_edge_));
  } else {
    edit_edge(flip_edge_command(document_, *hover_edge_));
  }
  return true;
}

void Session::edit_edge(Result<std::unique_ptr<Command>> edit) {
  if (edit) {
    execute(*std::move(edit));
  } else {
    toast(Kind::kProblem, std::move(edit.error().message));
  }
}

SphereJob::Question Session::sphere_question() const {
  SphereJob::Question question{document_.control, {}, 0};
  if (std::optional<SchemeSettings> scheme = shown_scheme(document_)) {
    if (scheme->scheme == Scheme::kLoop) {
      scheme->weights = LoopWeights::kOriginal;
      question.schemes.push_back(*scheme);
      scheme->weights = LoopWeights::kWarren;
    }
    question.schemes.push_back(*scheme);
  }
  const std::vector<SchemeCounts>& counts = scheme_facts_.counts();
  while (question.levels < kSphereLevels &&
         static_cast<std::size_t>(question.levels) + 1 < counts.size() &&
         counts[static_cast<std::size_t>(question.levels) + 1].faces <= kMostSphereFaces) {
    ++question.levels;
  }
  return question;
}

void Session::compare_with_sphere() {
  if (!document_.scheme || scheme_facts_.misfit()) {
    toast(Kind::kNote, "Choose a scheme that takes this mesh first.");
  } else {
    sphere_.start(sphere_question());
  }
}

int Session::second_levels() const noexcept {
  const int levels = shown_levels();
  if (levels != kAllLevels) {
    return levels;
  }
  // A first step that splits every face makes what is painted a level deeper.
  const DerivedLabels* labels = refinement_.labels();
  return display_.is_second_uniform && labels != nullptr ? labels->prediction.levels
                                                         : deepest_painting(document_);
}

void Session::follow_second() {
  if (!display_.second) {
    return;
  }
  LiveRefinement::Wish wish{is_stroking()};
  SchemeSettings scheme = *display_.second;
  scheme.corners = document_.settings.corners;
  wish.other = {scheme, second_facts_.misfit() ? 0 : std::min(second_levels(), kMostSchemeLevels)};
  second_.follow(document_, wish);
}

bool Session::shows_second_refined() const noexcept {
  return display_.second && second_levels() > 0 && display_.show != ui::ShowMode::kControl &&
         second_.refined() != nullptr;
}

void Session::update_facts() {
  if (display_.second && display_.is_second_uniform) {
    display_.second = painted_scheme(document_);  // That may have been changed.
  }
  facts_.update(document_.control, dihedral_threshold_);
  scheme_facts_.update(document_.control, document_.scheme);
  second_facts_.update(document_.control, display_.second);
  const bool is_other_surface =
      known_control_ == nullptr || &known_control_->topology() != &document_.control->topology();
  known_control_ = document_.control;
  lone_faces_ = aids_.mirror(document_.control, brush_.mirror).lone_faces();
  if (is_other_surface) {
    withdraw_proposal();
    hover_.reset();
    hover_edge_.reset();
    flaw_focus_.reset();
    refinement_.follow(document_, wish());
  }
  // Nothing refined from another mesh may be shown from now on, in the second half neither: it may
  // have been closed when the mesh changed.
  follow_second();
  follow_steps();
  if (display_.tint == ui::Tint::kLevel) {
    levels_.update(document_.control, shows_refined() ? refinement_.refined()->mesh : nullptr);
  }
  follow_distance();
  if (display_.valences) {
    valences_.update(document_.control, shows_refined() ? refinement_.refined()->mesh : nullptr);
    if (display_.second) {
      second_valences_.update(document_.control,
                              shows_second_refined() ? second_.refined()->mesh : nullptr);
    }
  }
}

ui::SchemeStatus Session::scheme_status() const {
  ui::SchemeStatus status;
  status.misfit = scheme_facts_.misfit();
  status.counts = scheme_facts_.counts();
  if (const JobResult* refined = refinement_.refined();
      refined != nullptr && refined->scheme == shown_scheme(document_)) {
    status.steps = refined->steps;
  }
  return status;
}

ui::SecondStatus Session::second_status() const {
  ui::SecondStatus status;
  status.misfit = second_facts_.misfit();
  if (shows_second_refined()) {
    status.faces = second_.refined()->mesh->face_count();
    status.levels = second_.refined()->prediction.levels;
  } else {
    status.faces = document_.control->face_count();
  }
  status.is_over_budget = second_.question().has_value();
  return status;
}

}  // namespace limn::app
