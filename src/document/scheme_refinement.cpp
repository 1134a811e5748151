#include "limn/document/scheme_refinement.h"

#include <chrono>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "limn/document/memory_budget.h"

namespace limn {
namespace {

/// Shows the work on one level as its part of the work on all, which grows with the faces.
class PartOfLevels final : public Progress {
 public:
  PartOfLevels(Progress& whole, const std::vector<SchemeCounts>& counts, int level)
      : whole_(whole) {
    double sum = 0.0;
    for (std::size_t k = 1; k < counts.size(); ++k) {
      const auto faces = static_cast<double>(counts[k].faces);
      before_ += static_cast<int>(k) < level ? faces : 0.0;
      this_ += static_cast<int>(k) == level ? faces : 0.0;
      sum += faces;
    }
    before_ /= sum;
    this_ /= sum;
  }

  [[nodiscard]] bool report(double fraction, std::string_view stage) override {
    return whole_.report(before_ + this_ * fraction, stage);
  }

 private:
  Progress& whole_;
  double before_ = 0.0;
  double this_ = 0.0;
};

std::uint64_t saturating_add(std::uint64_t a, std::uint64_t b) {
  return a > std::numeric_limits<std::uint64_t>::max() - b
             ? std::numeric_limits<std::uint64_t>::max()
             : a + b;
}

std::uint64_t saturating_multiply(std::uint64_t count, std::uint64_t bytes) {
  return count > std::numeric_limits<std::uint64_t>::max() / bytes
             ? std::numeric_limits<std::uint64_t>::max()
             : count * bytes;
}

}  // namespace

Result<SchemeRefinement> derive_scheme(const ControlMesh& control, const SchemeSettings& settings,
                                       const UniformLimits& limits, Progress& progress) {
  if (auto fits = check_fits(control, settings.scheme); !fits) {
    return tl::unexpected(std::move(fits.error()));
  }
  // Known before any work: a level that is too large is not to be reached by way of the others.
  const std::vector<SchemeCounts> counts = predict_scheme(control, settings, limits.levels);
  if (counts.back().faces > limits.face_budget) {
    return fail(ErrorKind::kOverBudget,
                fmt::format("Level {} has {} faces, more than {}.", limits.levels,
                            counts.back().faces, limits.face_budget));
  }
  if (const std::uint64_t bytes = scheme_bytes(counts.back()); bytes > limits.memory_budget) {
    return over_memory(counts.back().faces, bytes, limits.memory_budget);
  }
  SchemeRefinement derived;
  SchemeLevels levels(control, settings);
  derived.steps.push_back({0, levels.counts(), 0.0});
  while (levels.level() < limits.levels) {
    PartOfLevels part(progress, counts, levels.level() + 1);
    const auto start = std::chrono::steady_clock::now();
    if (auto advanced = levels.advance(limits.face_budget, part); !advanced) {
      return tl::unexpected(std::move(advanced.error()));
    }
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    derived.steps.push_back({levels.level(), levels.counts(), time.count()});
  }
  derived.mesh = std::make_shared<const RefinedMesh>(levels.mesh());
  return derived;
}

std::uint64_t scheme_bytes(const SchemeCounts& counts) noexcept {
  // A position and a level a vertex; a control face, a level and an offset a face; two corners an
  // edge.
  return saturating_add(saturating_add(saturating_multiply(counts.vertices, 13),
                                       saturating_multiply(counts.faces, 9)),
                        saturating_multiply(counts.edges, 8));
}

}  // namespace limn
