#pragma once

#include "limn/mesh/polygon_soup.h"

/// The bundled meshes, one function each. All are y-up, about 2 units across, centred around the
/// origin, with faces counter-clockwise seen from outside.
namespace limn::generator {

// solids.cpp
[[nodiscard]] PolygonSoup cube();
/// The cube with every square cut along a diagonal, in no symmetric way: 12 triangles.
[[nodiscard]] PolygonSoup cube_triangulated();
[[nodiscard]] PolygonSoup icosahedron();
/// The octahedron with every triangle cut into four and all vertices on the unit sphere: 32
/// triangles, valences 4 and 6.
[[nodiscard]] PolygonSoup sphere();
/// The rhombicosidodecahedron: 20 triangles, 30 squares and 12 pentagons.
[[nodiscard]] PolygonSoup rhombicosidodecahedron();

// surfaces.cpp
/// An open sheet of 12 x 12 quads with a gentle wave in it.
[[nodiscard]] PolygonSoup wavy_grid();
/// A torus of quads with a window cut into it: one boundary loop.
[[nodiscard]] PolygonSoup torus_with_window();

// creature.cpp
/// A small dragon, all quads, symmetric in x: what the program opens with.
[[nodiscard]] PolygonSoup creature();

// teapot.cpp
/// The Utah teapot, all quads: body, lid, handle and spout are open pieces that pass through one
/// another, as its author made them.
[[nodiscard]] PolygonSoup utah_teapot();

}  // namespace limn::generator
