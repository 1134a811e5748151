#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Validators.hpp>
#include <nlohmann/json.hpp>

#include "cli/compare.h"
#include "cli/console.h"
#include "cli/input.h"
#include "cli/scheme_options.h"
#include "limn/comparison/sphere_fit.h"
#include "limn/subdivision/schemes/uniform.h"

namespace limn::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kAllSchemes = "all";

struct CompareOptions {
  std::vector<std::string> inputs;
  std::string scheme = "loop";
  std::optional<LoopWeights> weights;  ///< Nothing: both.
  int levels = 5;
  std::uint64_t face_budget = 50'000'000;
  bool averages = false;
  bool is_fitted = false;
  bool json = false;
};

/// A scheme with all the choices asked for.
std::vector<SchemeSettings> choices_of(Scheme scheme, const CompareOptions& options) {
  const bool is_all = options.scheme == kAllSchemes;
  std::vector<SchemeSettings> choices;
  if (scheme == Scheme::kLoop) {
    for (const LoopWeights weights : {LoopWeights::kOriginal, LoopWeights::kWarren}) {
      if (options.weights.value_or(weights) == weights) {
        choices.push_back({.scheme = scheme, .weights = weights});
      }
    }
  } else if (scheme == Scheme::kLinear && is_all) {
    choices.push_back({.scheme = scheme});
    choices.push_back({.scheme = scheme, .averages = true});
  } else {
    choices.push_back({.scheme = scheme, .averages = options.averages});
  }
  return choices;
}

/// The schemes asked for.
std::vector<SchemeSettings> settings_of(const CompareOptions& options, const Document& document) {
  std::vector<SchemeSettings> all;
  for (const SchemeInfo& info : schemes()) {
    if (options.scheme == kAllSchemes || options.scheme == info.name) {
      for (SchemeSettings settings : choices_of(info.scheme, options)) {
        settings.corners = document.settings.corners;
        all.push_back(settings);
      }
    }
  }
  return all;
}

void print_table(const std::vector<SphereComparison>& rows) {
  // As many decimals as give the radius six digits.
  const double radius = rows.front().fit.radius;
  const int decimals = std::max(0, 5 - static_cast<int>(std::floor(std::log10(radius))));
  const auto number = [decimals](double value) {
    const std::string text = fmt::format("{:.{}f}", value, decimals);
    return text.find_first_not_of("-0.") == std::string::npos && text.front() == '-'
               ? text.substr(1)
               : text;
  };
  fmt::print("{:>5} {:>9} {:>9} {:>10} {:>12} {:>10} {:>10} {:>10} {:>8}  {}\n", "level",
             "vertices", "faces", "ms", "radius", "least", "greatest", "r.m.s.", "r.m.s. %",
             "centre");
  for (const SphereComparison& row : rows) {
    const SphereFit& fit = row.fit;
    fmt::print("{:>5} {:>9} {:>9} {:>10.3f} {:>12} {:>10} {:>10} {:>10} {:>8.3f}  {} {} {}\n",
               row.level, row.vertices, row.faces, 1e3 * row.seconds, number(fit.radius),
               number(fit.least), number(fit.greatest), number(fit.root_mean_square),
               100.0 * fit.root_mean_square / fit.radius, number(fit.centre.x),
               number(fit.centre.y), number(fit.centre.z));
  }
}

Json row_json(const SphereComparison& row) {
  const SphereFit& fit = row.fit;
  return {{"level", row.level},       {"vertices", row.vertices},
          {"edges", row.edges},       {"faces", row.faces},
          {"seconds", row.seconds},   {"centre", {fit.centre.x, fit.centre.y, fit.centre.z}},
          {"radius", fit.radius},     {"least", fit.least},
          {"greatest", fit.greatest}, {"root_mean_square", fit.root_mean_square}};
}

/// Adds to `report`, or prints.
Result<void> compare_mesh(const std::string& input, const CompareOptions& options, Json& report) {
  const Result<Project> project = open_input(input);
  if (!project) {
    return tl::unexpected(project.error());
  }
  const Document& document = project->document;
  for (const SchemeSettings& settings : settings_of(options, document)) {
    const bool is_fitted = options.is_fitted || options.scheme == kAllSchemes;
    const auto mesh = fit_mesh(document.control, settings.scheme, is_fitted, document.name);
    if (!mesh) {
      return tl::unexpected(mesh.error());
    }
    if (auto affordable = check_budget(**mesh, settings, options.levels, options.face_budget);
        !affordable) {
      return affordable;
    }
    Result<std::vector<SphereComparison>> rows;
    {
      TerminalProgress progress;
      rows = compare_with_sphere(**mesh, settings, options.levels, progress);
    }
    if (!rows) {
      return tl::unexpected(rows.error());
    }
    if (!options.json) {
      fmt::print("{}, {}{}\n", document.name, title_of(settings),
                 *mesh == document.control ? "" : ", made to fit");
      print_table(*rows);
      fmt::print("\n");
      continue;
    }
    Json entry = {{"mesh", document.name}, {"scheme", scheme_info(settings.scheme).name}};
    if (settings.scheme == Scheme::kLoop) {
      entry["weights"] = settings.weights == LoopWeights::kWarren ? "warren" : "original";
    }
    if (settings.scheme == Scheme::kLinear) {
      entry["averaged"] = settings.averages;
    }
    entry["fitted"] = *mesh != document.control;
    entry["levels"] = Json::array();
    for (const SphereComparison& row : *rows) {
      entry["levels"].push_back(row_json(row));
    }
    report.push_back(std::move(entry));
  }
  return {};
}

Result<void> compare_meshes(const CompareOptions& options) {
  Json report = Json::array();
  for (const std::string& input : options.inputs) {
    if (auto compared = compare_mesh(input, options, report); !compared) {
      return compared;
    }
  }
  if (options.json) {
    fmt::print("{}\n", report.dump(2));
  }
  return {};
}

}  // namespace

void add_sphere_command(CLI::App& compare, Work& work) {
  CLI::App* command = compare.add_subcommand(
      "sphere",
      "Subdivide meshes and hold each level against the sphere that fits it best. The errors are "
      "distances from the centre less the radius, over all vertices");
  const auto options = std::make_shared<CompareOptions>();
  options->inputs = {"sphere", "cube_triangulated"};
  command
      ->add_option("IN", options->inputs,
                   "Mesh files (.obj, .ply, .off or .stl), projects (.limn), names of bundled "
                   "meshes, or - for a mesh "
                   "on standard input")
      ->capture_default_str();
  command
      ->add_option("--scheme", options->scheme,
                   "Which scheme: " + scheme_words() + "; or all, each mesh made to fit")
      ->type_name("SCHEME")
      ->check([](const std::string& name) {
        return name == kAllSchemes || scheme_named(name)
                   ? std::string{}
                   : fmt::format("\"{}\" is none; there are {} and all", name, scheme_words());
      })
      ->capture_default_str();
  command
      ->add_option_function<std::string>(
          "--weights",
          [options](const std::string& word) {
            options->weights = word == "original" ? std::optional(LoopWeights::kOriginal)
                               : word == "warren" ? std::optional(LoopWeights::kWarren)
                                                  : std::nullopt;
          },
          "Weights of loop: original, warren or both")
      ->check(CLI::IsMember({"original", "warren", "both"}).description(""))
      ->type_name("WORD")
      ->default_str("both");
  add_level_options(*command, options->levels, options->face_budget);
  command->add_flag(
      "--average", options->averages,
      "After each split of linear, move vertices to the mean of the centroids around");
  command->add_flag("--fit", options->is_fitted,
                    "Make a mesh fit that the scheme cannot take: into triangles, or by one step "
                    "of catmull-clark into quads");
  command->add_flag("--json", options->json, "JSON on standard output");
  command
      ->add_option_function<std::string>(
          "--to", [](const std::string&) { throw CLI::ValidationError("--to", kSphereIsNoMesh); })
      ->group("");
  command->callback([options, &work] {
    if (options->averages && options->scheme != scheme_info(Scheme::kLinear).name) {
      throw CLI::ValidationError("--average", "only the scheme linear can be averaged");
    }
    work = [options] { return compare_meshes(*options); };
  });
}

void add_compare_command(CLI::App& program, Work& work) {
  CLI::App* command =
      program.add_subcommand("compare",
                             "Measure how far a mesh, refined as painted, is from the limit "
                             "surface or from another mesh; or hold a scheme against spheres");
  add_sphere_command(*command, work);
  add_distance_options(*command, work);
}

}  // namespace limn::cli
