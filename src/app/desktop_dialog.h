#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <sys/types.h>

#include "ui/model.h"

namespace limn::app {

/// What a dialog for choosing a file is opened with.
struct DialogRequest {
  ui::PathPrompt::Purpose purpose = ui::PathPrompt::Purpose::kOpen;
  std::filesystem::path folder;
  std::string name;  ///< Suggested; empty to open.
};

/// The programs that show a desktop's own dialogs.
enum class DialogProgram { kZenity, kKdialog };

/// The one that fits this desktop, among those that are installed: kdialog first under KDE, zenity
/// first elsewhere. Nothing where there is none, or where the environment variable LIMN_DIALOGS is
/// "own".
[[nodiscard]] std::optional<DialogProgram> find_dialog_program();

/// The command line that asks for it; the first word is the program.
[[nodiscard]] std::vector<std::string> dialog_command(DialogProgram program,
                                                      const DialogRequest& request);

/// The desktop's own dialog for choosing a file, in a process of its own: the window goes on.
class DesktopDialog {
 public:
  /// `wake` is called from another thread when the dialog was answered.
  explicit DesktopDialog(std::function<void()> wake) : wake_(std::move(wake)) {}
  /// Closes what is open.
  ~DesktopDialog() { close(); }
  DesktopDialog(const DesktopDialog&) = delete;
  DesktopDialog& operator=(const DesktopDialog&) = delete;

  /// False where it cannot be started. What is open is closed first.
  [[nodiscard]] bool open(DialogProgram program, const DialogRequest& request);
  void close();

  struct Answer {
    ui::PathPrompt::Purpose purpose{};
    std::filesystem::path path;  ///< Empty: nothing was chosen.
  };
  /// Once for each dialog that was not closed by us.
  [[nodiscard]] std::optional<Answer> take_answer();

 private:
  std::function<void()> wake_;
  std::mutex mutex_;
  pid_t child_ = 0;  ///< 0 once it has ended.
  std::optional<Answer> answer_;
  std::jthread reader_;
};

}  // namespace limn::app
