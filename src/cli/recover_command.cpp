#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Error.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>

#include "app/recovery_store.h"
#include "app/user_folders.h"
#include "cli/commands.h"
#include "cli/console.h"

namespace limn::cli {
namespace {

struct RecoverOptions {
  std::string output;
  bool discards = false;
  bool has_json = false;
};

void list(const std::vector<app::LostWork>& lost, bool has_json) {
  if (has_json) {
    auto json = nlohmann::ordered_json::array();
    for (const app::LostWork& work : lost) {
      json.push_back({{"name", work.name},
                      {"project", work.project_path.string()},
                      {"copy", work.copies.front().string()}});
    }
    fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    return;
  }
  for (const app::LostWork& work : lost) {
    fmt::print("{} ({}): {}\n", work.name,
               work.project_path.empty() ? "never saved" : work.project_path.string(),
               work.copies.front().string());
  }
  if (lost.empty()) {
    fmt::print("There is nothing to recover.\n");
  }
}

Result<void> recover(const RecoverOptions& options) {
  std::vector<app::LostWork> lost = app::find_lost_work(app::recovery_folder());
  if (options.discards) {
    const std::size_t count = lost.size();
    for (app::LostWork& work : lost) {
      app::discard_lost_work(std::move(work));
    }
    print_note(fmt::format("{} removed", count));
    return {};
  }
  if (options.output.empty()) {
    list(lost, options.has_json);
    return {};
  }
  if (lost.empty()) {
    return fail(ErrorKind::kFailed, "There is nothing to recover.");
  }
  const Result<Project> project = app::load_lost_work(lost.front());
  if (!project) {
    return tl::unexpected(project.error());
  }
  if (auto saved = save_project(options.output, project->document, project->view); !saved) {
    return saved;
  }
  print_note(fmt::format("{}: recovered {}", options.output, lost.front().name));
  app::discard_lost_work(std::move(lost.front()));
  return {};
}

}  // namespace

void add_recover_command(CLI::App& program, Work& work) {
  CLI::App* command = program.add_subcommand(
      "recover", "List the unsaved work that windows have left which were killed, or save it");
  const auto options = std::make_shared<RecoverOptions>();
  command->add_option("-o,--output", options->output,
                      "Save the newest as this project (.limn) and remove its copies");
  command->add_flag("--discard", options->discards, "Remove all of it")->excludes("--output");
  command->add_flag("--json", options->has_json, "The list as JSON on standard output");
  command->callback([options, &work] {
    if (!options->output.empty() && !options->output.ends_with(".limn")) {
      throw CLI::ValidationError("-o", "is a project and ends in .limn");
    }
    work = [options] { return recover(*options); };
  });
}

}  // namespace limn::cli
