// Unsaved work: what this run keeps of its own, and what killed runs have left.
#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <utility>

#include <fmt/format.h>

#include "app/session.h"

namespace limn::app {

using enum ui::ActionId;
using Kind = ui::Toast::Kind;

namespace {

std::string time_text(std::filesystem::file_time_type time) {
  const auto seconds = std::chrono::system_clock::to_time_t(
      std::chrono::time_point_cast<std::chrono::system_clock::duration>(
          std::chrono::file_clock::to_sys(time)));
  std::tm local{};
  ::localtime_r(&seconds, &local);
  std::array<char, 64> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), "%e %B, %H:%M", &local);
  return {text.data(), length};
}

std::string name_of(const LostWork& work) {
  const std::string name =
      work.project_path.empty() ? work.name : work.project_path.filename().string();
  return name.empty() ? "unsaved work" : name;
}

}  // namespace

bool Session::follow_autosave() {
  autosave_.follow({document_, camera_.goal(), history_.is_modified() && !wants_to_quit_,
                    is_stroking(), refinement_.refined_revision()},
                   now_);
  bool has_news = false;
  if (const auto error = autosave_.take_error()) {
    toast(Kind::kProblem, "No copy of unsaved work can be kept. " + to_string(*error));
    has_news = true;
  }
  has_news |= follow_copies();
  if (!lost_.empty() && std::holds_alternative<std::monostate>(modal_)) {
    ask_about_lost_work();
    has_news = true;
  }
  return has_news;
}

bool Session::follow_copies() {
  if (!host_.wall_clock) {
    return false;
  }
  Autosave::Standing standing = autosave_.standing();
  ui::CopyStatus now = copies_;
  if (standing.is_clear) {
    now.when.clear();
  } else if (standing.kept != known_copies_) {
    now.when = host_.wall_clock();
  }
  known_copies_ = standing.kept;
  now.problem = std::move(standing.problem);
  const bool is_new = now != copies_;
  copies_ = std::move(now);
  return is_new;
}

void Session::offer(std::vector<LostWork> lost) {
  lost_ = std::move(lost);
  std::ranges::reverse(lost_);  // The newest is asked about first.
}

void Session::ask_about_lost_work() {
  const LostWork& work = lost_.back();
  modal_ = ui::RecoveryQuestion{name_of(work), work.project_path.string(),
                                time_text(work.written_at), lost_.size() - 1};
}

bool Session::perform_recovery(const ui::Action& action) {
  if (action.id != kRecover && action.id != kDiscardLost) {
    return false;
  }
  if (!std::holds_alternative<ui::RecoveryQuestion>(modal_) || lost_.empty()) {
    return true;
  }
  modal_ = std::monostate{};
  if (action.id == kRecover) {
    recover();
  } else {
    discard_lost_work(std::move(lost_.back()));
    lost_.pop_back();
  }
  return true;
}

void Session::recover() {
  LostWork work = std::move(lost_.back());
  lost_.clear();  // One document at a time: the others wait for the next start.
  auto project = load_lost_work(work);
  if (!project) {
    show_error("Cannot recover " + name_of(work), std::move(project.error()));
    return;
  }
  const std::string name = name_of(work);
  show(std::move(*project));
  history_.mark_unsaved();
  autosave_.adopt(std::move(work));
  toast(Kind::kDone, fmt::format("Recovered {}. Save it to keep it.", name));
}

}  // namespace limn::app
