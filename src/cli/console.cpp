#include "cli/console.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <memory>

#include <fmt/format.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

namespace limn::cli {
namespace {

volatile std::sig_atomic_t g_interrupted = 0;

void note_interrupt(int) {
  g_interrupted = 1;
}

spdlog::logger& console() {
  static const std::shared_ptr<spdlog::logger> shared = [] {
    auto logger = spdlog::stderr_color_st("limn");
    logger->set_pattern("limn: %^%l%$: %v");
    return logger;
  }();
  return *shared;
}

}  // namespace

int exit_code(ErrorKind kind) noexcept {
  switch (kind) {
    case ErrorKind::kUsage:
      return 2;
    case ErrorKind::kBadInput:
      return 3;
    case ErrorKind::kOverBudget:
      return 4;
    case ErrorKind::kCancelled:
      return 130;
    case ErrorKind::kFailed:
    case ErrorKind::kEnvironment:
      return 1;
  }
  return 1;
}

void print_error(const Error& error) {
  console().error("{}", to_string(error));
}

void print_warning(std::string_view message) {
  console().warn("{}", message);
}

void print_note(std::string_view message) {
  console().info("{}", message);
}

void print_import_report(const ImportReport& report, const std::string& source) {
  for (const std::string& sentence : report.sentences()) {
    print_warning(fmt::format("{}: {}", source, sentence));
  }
}

TerminalProgress::TerminalProgress() : is_terminal_(::isatty(STDERR_FILENO) != 0) {
  g_interrupted = 0;
  previous_handler_ = std::signal(SIGINT, note_interrupt);
}

TerminalProgress::~TerminalProgress() {
  if (previous_handler_ != SIG_ERR) {
    std::signal(SIGINT, previous_handler_);
  }
  clear_line();
}

void TerminalProgress::clear_line() {
  if (has_drawn_) {
    fmt::print(stderr, "\r\033[K");
    has_drawn_ = false;
  }
}

void TerminalProgress::note(std::string_view message) {
  clear_line();
  print_note(message);
}

bool TerminalProgress::report(double fraction, std::string_view stage) {
  using namespace std::chrono_literals;
  const auto now = std::chrono::steady_clock::now();
  if (is_terminal_ && (!has_drawn_ || now - last_drawn_ > 100ms)) {
    constexpr int kWidth = 30;
    const int filled = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * kWidth);
    fmt::print(stderr, "\r\033[K[{:=<{}}{: <{}}] {:3.0f} %  {}", "", filled, "", kWidth - filled,
               100.0 * fraction, stage);
    std::fflush(stderr);
    has_drawn_ = true;
    last_drawn_ = now;
  }
  return g_interrupted == 0;
}

}  // namespace limn::cli
