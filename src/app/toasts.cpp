#include "app/toasts.h"

#include <algorithm>
#include <utility>

namespace limn::app {
namespace {

constexpr std::size_t kMostShown = 4;
constexpr double kShortestSeconds = 3.0;
constexpr double kSecondsPerCharacter = 0.05;
constexpr double kExtraSecondsForProblems = 3.0;

double reading_time(const ui::Toast& toast) {
  return kShortestSeconds + kSecondsPerCharacter * static_cast<double>(toast.text.size()) +
         (toast.kind == ui::Toast::Kind::kProblem ? kExtraSecondsForProblems : 0.0);
}

}  // namespace

void Toasts::add(ui::Toast::Kind kind, std::string text, double now) {
  const auto erase_at = [this](std::size_t index) {
    shown_.erase(shown_.begin() + static_cast<std::ptrdiff_t>(index));
    ends_.erase(ends_.begin() + static_cast<std::ptrdiff_t>(index));
  };
  const auto same = std::find_if(shown_.begin(), shown_.end(),
                                 [&](const ui::Toast& toast) { return toast.text == text; });
  if (same != shown_.end()) {
    erase_at(static_cast<std::size_t>(same - shown_.begin()));
  } else if (shown_.size() == kMostShown) {
    erase_at(0);
  }
  shown_.push_back({kind, std::move(text)});
  ends_.push_back(now + reading_time(shown_.back()));
}

bool Toasts::expire(double now) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    if (ends_[i] > now) {
      if (kept != i) {
        shown_[kept] = std::move(shown_[i]);
        ends_[kept] = ends_[i];
      }
      ++kept;
    }
  }
  const bool any = kept != shown_.size();
  shown_.resize(kept);
  ends_.resize(kept);
  return any;
}

double Toasts::next_end() const noexcept {
  const auto first = std::min_element(ends_.begin(), ends_.end());
  return first == ends_.end() ? std::numeric_limits<double>::infinity() : *first;
}

}  // namespace limn::app
