#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "subdivision/fine/quad_forest.h"

// Internal to this folder.
namespace limn {

/// Raises zeros to 1 until no quad among `quads` has just two neighbouring positive labels. While
/// there are such quads, that of their zero vertices rises which mends most, less the quads that it
/// makes illegal; then the one that adds the fewest faces; then the lowest. Labels are by vertex.
/// In n log n of the quads concerned.
void legalise_level(std::span<const ForestNode> quads, std::vector<std::uint8_t>& labels);

}  // namespace limn
