// The half-edge mesh goes through the same matching and assembly as a control mesh; a refinement is
// a manifold by construction, so what would be an error there is a bug here.
#include "limn/mesh/refined_mesh.h"

#include "limn/contract.h"
#include "limn/mesh/control_mesh.h"
#include "mesh/attributes.h"
#include "mesh/edge_matching.h"
#include "mesh/halfedge_assembly.h"

namespace limn {
namespace {

template <class Array>
std::size_t bytes_of(const Array& array) {
  return array.size() * sizeof(typename Array::value_type);
}

/// Faces in one numbering, quads first, and their matched edges.
struct Matched {
  std::vector<std::uint32_t> offsets;
  std::vector<std::uint32_t> vertices;
  std::size_t vertex_count = 0;
  detail::EdgeMatching edges;

  [[nodiscard]] detail::FaceArrays arrays() const noexcept {
    return {offsets, vertices, vertex_count};
  }
};

Matched match(const RefinedMesh& mesh) {
  Matched matched;
  matched.offsets.assign(mesh.face_count() + 1, 0);
  matched.vertices.reserve(4 * mesh.quads.size() + mesh.polygon_vertices.size());
  matched.vertex_count = mesh.vertex_count();
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face(f);
    matched.vertices.insert(matched.vertices.end(), corners.begin(), corners.end());
    matched.offsets[f + 1] = static_cast<std::uint32_t>(matched.vertices.size());
  }
  matched.edges = detail::match_edges(matched.arrays());
  LIMN_EXPECTS(detail::check_halfedge_limits(mesh.vertex_count(), matched.edges.edge_corners.size(),
                                             mesh.face_count())
                   .has_value());
  return matched;
}

HalfedgeMesh assemble(const RefinedMesh& mesh, const Matched& matched) {
  HalfedgeMesh halfedges = detail::assemble_halfedges(matched.arrays(), matched.edges);
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const glm::dvec3 p = mesh.position(v);
    halfedges.set_point(OpenMesh::VertexHandle(static_cast<int>(v)), {p.x, p.y, p.z});
  }
  return halfedges;
}

Creases creases_of(const RefinedMesh& mesh, const Matched& matched) {
  Creases creases;
  creases.method = mesh.creasing;
  std::vector<CreaseTag> tags;
  tags.reserve(mesh.creases.size());
  for (const RefinedCrease& crease : mesh.creases) {
    tags.push_back({crease.vertices, crease.sharpness});
  }
  ImportReport report;
  creases.edge_sharpness = detail::edge_sharpness(tags, matched.arrays(), matched.edges, report);
  LIMN_EXPECTS(!report.is_mended());
  if (!mesh.corners.empty()) {
    creases.vertex_sharpness.assign(mesh.vertex_count(), 0.0f);
    for (const RefinedCorner& corner : mesh.corners) {
      LIMN_EXPECTS(corner.vertex < mesh.vertex_count());
      creases.vertex_sharpness[corner.vertex] = corner.sharpness;
    }
  }
  return creases;
}

TextureCoordinates texture_of(const RefinedMesh& mesh) {
  TextureCoordinates texture;
  texture.values.assign(mesh.uvs.begin(), mesh.uvs.end());
  texture.corner_values.reserve(4 * mesh.quad_uvs.size() + mesh.polygon_uvs.size());
  for (const auto& quad : mesh.quad_uvs) {
    texture.corner_values.insert(texture.corner_values.end(), quad.begin(), quad.end());
  }
  texture.corner_values.insert(texture.corner_values.end(), mesh.polygon_uvs.begin(),
                               mesh.polygon_uvs.end());
  return texture;
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
         bytes_of(face_levels) + bytes_of(normals) + bytes_of(uvs) + bytes_of(quad_uvs) +
         bytes_of(polygon_uvs) + bytes_of(creases) + bytes_of(corners) + bytes_of(boundary_edges);
}

HalfedgeMesh to_halfedge_mesh(const RefinedMesh& mesh) {
  return assemble(mesh, match(mesh));
}

std::shared_ptr<const ControlMesh> to_control_mesh(const RefinedMesh& mesh,
                                                   const ControlMesh* control) {
  const Matched matched = match(mesh);
  MeshAttributes attributes{creases_of(mesh, matched), mesh.corner_rule, texture_of(mesh), {}, {}};
  if (control != nullptr) {
    attributes.names = names_by_source(control->attributes().names, mesh.face_control_faces);
    attributes.loose_vertices = control->attributes().loose_vertices;
  }
  return std::make_shared<const ControlMesh>(assemble(mesh, matched), std::move(attributes));
}

}  // namespace limn
