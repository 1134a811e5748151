#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "support/shapes.h"

// Faces as plain lists, to judge edits by without the library's topology.
namespace limn::test {

using Faces = std::vector<std::vector<std::uint32_t>>;

[[nodiscard]] Faces faces_of(const ControlMesh& mesh);

/// Every face starting with its lowest vertex, sorted: equal for equal sets of faces.
[[nodiscard]] Faces sorted_faces(Faces faces);

/// Whether the faces are an oriented manifold that uses all of so many vertices: no vertex twice in
/// a face, no directed edge in two faces, and around every vertex a single path or ring of faces.
[[nodiscard]] bool is_manifold(const Faces& faces, std::size_t vertices);

/// Triangles, by the fan from every face's first corner.
[[nodiscard]] PolygonSoup triangulated(const PolygonSoup& soup);

/// Open and closed triangle meshes with vertices of many valences: by random edge flips. `i` picks
/// the kind; every third has holes.
[[nodiscard]] MeshPointer random_triangles(int i, Random& random);

}  // namespace limn::test
