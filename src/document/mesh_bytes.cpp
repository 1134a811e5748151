#include "mesh_bytes.h"

#include <string>
#include <vector>

namespace limn {
namespace {

template <class T>
std::size_t array_bytes(const std::vector<T>& array) {
  return array.capacity() * sizeof(T);
}

template <class Iterator>
std::size_t property_bytes(Iterator first, Iterator last) {
  std::size_t bytes = 0;
  for (; first != last; ++first) {
    if (*first != nullptr) {
      bytes += (*first)->size_of();
    }
  }
  return bytes;
}

std::size_t text_bytes(const std::vector<std::string>& texts) {
  std::size_t bytes = array_bytes(texts);
  for (const std::string& text : texts) {
    bytes += text.capacity();
  }
  return bytes;
}

std::size_t name_bytes(const FaceNaming& names) {
  std::size_t bytes = text_bytes(names.material_libraries);
  for (const FaceNames* layer : {&names.objects, &names.groups, &names.materials}) {
    bytes += text_bytes(layer->names) + array_bytes(layer->of_faces);
  }
  return bytes;
}

std::size_t halfedge_bytes(const HalfedgeMesh& mesh) {
  return mesh.n_vertices() * sizeof(HalfedgeMesh::Vertex) +
         mesh.n_edges() * sizeof(HalfedgeMesh::Edge) + mesh.n_faces() * sizeof(HalfedgeMesh::Face) +
         property_bytes(mesh.vprops_begin(), mesh.vprops_end()) +
         property_bytes(mesh.hprops_begin(), mesh.hprops_end()) +
         property_bytes(mesh.eprops_begin(), mesh.eprops_end()) +
         property_bytes(mesh.fprops_begin(), mesh.fprops_end());
}

std::size_t topology_bytes(const FlatTopology& topology) {
  return array_bytes(topology.face_offsets) + array_bytes(topology.corner_vertices) +
         array_bytes(topology.corner_edges) + array_bytes(topology.corner_faces) +
         array_bytes(topology.edge_vertices) + array_bytes(topology.edge_corners) +
         array_bytes(topology.corner_twins) + array_bytes(topology.vertex_offsets) +
         array_bytes(topology.vertex_corners) + array_bytes(topology.corner_ranks) +
         array_bytes(topology.irregular_vertices) + array_bytes(topology.quad_rings);
}

}  // namespace

std::size_t attribute_bytes(const ControlMesh& mesh) {
  std::size_t bytes =
      array_bytes(mesh.creases().edge_sharpness) + array_bytes(mesh.creases().vertex_sharpness) +
      array_bytes(mesh.texture().values) + array_bytes(mesh.texture().corner_values) +
      name_bytes(mesh.attributes().names) + array_bytes(mesh.attributes().loose_vertices);
  if (const TextureSurface* texture = mesh.texture_surface(); texture != nullptr) {
    bytes += topology_bytes(texture->topology) + array_bytes(texture->points) +
             array_bytes(texture->vertices) + array_bytes(texture->edges);
  }
  return bytes;
}

std::size_t mesh_bytes(const ControlMesh& mesh) {
  return sizeof(ControlMesh) + attribute_bytes(mesh) + halfedge_bytes(mesh.halfedges()) +
         mesh.positions().size_bytes() + topology_bytes(mesh.topology());
}

std::size_t bytes_beside(const Document& document, const ControlMesh& mesh) {
  const auto shares_surface = [&](const std::shared_ptr<const ControlMesh>& other) {
    return other != nullptr && &other->topology() == &mesh.topology();
  };
  if (&mesh == document.control.get() || &mesh == document.opened.get()) {
    return 0;
  }
  return shares_surface(document.control) || shares_surface(document.opened)
             ? sizeof(ControlMesh) + attribute_bytes(mesh)
             : mesh_bytes(mesh);
}

}  // namespace limn
