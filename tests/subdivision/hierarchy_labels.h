#pragma once

#include <cstdint>
#include <string>

#include "limn/subdivision/fine_labels.h"
#include "support/opensubdiv_reference.h"
#include "support/shapes.h"

// Labels of finer levels, vertex by vertex on the uniform meshes.
namespace limn::test {

/// Random demands on faces of level 1 up to `deepest` - 1, of depths up to `deepest`.
[[nodiscard]] std::vector<FineDemand> random_demands(const ControlMesh& mesh, std::size_t count,
                                                     int deepest, Random& random);

/// The labels that the library gives every vertex of every level, as far as the hierarchy goes, and
/// what is wrong with them.
struct HierarchyLabels {
  LevelLabels labels;
  std::string breach;  ///< Empty if nothing is.
};

/// The number of a face of some level there.
[[nodiscard]] std::uint32_t find_face(const UniformHierarchy& hierarchy, const ControlMesh& mesh,
                                      const FineFace& face);

/// Depths and demands with what the library makes of them.
struct FinePainting {
  LabelsWithDemands labels;
  HierarchyLabels given;
};

/// Random demands up to the hierarchy's last level over some depths.
[[nodiscard]] FinePainting random_fine_painting(const UniformHierarchy& hierarchy,
                                                const ControlMesh& mesh,
                                                std::span<const std::uint8_t> depths,
                                                std::size_t demands,
                                                const SubdivisionSettings& settings,
                                                Random& random);

/// Spreads what `legal_labels` found over a whole hierarchy, whose mesh is `mesh`, and checks it by
/// definition: where the painted and demanded labels are positive they are unchanged, and the
/// others are 0 or 1; positive edge points have both ends positive, old vertices themselves, face
/// points their face split; and no quad has just two neighbouring positive labels.
[[nodiscard]] HierarchyLabels hierarchy_labels(const UniformHierarchy& hierarchy,
                                               const ControlMesh& mesh,
                                               std::span<const std::uint8_t> depths,
                                               const FineDemands& demands,
                                               const SubdivisionSettings& settings,
                                               const LabelsWithDemands& found);

}  // namespace limn::test
