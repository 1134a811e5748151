#include "app/run_window.h"

#include <memory>
#include <sstream>
#include <string>
#include <utility>

#include <spdlog/spdlog.h>

#include "app/application.h"
#include "app/preferences.h"
#include "app/recording/recorder.h"
#include "app/recovery_store.h"
#include "app/user_folders.h"
#include "limn/mesh/bundled.h"
#include "render/environment_error.h"

namespace limn::app {

namespace {

Preferences for_classroom(Preferences preferences) {
  preferences.keymap = ui::KeymapId::kClassroom;
  preferences.layout.paint_open = false;
  preferences.layout.subdivide_open = false;
  preferences.layout.schemes_open = true;
  return preferences;
}

std::string input_of(const WindowOptions& options) {
  return options.input.empty() ? std::string(kDefaultMesh) : options.input;
}

/// How a run comes by its document.
struct Beginning {
  Project project;
  std::string input;                 ///< What was opened; or
  std::string text;                  ///< the text of the project that was there already.
  std::filesystem::path bad_file{};  ///< To be tried again in the window, which then says why not;
  Error problem{};                   ///< what was wrong with it.
};

Result<void> run(Beginning beginning, const WindowOptions& options, Recorder* recorder) {
  const std::filesystem::path kept = preferences_path();
  const auto loaded = load_preferences(kept);
  const Preferences preferences = loaded.value_or(Preferences{});

  Application application(options.is_classroom ? for_classroom(preferences) : preferences,
                          std::move(beginning.project), recorder);
  application.set_status_file(options.status_file);
  if (recorder != nullptr) {
    application.begin_recording(std::move(beginning.input), std::move(beginning.text));
  } else {
    // What earlier runs have left is not this recording's; the next run asks.
    application.offer(find_lost_work(recovery_folder()));
    if (!loaded) {
      application.toast(ui::Toast::Kind::kProblem, to_string(loaded.error()));
    }
  }
  if (!beginning.bad_file.empty()) {
    spdlog::error("{}", to_string(beginning.problem));
    application.drop(std::move(beginning.bad_file));
  }
  application.run();

  Preferences now = application.preferences();
  if (options.is_classroom) {
    now.keymap = preferences.keymap;
    now.layout = preferences.layout;
  }
  if (!kept.empty()) {
    if (const auto saved = save_preferences(kept, now); !saved) {
      spdlog::warn("{}", to_string(saved.error()));
    }
  }
  return {};
}

/// Null where nothing is to be recorded.
Result<std::unique_ptr<Recorder>> recorder_for(const WindowOptions& options) {
  return options.record.empty() ? nullptr : Recorder::create(options.record);
}

}  // namespace

Result<void> run_window(const WindowOptions& options) {
  auto recorder = recorder_for(options);
  if (!recorder) {
    return tl::unexpected(std::move(recorder.error()));
  }
  FileAccess& files = *recorder != nullptr ? static_cast<FileAccess&>(**recorder) : disk();
  // Read first: a bad file is told on the terminal it was named on.
  auto project = files.open(input_of(options));
  if (project) {
    return run({*std::move(project), input_of(options), {}}, options, recorder->get());
  }
  const Error error = std::move(project.error());
  if (*recorder != nullptr) {
    (*recorder)->forget();
  }
  // And in the window, for who came by the desktop and sees no terminal.
  Project usual = files.open(std::string(kDefaultMesh)).value();
  try {
    return run({std::move(usual), std::string(kDefaultMesh), {}, options.input, error}, options,
               recorder->get());
  } catch (const render::EnvironmentError&) {
    return tl::unexpected(error);
  }
}

Result<void> run_window(Project project, const WindowOptions& options) {
  auto recorder = recorder_for(options);
  if (!recorder) {
    return tl::unexpected(std::move(recorder.error()));
  }
  std::string text;
  if (*recorder != nullptr) {
    std::ostringstream out;
    write_project(out, project.document, project.view);
    text = std::move(out).str();
  }
  return run({std::move(project), {}, std::move(text)}, options, recorder->get());
}

}  // namespace limn::app
