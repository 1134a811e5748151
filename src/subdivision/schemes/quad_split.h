#pragma once

#include <cstddef>

#include "subdivision/schemes/level_mesh.h"

// Internal to this folder.
namespace limn {

/// Every face of n sides becomes n quads. Vertices: the old ones, then one per edge, then one per
/// face. The quad at half-edge h has number h and its vertices in the order of h's start, the
/// middle of h, the middle of the face, the middle of the half-edge before. Edge e becomes 2 e at
/// the start of its first half-edge, and 2 e + 1; the edge from the middle of h into the face has
/// number 2 E + h.
[[nodiscard]] LevelFaces split_into_quads(const LevelMesh& from);
void connect_quads(const LevelMesh& from, LevelMesh& to);
[[nodiscard]] std::size_t quad_split_vertices(const LevelMesh& from);

}  // namespace limn
