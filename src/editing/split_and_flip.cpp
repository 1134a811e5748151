// A triangle is cut three times by the splits of its edges, and of the three cuts the first alone
// ends in an old vertex. Flipping that one leaves the four triangles of Loop's scheme:
//
//             c                     c                     c
//           / | \                 / | \                 /   \              .
//         /   |   \             /   |   \             /       \            .
//        /    |    \    =>    ca    |    bc   =>    ca---------bc
//       /     |     \         /  \  |  /  \         /  \     /  \          .
//      a-----ab-----b        a-----ab-----b        a-----ab-----b
//         first split            all splits         ab-c flipped
//
// Every split and flip is local, so the whole takes time linear in the mesh.
#include <utility>

#include <fmt/format.h>

#include "editing/loop_step.h"
#include "editing/surgery.h"
#include "editing/triangles_only.h"
#include "limn/contract.h"
#include "limn/editing/edge_edits.h"

namespace limn {

Result<std::shared_ptr<const ControlMesh>> upsample_by_split_and_flip(const ControlMesh& mesh,
                                                                      CornerRule corners) {
  if (auto triangles = check_triangles(mesh); !triangles) {
    return tl::unexpected(std::move(triangles.error()));
  }
  const FlatTopology& flat = mesh.topology();
  const auto old_vertices = static_cast<std::uint32_t>(mesh.vertex_count());
  LoopStep placed = loop_step(mesh, corners);

  Surgery surgery(mesh);
  std::vector<std::uint32_t> spokes_to_old;
  spokes_to_old.reserve(mesh.face_count());
  for (std::uint32_t e = 0; e < mesh.edge_count(); ++e) {
    const std::uint32_t corner = flat.edge_corners[e][0];
    if (const auto reason = surgery.why_not_split(corner)) {
      return fail(ErrorKind::kFailed,
                  fmt::format("The edge between vertices {} and {} cannot be split: {}.",
                              surgery.from(corner), surgery.to(corner), *reason));
    }
    const Surgery::Split split = surgery.split(corner);
    surgery.set_sharpness(corner, placed.half_sharpness[e][0]);
    surgery.set_sharpness(split.rest, placed.half_sharpness[e][1]);
    for (const std::uint32_t spoke : split.spokes) {
      if (spoke != kNone && surgery.to(spoke) < old_vertices) {
        spokes_to_old.push_back(spoke);
      }
    }
  }
  for (const std::uint32_t spoke : spokes_to_old) {
    LIMN_EXPECTS(!surgery.why_not_flip(spoke));
    surgery.flip(spoke);
  }
  surgery.move_vertices(std::move(placed.positions));
  surgery.set_vertex_sharpness(std::move(placed.vertex_sharpness));
  return surgery.finish();
}

}  // namespace limn
