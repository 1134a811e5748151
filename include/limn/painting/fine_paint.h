#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "limn/mesh/control_mesh.h"
#include "limn/mesh/refined_mesh.h"
#include "limn/painting/depth_change.h"
#include "limn/painting/face_depths.h"
#include "limn/subdivision/fine_demands.h"
#include "limn/subdivision/fine_places.h"
#include "limn/subdivision/settings.h"

/// Painting on faces of a refined mesh instead of on control faces. Such a face has a name that
/// holds for every refinement of its control mesh (`places_of`), so what is painted does not hang
/// on how far the refined mesh one paints on has kept up.
namespace limn {

/// All that is painted on a control mesh; borrowed.
struct Painting {
  const ControlMesh& mesh;
  const FaceDepths& depths;
  const FineDemands& demands;
  NonQuadRule non_quads = NonQuadRule::kUniformFirstStep;
};

/// The depth asked for at a face: its control face's, or that of a demand on it or on a face that
/// it lies in, less the level that the rule for non-quads adds to every depth. A face may be finer
/// than that, for the sake of its neighbours.
[[nodiscard]] int depth_asked(const Painting& painting, const FineFace& face);

/// For each face of a refined mesh the depth that demands ask of it, counted likewise; 0 where none
/// does. `from` is the painting's refinement. Time is linear in the refined faces of those control
/// faces that have demands, but for a logarithm.
[[nodiscard]] std::vector<std::uint8_t> demanded_depths(const Painting& painting,
                                                        const RefinedFrom& from,
                                                        const RefinedMesh& refined);

/// What painting makes of depths and demands, and of how many of the faces painted on.
struct FineEdits {
  std::vector<DepthEdit> depths;  ///< By ascending face.
  DemandEdits demands;
  std::size_t faces = 0;       ///< That are asked for other than before.
  std::optional<int> depth{};  ///< That all of these get; nothing where it differs.

  [[nodiscard]] bool empty() const noexcept { return depths.empty() && demands.empty(); }
};

/// The edits of one stroke over faces of a refined mesh, all seen as they were before it. Those of
/// level 0 are control faces, still whole.
///
/// To add is to subdivide each face by so much more than it is. Faces that are lowered or set to
/// less are no longer asked for more than that, and all beside them stays as it is: what a control
/// face's depth, or a demand on a larger face, asked of the rest becomes demands on the rest. Four
/// faces that one face was split into go together, as far as nothing else holds them apart. A face
/// that is finer than anything asks for is not lowered; to set it to the level that it has holds it
/// there. Where a face and one that it lies in are both raised, more counts; raised counts before
/// lowered. Time is n log n in the faces and linear in the demands.
[[nodiscard]] FineEdits plan_fine_edits(const Painting& painting, std::span<const FineFace> faces,
                                        DepthChange change);

}  // namespace limn
