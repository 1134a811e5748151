#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace limn {

/// "No such element" in arrays of indices: the missing face beyond a boundary edge.
inline constexpr std::uint32_t kNone = 0xFFFFFFFFu;

/// An oriented 2-manifold of polygons as flat arrays, for loops that must run at the speed of
/// memory.
///
/// V vertices, E edges, F faces, C = sum of face sides corners. A corner is a (face, side) pair;
/// corner `face_offsets[f] + i` stands at the i-th vertex of face f and names the edge from there
/// to the next vertex.
struct FlatTopology {
  std::vector<std::uint32_t> face_offsets;     ///< F + 1, prefix sums of face sides.
  std::vector<std::uint32_t> corner_vertices;  ///< C, counter-clockwise.
  std::vector<std::uint32_t> corner_edges;     ///< C, edge from this corner to the next.
  std::vector<std::uint32_t> corner_faces;     ///< C, the face a corner belongs to.
  std::vector<std::array<std::uint32_t, 2>> edge_vertices;  ///< E, from corner to corner:
  std::vector<std::array<std::uint32_t, 2>> edge_corners;   ///< E, lower first; second is kNone on
                                                            ///< a boundary.

  // What follows from the above (mesh/flat_topology.cpp).

  /// C, the corner on the other side of a corner's edge, or kNone on a boundary.
  std::vector<std::uint32_t> corner_twins;
  std::vector<std::uint32_t> vertex_offsets;  ///< V + 1, prefix sums of faces around.
  /// C, corners around each vertex, counter-clockwise; at a boundary vertex from one boundary edge
  /// to the other.
  std::vector<std::uint32_t> vertex_corners;
  std::vector<std::uint32_t> corner_ranks;  ///< C, its place among the corners of its vertex.
  /// Ascending: vertices inside that have not four quads around them, and on the boundary not two.
  std::vector<std::uint32_t> irregular_vertices;
  /// F, the twelve vertices around a quad, kNone where there is none. Number 3 i + 0 is the end of
  /// the edge that goes on beyond side i from corner i, 3 i + 1 the one beyond side i - 1, and
  /// 3 i + 2 what lies opposite in the quad between these two, where corner i has four quads around
  /// it. Faces that are no quads have none.
  std::vector<std::array<std::uint32_t, 12>> quad_rings;
};

}  // namespace limn
