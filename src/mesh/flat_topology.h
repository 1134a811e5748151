#pragma once

#include <cstddef>

#include "limn/mesh/flat_topology.h"

// Internal to this folder.
namespace limn::detail {

/// Fills in what follows from faces, corners and edges. Vertices have one fan of faces each.
void complete_topology(FlatTopology& flat, std::size_t vertices);

}  // namespace limn::detail
