#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec4.hpp>

namespace limn::render {

/// A font of ten digits made of straight strokes, to be drawn by distance at any size.
struct DigitStrokes {
  std::array<std::uint32_t, 11> first{};  ///< Digit d has strokes first[d] .. first[d + 1] - 1.
  std::vector<glm::vec4> strokes;  ///< From x, y to x, y; a digit is 0.6 wide, 1 high, y upwards.
};

[[nodiscard]] DigitStrokes make_digit_strokes();

}  // namespace limn::render
