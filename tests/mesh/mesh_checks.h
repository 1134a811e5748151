#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "limn/mesh/build.h"
#include "limn/mesh/control_mesh.h"
#include "limn/mesh/polygon_soup.h"

namespace limn::test {

/// A soup of faces over `vertex_count` vertices on a moment curve, so that no two coincide.
[[nodiscard]] PolygonSoup soup_of(std::size_t vertex_count,
                                  const std::vector<std::vector<std::uint32_t>>& faces);

/// The faces' vertices, as nested vectors.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> faces_of(const ControlMesh& mesh);

/// Every broken promise of a control mesh, as sentences; empty where all hold. Counts by brute
/// force over the faces and follows OpenMesh's links one by one.
[[nodiscard]] std::vector<std::string> faults_of(const ControlMesh& mesh);

/// The same for links alone: every half-edge, vertex and face of a half-edge mesh.
[[nodiscard]] std::vector<std::string> link_faults_of(const HalfedgeMesh& mesh);

/// Edges named by one, two, three... faces, as undirected vertex pairs: counts[k] edges with k.
[[nodiscard]] std::vector<std::size_t> edge_use_counts(const PolygonSoup& soup);

/// The mesh of an OBJ text that must be accepted and give a sound mesh; the test fails otherwise.
[[nodiscard]] ImportedMesh import_text(std::string_view text);

/// "path:line: message" of an OBJ text that must be refused as bad input; "accepted" if it is not.
[[nodiscard]] std::string refusal_of(std::string_view text);

}  // namespace limn::test
