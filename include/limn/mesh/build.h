#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/mesh/polygon_soup.h"

namespace limn {

/// What had to be mended, or was set aside, to make a control mesh of what a file holds.
struct ImportReport {
  std::size_t flipped_faces = 0;         ///< Orientation clashed with the neighbours; flipped.
  std::size_t split_vertices = 0;        ///< Bow-tie vertices; one copy added per extra fan.
  std::size_t isolated_vertices = 0;     ///< In no face; dropped.
  std::size_t repeated_corners = 0;      ///< The same vertex twice in a row in a face; merged.
  std::size_t lost_creases = 0;          ///< Crease tags between vertices that share no edge.
  std::size_t lost_corners = 0;          ///< Corner tags on vertices that are not there.
  std::size_t negative_sharpness = 0;    ///< Tags with a sharpness below 0; taken as 0.
  std::size_t filled_uvs = 0;            ///< Corners without texture coordinates in a mesh that
                                         ///< has some; they share one more point, 0 0.
  std::size_t broken_uvs = 0;            ///< Texture coordinates that are not finite or beyond
                                         ///< 1e18; became 0.
  std::vector<std::string> unused_data;  ///< What the file holds and Limn does not read, counted
                                         ///< ("12 normals", "2 line elements").

  /// True where the mesh differs from the file's.
  [[nodiscard]] bool is_mended() const noexcept;
  /// One sentence per kind of mend and of unused data; empty where the file came in as it was.
  [[nodiscard]] std::vector<std::string> sentences() const;
};

/// A control mesh, and what was mended to make it one.
struct ImportedMesh {
  std::shared_ptr<const ControlMesh> mesh;
  ImportReport report;
};

/// Validates a soup and makes the half-edge control mesh of it.
///
/// Mended with a report, since nothing is lost by it: clashing orientation of an orientable
/// component (the smaller side is flipped), bow-tie vertices (split, one vertex per fan), isolated
/// vertices (dropped), a corner repeated in a row (merged), tags that fit nothing (left out),
/// corners without texture coordinates in a mesh with some (given one common point).
/// Creases, corners and texture coordinates go with the edges, vertices and corners they belong to:
/// both copies of a split vertex keep its sharpness. Texture coordinates that no corner uses are
/// dropped and counted in ImportReport::unused_data, the others keep their order.
/// Refused, kBadInput, naming the source line of the first culprit: no faces, coordinates that are
/// not finite or beyond 1e18 (refined meshes are single precision), an index out of range, a face
/// with fewer than three distinct vertices or with a vertex twice, an edge with three or more
/// faces, a surface that cannot be oriented (Moebius). Two faces on the same vertices, back to
/// back, are a closed surface and accepted, and so is a vertex with two edges. Faces keep their
/// order and their first corner; vertices keep their order, copies come last. Takes linear time,
/// whatever the valences and numbers of sides.
[[nodiscard]] Result<ImportedMesh> build_control_mesh(const PolygonSoup& soup);

}  // namespace limn
