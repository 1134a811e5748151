#include "cli/scheme_options.h"

#include <map>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Validators.hpp>

#include "cli/console.h"
#include "limn/document/memory_budget.h"
#include "limn/document/scheme_refinement.h"
#include "limn/subdivision/schemes/uniform.h"

namespace limn::cli {

std::string scheme_words() {
  std::vector<std::string_view> names;
  for (const SchemeInfo& info : schemes()) {
    names.push_back(info.name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

void add_level_options(CLI::App& command, int& levels, std::uint64_t& face_budget) {
  command.add_option("--levels", levels, "How many steps")
      ->type_name("N")
      ->check(CLI::Range(0, kMostSchemeLevels))
      ->capture_default_str();
  command
      .add_option("--budget", face_budget,
                  "Refuse, before any work on a mesh, a last level with more faces")
      ->type_name("FACES")
      ->capture_default_str();
}

void add_corners_option(CLI::App& command, std::optional<CornerRule>& corners) {
  command
      .add_option("--corners", corners,
                  "Boundary vertices with one face: sharp (they stay) or smooth")
      ->transform(CLI::CheckedTransformer(
                      std::map<std::string, CornerRule>{{"sharp", CornerRule::kSharp},
                                                        {"smooth", CornerRule::kSmooth}})
                      .description(""))
      ->type_name("WORD");
}

void add_scheme_options(CLI::App& command, SchemeOptions& options) {
  std::map<std::string, Scheme> names;
  for (const SchemeInfo& info : schemes()) {
    names.emplace(info.name, info.scheme);
  }
  command
      .add_option("--scheme", options.scheme,
                  "How to subdivide, every face alike: " + scheme_words() +
                      ". `limn schemes` tells about each")
      ->transform(CLI::CheckedTransformer(names).description(""))
      ->type_name("SCHEME");
  command
      .add_option("--weights", options.weights,
                  "How much of themselves vertices keep under loop: original or warren")
      ->transform(CLI::CheckedTransformer(
                      std::map<std::string, LoopWeights>{{"original", LoopWeights::kOriginal},
                                                         {"warren", LoopWeights::kWarren}})
                      .description(""))
      ->type_name("WORD");
  command.add_flag("--average", options.averages,
                   "After each split of linear, move vertices to the mean of the centroids around");
  command.add_flag("--fit", options.is_fitted,
                   "Make a mesh fit that the scheme cannot take: into triangles, or by one step "
                   "of catmull-clark into quads");
}

void check_scheme_options(const SchemeOptions& options) {
  if (options.weights && options.scheme != Scheme::kLoop) {
    throw CLI::ValidationError("--weights", "only the scheme loop has a choice of weights");
  }
  if (options.averages && options.scheme != Scheme::kLinear) {
    throw CLI::ValidationError("--average", "only the scheme linear can be averaged");
  }
}

SchemeSettings scheme_settings(const SchemeOptions& options, const Document& document) {
  return {.scheme = options.scheme.value(),
          .weights = options.weights.value_or(LoopWeights::kOriginal),
          .averages = options.averages,
          .corners = options.corners.value_or(document.settings.corners)};
}

std::string title_of(const SchemeSettings& settings) {
  const std::string_view title = scheme_info(settings.scheme).title;
  if (settings.scheme == Scheme::kLoop) {
    return fmt::format("{}, {} weights", title,
                       settings.weights == LoopWeights::kWarren ? "Warren's" : "original");
  }
  return settings.averages ? fmt::format("{}, averaged", title) : std::string(title);
}

Result<std::shared_ptr<const ControlMesh>> fit_mesh(const std::shared_ptr<const ControlMesh>& mesh,
                                                    Scheme scheme, bool is_fitted,
                                                    const std::string& name) {
  Result<void> fits = check_fits(*mesh, scheme);
  if (fits) {
    return mesh;
  }
  const SchemeInfo& info = scheme_info(scheme);
  const Fitting fitting = fitting_for(info.takes);
  std::shared_ptr<const ControlMesh> fitted = make_fit(*mesh, fitting);
  if (Result<void> still = check_fits(*fitted, scheme); !still) {
    return tl::unexpected(std::move(still.error()));
  }
  if (!is_fitted) {
    fits.error().message += " --fit does it.";
    return tl::unexpected(std::move(fits.error()));
  }
  print_note(fmt::format(
      "{}: {} to fit {}; {} faces became {}", name,
      fitting == Fitting::kTriangulate ? "cut into triangles" : "one Catmull-Clark step into quads",
      info.title, mesh->face_count(), fitted->face_count()));
  return fitted;
}

Result<void> check_budget(const ControlMesh& mesh, const SchemeSettings& settings, int levels,
                          std::uint64_t face_budget) {
  const SchemeCounts counts = predict_scheme(mesh, settings, levels).back();
  const std::uint64_t faces = counts.faces;
  if (faces <= face_budget) {
    const std::uint64_t bytes = scheme_bytes(counts);
    const std::uint64_t memory = memory_budget();
    return bytes <= memory ? Result<void>() : over_memory(faces, bytes, memory);
  }
  return fail(ErrorKind::kOverBudget,
              fmt::format("The result would have {} faces, more than the allowed {}. Make fewer "
                          "levels, or raise the face budget.",
                          faces, face_budget));
}

}  // namespace limn::cli
