#pragma once

#include <cstdint>
#include <functional>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/painting/auto_depth/tolerance.h"
#include "limn/painting/face_depths.h"
#include "limn/progress.h"
#include "limn/subdivision/settings.h"

namespace limn {

class FineDemands;

/// The most that a refined mesh may have, and what to make of it.
struct FaceBudget {
  enum class Unit { kFaces, kTriangles };
  enum class Goal {
    kMeanSquare,  ///< The least error over all of the surface: squares removed per face added.
    kGreatest,    ///< The least greatest error: whatever is worst comes next.
    kRandom,      ///< None: faces at random, always the same ones. What others are held against.
  };
  std::uint64_t most = 50'000;
  Unit unit = Unit::kFaces;
  Goal goal = Goal::kMeanSquare;

  [[nodiscard]] bool operator==(const FaceBudget&) const = default;
};

/// What becomes of depths that a budget proposes, before they are counted: they may be held to a
/// selection, or combined with what is painted.
using FinishDepths = std::function<FaceDepths(const FaceDepths& proposed)>;

/// What a budget is spent on.
struct BudgetTask {
  FaceBudget budget;
  FinishDepths finish;                   ///< Empty: depths are taken as proposed.
  const FineDemands* demands = nullptr;  ///< On finer faces; null: none.
};

/// Depths that were chosen, and how much the mesh they make has: faces or triangles, as asked.
struct BudgetedDepths {
  ChosenDepths chosen;  ///< As proposed, before they are finished.
  std::uint64_t count = 0;
};

/// Spends a budget: raises faces level by level in the order of what that gains until nothing more
/// fits. Faces are counted exactly, as refined from `finish(depths)` and the demands: with all that
/// labels, legalisation and faces that are no quads add. Never over the budget; the same depths for
/// the same question, on any number of threads.
///
/// What a level gains follows from `face_errors`, the error's square times the face's area; what it
/// costs are the three faces that each of the present ones then has more. So the order is known
/// beforehand, and how far it can be followed is foretold by counting labels that are not legal
/// yet, and found by counting what they become: once or twice as a rule, two dozen times at the
/// most, until no more than half a per cent of the budget is left, or one per cent on meshes of
/// more than 30,000 faces, where counting takes its time. Errors: kOverBudget where the mesh with
/// nothing proposed has more already; kCancelled; kUsage where the settings ask for Loop's scheme.
[[nodiscard]] Result<BudgetedDepths> depths_for_budget(const ControlMesh& mesh,
                                                       const SubdivisionSettings& settings,
                                                       const BudgetTask& task, Progress& progress);

}  // namespace limn
