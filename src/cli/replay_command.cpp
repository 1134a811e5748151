#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Error.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>

#include "app/recording/play.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "limn/document/project_file.h"

namespace limn::cli {
namespace {

struct ReplayOptions {
  std::string recording;
  std::string output;
  std::string pictures;
  double speed = 1.0;
  bool is_in_window = false;
  bool has_json = false;
};

Result<app::Recording> read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    return fail(ErrorKind::kBadInput, "The recording cannot be read. Is the name right?", path);
  }
  const std::string text(std::istreambuf_iterator<char>(file), {});
  return app::parse_recording(text, path);
}

void print(const app::Played& played, bool is_whole, const ReplayOptions& options) {
  const app::PlayReport& report = played.report;
  if (options.has_json) {
    const nlohmann::ordered_json json = {{"turns", report.turns},
                                         {"actions", report.actions},
                                         {"documents_compared", report.documents},
                                         {"pictures_compared", report.pictures},
                                         {"is_whole", is_whole},
                                         {"differences", report.differences}};
    fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    return;
  }
  fmt::print("{} turns with {} actions; compared {} states of the document and {} pictures\n",
             report.turns, report.actions, report.documents, report.pictures);
  if (!is_whole) {
    print_note("the recording ends abruptly: the program was killed, or it crashed, soon after");
  }
  if (!played.has_same_fonts) {
    print_note("other typefaces are installed here than in the recorded run: a click may miss");
  }
  if (!played.compared_pictures && !options.is_in_window) {
    print_note("pictures were not compared: another graphics driver draws other pixels");
  }
}

Result<void> replay(const ReplayOptions& options) {
  auto recording = read(options.recording);
  if (!recording) {
    return tl::unexpected(std::move(recording.error()));
  }
  const bool is_whole = recording->is_whole;
  if (!options.pictures.empty()) {
    std::error_code error;
    std::filesystem::create_directories(options.pictures, error);
    if (error) {
      return fail(ErrorKind::kFailed,
                  fmt::format("The folder cannot be made: {}.", error.message()), options.pictures);
    }
  }
  TerminalProgress progress;
  auto played = options.is_in_window
                    ? app::play_in_window(*std::move(recording), options.speed)
                    : app::play_headless(*std::move(recording), {options.pictures}, progress);
  if (!played) {
    return tl::unexpected(std::move(played.error()));
  }
  print(*played, is_whole, options);
  if (!options.output.empty()) {
    if (auto saved = save_project(options.output, played->document, played->view); !saved) {
      return saved;
    }
  }
  const std::vector<std::string>& differences = played->report.differences;
  if (differences.empty()) {
    return {};
  }
  std::string message = "What was played back is not what was recorded:";
  for (const std::string& difference : differences) {
    message += "\n  " + difference;
  }
  return fail(ErrorKind::kFailed, std::move(message), options.recording);
}

}  // namespace

void add_replay_command(CLI::App& program, Work& work) {
  CLI::App* command = program.add_subcommand(
      "replay",
      "Do again what limn --record wrote down, without a window, and compare what comes of it. No "
      "file that the recorded run wrote is written again");
  const auto options = std::make_shared<ReplayOptions>();
  command->add_option("FILE", options->recording, "A recording")->required();
  command->add_option("-o,--output", options->output, "The project to write at the end (.limn)");
  auto* pictures =
      command->add_option("--pictures", options->pictures,
                          "A folder for the screenshots that were taken, and for the window as it "
                          "was at the end");
  auto* window = command->add_flag("--window", options->is_in_window,
                                   "Play in a window, as fast as it was done; Esc ends it");
  command->add_option("--speed", options->speed, "Times as fast, in a window")
      ->needs(window)
      ->check(CLI::Range(0.05, 100.0));
  window->excludes(pictures);
  command->add_flag("--json", options->has_json, "What was compared as JSON on standard output");
  command->callback([options, &work] {
    if (!options->output.empty() && !options->output.ends_with(".limn")) {
      throw CLI::ValidationError("-o", "is a project and ends in .limn");
    }
    work = [options] { return replay(*options); };
  });
}

}  // namespace limn::cli
