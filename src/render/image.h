#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace limn::render {

/// A picture: 8-bit red, green, blue, alpha, sRGB, rows from top to bottom without padding.
struct Image {
  glm::ivec2 size{0};
  std::vector<std::uint8_t> rgba;  ///< 4 * size.x * size.y bytes.

  Image() = default;
  explicit Image(glm::ivec2 pixels)
      : size(pixels),
        rgba(static_cast<std::size_t>(pixels.x) * static_cast<std::size_t>(pixels.y) * 4) {}

  /// The four bytes of the pixel in column x, row y from the top.
  [[nodiscard]] std::uint8_t* pixel(int x, int y) noexcept { return rgba.data() + offset(x, y); }
  [[nodiscard]] const std::uint8_t* pixel(int x, int y) const noexcept {
    return rgba.data() + offset(x, y);
  }

  [[nodiscard]] bool operator==(const Image&) const = default;

 private:
  [[nodiscard]] std::size_t offset(int x, int y) const noexcept {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
            static_cast<std::size_t>(x)) *
           4;
  }
};

}  // namespace limn::render
