// Rules under names: those that come with the program, and those saved in the window.
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/input.h"

namespace limn::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Lines without their ends.
std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (end > 0) {
      lines.emplace_back(text.substr(0, end));
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

Json preset_json(const RulePreset& preset, bool is_bundled) {
  return {{"name", preset.name},
          {"bundled", is_bundled},
          {"description", preset.description},
          {"rules", lines_of(preset.rules)}};
}

void print_preset(const RulePreset& preset) {
  fmt::print("{}\n", preset.name);
  if (!preset.description.empty()) {
    fmt::print("  {}\n", preset.description);
  }
  for (const std::string& rule : lines_of(preset.rules)) {
    fmt::print("    {}\n", rule);
  }
}

Result<void> list_presets(bool as_json) {
  const Result<std::vector<RulePreset>> own = own_presets();
  if (!own) {
    return tl::unexpected(own.error());
  }
  Json list = Json::array();
  for (const bool is_bundled : {true, false}) {
    for (const RulePreset& preset :
         is_bundled ? bundled_presets() : std::span<const RulePreset>(*own)) {
      if (as_json) {
        list.push_back(preset_json(preset, is_bundled));
      } else {
        print_preset(preset);
      }
    }
  }
  if (as_json) {
    fmt::print("{}\n", Json{{"presets", std::move(list)}}.dump(2));
  }
  return {};
}

}  // namespace

void add_presets_command(CLI::App& program, Work& work) {
  const auto as_json = std::make_shared<bool>(false);
  CLI::App* command = program.add_subcommand(
      "presets", "List paint rules that have a name, for --paint preset=NAME");
  command->add_flag("--json", *as_json, "One JSON object on standard output");
  command->callback([as_json, &work] { work = [as_json] { return list_presets(*as_json); }; });
}

}  // namespace limn::cli
