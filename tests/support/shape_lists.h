#pragma once

#include <vector>

#include "support/shapes.h"

// Meshes to try things on in numbers, by kind.
namespace limn::test {

/// Quads with vertices of valence 4 inside, and a cube; open and closed, from one face up.
[[nodiscard]] std::vector<PolygonSoup> regular_soups();
/// Quads with vertices of all valences; closed for even i, open for odd, and every third with
/// holes.
[[nodiscard]] PolygonSoup random_quad_soup(int i, Random& random);
/// Faces of three to six sides, on regular or every fourth time on random vertices; every third
/// with holes.
[[nodiscard]] PolygonSoup random_mixed_soup(int i, Random& random);

}  // namespace limn::test
