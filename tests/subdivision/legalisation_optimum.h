#pragma once

#include <cstdint>
#include <optional>

#include "limn/mesh/control_mesh.h"
#include "limn/subdivision/labels.h"

namespace limn::test {

/// What an optimum is least in.
enum class LegalisationGoal {
  kRelabels,  ///< Vertices raised.
  kFaces,     ///< Faces of the refined mesh.
};

struct OptimalLegalisation {
  VertexLabels labels;         ///< Of one optimum.
  std::uint64_t relabels = 0;  ///< Vertices it raises.
  std::uint64_t faces = 0;     ///< Faces of its refined mesh.
};

/// The best legal labels that raise zeros of `labels` (which satisfy `rule`) to 1 and leave what is
/// positive alone. Faces with two opposite zeros are legal.
///
/// Exact: variable elimination over the zero vertices, so the time grows with 2^width of the mesh,
/// not with its size. Nothing if a table would have more than 2^`most_width` entries.
[[nodiscard]] std::optional<OptimalLegalisation> optimal_legalisation(const ControlMesh& mesh,
                                                                      const VertexLabels& labels,
                                                                      NonQuadRule rule,
                                                                      LegalisationGoal goal,
                                                                      std::size_t most_width = 20);

}  // namespace limn::test
