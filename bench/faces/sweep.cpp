// limn_tolerance_sweep TOLERANCE level|limit|measured FILE...
// Chooses depths for a tolerance, in diagonals, refines and measures. Prints a line a file: what
// was measured and what was expected, both in tolerances. Fails where anything measured is above
// its tolerance. With `measured`, depths are measured while they are chosen, for vertices on the
// limit surface. scripts/sweep-tolerance.sh runs it over many files.
#include <charconv>
#include <cstring>
#include <string>

#include <fmt/format.h>

#include "limn/comparison/limit_distance.h"
#include "limn/contract.h"
#include "limn/document/open.h"
#include "limn/document/refinement.h"
#include "limn/painting/auto_depth/tolerance.h"

namespace {

using namespace limn;  // NOLINT(google-build-using-namespace)

/// Refinements beyond this take too long to measure.
constexpr std::uint64_t kMostFaces = 1'500'000;

struct Question {
  double tolerance = 0.0;  ///< In diagonals.
  SurfacePoints points = SurfacePoints::kLimit;
  bool is_measured = false;
};

/// False where more was measured than is tolerated.
bool sweep(const std::string& file, const Question& question) {
  const Result<Project> project = open_document(file);
  if (!project) {
    fmt::print("refused  {}\n", file);
    return true;
  }
  const ControlMesh& mesh = *project->document.control;
  RefinementOptions options;
  options.settings = project->document.settings;
  options.settings.points = question.points;
  options.face_budget = kMostFaces;
  const double distance = question.tolerance * mesh.bounds().diagonal();
  IgnoreProgress progress;
  const auto chosen =
      question.is_measured
          ? depths_for_measured_tolerance(mesh, options.settings, {&distance, 1}, progress)
          : depths_for_tolerance(mesh, options.settings, {&distance, 1}, progress);
  LIMN_EXPECTS(chosen.has_value());
  const auto labels = derive_labels(mesh, chosen->depths.values(), options.settings, progress);
  LIMN_EXPECTS(labels.has_value());
  const auto refined = derive_refinement(mesh, *labels, options, progress);
  if (!refined) {
    fmt::print("large    {}: {} faces\n", file, labels->prediction.faces);
    return true;
  }
  LimitDistanceLimits limits;
  limits.samples = std::size_t{1} << 21;
  const auto measured = measure_limit_distance(mesh, labels->legal.labels, options.settings,
                                               *refined->mesh, progress, limits);
  LIMN_EXPECTS(measured.has_value());
  const double share = distance > 0.0 ? measured->greatest() / distance : 0.0;
  // Where the deepest level there is does not suffice, nothing was promised.
  const bool is_short = chosen->short_faces > 0;
  const bool holds = share <= 1.0 || is_short;
  fmt::print("{}  {:.3f} measured, {:.3f} expected, {} faces of {}: {}\n",
             is_short ? "short  "
             : holds  ? "holds  "
                      : "ABOVE  ",
             share, distance > 0.0 ? chosen->expected_error / distance : 0.0,
             labels->prediction.faces, mesh.face_count(), file);
  return holds;
}

}  // namespace

int main(int argc, char** argv) {
  Question question;
  bool is_understood = argc >= 4;
  if (is_understood) {
    const char* const end = argv[1] + std::strlen(argv[1]);
    is_understood =
        std::from_chars(argv[1], end, question.tolerance).ptr == end && question.tolerance > 0.0;
    const std::string way = argv[2];
    question.points = way == "level" ? SurfacePoints::kLevel : SurfacePoints::kLimit;
    question.is_measured = way == "measured";
    is_understood = is_understood && (way == "level" || way == "limit" || way == "measured");
  }
  if (!is_understood) {
    fmt::print(stderr, "limn_tolerance_sweep TOLERANCE level|limit|measured FILE...\n");
    return 2;
  }
  bool holds = true;
  for (int i = 3; i < argc; ++i) {
    holds = sweep(argv[i], question) && holds;
  }
  return holds ? 0 : 1;
}
