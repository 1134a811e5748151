// The dialog writes the chosen path and a line end to its standard output and ends with 0, or ends
// with another number where nothing was chosen. A thread waits for that.
#include "app/desktop_dialog.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "limn/mesh/mesh_format.h"

extern char** environ;

namespace limn::app {
namespace {

namespace fs = std::filesystem;
using Purpose = ui::PathPrompt::Purpose;

bool is_installed(std::string_view program) {
  const char* path = std::getenv("PATH");
  std::string_view folders = path == nullptr ? std::string_view() : path;
  while (!folders.empty()) {
    const std::size_t end = folders.find(':');
    const fs::path file = fs::path(folders.substr(0, end)) / program;
    if (access(file.c_str(), X_OK) == 0) {
      return true;
    }
    folders.remove_prefix(end == std::string_view::npos ? folders.size() : end + 1);
  }
  return false;
}

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : value;
}

/// What the dialog is called, and the endings it shows, blanks between them.
struct Look {
  std::string title;
  std::string kind;
  std::string endings;
  bool saves = false;
};

Look look_of(Purpose purpose) {
  const std::string meshes = "*.obj *.ply *.off *.stl *.OBJ *.PLY *.OFF *.STL";
  switch (purpose) {
    case Purpose::kOpen:
      return {"Open", "Meshes and projects", meshes + " *.limn"};
    case Purpose::kReplaceMesh:
      return {"Replace the mesh under the painting", "Meshes", meshes};
    case Purpose::kSaveProject:
      return {"Save project", "Projects", "*.limn", true};
    case Purpose::kExportRefined:
      return {"Export mesh", "Meshes", meshes, true};
  }
  return {};
}

/// Reads to the end; what came, without the last line end.
std::string read_all(int file) {
  std::string text;
  std::array<char, 512> part{};
  for (ssize_t count = 1; count != 0;) {
    count = read(file, part.data(), part.size());
    if (count > 0) {
      text.append(part.data(), static_cast<std::size_t>(count));
    } else if (count < 0 && errno != EINTR) {
      break;
    }
  }
  if (text.ends_with('\n')) {
    text.pop_back();
  }
  return text;
}

/// Waits for its end, but leaves its number taken.
void wait_for_end(pid_t child) {
  siginfo_t info{};
  while (waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOWAIT) != 0 && errno == EINTR) {
  }
}

bool ended_well(pid_t child) {
  int status = 0;
  return waitpid(child, &status, WNOHANG) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

std::optional<DialogProgram> find_dialog_program() {
  if (environment("LIMN_DIALOGS") == "own") {
    return std::nullopt;
  }
  const bool has_zenity = is_installed("zenity");
  const bool has_kdialog = is_installed("kdialog");
  const bool is_kde = environment("XDG_CURRENT_DESKTOP").find("KDE") != std::string_view::npos;
  if (has_kdialog && (is_kde || !has_zenity)) {
    return DialogProgram::kKdialog;
  }
  return has_zenity ? std::optional(DialogProgram::kZenity) : std::nullopt;
}

std::vector<std::string> dialog_command(DialogProgram program, const DialogRequest& request) {
  const Look look = look_of(request.purpose);
  // A folder ends in a separator, or its name would be taken for a file's.
  const std::string start = (request.folder / request.name).string();
  if (program == DialogProgram::kKdialog) {
    return {"kdialog",  "--title",
            look.title, look.saves ? "--getsavefilename" : "--getopenfilename",
            start,      fmt::format("{} ({})", look.kind, look.endings)};
  }
  std::vector<std::string> command{"zenity",
                                   "--file-selection",
                                   "--title=" + look.title,
                                   "--filename=" + start,
                                   fmt::format("--file-filter={} | {}", look.kind, look.endings),
                                   "--file-filter=All files | *"};
  if (look.saves) {
    command.insert(command.end(), {"--save", "--confirm-overwrite"});
  }
  return command;
}

bool DesktopDialog::open(DialogProgram program, const DialogRequest& request) {
  close();
  std::array<int, 2> pipe_ends{};
  if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) {
    return false;
  }
  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  posix_spawn_file_actions_adddup2(&streams, pipe_ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&streams, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  std::vector<std::string> words = dialog_command(program, request);
  std::vector<char*> arguments;
  for (std::string& word : words) {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int error =
      posix_spawnp(&child, arguments.front(), &streams, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&streams);
  ::close(pipe_ends[1]);
  if (error != 0) {
    ::close(pipe_ends[0]);
    return false;
  }
  child_ = child;
  reader_ = std::jthread(
      [this, child, file = pipe_ends[0], purpose = request.purpose](const std::stop_token& stop) {
        std::string path = read_all(file);
        ::close(file);
        wait_for_end(child);
        {
          const std::lock_guard lock(mutex_);
          if (!ended_well(child)) {
            path.clear();
          }
          child_ = 0;  // From now on the number may be another's.
          answer_ = Answer{purpose, path};
        }
        if (!stop.stop_requested()) {
          wake_();
        }
      });
  return true;
}

void DesktopDialog::close() {
  if (reader_.joinable()) {
    reader_.request_stop();
    {
      const std::lock_guard lock(mutex_);
      if (child_ > 0) {
        kill(child_, SIGTERM);
      }
    }
    reader_.join();
  }
  answer_.reset();
}

std::optional<DesktopDialog::Answer> DesktopDialog::take_answer() {
  const std::lock_guard lock(mutex_);
  return std::exchange(answer_, std::nullopt);
}

}  // namespace limn::app
