// Round about vertex v with faces f and g on both sides of edge h, t its twin:
//
//         f           each face keeps its sides between new vertices in its corners; between the
//    v(f)---->w(f)    two faces at an edge a quad runs the other way round; the rest at v is a face
//      ^   E   |      between the corners there.
//    v(g)<----w(g)
//         g
#include "subdivision/schemes/vertex_split.h"

#include <algorithm>

#include "subdivision/schemes/face_list.h"
#include "subdivision/schemes/marked_corners.h"

namespace limn {

VertexSplit::VertexSplit(const LevelMesh& from)
    : from_(&from),
      inner_(static_cast<std::uint32_t>(from.half_edge_count())),
      boundary_(boundary_edges(from)) {
  for (std::uint32_t v = 0; v < from.vertex_sharpness.size(); ++v) {
    if (is_marked(from, v)) {
      corners_.push_back(v);
    }
  }
}

LevelFaces split_vertices(const LevelMesh& from) {
  const VertexSplit split(from);
  FaceList list;
  list.reserve(
      from.faces.count() + from.edge_count + from.vertex_count(),
      2 * from.half_edge_count() + 4 * from.edge_count + 3 * split.boundary().half_edges.size());
  for (std::uint32_t f = 0; f < from.faces.count(); ++f) {
    for (std::uint32_t h = from.faces.first(f); h < from.faces.first(f + 1); ++h) {
      list.add_corner(h);
    }
    list.end_face(from.faces.control_faces[f]);
  }
  for (std::uint32_t h = 0; h < from.half_edge_count(); ++h) {
    if (!from.is_first(h)) {
      continue;
    }
    const std::uint32_t twin = from.twins[h];
    list.add_corner(from.next(h));
    list.add_corner(h);
    list.add_corner(twin == kNone ? split.near_start(h) : from.next(twin));
    list.add_corner(twin == kNone ? split.near_end(h) : twin);
    list.end_face(from.faces.control_faces[from.face_of(h)]);
  }
  std::uint32_t corner = split.first_corner();
  for (std::uint32_t v = 0; v < from.vertex_count(); ++v) {
    const std::uint32_t first = from.vertex_starts[v];
    if (from.is_boundary_vertex(v)) {
      list.add_corner(split.near_start(first));
    }
    const std::uint32_t arriving = from.around(v, [&](std::uint32_t h) { list.add_corner(h); });
    if (arriving != kNone) {
      list.add_corner(split.near_end(arriving));
      if (is_marked(from, v)) {
        list.add_corner(corner++);
      }
    }
    list.end_face(from.faces.control_faces[from.face_of(first)]);
  }
  return list.take();
}

std::size_t vertex_split_vertices(const LevelMesh& from) {
  return VertexSplit(from).vertex_count();
}

void connect_vertex_split(const LevelMesh& from, LevelMesh& to) {
  const VertexSplit split(from);
  connect(split.vertex_count(), to);
  if (!split.corners().empty()) {
    to.vertex_sharpness.assign(split.vertex_count(), 0.0f);
    std::fill(to.vertex_sharpness.begin() + split.first_corner(), to.vertex_sharpness.end(),
              kInfiniteSharpness);
  }
}

}  // namespace limn
