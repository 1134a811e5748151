#include "app/run_window.h"

#include <string>
#include <utility>

#include <spdlog/spdlog.h>

#include "app/application.h"
#include "app/preferences.h"
#include "limn/document/open.h"
#include "limn/mesh/bundled.h"

namespace limn::app {

Result<void> run_window(const WindowOptions& options) {
  // Read first: a bad file is told on the terminal it was named on.
  auto project = open_document(options.input.empty() ? std::string(kDefaultMesh) : options.input);
  if (!project) {
    return tl::unexpected(std::move(project.error()));
  }
  const std::filesystem::path kept = preferences_path();
  const auto preferences = load_preferences(kept);

  Application application(preferences.value_or(Preferences{}), std::move(*project));
  application.set_status_file(options.status_file);
  if (!preferences) {
    application.toast(ui::Toast::Kind::kProblem, to_string(preferences.error()));
  }
  application.run();

  if (!kept.empty()) {
    if (const auto saved = save_preferences(kept, application.preferences()); !saved) {
      spdlog::warn("{}", to_string(saved.error()));
    }
  }
  return {};
}

}  // namespace limn::app
