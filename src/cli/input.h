#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/fine_option.h"
#include "limn/document/project_file.h"
#include "limn/document/refinement.h"
#include "limn/error.h"
#include "limn/painting/crease_rule.h"
#include "limn/painting/paint_rule.h"
#include "limn/painting/rule_presets.h"
#include "limn/painting/selection.h"

namespace CLI {
class App;
}

namespace limn::cli {

inline constexpr std::string_view kProjectEnding = ".limn";

/// The presets that were saved in the window. Errors: those of `load_preferences`.
[[nodiscard]] Result<std::vector<RulePreset>> own_presets();

/// What every subcommand that paints and subdivides takes. Settings left out are the project's, or
/// the defaults for a mesh file.
struct PaintingOptions {
  std::string input;
  std::vector<PaintRule> rules;     ///< In the order given.
  std::vector<CreaseRule> creases;  ///< In the order given.
  std::vector<FineRule> fine;       ///< In the order given, after the rules.
  std::optional<RefinementScheme> adaptive;
  std::optional<LoopWeights> adaptive_weights;
  std::optional<LegalisationMethod> legalisation;
  std::optional<NonQuadRule> non_quads;
  std::optional<CornerRule> corners;
  std::optional<SurfacePoints> points;
  std::optional<TextureRule> texture;
  int levels = kAllLevels;
  std::uint64_t face_budget = 50'000'000;
  std::optional<std::uint64_t> memory_budget;  ///< Bytes; nothing: what the machine can spare.
  int threads = 0;                             ///< 0: as many as the machine has.
};

/// Adds the positional IN, or one or more.
void add_input_option(CLI::App& command, std::string& input);
void add_inputs_option(CLI::App& command, std::vector<std::string>& inputs);

/// Adds --paint, --crease, --fine, --legalize, --non-quads, --corners, --positions, --texture,
/// --levels,
/// --budget, --memory and --threads.
void add_painting_options(CLI::App& command, PaintingOptions& options);

/// Opens IN: `-` is a mesh on standard input, else see open_document. Prints what was mended.
[[nodiscard]] Result<Project> open_input(const std::string& input);
/// The same without printing.
[[nodiscard]] Result<Project> open_quietly(const std::string& input,
                                           const BuildSettings& settings = {});

/// Makes what rules may ask of an opened project, which outlives it: visible faces and cameras.
using MakePaintContext = std::function<PaintContext(const Project&)>;

/// Opens IN and applies settings and rules to it.
[[nodiscard]] Result<Project> open_painted(const PaintingOptions& options,
                                           const MakePaintContext& make_context);

/// A refinement that was made and stays on the GPU.
struct RefinedOnGpu {
  RefinementPrediction prediction;
  std::uint64_t quads = 0;
  std::uint64_t other_faces = 0;
  std::string renderer;  ///< What the driver calls itself.
  double seconds = 0.0;  ///< From labels to the finished surface.
};

/// Everything derived from a painting.
struct Derived {
  DerivedLabels labels;
  std::optional<Refinement> refinement;  ///< Nothing where no level is made, or not on the CPU.
  std::optional<RefinedOnGpu> on_gpu;
};

/// Holds the process to so many threads until it is destroyed; 0: as many as the machine has.
[[nodiscard]] std::shared_ptr<void> limit_threads(int threads);

/// The refinement of an opened project, with progress on the terminal, on `options.threads`
/// threads.
[[nodiscard]] Result<Derived> derive(const Project& project, const PaintingOptions& options);

}  // namespace limn::cli
