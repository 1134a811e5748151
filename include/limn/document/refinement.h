#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "limn/document/document.h"
#include "limn/error.h"
#include "limn/mesh/refined_mesh.h"
#include "limn/progress.h"
#include "limn/subdivision/crack_check.h"
#include "limn/subdivision/legalisation.h"
#include "limn/subdivision/prediction.h"

namespace limn {

/// Everything derived from a control mesh and its painting, for the window and the command line
/// alike.
struct Refinement {
  VertexLabels painted_labels;  ///< L(v) with the rule for non-quads, before legalisation.
  std::vector<std::uint32_t> illegal_faces_before;     ///< Under `painted_labels`.
  std::vector<std::uint32_t> illegal_vertices_before;  ///< Likewise.
  Legalisation legalisation;
  RefinementPrediction prediction;  ///< For the levels asked for; equals what `mesh` holds.
  std::shared_ptr<const RefinedMesh>
      mesh;           ///< Null where `levels` is 0: the control mesh itself is shown.
  CrackCheck cracks;  ///< Of `mesh`; empty where that is null.
  double legalise_seconds = 0.0;
  double refine_seconds = 0.0;
  double check_seconds = 0.0;
};

struct RefinementRequest {
  SubdivisionSettings settings;
  int levels = kAllLevels;  ///< 0 derives labels, legalisation and prediction only.
  std::uint64_t face_budget = std::numeric_limits<std::uint64_t>::max();
};

/// Labels, legalises, predicts, refines and checks, reporting one progress over all of it.
/// `depths` has one entry per face of `control`.
/// Errors: kOverBudget (with the exact count, before the refinement), kCancelled.
[[nodiscard]] Result<Refinement> derive_refinement(const ControlMesh& control,
                                                   std::span<const std::uint8_t> depths,
                                                   const RefinementRequest& request,
                                                   Progress& progress);

}  // namespace limn
