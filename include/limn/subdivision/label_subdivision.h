#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/mesh/refined_mesh.h"
#include "limn/progress.h"
#include "limn/subdivision/fine_labels.h"
#include "limn/subdivision/labels.h"
#include "limn/subdivision/legalisation.h"
#include "limn/subdivision/prediction.h"
#include "limn/subdivision/settings.h"

namespace limn {

/// The labels a refinement runs on, and how they came about: L(v), the rule for non-quads, then
/// legalisation. `depths` has one entry per control face.
/// Errors: kCancelled.
[[nodiscard]] Result<Legalisation> legal_labels(const ControlMesh& mesh,
                                                std::span<const std::uint8_t> depths,
                                                const SubdivisionSettings& settings,
                                                Progress& progress);

/// Legalises labels that the rule for non-quads has gone over, by the method of the settings.
/// Errors: kCancelled.
[[nodiscard]] Result<Legalisation> legalise(const ControlMesh& mesh, VertexLabels labels,
                                            const SubdivisionSettings& settings,
                                            Progress& progress);

/// Where a refinement stops, where it is refused, and what it gives besides.
struct RefineLimits {
  int levels = kAllLevels;  ///< Stop after so many steps: 1 is "one level only".
  std::uint64_t face_budget = std::numeric_limits<std::uint64_t>::max();
  bool normals = false;              ///< Fill RefinedMesh::normals.
  const FineLabels* fine = nullptr;  ///< Labels of finer levels, found together with those of the
                                     ///< control mesh (`LabelsWithDemands`).
};

/// Label-driven adaptive Catmull-Clark subdivision (Yong & Cheng 2005, with Kobbelt's Y-elements).
///
/// `labels` must be legal (from `legal_labels`). Crack-free: an edge is split exactly when one of
/// its ends is positive. Exact: every vertex that was made or last moved at level k lies at its
/// position P_k of uniform Catmull-Clark, or with SurfacePoints::kLimit where these tend to.
/// Boundaries follow the cubic B-spline; the mesh's creases and corners hold for as many levels as
/// they are sharp (DeRose, Kass & Truong 1998). The same input gives the same bytes for any number
/// of threads. Time and memory are proportional to the output. Errors: kOverBudget (before any
/// work, with the exact count), kCancelled.
[[nodiscard]] Result<RefinedMesh> refine(const ControlMesh& mesh, const VertexLabels& labels,
                                         const SubdivisionSettings& settings,
                                         const RefineLimits& limits, Progress& progress);

/// `refine` for those who do it again and again, while an artist paints: it keeps its working
/// memory and writes into a result that is there already. A result that is large enough is not
/// allocated anew, and then nothing else is either.
class Refiner {
 public:
  Refiner();
  ~Refiner();
  Refiner(Refiner&&) noexcept;
  Refiner& operator=(Refiner&&) noexcept;

  /// Replaces the contents of `result`; after an error these are unspecified.
  [[nodiscard]] Result<void> refine(const ControlMesh& mesh, const VertexLabels& labels,
                                    const SubdivisionSettings& settings, const RefineLimits& limits,
                                    Progress& progress, RefinedMesh& result);

 private:
  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace limn
