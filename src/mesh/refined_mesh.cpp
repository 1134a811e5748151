// The half-edge mesh goes through the same matching and assembly as a control mesh; a refinement is
// a manifold by construction, so what would be an error there is a bug here.
#include "limn/mesh/refined_mesh.h"

#include "limn/contract.h"
#include "limn/mesh/control_mesh.h"
#include "mesh/edge_matching.h"
#include "mesh/halfedge_assembly.h"

namespace limn {
namespace {

template <class Array>
std::size_t bytes_of(const Array& array) {
  return array.size() * sizeof(typename Array::value_type);
}

}  // namespace

std::span<const std::uint32_t> RefinedMesh::face(std::size_t f) const noexcept {
  if (f < quads.size()) {
    return quads[f];
  }
  const std::size_t polygon = f - quads.size();
  const std::uint32_t begin = polygon_offsets[polygon];
  return std::span(polygon_vertices).subspan(begin, polygon_offsets[polygon + 1] - begin);
}

std::size_t RefinedMesh::bytes() const noexcept {
  return bytes_of(positions) + bytes_of(vertex_levels) + bytes_of(quads) +
         bytes_of(polygon_offsets) + bytes_of(polygon_vertices) + bytes_of(face_control_faces) +
         bytes_of(face_levels);
}

HalfedgeMesh to_halfedge_mesh(const RefinedMesh& mesh) {
  std::vector<std::uint32_t> offsets(mesh.face_count() + 1, 0);
  std::vector<std::uint32_t> vertices;
  vertices.reserve(4 * mesh.quads.size() + mesh.polygon_vertices.size());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face(f);
    vertices.insert(vertices.end(), corners.begin(), corners.end());
    offsets[f + 1] = static_cast<std::uint32_t>(vertices.size());
  }
  const detail::FaceArrays faces{offsets, vertices, mesh.vertex_count()};
  const detail::EdgeMatching edges = detail::match_edges(faces);
  LIMN_EXPECTS(edges.crowded_corner == kNone);
  LIMN_EXPECTS(detail::check_halfedge_limits(mesh.vertex_count(), edges.edge_corners.size(),
                                             mesh.face_count())
                   .has_value());

  HalfedgeMesh halfedges = detail::assemble_halfedges(faces, edges);
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const glm::dvec3 p = mesh.position(v);
    halfedges.set_point(OpenMesh::VertexHandle(static_cast<int>(v)), {p.x, p.y, p.z});
  }
  return halfedges;
}

}  // namespace limn
