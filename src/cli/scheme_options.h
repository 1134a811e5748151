#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "limn/document/project_file.h"
#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/subdivision/schemes/scheme.h"

namespace CLI {
class App;
}

namespace limn::cli {

/// A uniform scheme as a subcommand is told it.
struct SchemeOptions {
  std::optional<Scheme> scheme;
  std::optional<LoopWeights> weights;
  std::optional<CornerRule> corners;  ///< Left out: the mesh's own rule.
  bool averages = false;
  bool is_fitted = false;  ///< What a scheme cannot take is made to fit.
};

/// The schemes' names, as in "linear, catmull-clark, ...".
[[nodiscard]] std::string scheme_words();

/// Adds --scheme, --weights, --average and --fit.
void add_scheme_options(CLI::App& command, SchemeOptions& options);
/// Adds --levels and --budget.
void add_level_options(CLI::App& command, int& levels, std::uint64_t& face_budget);
/// Adds --corners.
void add_corners_option(CLI::App& command, std::optional<CornerRule>& corners);

/// A CLI::ValidationError where --weights or --average goes with a scheme that has no such choice.
void check_scheme_options(const SchemeOptions& options);

/// `options.scheme` is there.
[[nodiscard]] SchemeSettings scheme_settings(const SchemeOptions& options,
                                             const Document& document);

/// "Loop, original weights".
[[nodiscard]] std::string title_of(const SchemeSettings& settings);

/// A mesh that a scheme can take: itself, or made to fit, which is said. `name` is the mesh's, for
/// the message. Errors: kFailed where it does not fit and is not to be made so, telling how.
[[nodiscard]] Result<std::shared_ptr<const ControlMesh>> fit_mesh(
    const std::shared_ptr<const ControlMesh>& mesh, Scheme scheme, bool is_fitted,
    const std::string& name);

/// kOverBudget where so many levels have more faces than are allowed. The mesh fits.
[[nodiscard]] Result<void> check_budget(const ControlMesh& mesh, const SchemeSettings& settings,
                                        int levels, std::uint64_t face_budget);

}  // namespace limn::cli
