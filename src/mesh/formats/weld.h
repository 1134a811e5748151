#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace limn::detail {

/// What is to be one where all three are equal.
using WeldKey = std::array<std::uint64_t, 3>;

/// The bits of a position, those of -0 being those of 0.
[[nodiscard]] WeldKey weld_key(const glm::dvec3& position) noexcept;

/// A vertex and the bits of a texture coordinate that one of its corners has.
[[nodiscard]] WeldKey corner_key(std::uint32_t vertex, const glm::dvec2& uv) noexcept;

struct Welding {
  std::vector<std::uint32_t> first;    ///< For every number of the result a key that has it, the
                                       ///< first; rising.
  std::vector<std::uint32_t> numbers;  ///< For every key its number, by first appearance.
};

/// Numbers equal keys alike. Takes as long as sorting them, whatever they are.
[[nodiscard]] Welding weld(const std::vector<WeldKey>& keys);

}  // namespace limn::detail
