#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "limn/error.h"
#include "limn/mesh/build.h"
#include "limn/progress.h"

namespace limn::cli {

/// The exit code that tells scripts what kind of failure it was:
/// 1 failed, 2 usage, 3 bad input, 4 over budget, 130 cancelled.
[[nodiscard]] int exit_code(ErrorKind kind) noexcept;

/// Messages for people, on standard error. Standard output carries results alone.
void print_error(const Error& error);
void print_warning(std::string_view message);
void print_note(std::string_view message);

/// Warns of everything an import mended or left out.
void print_import_report(const ImportReport& report, const std::string& source);

/// Shows progress as one line on standard error where that is a terminal, and asks the algorithm to
/// stop once the user has pressed Ctrl+C. While an object lives, Ctrl+C no longer kills the
/// program.
class TerminalProgress final : public Progress {
 public:
  TerminalProgress();
  ~TerminalProgress() override;
  TerminalProgress(const TerminalProgress&) = delete;
  TerminalProgress& operator=(const TerminalProgress&) = delete;

  [[nodiscard]] bool report(double fraction, std::string_view stage) override;
  /// As print_note, in place of the line of progress.
  void note(std::string_view message);

 private:
  void clear_line();

  bool is_terminal_;
  bool has_drawn_ = false;
  std::chrono::steady_clock::time_point last_drawn_;
  void (*previous_handler_)(int);
};

}  // namespace limn::cli
