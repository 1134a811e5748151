#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "limn/mesh/control_mesh.h"
#include "limn/painting/auto_depth/budget.h"
#include "limn/painting/face_depths.h"
#include "limn/subdivision/face_errors.h"

// What a budget can be spent on. Internal to this folder.
namespace limn {

/// One face, one level deeper.
struct BudgetStep {
  float gain = 0.0F;  ///< Per face added.
  std::uint32_t face = 0;
  std::uint8_t depth = 0;  ///< Afterwards.
};

/// Faces that a step adds, by itself.
[[nodiscard]] inline std::uint64_t cost_of(const BudgetStep& step) noexcept {
  return std::uint64_t{3} << (2 * (step.depth - 1));
}

/// How deep a single face could go, all others staying as they are.
[[nodiscard]] int deepest_affordable(const ControlMesh& mesh, std::uint64_t most) noexcept;

/// The area of every face: of the triangles around its first corner, added as vectors.
[[nodiscard]] std::vector<double> face_areas(const ControlMesh& mesh);

/// What steps gain.
struct BudgetGains {
  const ControlMesh* mesh = nullptr;
  FaceBudget budget;
  int first_step = 0;  ///< Levels that come with the first step of a face.
  std::span<const LevelErrors> errors;
  std::span<const double> areas;
};

/// Steps of all faces, the most rewarding first, until they cost so much or there are no more; of
/// each face they are in order. By classes of gains that differ by less than a hundredth, so in
/// linear time; whatever is no longer needed then is not looked at for long.
[[nodiscard]] std::vector<BudgetStep> most_rewarding(const BudgetGains& gains, std::uint64_t cost);

/// Depths once these steps are made.
[[nodiscard]] FaceDepths depths_after(std::span<const BudgetStep> steps, std::size_t faces);

}  // namespace limn
