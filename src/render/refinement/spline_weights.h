#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec4.hpp>

namespace limn::render {

/// For each level m = 0..most, for each vertex 0..2^m of a segment of a uniform cubic B-spline's
/// control polygon after m steps of subdivision, how much of it each of the four control points
/// around the segment is. Level m starts at 2^m - 1 + m. Exact to a rounding.
[[nodiscard]] std::vector<glm::vec4> spline_weights(std::uint32_t most);

}  // namespace limn::render
