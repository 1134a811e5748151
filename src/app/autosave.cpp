// The owner decides when, with its own clock; the worker does in order what it is told. Copies that
// follow each other quickly take a tenth of the time at most.
#include "app/autosave.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <utility>

namespace limn::app {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kRestPerWork = 10.0;

bool is_same(const Revisions& a, const Revisions& b) {
  return a.control == b.control && a.depths == b.depths && a.stage == b.stage;
}

}  // namespace

Autosave::Autosave(std::filesystem::path common, std::function<void()> wake)
    : common_(std::move(common)),
      wake_(std::move(wake)),
      changed_at_(kNever),
      kept_at_(-kNever),
      store_(common_) {
  if (!common_.empty()) {
    worker_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
  }
}

Autosave::~Autosave() = default;

void Autosave::follow(const State& state, double now) {
  const bool is_refined = std::exchange(refinement_, state.refinement) != state.refinement;
  next_ = kNever;
  if (common_.empty()) {
    return;
  }
  if (!state.is_modified) {
    if (has_copies_) {
      clear();
    }
    changed_at_ = kNever;
    return;
  }
  if (is_same(state.document.revisions, kept_)) {
    changed_at_ = kNever;
    is_refined_ = false;
    return;
  }
  changed_at_ = std::min(changed_at_, now);
  is_refined_ |= is_refined;
  if (state.is_stroking || is_busy()) {
    return;  // What ends this calls again.
  }
  double due = changed_at_ + kSeconds;
  if (is_refined_) {
    const std::lock_guard lock(mutex_);
    due = std::min(due, kept_at_ + kRestPerWork * seconds_);
  }
  if (now < due) {
    next_ = due;
    return;
  }
  Copy copy{state.document, state.view};
  copy.document.import_report = {};  // No part of a project.
  submit(std::move(copy));
  kept_ = state.document.revisions;
  kept_at_ = now;
  changed_at_ = kNever;
  is_refined_ = false;
  has_copies_ = true;
}

void Autosave::clear() {
  kept_ = {};
  changed_at_ = kNever;
  is_refined_ = false;
  has_copies_ = false;
  submit(Clear{});
}

void Autosave::adopt(LostWork work) {
  has_copies_ = true;
  submit(std::move(work));
}

std::optional<Error> Autosave::take_error() {
  const std::lock_guard lock(mutex_);
  return std::exchange(error_, std::nullopt);
}

Autosave::Standing Autosave::standing() const {
  const std::lock_guard lock(mutex_);
  return {kept_copies_, has_copies_ ? problem_ : std::string(), !has_copies_};
}

bool Autosave::is_busy() const {
  const std::lock_guard lock(mutex_);
  return is_working_ || !tasks_.empty();
}

void Autosave::wait_until_idle() const {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !is_working_ && tasks_.empty(); });
}

void Autosave::submit(Task task) {
  if (common_.empty()) {
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    if (std::holds_alternative<Clear>(task)) {
      std::erase_if(tasks_, [](const Task& t) { return std::holds_alternative<Copy>(t); });
    }
    tasks_.push_back(std::move(task));
  }
  changed_.notify_all();
}

void Autosave::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  // What is waiting when the end comes is done first: it may be what makes the end a clean one.
  while (changed_.wait(lock, stop, [this] { return !tasks_.empty(); })) {
    Task task = std::move(tasks_.front());
    tasks_.pop_front();
    is_working_ = true;
    lock.unlock();
    carry_out(std::move(task));
    lock.lock();
    is_working_ = false;
    changed_.notify_all();
    lock.unlock();
    wake_();
    lock.lock();
  }
}

void Autosave::carry_out(Task task) {
  if (std::holds_alternative<Clear>(task)) {
    store_.clear();
    return;
  }
  if (auto* const adopted = std::get_if<LostWork>(&task)) {
    store_.adopt(std::move(*adopted));
    return;
  }
  const auto start = std::chrono::steady_clock::now();
  const Copy& copy = std::get<Copy>(task);
  Result<void> kept;
  try {
    kept = store_.keep(copy.document, copy.view);
  } catch (const std::bad_alloc&) {
    kept = fail(ErrorKind::kFailed, "There is not enough memory to keep a copy.");
  }
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  const std::lock_guard lock(mutex_);
  seconds_ = time.count();
  problem_ = kept ? std::string() : to_string(kept.error());
  if (!kept && !has_failed_) {
    error_ = std::move(kept.error());
  }
  has_failed_ = !kept;
  kept_copies_ += kept ? 1 : 0;
}

}  // namespace limn::app
