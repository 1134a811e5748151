#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/mesh/refined_mesh.h"
#include "limn/progress.h"
#include "limn/subdivision/crack_check.h"
#include "limn/subdivision/fine_labels.h"
#include "limn/subdivision/label_subdivision.h"
#include "limn/subdivision/legalisation.h"
#include "limn/subdivision/prediction.h"

/// From a painting to its refinement in two stages, for the window and the command line alike: the
/// labels are known long before the refined mesh.
namespace limn {

/// What a painting asks for, before anything is subdivided. Under RefinementScheme::kLoop nothing
/// is illegal; faces are deepened instead until neighbours are one level apart at most.
struct DerivedLabels {
  VertexLabels painted;                         ///< L(v) with the rule for non-quads.
  std::vector<std::uint32_t> illegal_faces;     ///< Under `painted`, ascending.
  std::vector<std::uint32_t> illegal_vertices;  ///< Likewise.
  Legalisation legal;
  /// Vertices that legalisation raised from 0, ascending: those its steps chose and, where faces
  /// that are no quads were raised with them, their other vertices.
  std::vector<std::uint32_t> raised_vertices;
  /// Labels of finer levels; null where nothing is demanded there, and for kLoop.
  std::shared_ptr<const FineLabels> fine;
  /// kLoop alone: balanced, one per face, and how many faces are deeper than painted.
  std::vector<std::uint8_t> face_depths;
  std::size_t deepened_faces = 0;
  RefinementPrediction prediction;  ///< Of all the levels the labels ask for.
  double seconds = 0.0;
};

/// Labels, legalises (or balances) and predicts. `depths` has one entry per face of `control`.
/// `demands` on finer faces are valid there; Loop has no such faces and passes over them.
/// Errors: kCancelled; kFailed where kLoop cannot take the mesh (`check_fits`).
[[nodiscard]] Result<DerivedLabels> derive_labels(const ControlMesh& control,
                                                  std::span<const std::uint8_t> depths,
                                                  const SubdivisionSettings& settings,
                                                  Progress& progress,
                                                  const FineDemands& demands = {});

/// The legal labels of a refinement that stops after so many levels.
[[nodiscard]] VertexLabels labels_up_to(const DerivedLabels& labels, int levels);

/// The refined mesh of a painting and what was found out about it.
struct Refinement {
  std::shared_ptr<const RefinedMesh> mesh;
  RefinementPrediction prediction;  ///< For the levels asked for; equals what `mesh` holds.
  CrackCheck cracks;
  double refine_seconds = 0.0;
  double check_seconds = 0.0;
};

/// How far a refinement goes: the rules, the steps and the most faces it may make.
struct RefinementOptions {
  SubdivisionSettings settings;
  int levels = kAllLevels;  ///< 1..kAllLevels.
  std::uint64_t face_budget = std::numeric_limits<std::uint64_t>::max();
  /// Most bytes that the refined mesh may have; see memory_budget.h.
  std::uint64_t memory_budget = std::numeric_limits<std::uint64_t>::max();
};

/// What `derive_refinement` will give after so many levels. Its `bytes` are those of the refined
/// mesh, the normals included; what is still sharp comes on top. For kLoop they are right to a few
/// per cent.
[[nodiscard]] RefinementPrediction predict_derived(const ControlMesh& control,
                                                   const DerivedLabels& labels, int levels);

/// Predicts, refines and checks, under one progress. `labels` come from `derive_labels` with the
/// same settings.
/// Errors: kOverBudget (with the exact count of faces or bytes, before any work), kCancelled.
[[nodiscard]] Result<Refinement> derive_refinement(const ControlMesh& control,
                                                   const DerivedLabels& labels,
                                                   const RefinementOptions& options,
                                                   Progress& progress);

/// `derive_refinement` for those who do it again and again, while an artist paints: it keeps its
/// working memory, and that of a refined mesh which nobody holds any more. For one thread at a
/// time; what it hands out may be let go of on any.
class RefinementSource {
 public:
  RefinementSource();
  ~RefinementSource();
  RefinementSource(const RefinementSource&) = delete;
  RefinementSource& operator=(const RefinementSource&) = delete;

  /// As `derive_refinement`.
  [[nodiscard]] Result<Refinement> derive(const ControlMesh& control, const DerivedLabels& labels,
                                          const RefinementOptions& options, Progress& progress);

 private:
  struct Spare;
  [[nodiscard]] Result<void> refine(const ControlMesh& control, const DerivedLabels& labels,
                                    const RefinementOptions& options, Progress& progress,
                                    RefinedMesh& mesh);

  Refiner refiner_;
  CrackChecker checker_;
  std::shared_ptr<Spare> spare_;
};

}  // namespace limn
