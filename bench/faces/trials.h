#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "limn/mesh/control_mesh.h"
#include "limn/painting/auto_depth/budget.h"
#include "limn/painting/face_depths.h"
#include "limn/subdivision/labels.h"
#include "limn/subdivision/settings.h"

namespace limn::bench {

/// A refined mesh, and how far it is from the limit surface as measured, in diagonals.
struct Trial {
  double asked = 0.0;  ///< The level, the tolerance in diagonals or the budget it came from.
  std::uint64_t faces = 0;
  double greatest = 0.0;
  double root_mean_square = 0.0;
};

/// What is compared.
enum class Figure { kGreatest, kRootMeanSquare };

[[nodiscard]] double figure_of(const Trial& trial, Figure figure) noexcept;

/// A control mesh and the settings it is refined with.
struct Subject {
  const ControlMesh* mesh = nullptr;
  SubdivisionSettings settings;
};

/// Refines from legal labels and measures. `of_faces`, if asked for, gets each control face's
/// greatest distance, in mesh units.
[[nodiscard]] Trial measure(const Subject& subject, const VertexLabels& labels,
                            std::vector<double>* of_faces = nullptr);

/// All faces refined by so many levels.
[[nodiscard]] Trial try_uniform(const Subject& subject, int level);
/// A tolerance in diagonals.
[[nodiscard]] Trial try_tolerance(const Subject& subject, double tolerance);
/// The same, measured while depths are chosen.
[[nodiscard]] Trial try_measured_tolerance(const Subject& subject, double tolerance);
/// A number of faces.
[[nodiscard]] Trial try_budget(const Subject& subject, std::uint64_t faces, FaceBudget::Goal goal);

/// Looks for the fewest faces with which `figure` is at most `target` (in diagonals), with some
/// tolerances, or some budgets from `faces` on. All that was tried is added to `trials`. The target
/// is about that of the uniform mesh of a level.
void approach_by_tolerance(const Subject& subject, Figure figure, double target, int level,
                           std::vector<Trial>& trials);
void approach_by_budget(const Subject& subject, Figure figure, double target, std::uint64_t faces,
                        std::vector<Trial>& trials);

/// The one with the fewest faces of those that keep to a target; null where none does.
[[nodiscard]] const Trial* fewest_faces(const std::vector<Trial>& trials, Figure figure,
                                        double target) noexcept;

}  // namespace limn::bench
