// The new vertices are the middles of the edges; those of a face, and those around a vertex, make a
// face each. Two steps double the resolution, so the boundary is refined once in two: in the first
// step its vertices stay as corners of the faces around them, in the second they are cut off, which
// leaves points at 1/4 and 3/4 of the old edges, those of the quadratic B-spline.
//
//      first             second
//    . m0 .            .       .
//   m1   . v           m1 ---- m0     v is gone, but for corners that stay
//    .  m2             .       .
#include "subdivision/parallel_ranges.h"
#include "subdivision/schemes/boundary_edges.h"
#include "subdivision/schemes/face_list.h"
#include "subdivision/schemes/marked_corners.h"
#include "subdivision/schemes/scheme_rules.h"

namespace limn {
namespace {

constexpr std::size_t kMidedgeGrain = 16384;

/// The old vertices that stay, in growing order; new vertices come after those of the edges.
LargeArray<std::uint32_t> staying_vertices(const LevelMesh& from) {
  LargeArray<std::uint32_t> staying;
  for (std::uint32_t v = 0; v < from.vertex_count(); ++v) {
    if (from.is_boundary_vertex(v) && (from.level % 2 == 0 || is_marked(from, v))) {
      staying.push_back(v);
    }
  }
  return staying;
}

LevelFaces split_midedge(const LevelMesh& from) {
  const LargeArray<std::uint32_t> staying = staying_vertices(from);
  FaceList list;
  list.reserve(from.faces.count() + from.vertex_count(),
               2 * from.half_edge_count() + 2 * from.edge_count);
  for (std::uint32_t f = 0; f < from.faces.count(); ++f) {
    for (std::uint32_t h = from.faces.first(f); h < from.faces.first(f + 1); ++h) {
      list.add_corner(from.edges[h]);
    }
    list.end_face(from.faces.control_faces[f]);
  }
  std::uint32_t stays = 0;
  for (std::uint32_t v = 0; v < from.vertex_count(); ++v) {
    const std::uint32_t arriving =
        from.around(v, [&](std::uint32_t h) { list.add_corner(from.edges[h]); });
    if (arriving != kNone) {
      list.add_corner(from.edges[arriving]);
    }
    if (stays < staying.size() && staying[stays] == v) {
      list.add_corner(static_cast<std::uint32_t>(from.edge_count) + stays++);
    }
    list.end_face(from.faces.control_faces[from.face_of(from.vertex_starts[v])]);
  }
  return list.take();
}

std::size_t midedge_vertices(const LevelMesh& from) {
  return from.edge_count + staying_vertices(from).size();
}

void connect_midedge(const LevelMesh& from, LevelMesh& to) {
  const LargeArray<std::uint32_t> staying = staying_vertices(from);
  connect(from.edge_count + staying.size(), to);
  if (!from.vertex_sharpness.empty()) {
    to.vertex_sharpness.assign(from.edge_count + staying.size(), 0.0f);
    for (std::size_t i = 0; i < staying.size(); ++i) {
      to.vertex_sharpness[from.edge_count + i] = from.vertex_sharpness[staying[i]];
    }
  }
}

void place_midedge(const LevelMesh& from, const SchemeSettings&, const LevelMesh&,
                   const PointSink& sink) {
  parallel_ranges(
      0, from.half_edge_count(), kMidedgeGrain, [&](std::size_t begin, std::size_t end) {
        for (auto h = static_cast<std::uint32_t>(begin); h < end; ++h) {
          if (from.is_first(h)) {
            sink.put(from.edges[h], 0.5 * (from.points[from.start(h)] + from.points[from.end(h)]));
          }
        }
      });
  std::size_t at = from.edge_count;
  for (const std::uint32_t v : staying_vertices(from)) {
    sink.put(at++, from.points[v]);
  }
}

}  // namespace

const SchemeRules& midedge_rules() noexcept {
  static constexpr SchemeRules kRules{split_midedge, connect_midedge, place_midedge,
                                      midedge_vertices, false};
  return kRules;
}

}  // namespace limn
