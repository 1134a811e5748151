// Flattens OpenMesh's links once: corners are numbered face by face, and a half-edge with a face is
// the corner it leaves from.
#include "limn/mesh/control_mesh.h"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "limn/contract.h"

namespace limn {
namespace {

template <class Handle>
std::uint32_t index_of(const Handle& handle) {
  return static_cast<std::uint32_t>(handle.idx());
}

/// Faces, their corners, and for each half-edge the corner it leaves from (kNone without a face).
std::vector<std::uint32_t> flatten_faces(const HalfedgeMesh& mesh, FlatTopology& flat) {
  flat.face_offsets.reserve(mesh.n_faces() + 1);
  flat.face_offsets.push_back(0);
  flat.corner_vertices.reserve(mesh.n_halfedges());
  flat.corner_edges.reserve(mesh.n_halfedges());
  flat.corner_faces.reserve(mesh.n_halfedges());
  std::vector<std::uint32_t> halfedge_corners(mesh.n_halfedges(), kNone);
  for (const auto face : mesh.faces()) {
    // OpenMesh keeps for a face the half-edge that ends at its first vertex.
    const auto first = mesh.next_halfedge_handle(mesh.halfedge_handle(face));
    for (const auto halfedge : mesh.hl_range(first)) {
      halfedge_corners[index_of(halfedge)] = static_cast<std::uint32_t>(flat.corner_edges.size());
      flat.corner_vertices.push_back(index_of(mesh.from_vertex_handle(halfedge)));
      flat.corner_edges.push_back(index_of(mesh.edge_handle(halfedge)));
      flat.corner_faces.push_back(index_of(face));
    }
    flat.face_offsets.push_back(static_cast<std::uint32_t>(flat.corner_edges.size()));
  }
  return halfedge_corners;
}

void flatten_edges(const HalfedgeMesh& mesh, const std::vector<std::uint32_t>& halfedge_corners,
                   FlatTopology& flat) {
  flat.edge_vertices.reserve(mesh.n_edges());
  flat.edge_corners.reserve(mesh.n_edges());
  for (const auto edge : mesh.edges()) {
    auto halfedge = mesh.halfedge_handle(edge, 0);
    if (mesh.is_boundary(halfedge)) {
      halfedge = mesh.opposite_halfedge_handle(halfedge);
    }
    LIMN_EXPECTS(!mesh.is_boundary(halfedge));
    flat.edge_vertices.push_back(
        {index_of(mesh.from_vertex_handle(halfedge)), index_of(mesh.to_vertex_handle(halfedge))});
    flat.edge_corners.push_back(
        {halfedge_corners[index_of(halfedge)],
         halfedge_corners[index_of(mesh.opposite_halfedge_handle(halfedge))]});
  }
}

void flatten_vertices(const HalfedgeMesh& mesh, const std::vector<std::uint32_t>& halfedge_corners,
                      FlatTopology& flat) {
  flat.vertex_offsets.reserve(mesh.n_vertices() + 1);
  flat.vertex_offsets.push_back(0);
  flat.vertex_corners.reserve(flat.corner_vertices.size());
  for (const auto vertex : mesh.vertices()) {
    LIMN_EXPECTS(!mesh.is_isolated(vertex));
    // At a boundary vertex OpenMesh starts with the half-edge that has no face, so that what
    // follows runs from one boundary edge to the other.
    for (const auto halfedge : mesh.voh_ccw_range(vertex)) {
      if (const std::uint32_t corner = halfedge_corners[index_of(halfedge)]; corner != kNone) {
        flat.vertex_corners.push_back(corner);
      }
    }
    flat.vertex_offsets.push_back(static_cast<std::uint32_t>(flat.vertex_corners.size()));
  }
  // A vertex with several fans of faces would have left corners out.
  LIMN_EXPECTS(flat.vertex_corners.size() == flat.corner_vertices.size());
}

}  // namespace

glm::dvec3 Bounds::centre() const noexcept {
  return low + 0.5 * (high - low);
}

double Bounds::diagonal() const noexcept {
  return glm::length(high - low);
}

ControlMesh::ControlMesh(HalfedgeMesh mesh) : mesh_(std::move(mesh)) {
  const std::vector<std::uint32_t> halfedge_corners = flatten_faces(mesh_, topology_);
  flatten_edges(mesh_, halfedge_corners, topology_);
  flatten_vertices(mesh_, halfedge_corners, topology_);

  positions_.reserve(mesh_.n_vertices());
  for (const auto vertex : mesh_.vertices()) {
    const auto& p = mesh_.point(vertex);
    positions_.emplace_back(p[0], p[1], p[2]);
  }
  if (!positions_.empty()) {
    bounds_ = {positions_.front(), positions_.front()};
    for (const glm::dvec3& p : positions_) {
      bounds_.low = glm::min(bounds_.low, p);
      bounds_.high = glm::max(bounds_.high, p);
    }
  }
  is_all_quads_ = true;
  for (std::size_t f = 0; f < face_count() && is_all_quads_; ++f) {
    is_all_quads_ = topology_.face_offsets[f + 1] - topology_.face_offsets[f] == 4;
  }
  is_closed_ = std::all_of(topology_.edge_corners.begin(), topology_.edge_corners.end(),
                           [](const auto& corners) { return corners[1] != kNone; });
}

std::span<const std::uint32_t> ControlMesh::face(std::size_t f) const noexcept {
  const std::uint32_t begin = topology_.face_offsets[f];
  return std::span(topology_.corner_vertices).subspan(begin, topology_.face_offsets[f + 1] - begin);
}

}  // namespace limn
