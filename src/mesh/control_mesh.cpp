// Flattens OpenMesh's links once: corners are numbered face by face, and a half-edge with a face is
// the corner it leaves from.
#include "limn/mesh/control_mesh.h"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "limn/contract.h"
#include "mesh/flat_topology.h"

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
    const auto opposite = mesh.opposite_halfedge_handle(halfedge);
    if (halfedge_corners[index_of(opposite)] < halfedge_corners[index_of(halfedge)]) {
      halfedge = opposite;
    }
    flat.edge_vertices.push_back(
        {index_of(mesh.from_vertex_handle(halfedge)), index_of(mesh.to_vertex_handle(halfedge))});
    flat.edge_corners.push_back(
        {halfedge_corners[index_of(halfedge)],
         halfedge_corners[index_of(mesh.opposite_halfedge_handle(halfedge))]});
  }
}

}  // namespace

glm::dvec3 Bounds::centre() const noexcept {
  return low + 0.5 * (high - low);
}

double Bounds::diagonal() const noexcept {
  return glm::length(high - low);
}

ControlMesh::ControlMesh(HalfedgeMesh mesh, MeshAttributes attributes) {
  // Copied when it is made: where memory runs out while OpenMesh assigns one mesh to another, both
  // own the same arrays.
  const std::shared_ptr<Surface> surface(new Surface{mesh, {}, {}, {}, false, false});
  FlatTopology& topology = surface->topology;
  const HalfedgeMesh& halfedges = surface->halfedges;
  const std::vector<std::uint32_t> halfedge_corners = flatten_faces(halfedges, topology);
  flatten_edges(halfedges, halfedge_corners, topology);
  detail::complete_topology(topology, halfedges.n_vertices());

  surface->positions.reserve(halfedges.n_vertices());
  for (const auto vertex : halfedges.vertices()) {
    const auto& p = halfedges.point(vertex);
    surface->positions.emplace_back(p[0], p[1], p[2]);
  }
  if (!surface->positions.empty()) {
    Bounds& bounds = surface->bounds;
    bounds = {surface->positions.front(), surface->positions.front()};
    for (const glm::dvec3& p : surface->positions) {
      bounds.low = glm::min(bounds.low, p);
      bounds.high = glm::max(bounds.high, p);
    }
  }
  surface->is_all_quads = std::ranges::adjacent_find(topology.face_offsets, [](auto a, auto b) {
                            return b - a != 4;
                          }) == topology.face_offsets.end();
  surface->is_closed = std::ranges::all_of(topology.edge_corners,
                                           [](const auto& corners) { return corners[1] != kNone; });
  *this = ControlMesh(surface, std::move(attributes));
}

ControlMesh::ControlMesh(std::shared_ptr<const Surface> surface, MeshAttributes attributes)
    : surface_(std::move(surface)), attributes_(std::move(attributes)) {
  const auto fits = [](const auto& array, std::size_t size) {
    return array.empty() || array.size() == size;
  };
  LIMN_EXPECTS(fits(creases().edge_sharpness, edge_count()));
  LIMN_EXPECTS(fits(creases().vertex_sharpness, vertex_count()));
  LIMN_EXPECTS(fits(texture().corner_values, topology().corner_vertices.size()));
  if (!texture().empty()) {
    texture_surface_ =
        std::make_shared<const TextureSurface>(make_texture_surface(topology(), texture()));
  }
}

ControlMesh ControlMesh::with_attributes(MeshAttributes attributes) const {
  return {surface_, std::move(attributes)};
}

std::span<const std::uint32_t> ControlMesh::face(std::size_t f) const noexcept {
  const FlatTopology& flat = topology();
  const std::uint32_t begin = flat.face_offsets[f];
  return std::span(flat.corner_vertices).subspan(begin, flat.face_offsets[f + 1] - begin);
}

}  // namespace limn
