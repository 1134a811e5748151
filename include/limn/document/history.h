#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <string>

#include "limn/document/command.h"

namespace limn {

/// Undo and redo, bounded by the bytes its commands keep alive; the oldest are forgotten first, and
/// where that is not enough, what lies farthest ahead in the redo list. The command that was last
/// applied or undone is kept whatever its size.
class History {
 public:
  explicit History(std::size_t byte_budget = std::size_t{256} << 20U) : byte_budget_(byte_budget) {}

  /// Applies the command and remembers it; what could be redone is forgotten. Where that throws
  /// (std::bad_alloc), document and history are as they were; the same for the others.
  void execute(Document& document, std::unique_ptr<Command> command);
  /// Remembers a command whose effect is already in the document (a stroke painted live).
  void record(std::unique_ptr<Command> command);

  [[nodiscard]] bool can_undo() const noexcept { return next_ > 0; }
  [[nodiscard]] bool can_redo() const noexcept { return next_ < commands_.size(); }
  /// Name of what undo or redo would do; empty where there is nothing.
  [[nodiscard]] std::string undo_name() const;
  [[nodiscard]] std::string redo_name() const;
  /// Does nothing where there is nothing to undo; the same for redo.
  void undo(Document& document);
  void redo(Document& document);

  /// The commands that are remembered, oldest first, and how many of them are applied.
  [[nodiscard]] std::size_t size() const noexcept { return commands_.size(); }
  [[nodiscard]] std::size_t position() const noexcept { return next_; }
  /// Name of command `i` < size().
  [[nodiscard]] std::string name(std::size_t i) const;
  /// Undoes or redoes until `position` (or the nearest one there is) is reached.
  void go_to(Document& document, std::size_t position);
  /// How many commands were applied when `mark_saved` was called; nothing once that is forgotten.
  [[nodiscard]] std::optional<std::size_t> saved_position() const noexcept;
  /// Whether commands were forgotten, so that the beginning cannot be reached any more.
  [[nodiscard]] bool has_forgotten() const noexcept { return has_forgotten_; }

  [[nodiscard]] std::size_t bytes() const noexcept { return bytes_; }
  /// Whether the document differs from when `mark_saved` was last called (or from its beginning).
  [[nodiscard]] bool is_modified() const noexcept;
  void mark_saved() noexcept;
  /// The document as it is differs from what is on disk, however much is undone.
  void mark_unsaved() noexcept;
  /// Forgets everything: a new document was opened. It counts as saved.
  void clear() noexcept;

 private:
  void settle(std::unique_ptr<Command> command) noexcept;
  void forget_redo() noexcept;
  void keep_within_budget(std::size_t kept) noexcept;

  std::deque<std::unique_ptr<Command>> commands_;
  std::size_t next_ = 0;   ///< commands_[0..next_) are applied.
  std::size_t bytes_ = 0;  ///< Sum of the commands' bytes, kept up to date.
  std::size_t byte_budget_;
  bool has_forgotten_ = false;
  std::ptrdiff_t saved_at_ = 0;  ///< Value of next_ at the saved state; -1 once that is forgotten.
};

}  // namespace limn
