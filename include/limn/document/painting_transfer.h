#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "limn/mesh/control_mesh.h"
#include "limn/painting/face_depths.h"

namespace limn {

/// A hash of which vertices each face has, by their numbers: equal for two meshes that differ in
/// positions and attributes alone.
[[nodiscard]] std::uint64_t topology_hash(const ControlMesh& mesh) noexcept;

/// How a painting found the faces it belongs to.
enum class FaceMatching : std::uint8_t {
  kVertices,  ///< By the positions of their vertices, whatever their order.
  kOrder,     ///< By their numbers: the faces are the same, the vertices have moved.
};

/// A painting on another mesh than it was made on.
struct PaintingTransfer {
  /// The other mesh with the creases, corners and rules of the painted one where it has none of its
  /// own.
  std::shared_ptr<const ControlMesh> mesh;
  FaceDepths depths;  ///< One per face of `mesh`.
  FaceMatching matching = FaceMatching::kVertices;
  std::vector<std::uint32_t> new_faces;   ///< Of `mesh`, ascending: unpainted, since none matches.
  std::vector<std::uint32_t> lost_faces;  ///< Painted before, ascending: in `mesh` no more.
  std::size_t kept_creases = 0;           ///< Sharp edges and vertices taken over,
  std::size_t lost_creases = 0;           ///< and those whose edge or vertex is no more.
};

/// Carries a painting over to a mesh that another program has written: the faces may stand in
/// another order and begin at another corner, vertices may be renumbered and their positions
/// rounded to single precision or to six decimals.
///
/// Two vertices are the same where they are nearest to each other and closer than 4e-6 times the
/// largest coordinate of either mesh (1 at the least), two faces where their vertices are; of
/// several such faces those that are turned the same way first, then in their order. Where that
/// leaves faces over and `topology_hash` is the same, faces keep their numbers instead. Time is n
/// log n. `depths` has one entry per face of `from`.
[[nodiscard]] PaintingTransfer transfer_painting(const ControlMesh& from,
                                                 std::span<const std::uint8_t> depths,
                                                 const std::shared_ptr<const ControlMesh>& to);

}  // namespace limn
