#pragma once

#include <cstdint>

#include "limn/error.h"
#include "subdivision/flat_plan.h"

// What drivers allow, and what a refinement on the GPU needs.
namespace limn::render {

inline constexpr std::uint64_t kGroupSize = 64;           ///< Invocations, as in the shaders.
inline constexpr std::uint64_t kMostGroupsInRow = 65535;  ///< What every driver allows.
inline constexpr std::uint64_t kPiecePoints = 25;         ///< As in the shaders.

/// Throws EnvironmentError where shaders see too few buffers.
void require_slots();

/// Bytes of the points of all roots and pieces.
[[nodiscard]] std::uint64_t point_bytes(const FlatPlan& plan);

/// Errors: kEnvironment where something is larger than the driver allows, naming its limit.
[[nodiscard]] Result<void> require_room(const FlatPlan& plan);

}  // namespace limn::render
