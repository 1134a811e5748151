#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/mesh/import_report.h"
#include "limn/mesh/polygon_soup.h"

namespace limn {

/// A control mesh, and what was mended to make it one.
struct ImportedMesh {
  std::shared_ptr<const ControlMesh> mesh;
  ImportReport report;
  std::vector<std::uint32_t> depths{};  ///< What the file has painted on each face; empty: nothing.
};

struct BuildSettings {
  bool is_strict = false;  ///< Refuse what would have to be mended.
};

/// Validates a soup and makes the half-edge control mesh of it.
///
/// Refused, kBadInput, naming the place of the first culprit: no faces, a vertex of a face with
/// coordinates that are not finite or beyond 1e18 (refined meshes are single precision), an index
/// out of range, more elements than half-edges can number, and a face that meets a vertex twice
/// where the faces around that vertex join both meetings.
///
/// Everything else is mended, in this order, each step counted in the report:
///   1. A corner that repeats the one before is merged with it. Faces that are left with fewer than
///      three distinct vertices are dropped, and so are those on the vertices of an earlier face in
///      the same circle, of either direction, but for the two faces that are a closed surface of
///      their own, back to back.
///   2. Neighbours are made to agree about the outside, component by component over edges with two
///      faces; the smaller side is turned over. Where a surface is one-sided and cannot agree, it
///      is cut open along the edges that clash.
///   3. At an edge with three or more faces, pairs that run in opposite directions stay joined, the
///      straightest first; the others end there. No other edge is torn.
///   4. A vertex where several fans of faces meet, by itself or after the cuts above, is given a
///      copy for every further fan.
///   5. Vertices in no face are set aside (MeshAttributes::loose_vertices), or left out where their
///      coordinates are no usable numbers.
///   6. Tags, texture coordinates and depths that fit nothing are left out or made to fit.
/// With `is_strict`, what would be mended is refused instead, kBadInput, naming the first culprit.
///
/// Creases, corners, texture coordinates, names and depths go with the edges, vertices, corners and
/// faces they belong to: all copies of a split vertex or edge keep its sharpness. Texture
/// coordinates that no corner uses are dropped and counted in ImportReport::unused_data, the others
/// keep their order. Two faces on the same vertices, back to back, are a closed surface and
/// accepted, and so is a vertex with two edges. Faces keep their order and their first corner;
/// vertices keep their order, copies come last. Takes linear time, whatever the valences and
/// numbers of sides.
[[nodiscard]] Result<ImportedMesh> build_control_mesh(const PolygonSoup& soup,
                                                      const BuildSettings& settings = {});

}  // namespace limn
