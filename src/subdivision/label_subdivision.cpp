// Level by level: plan a step (step_plan.cpp), make the next level's connectivity
// (level_topology.cpp), place its points (level_geometry.cpp), write what is finished
// (refinement_output.cpp). The prediction gives the sizes of all output arrays and the number of
// steps; stopping after N steps is the same as running on the labels min(L, N).
#include "limn/subdivision/label_subdivision.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limn/contract.h"
#include "subdivision/invariants.h"
#include "subdivision/refine_hooks.h"
#include "subdivision/refinement_output.h"
#include "subdivision/step_geometry.h"

namespace limn {
namespace {

/// Faces and vertices are numbered with 32 bits, and so are the four corners of every quad.
constexpr std::uint64_t kMostFaces = 0x3FFFFFF0u;

class Refinement {
 public:
  Refinement(const RefinementPrediction& prediction, const GeometryRules& rules, Progress& progress,
             const RefineHooks& hooks)
      : prediction_(&prediction), rules_(&rules), hooks_(&hooks), sweep_(progress) {}

  /// False if cancelled.
  bool run(const ControlMesh& mesh, Level level, RefinedMesh& output) {
    output_ = &output;
    next_vertex_ = static_cast<std::uint32_t>(mesh.vertex_count());
    do {
      const double items = static_cast<double>(6 * level.face_count() + 5 * level.corner_count() +
                                               5 * level.vertex_count());
      sweep_.begin_stage(fmt::format("Refining level {}", level.number + 1), reached(level.number),
                         reached(level.number + 1), static_cast<std::size_t>(items));
      if (mesh.is_all_quads() || level.number > 0) {
        level = step(QuadSides{}, level);
      } else {
        level =
            step(PolygonSides{mesh.topology().face_offsets, mesh.topology().corner_faces}, level);
      }
      if (sweep_.is_cancelled()) {
        return false;
      }
    } while (level.number < prediction_->levels);
    LIMN_EXPECTS(next_quad_ == output.quads.size());
    LIMN_EXPECTS(next_vertex_ == output.positions.size());
    return true;
  }

 private:
  /// Share of the whole work that is done when level k is reached; each is about 4 times the last.
  [[nodiscard]] double reached(int level) const {
    const int levels = std::max(prediction_->levels, 1);
    return (std::pow(4.0, std::min(level, levels)) - 1.0) / (std::pow(4.0, levels) - 1.0);
  }

  /// Returns the next level; after the last step an empty one that only has a number.
  template <class Sides>
  Level step(const Sides& sides, const Level& level) {
    if (hooks_->on_level) {
      hooks_->on_level(level);
    }
    const bool is_last = level.number + 1 >= prediction_->levels;
    const Step step = plan_step(sweep_, sides, level, next_quad_, next_vertex_, is_last);
    Level next;
    next.number = level.number + 1;
    if (sweep_.is_cancelled()) {
      return next;
    }
    next_quad_ += step.quads;
    next_vertex_ += step.emitted - step.moved;
    LIMN_EXPECTS(next_quad_ <= output_->quads.size());
    LIMN_EXPECTS(next_vertex_ <= output_->positions.size());
    emit_quads(sweep_, sides, level, step, *output_);
    if (is_last) {
      place_points(sweep_, sides, level, step, *rules_, nullptr, *output_);
    } else {
      next = child_level(sweep_, sides, level, step);
      place_points(sweep_, sides, level, step, *rules_, &next, *output_);
    }
    return next;
  }

  const RefinementPrediction* prediction_;
  const GeometryRules* rules_;
  const RefineHooks* hooks_;
  Sweep sweep_;
  RefinedMesh* output_ = nullptr;
  std::uint32_t next_quad_ = 0;
  std::uint32_t next_vertex_ = 0;
};

tl::unexpected<Error> over_budget(const RefinementPrediction& prediction, std::uint64_t budget) {
  return fail(ErrorKind::kOverBudget,
              fmt::format("The refinement would have {} faces, more than the allowed {}. Lower the "
                          "depths, refine fewer levels, or raise the face budget.",
                          prediction.faces, budget));
}

}  // namespace

Result<Legalisation> legal_labels(const ControlMesh& mesh, std::span<const std::uint8_t> depths,
                                  const SubdivisionSettings& settings, Progress& progress) {
  VertexLabels labels = apply_non_quad_rule(mesh, vertex_labels(mesh, depths), settings.non_quads);
  switch (settings.legalisation) {
    case LegalisationMethod::kGreedy:
      return legalise_greedy(mesh, std::move(labels), settings.non_quads, progress);
  }
  LIMN_EXPECTS(!"a known legalisation method");
  return {};
}

Result<RefinedMesh> refine(const ControlMesh& mesh, const VertexLabels& labels,
                           const SubdivisionSettings& settings, const RefineLimits& limits,
                           Progress& progress) {
  return refine_with_hooks(mesh, labels, settings, limits, progress, {});
}

Result<RefinedMesh> refine_with_hooks(const ControlMesh& mesh, const VertexLabels& labels,
                                      const SubdivisionSettings& settings,
                                      const RefineLimits& limits, Progress& progress,
                                      const RefineHooks& hooks) {
  const RefinementPrediction prediction = predict_refinement(mesh, labels, limits.levels);
  const std::uint64_t budget = std::min(limits.face_budget, kMostFaces);
  if (prediction.faces > budget) {
    return over_budget(prediction, budget);
  }
  VertexLabels steps(labels.size());
  std::ranges::transform(labels, steps.begin(), [&](std::uint8_t label) {
    return static_cast<std::uint8_t>(std::min<int>(label, limits.levels));
  });
  const GeometryRules rules{settings.corners, hooks.faults};
  RefinedMesh output = allocate_output(mesh, steps, prediction);
  Refinement refinement(prediction, rules, progress, hooks);
  if (!refinement.run(mesh, seed_level(mesh, steps, output.origin), output)) {
    return fail(ErrorKind::kCancelled, "The refinement was cancelled.");
  }
  LIMN_ASSERT(greatest_level_difference(output) <= 1);
  return output;
}

}  // namespace limn
