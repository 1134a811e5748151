#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/input.h"
#include "cli/scheme_options.h"
#include "limn/subdivision/schemes/loop_adjacency.h"

namespace limn::cli {
namespace {

using Json = nlohmann::ordered_json;

struct SchemesOptions {
  std::string scheme;
  std::string input;
  bool has_adjacency = false;
  bool is_fitted = false;
  bool json = false;
};

std::string_view takes_word(FaceKinds kinds) {
  switch (kinds) {
    case FaceKinds::kTriangles:
      return "triangles";
    case FaceKinds::kQuads:
      return "quads";
    case FaceKinds::kAny:
      break;
  }
  return "any faces";
}

Json scheme_json(const SchemeInfo& info) {
  return {{"name", info.name},
          {"title", info.title},
          {"takes", takes_word(info.takes)},
          {"makes", info.makes},
          {"interpolates", info.interpolates},
          {"splits", info.splits_vertices ? "vertices" : "faces"},
          {"continuity", info.continuity},
          {"boundary", info.boundary},
          {"source", info.source}};
}

void print_scheme(const SchemeInfo& info) {
  const auto row = [](std::string_view name, std::string_view value) {
    fmt::print("  {:<14}{}\n", name, value);
  };
  fmt::print("{} ({})\n", info.name, info.title);
  row("takes", takes_word(info.takes));
  row("makes", info.makes);
  row("interpolates", info.interpolates ? "yes: old vertices stay" : "no");
  row("splits", info.splits_vertices ? "vertices" : "faces");
  row("continuity", info.continuity);
  row("boundary", info.boundary);
  row("source", info.source);
}

/// Of one scheme where one is named, else of all.
void print_schemes(const std::optional<Scheme>& only, bool json) {
  Json all = Json::array();
  std::string_view gap;
  for (const SchemeInfo& info : schemes()) {
    if (only && info.scheme != *only) {
      continue;
    }
    if (json) {
      all.push_back(scheme_json(info));
    } else {
      fmt::print("{}", gap);
      print_scheme(info);
      gap = "\n";
    }
  }
  if (json) {
    fmt::print("{}\n", all.dump(2));
  }
}

void print_adjacency(const ControlMesh& mesh) {
  const LoopAdjacency adjacency = loop_adjacency(mesh);
  fmt::print("# {} old vertices, a row each: how many neighbours, then these\n",
             mesh.vertex_count());
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    fmt::print("{}\n", fmt::join(adjacency.row(v), " "));
  }
  fmt::print(
      "# {} midpoints, a row each: the ends of the edge, then the vertices opposite (-: none)\n",
      adjacency.midpoints.size());
  for (const auto& [a, b, x, y] : adjacency.midpoints) {
    fmt::print("{} {} {} {}\n", a, b, x, y == kNone ? "-" : std::to_string(y));
  }
}

Json adjacency_json(const ControlMesh& mesh) {
  const LoopAdjacency adjacency = loop_adjacency(mesh);
  Json vertices = Json::array();
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    vertices.push_back(adjacency.row(v));
  }
  Json midpoints = Json::array();
  for (const auto& [a, b, x, y] : adjacency.midpoints) {
    midpoints.push_back({a, b, x, y == kNone ? Json(nullptr) : Json(y)});
  }
  return {{"vertices", vertices}, {"midpoints", midpoints}};
}

Result<void> show_adjacency(const SchemesOptions& options) {
  const Result<Project> project = open_input(options.input);
  if (!project) {
    return tl::unexpected(project.error());
  }
  return fit_mesh(project->document.control, Scheme::kLoop, options.is_fitted,
                  project->document.name)
      .map([&](const std::shared_ptr<const ControlMesh>& mesh) {
        if (options.json) {
          fmt::print("{}\n", adjacency_json(*mesh).dump());
        } else {
          print_adjacency(*mesh);
        }
      });
}

}  // namespace

void add_schemes_command(CLI::App& program, Work& work) {
  CLI::App* command = program.add_subcommand(
      "schemes", "What each uniform scheme takes and makes; the adjacency that Loop's needs");
  const auto options = std::make_shared<SchemesOptions>();
  command->add_option("SCHEME", options->scheme, "Tell of this one alone: " + scheme_words());
  command->add_option(
      "IN", options->input,
      "With --adjacency: a mesh file (.obj, .ply, .off or .stl), a project (.limn), the name of a "
      "bundled mesh, or - for a mesh on standard input; without, the sphere");
  command->add_flag("--adjacency", options->has_adjacency,
                    "For loop: of every old vertex its neighbours, of every midpoint "
                    "the ends of its edge and the vertices opposite");
  command->add_flag("--fit", options->is_fitted,
                    "With --adjacency: cut what is no triangle into triangles first");
  command->add_flag("--json", options->json, "JSON on standard output");
  command->callback([options, &work] {
    const std::optional<Scheme> scheme = scheme_named(options->scheme);
    if (!options->scheme.empty() && !scheme) {
      throw CLI::ValidationError(
          "SCHEME", fmt::format("\"{}\" is none; there are {}", options->scheme, scheme_words()));
    }
    if (options->has_adjacency && scheme != Scheme::kLoop) {
      throw CLI::ValidationError("--adjacency",
                                 "only loop has it: limn schemes loop IN --adjacency");
    }
    if (!options->has_adjacency && !options->input.empty()) {
      throw CLI::ValidationError("IN", "a mesh is for --adjacency");
    }
    if (options->input.empty()) {
      options->input = "sphere";
    }
    work = [options, scheme]() -> Result<void> {
      if (options->has_adjacency) {
        return show_adjacency(*options);
      }
      print_schemes(scheme, options->json);
      return {};
    };
  });
}

}  // namespace limn::cli
