#include "cli/input.h"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Validators.hpp>

#include "app/preferences.h"
#include "cli/console.h"
#include "limn/document/commands.h"
#include "limn/document/memory_budget.h"
#include "limn/document/open.h"
#include "limn/mesh/import.h"

namespace limn::cli {
namespace {

constexpr std::string_view kPreset = "preset=";

std::string read_all(std::istream& in) {
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// The rules of one --paint argument: a rule, `@FILE` with a rule a line, or `preset=NAME`.
std::vector<PaintRule> read_rules(const std::string& argument) {
  Result<std::vector<PaintRule>> rules;
  if (argument.starts_with('@')) {
    const std::string path = argument.substr(1);
    std::ifstream file(path);
    if (!file) {
      throw CLI::ValidationError("--paint", path + ": the file of rules cannot be read");
    }
    rules = parse_paint_rules(read_all(file), path);
  } else if (argument.starts_with(kPreset)) {
    rules = own_presets().and_then([&](const std::vector<RulePreset>& own) {
      return rules_of_preset(own, std::string_view(argument).substr(kPreset.size()));
    });
  } else {
    rules = parse_paint_rule(argument).map(
        [](PaintRule rule) { return std::vector<PaintRule>{std::move(rule)}; });
  }
  if (!rules) {
    throw CLI::ValidationError("--paint", to_string(rules.error()));
  }
  return *std::move(rules);
}

/// Adds an option whose words stand for enumerators.
template <class T>
void add_choice(CLI::App& command, const std::string& name, std::optional<T>& value,
                std::map<std::string, T> words, const std::string& description) {
  command.add_option(name, value, description)
      ->transform(CLI::CheckedTransformer(std::move(words)).description(""))
      ->type_name("WORD");
}

}  // namespace

Result<std::vector<RulePreset>> own_presets() {
  return app::load_preferences(app::preferences_path()).map([](app::Preferences preferences) {
    return std::move(preferences.presets);
  });
}

void add_input_option(CLI::App& command, std::string& input) {
  command
      .add_option(
          "IN", input,
          "A mesh file (.obj, .ply, .off or .stl), a project (.limn), the name of a bundled "
          "mesh, or - for a mesh on standard input")
      ->required();
}

void add_inputs_option(CLI::App& command, std::vector<std::string>& inputs) {
  command
      .add_option("IN", inputs,
                  "One or more: mesh files (.obj, .ply, .off or .stl), projects (.limn), names of "
                  "bundled meshes, or - for a mesh on standard input")
      ->required();
}

void add_painting_options(CLI::App& command, PaintingOptions& options) {
  command
      .add_option_function<std::vector<std::string>>(
          "--paint",
          [&options](const std::vector<std::string>& arguments) {
            for (const std::string& argument : arguments) {
              for (PaintRule& rule : read_rules(argument)) {
                options.rules.push_back(std::move(rule));
              }
            }
          },
          "A rule SELECTION:CHANGE, any number of times, applied in order. SELECTION is all, "
          "visible, painted, unpainted, dihedral>DEGREES, curvature>DEGREES, faces=0,3-9, "
          "flood=FACE (its surroundings of equal depth), smart=FACE,DEGREES (as far as the surface "
          "bends by so much in all) or connected=FACE; CHANGE is +N, -N, =N, maxN or minN. Or "
          "depths "
          "that come about by themselves: tolerance=0.001d (distance to the limit surface, in "
          "diagonals), tolerance=0.5px@CAMERA, budget=50000 (or 50000t triangles), "
          "screen=4px@CAMERA, curve=curvature,5/0,40/3; :max, :min or :add behind them combines "
          "them "
          "with what is painted. Or a word for the whole painting: grow, shrink, invert, smooth, "
          "clear, mirror=AXES. Any of them followed by \" in SELECTION\" changes those faces only. "
          "@FILE reads a rule a line; preset=NAME stands for the rules of a preset (limn presets)")
      ->type_name("RULE")
      ->expected(1)
      ->take_all();
  command
      .add_option_function<std::vector<std::string>>(
          "--crease",
          [&options](const std::vector<std::string>& arguments) {
            for (const std::string& argument : arguments) {
              Result<CreaseRule> rule = parse_crease_rule(argument);
              if (!rule) {
                throw CLI::ValidationError("--crease", to_string(rule.error()));
              }
              options.creases.push_back(*std::move(rule));
            }
          },
          "Edges to keep sharp, SELECTION:CHANGE, any number of times, applied in order. SELECTION "
          "is all, creased or angle>DEGREES (between the two faces); CHANGE is =S, +S or -S, S "
          "levels up to 10 or inf. clear makes everything smooth")
      ->type_name("RULE")
      ->expected(1)
      ->take_all();
  add_fine_option(command, options.fine);
  add_choice<RefinementScheme>(
      command, "--adaptive", options.adaptive,
      {{"catmull-clark", RefinementScheme::kCatmullClark}, {"loop", RefinementScheme::kLoop}},
      "What subdivides the painted faces: catmull-clark, or loop for triangle meshes");
  add_choice<LoopWeights>(command, "--adaptive-weights", options.adaptive_weights,
                          {{"original", LoopWeights::kOriginal}, {"warren", LoopWeights::kWarren}},
                          "Of --adaptive loop: original or warren");
  add_choice<LegalisationMethod>(
      command, "--legalize", options.legalisation,
      {{"look-ahead", LegalisationMethod::kLookAhead}, {"greedy", LegalisationMethod::kGreedy}},
      "How illegal vertices are removed: look-ahead (never more faces) "
      "or greedy (the paper's order)");
  add_choice<NonQuadRule>(command, "--non-quads", options.non_quads,
                          {{"uniform-first-step", NonQuadRule::kUniformFirstStep},
                           {"where-painted", NonQuadRule::kWherePainted}},
                          "Faces that are no quads: uniform-first-step or where-painted");
  add_choice<CornerRule>(command, "--corners", options.corners,
                         {{"sharp", CornerRule::kSharp}, {"smooth", CornerRule::kSmooth}},
                         "Boundary vertices with one face: sharp (they stay) or smooth");
  add_choice<SurfacePoints>(command, "--positions", options.points,
                            {{"level", SurfacePoints::kLevel}, {"limit", SurfacePoints::kLimit}},
                            "Vertices where uniform subdivision to their level puts them (level), "
                            "or on the limit surface (limit)");
  add_choice<TextureRule>(
      command, "--texture", options.texture,
      {{"smooth-inside", TextureRule::kSmoothInside}, {"linear", TextureRule::kLinear}},
      "Texture coordinates: smooth-inside (straight along seams and "
      "boundaries) or linear");
  command.add_option("--levels", options.levels, "Stop after N steps")
      ->type_name("N")
      ->check(CLI::Range(0, kAllLevels))
      ->default_str("as painted");
  command
      .add_option("--budget", options.face_budget,
                  "Refuse, before any work, a result with more faces")
      ->type_name("FACES")
      ->capture_default_str();
  command
      .add_option("--memory", options.memory_budget,
                  "Refuse, before any work, a result that takes more: a size such as 800MB or 4GB")
      ->type_name("SIZE")
      ->transform(CLI::AsSizeValue(true))
      ->default_str("70 % of what is available");
  command.add_option("--threads", options.threads, "Use at most N threads; the result is the same")
      ->type_name("N")
      ->check(CLI::Range(1, 1024))
      ->default_str("all");
}

Result<Project> open_quietly(const std::string& input, const BuildSettings& settings) {
  if (input != "-") {
    return open_document(input, settings);
  }
  return import_bytes(read_all(std::cin), MeshFormat::kObj, "standard input", settings)
      .map([](ImportedMesh mesh) {
        return Project{make_document(std::move(mesh), "standard input"), std::nullopt};
      });
}

Result<Project> open_input(const std::string& input) {
  Result<Project> project = open_quietly(input);
  if (project) {
    print_import_report(project->document.import_report, input);
  }
  return project;
}

Result<Project> open_painted(const PaintingOptions& options, const MakePaintContext& make_context) {
  Result<Project> project = open_input(options.input);
  if (!project) {
    return project;
  }
  Document& document = project->document;
  document.settings.scheme = options.adaptive.value_or(document.settings.scheme);
  document.settings.weights = options.adaptive_weights.value_or(document.settings.weights);
  document.settings.legalisation = options.legalisation.value_or(document.settings.legalisation);
  document.settings.non_quads = options.non_quads.value_or(document.settings.non_quads);
  document.settings.corners = options.corners.value_or(document.settings.corners);
  // Where distances to the limit surface count, the vertices had better lie on it.
  const bool aims = std::ranges::any_of(options.rules, aims_at_limit);
  document.settings.points =
      options.points.value_or(aims ? SurfacePoints::kLimit : document.settings.points);
  document.settings.texture = options.texture.value_or(document.settings.texture);

  for (const CreaseRule& rule : options.creases) {
    crease_command(document, rule)->apply(document);
  }
  // Before the rules: a budget counts what is demanded.
  if (auto demanded = apply_fine_rules(document, options.fine); !demanded) {
    return tl::unexpected(std::move(demanded.error()));
  }
  TerminalProgress progress;
  PaintContext context = make_context(*project);
  context.settings = document.settings;
  context.demands = &document.demands;
  context.progress = &progress;
  for (const PaintRule& rule : options.rules) {
    if (auto painted = apply_paint_rule(*document.control, rule, context, document.depths);
        !painted) {
      return tl::unexpected(std::move(painted.error()));
    }
    if (clears_all(rule)) {
      document.demands = {};
    }
  }
  return project;
}

std::shared_ptr<void> limit_threads(int threads) {
  if (threads == 0) {
    return nullptr;
  }
  return std::make_shared<oneapi::tbb::global_control>(
      oneapi::tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
}

Result<Derived> derive(const Project& project, const PaintingOptions& options) {
  const std::shared_ptr<void> limit = limit_threads(options.threads);
  const Document& document = project.document;
  if (document.scheme) {
    print_note(fmt::format(
        "{}: the project shows {}; here its painting is refined. --scheme (render, subdivide) "
        "takes the whole mesh",
        document.name, scheme_info(document.scheme->scheme).title));
  }
  TerminalProgress progress;
  Result<DerivedLabels> labels = derive_labels(*document.control, document.depths.values(),
                                               document.settings, progress, document.demands);
  if (!labels) {
    return tl::unexpected(std::move(labels.error()));
  }
  Derived derived{*std::move(labels), std::nullopt, std::nullopt};
  if (options.levels > 0 && derived.labels.prediction.levels > 0) {
    Result<Refinement> refinement =
        derive_refinement(*document.control, derived.labels,
                          {document.settings, options.levels, options.face_budget,
                           options.memory_budget ? *options.memory_budget : memory_budget()},
                          progress);
    if (!refinement) {
      return tl::unexpected(std::move(refinement.error()));
    }
    derived.refinement = *std::move(refinement);
  }
  return derived;
}

}  // namespace limn::cli
