#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>

#include "cli/batch.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "limn/mesh/statistics.h"

namespace limn::cli {
namespace {

using Json = nlohmann::ordered_json;

struct ValidateOptions {
  std::vector<std::string> inputs;
  BuildSettings build;
  bool json = false;
};

Json element_json(const ImportReport& report, const Mend& mend, const MendedElement& element) {
  Json result = {{"place", place_of(report, mend, element)}};
  if (element.face != kNone) {
    result["face"] = element.face;
  }
  Json vertices = Json::array();
  for (const std::uint32_t v : element.vertices) {
    if (v != kNone) {
      vertices.push_back(v);
    }
  }
  if (!vertices.empty()) {
    result["vertices"] = vertices;
  }
  result["position"] = {element.position.x, element.position.y, element.position.z};
  return result;
}

Json report_json(const Document& document) {
  const ImportReport& report = document.import_report;
  Json mends = Json::array();
  for (const Mend& mend : report.mends) {
    Json elements = Json::array();
    for (const MendedElement& element : mend.elements) {
      elements.push_back(element_json(report, mend, element));
    }
    mends.push_back({{"kind", name_of(mend.kind)},
                     {"count", mend.count},
                     {"sentence", sentence_of(mend.kind, mend.count)},
                     {"elements", elements}});
  }
  return {{"vertices", document.control->vertex_count()},
          {"faces", document.control->face_count()},
          {"closed", document.control->is_closed()},
          {"mended", report.is_mended()},
          {"mends", mends},
          {"unused_data", report.unused_data}};
}

void print_report(const std::string& input, const Document& document) {
  constexpr std::size_t most_shown = 10;
  const ImportReport& report = document.import_report;
  const MeshStatistics counts = mesh_statistics(*document.control);
  fmt::print("{}: {}, {} vertices, {} faces in {}, {}\n", input,
             report.is_mended() ? "mended" : "sound", counts.vertices, counts.faces,
             counts.components == 1 ? "1 part" : fmt::format("{} parts", counts.components),
             counts.boundary_edges == 0 ? "closed"
                                        : fmt::format("{} boundary edges", counts.boundary_edges));
  for (const Mend& mend : report.mends) {
    fmt::print("  {}\n", sentence_of(mend.kind, mend.count));
    for (std::size_t i = 0; i < mend.elements.size() && i < most_shown; ++i) {
      const MendedElement& element = mend.elements[i];
      fmt::print("    {} at {:.6g} {:.6g} {:.6g}\n", place_of(report, mend, element),
                 element.position.x, element.position.y, element.position.z);
    }
    if (mend.count > most_shown && !mend.elements.empty()) {
      fmt::print("    and {} more\n", mend.count - std::min(mend.elements.size(), most_shown));
    }
  }
  for (const std::string& data : report.unused_data) {
    fmt::print("  Not used: {}.\n", data);
  }
}

Result<void> validate(const ValidateOptions& options) {
  Batch batch(options.inputs);
  for (const std::string& input : options.inputs) {
    batch.run(input, [&]() -> Result<Json> {
      return open_quietly(input, options.build).map([&](const Project& project) {
        if (!options.json) {
          print_report(input, project.document);
        }
        return report_json(project.document);
      });
    });
  }
  if (options.json) {
    fmt::print("{}\n", batch.report().dump(2));
  }
  return batch.result();
}

}  // namespace

void add_validate_command(CLI::App& program, Work& work) {
  CLI::App* command = program.add_subcommand(
      "validate",
      "Say whether mesh files are sound, and what had to be mended, element by element");
  const auto options = std::make_shared<ValidateOptions>();
  add_inputs_option(*command, options->inputs);
  command->add_flag("--strict", options->build.is_strict,
                    "Refuse what would have to be mended (exit code 3)");
  command->add_flag("--json", options->json, "All elements as JSON on standard output");
  command->callback([options, &work] { work = [options] { return validate(*options); }; });
}

}  // namespace limn::cli
