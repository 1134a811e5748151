#pragma once

#include <cstdint>

#include "subdivision/cage.h"
#include "subdivision/patch.h"
#include "subdivision/ring_tables.h"

// From the cage to the points around a patch. Internal to this folder.
namespace limn {

/// Quad f of the cage with what surrounds it.
void gather_quad(const Cage& cage, const RingTables& rings, std::uint32_t f, Patch& patch);

/// The level-1 quad at corner `corner` of a face f that is no quad. Its corners are that vertex,
/// the point on the side from there, the face's centre, and the point on the side to there.
void gather_polygon_corner(const Cage& cage, const RingTables& rings, std::uint32_t f,
                           std::uint32_t corner, Patch& patch);

}  // namespace limn
