#include "limn/document/history.h"

#include <utility>

namespace limn {

void History::execute(Document& document, std::unique_ptr<Command> command) {
  LIMN_EXPECTS(command != nullptr);
  commands_.push_back(nullptr);  // What may fail comes before the document changes.
  try {
    command->apply(document);
  } catch (...) {
    commands_.pop_back();
    throw;
  }
  settle(std::move(command));
}

void History::record(std::unique_ptr<Command> command) {
  LIMN_EXPECTS(command != nullptr);
  commands_.push_back(nullptr);
  settle(std::move(command));
}

/// Puts an applied command in the place that was made for it at the end.
void History::settle(std::unique_ptr<Command> command) noexcept {
  forget_redo();
  bytes_ += command->bytes();
  commands_.back() = std::move(command);
  next_ = commands_.size();
  keep_within_budget(next_ - 1);
}

std::string History::undo_name() const {
  return can_undo() ? commands_[next_ - 1]->name() : std::string{};
}

std::string History::redo_name() const {
  return can_redo() ? commands_[next_]->name() : std::string{};
}

void History::undo(Document& document) {
  if (!can_undo()) {
    return;
  }
  Command& command = *commands_[--next_];
  bytes_ -= command.bytes();
  command.revert(document);
  bytes_ += command.bytes();
  keep_within_budget(next_);
}

void History::redo(Document& document) {
  if (!can_redo()) {
    return;
  }
  Command& command = *commands_[next_++];
  bytes_ -= command.bytes();
  command.apply(document);
  bytes_ += command.bytes();
  keep_within_budget(next_ - 1);
}

std::string History::name(std::size_t i) const {
  LIMN_EXPECTS(i < commands_.size());
  return commands_[i]->name();
}

void History::go_to(Document& document, std::size_t position) {
  // Each step may forget commands at either end, and shift those that are left.
  const bool is_back = position < next_;
  std::size_t left = is_back ? next_ - position : position - next_;
  for (; left > 0 && (is_back ? can_undo() : can_redo()); --left) {
    is_back ? undo(document) : redo(document);
  }
}

std::optional<std::size_t> History::saved_position() const noexcept {
  return saved_at_ >= 0 ? std::optional(static_cast<std::size_t>(saved_at_)) : std::nullopt;
}

bool History::is_modified() const noexcept {
  return saved_at_ != static_cast<std::ptrdiff_t>(next_);
}

void History::mark_saved() noexcept {
  saved_at_ = static_cast<std::ptrdiff_t>(next_);
}

void History::mark_unsaved() noexcept {
  saved_at_ = -1;
}

void History::clear() noexcept {
  commands_.clear();
  next_ = 0;
  bytes_ = 0;
  saved_at_ = 0;
  has_forgotten_ = false;
}

void History::forget_redo() noexcept {
  while (commands_.size() > next_ + 1) {
    std::swap(commands_[commands_.size() - 2], commands_.back());  // The empty place stays last.
    bytes_ -= commands_.back()->bytes();
    commands_.pop_back();
  }
  if (saved_at_ > static_cast<std::ptrdiff_t>(next_)) {
    saved_at_ = -1;  // The saved state lay on the branch that is cut off.
  }
}

/// Drops commands until the budget is met or only commands_[kept] is left. Those before it are all
/// applied and those behind it all undone, so both ends may be dropped without breaking the chain.
void History::keep_within_budget(std::size_t kept) noexcept {
  while (bytes_ > byte_budget_ && kept > 0) {
    bytes_ -= commands_.front()->bytes();
    commands_.pop_front();
    has_forgotten_ = true;
    --kept;
    --next_;
    if (saved_at_ >= 0) {
      --saved_at_;  // Falls to -1 where the saved state was the one before the dropped command.
    }
  }
  while (bytes_ > byte_budget_ && commands_.size() > kept + 1) {
    bytes_ -= commands_.back()->bytes();
    commands_.pop_back();
    if (saved_at_ > static_cast<std::ptrdiff_t>(commands_.size())) {
      saved_at_ = -1;
    }
  }
}

}  // namespace limn
