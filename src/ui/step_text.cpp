// A candidate wins by the first of its keys in which it is alone; that one is told.

#include "ui/step_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ui/format.h"

namespace limn::ui {
namespace {

std::string decimal(float value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", static_cast<double>(value));
  std::string shown = text;
  if (shown.front() == '-') {
    shown.replace(0, 1, "−");
  }
  return shown;
}

std::string name(std::uint32_t vertex) {
  return "Vertex " + grouped(vertex);
}

std::string greedy_reason(const StepperStatus& steps) {
  const LegalisationCandidate& best = steps.candidates.front();
  const auto as_good = [&](auto&& is_equal) {
    return std::ranges::count_if(steps.candidates, is_equal) - 1;
  };
  std::string text = name(best.vertex) + " rises from 0 to 1 next. ";
  if (best.is_beside_leaf) {
    text += "Only neighbours of a vertex that has a single illegal neighbour are candidates now. ";
  }
  if (steps.candidates.size() == 1) {
    return text + "It is the only one.";
  }
  text += "Of " + grouped(steps.candidates.size()) + " candidates ";
  const std::string neighbours = counted(best.valence, "illegal neighbour");
  const auto same_valence =
      as_good([&](const LegalisationCandidate& c) { return c.valence == best.valence; });
  if (same_valence == 0) {
    return text + "it has the most illegal neighbours (" + grouped(best.valence) + ").";
  }
  const auto same = as_good([&](const LegalisationCandidate& c) {
    return c.valence == best.valence && c.cost == best.cost;
  });
  const std::string cost = counted(best.cost, "quad");
  if (same == 0) {
    return text + "no other has more than " + neighbours +
           ", and of those it would touch the fewest quads with three zeros (" +
           grouped(best.cost) + ").";
  }
  return text + "none is better (" + neighbours + ", " + cost +
         " with three zeros); of equals the lowest number is taken.";
}

std::string look_ahead_reason(const StepperStatus& steps) {
  const LegalisationCandidate& best = steps.candidates.front();
  std::string text = name(best.vertex) + " rises from 0 to 1 next. ";
  if (steps.candidates.size() == 1) {
    return text + "It is the only candidate.";
  }
  const auto same = std::ranges::count_if(
      steps.candidates, [&](const LegalisationCandidate& c) { return c.score == best.score; });
  text += "Its score of " + decimal(best.score) +
          (same > 1 ? " is not exceeded by any of " : " is the highest of ") +
          grouped(steps.candidates.size()) + " candidates: ";
  return text +
         "quads mended less quads made illegal and faces added, with a look at one further "
         "step.";
}

}  // namespace

std::string step_count_text(const StepperStatus& steps) {
  if (!steps.has_trace) {
    return "–";
  }
  if (steps.position == 0) {
    return steps.size == 0 ? "No step is needed" : "Before " + counted(steps.size, "step");
  }
  return "Step " + grouped(steps.position) + " of " + grouped(steps.size);
}

std::string step_reason(const StepperStatus& steps) {
  if (!steps.has_trace) {
    return steps.is_shown ? "There are no labels to follow: paint some faces first."
                          : "Show the steps to see, vertex by vertex, how illegal vertices are "
                            "removed, and why each is picked.";
  }
  if (steps.position == steps.size) {
    return steps.size == 0
               ? "Every face can be subdivided as it is painted: nothing is illegal."
               : "Nothing is illegal any more: " + counted(steps.raised, "vertex", "vertices") +
                     " raised from 0 to 1.";
  }
  if (!steps.falling.empty()) {
    std::string text;
    if (steps.falling.size() == 1) {
      text = name(steps.falling.front()) + " goes back to 0 next: all quads around it stay legal.";
    } else {
      text = "Vertices " + grouped(steps.falling.front()) + " and " +
             grouped(steps.falling.back()) +
             (steps.falling.size() > 2 ? " and " + grouped(steps.falling.size() - 2) + " more"
                                       : std::string()) +
             " go back to 0 together next: all quads around them stay legal.";
    }
    return text + " What proves needless is taken back.";
  }
  if (steps.candidates.empty()) {
    return {};
  }
  return steps.order == LegalisationMethod::kGreedy ? greedy_reason(steps)
                                                    : look_ahead_reason(steps);
}

std::string step_key(const StepperStatus& steps, const LegalisationCandidate& candidate) {
  return steps.order == LegalisationMethod::kGreedy
             ? grouped(candidate.valence) + " / " + grouped(candidate.cost)
             : decimal(candidate.score);
}

}  // namespace limn::ui
