#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/mesh/refined_mesh.h"
#include "limn/progress.h"
#include "limn/subdivision/schemes/uniform.h"

namespace limn {

/// One level of a uniform scheme, as a course's exercise prints it.
struct SchemeStep {
  int level = 0;
  SchemeCounts counts;
  double seconds = 0.0;  ///< To make this level, of the one before; 0 for level 0.
};

/// What came of a uniform scheme.
struct SchemeRefinement {
  std::shared_ptr<const RefinedMesh> mesh;
  std::vector<SchemeStep> steps;  ///< Levels 0..n.
};

/// Subdivides a control mesh by a uniform scheme, level by level with the time each takes.
/// Errors: those of `subdivide`.
[[nodiscard]] Result<SchemeRefinement> derive_scheme(const ControlMesh& control,
                                                     const SchemeSettings& settings,
                                                     const UniformLimits& limits,
                                                     Progress& progress);

/// Memory that the refined mesh of such counts takes, for people to weigh: right to a few per cent.
[[nodiscard]] std::uint64_t scheme_bytes(const SchemeCounts& counts) noexcept;

}  // namespace limn
