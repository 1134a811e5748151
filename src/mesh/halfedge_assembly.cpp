// The links are written straight into OpenMesh's kernel. Its add_face would meet, on the way to a
// perfectly good mesh, vertices with several fans that later faces join; it then refuses the face
// ("complex vertex", "patch re-linking failed"), depending on the order of the faces.
//
//        v                    corner c at u: half-edge u -> v, face on its left.
//   <----+----<               Beyond a boundary edge the opposite half-edge has no face; its next
//   is
//        | |                  the only half-edge without face that leaves u, since u has one fan.
//     c  | | opposite
//        | v
//   >----+---->
//        u
#include "mesh/halfedge_assembly.h"

#include <limits>
#include <vector>

#include <fmt/format.h>

#include "limn/contract.h"
#include "limn/mesh/control_mesh.h"

namespace limn::detail {

Result<void> check_halfedge_limits(std::size_t vertices, std::size_t edges, std::size_t faces) {
  constexpr std::size_t most_handles = std::numeric_limits<int>::max();
  constexpr std::size_t most_edges = most_handles / 2;  // Two half-edges each.
  if (vertices <= most_handles && edges <= most_edges && faces <= most_handles) {
    return {};
  }
  return fail(
      ErrorKind::kBadInput,
      fmt::format("The mesh has {} vertices, {} edges and {} faces; the most a control mesh "
                  "can have are {} vertices, {} edges and {} faces.",
                  vertices, edges, faces, most_handles, most_edges, most_handles));
}

HalfedgeMesh assemble_halfedges(const FaceArrays& faces, const EdgeMatching& edges) {
  using OpenMesh::FaceHandle;
  using OpenMesh::HalfedgeHandle;
  using OpenMesh::VertexHandle;

  HalfedgeMesh mesh;
  mesh.resize(faces.vertex_count, edges.edge_corners.size(), faces.face_count());
  const auto halfedge_of = [&](std::uint32_t c) {
    const std::uint32_t e = edges.corner_edges[c];
    const std::uint32_t side = edges.edge_corners[e][0] == c ? 0 : 1;
    return HalfedgeHandle(static_cast<int>(2 * e + side));
  };

  std::vector<HalfedgeHandle> outgoing(faces.vertex_count);
  for (std::size_t f = 0; f < faces.face_count(); ++f) {
    const FaceHandle face(static_cast<int>(f));
    const std::uint32_t end = faces.offsets[f + 1];
    HalfedgeHandle last = halfedge_of(end - 1);
    // OpenMesh's face circulators begin where this half-edge ends.
    mesh.set_halfedge_handle(face, last);
    for (std::uint32_t c = faces.offsets[f]; c < end; ++c) {
      const HalfedgeHandle here = halfedge_of(c);
      const VertexHandle from(static_cast<int>(faces.vertices[c]));
      mesh.set_face_handle(here, face);
      mesh.set_vertex_handle(last, from);
      mesh.set_next_halfedge_handle(last, here);
      if (!mesh.halfedge_handle(from).is_valid()) {
        mesh.set_halfedge_handle(from, here);
      }
      last = here;
    }
  }

  for (const auto& pair : edges.edge_corners) {
    if (pair[1] == kNone) {
      const HalfedgeHandle inner = halfedge_of(pair[0]);
      const HalfedgeHandle outer = mesh.opposite_halfedge_handle(inner);
      const VertexHandle from = mesh.to_vertex_handle(inner);
      mesh.set_vertex_handle(outer, VertexHandle(static_cast<int>(faces.vertices[pair[0]])));
      mesh.set_halfedge_handle(from, outer);
      LIMN_EXPECTS(!outgoing[static_cast<std::size_t>(from.idx())].is_valid());
      outgoing[static_cast<std::size_t>(from.idx())] = outer;
    }
  }
  for (const auto& pair : edges.edge_corners) {
    if (pair[1] == kNone) {
      const HalfedgeHandle outer = mesh.opposite_halfedge_handle(halfedge_of(pair[0]));
      const auto to = static_cast<std::size_t>(mesh.to_vertex_handle(outer).idx());
      mesh.set_next_halfedge_handle(outer, outgoing[to]);
    }
  }
  return mesh;
}

}  // namespace limn::detail
