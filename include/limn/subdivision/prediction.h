#pragma once

#include <cstdint>

#include "limn/mesh/control_mesh.h"
#include "limn/subdivision/fine_labels.h"
#include "limn/subdivision/labels.h"

namespace limn {

/// "All levels the labels ask for."
inline constexpr int kAllLevels = 255;

/// What a refinement will produce, known exactly before it runs.
struct RefinementPrediction {
  std::uint64_t faces = 0;
  std::uint64_t vertices = 0;
  std::uint64_t edges = 0;
  std::uint64_t bytes = 0;  ///< Of the RefinedMesh's arrays, creases, corners, boundary edges and
                            ///< normals aside.
  std::uint64_t uniform_faces = 0;  ///< Of uniform Catmull-Clark at the same greatest level.
  int levels = 0;                   ///< Steps that will be made.
};

/// Counts by the recursion of the face patterns, with one table entry per label quadruple: the time
/// is linear in the control mesh, whatever the depth. Counts saturate at 2^64 - 1.
/// `labels` must be legal; `levels` stops after so many steps. `fine`: labels of finer levels,
/// found together with those of the control mesh; the time is linear in these, too.
[[nodiscard]] RefinementPrediction predict_refinement(const ControlMesh& mesh,
                                                      const VertexLabels& labels,
                                                      int levels = kAllLevels,
                                                      const FineLabels* fine = nullptr);

/// What labels lead to that are not legal yet.
struct PaintedCounts {
  std::uint64_t faces = 0;  ///< Illegal quads count as split, which they will be.
  std::uint64_t illegal_quads = 0;
};

/// Where legalising would take too long. `labels` are any, but faces that are no quads have labels
/// that are positive throughout, or none.
[[nodiscard]] PaintedCounts count_painted(const ControlMesh& mesh, const VertexLabels& labels);

}  // namespace limn
