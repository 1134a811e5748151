#pragma once

#include <cstddef>
#include <cstdint>

#include "limn/mesh/mesh_format.h"

namespace limn::fuzz {

/// Reads bytes as a mesh. Where they are one, writes it in the same format, reads that again, and
/// aborts with a message where the two differ in something that the format holds.
void check_round_trip(MeshFormat format, const std::uint8_t* data, std::size_t size);

}  // namespace limn::fuzz
