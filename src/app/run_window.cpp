#include "app/run_window.h"

#include <string>
#include <utility>

#include <spdlog/spdlog.h>

#include "app/application.h"
#include "app/preferences.h"
#include "app/recovery_store.h"
#include "app/user_folders.h"
#include "limn/document/open.h"
#include "limn/mesh/bundled.h"

namespace limn::app {

namespace {

Preferences for_classroom(Preferences preferences) {
  preferences.keymap = ui::KeymapId::kClassroom;
  preferences.layout.paint_open = false;
  preferences.layout.subdivide_open = false;
  preferences.layout.schemes_open = true;
  return preferences;
}

}  // namespace

Result<void> run_window(const WindowOptions& options) {
  // Read first: a bad file is told on the terminal it was named on.
  auto project = open_document(options.input.empty() ? std::string(kDefaultMesh) : options.input);
  if (!project) {
    return tl::unexpected(std::move(project.error()));
  }
  return run_window(*std::move(project), options);
}

Result<void> run_window(Project project, const WindowOptions& options) {
  const std::filesystem::path kept = preferences_path();
  const auto loaded = load_preferences(kept);
  const Preferences preferences = loaded.value_or(Preferences{});

  Application application(options.is_classroom ? for_classroom(preferences) : preferences,
                          std::move(project));
  application.set_status_file(options.status_file);
  if (!loaded) {
    application.toast(ui::Toast::Kind::kProblem, to_string(loaded.error()));
  }
  application.offer(find_lost_work(recovery_folder()));
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

}  // namespace limn::app
