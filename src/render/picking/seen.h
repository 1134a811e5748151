#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace limn::render {

/// What the id image holds in a pixel: 0 for nothing, else the drawn face + 1, with the highest bit
/// set where the triangle is seen from behind.
inline constexpr std::uint32_t kFromBehind = 1U << 31U;

[[nodiscard]] constexpr bool is_from_behind(std::uint32_t id) noexcept {
  return (id & kFromBehind) != 0;
}
/// Expects an id that is not 0.
[[nodiscard]] constexpr std::uint32_t drawn_face_of(std::uint32_t id) noexcept {
  return (id & ~kFromBehind) - 1;
}

/// Whether the pixel at (column, row) of a rectangle of ids makes its face a seen one.
///
/// A triangle seen from the front always counts. One seen from behind counts where all the pixels
/// around are seen from behind too. At the silhouette of a closed surface the rounding of positions
/// to parts of a pixel lets single pixels of faces through that are hidden; they border on the
/// background or on front faces. What is lost by it is a rim one pixel wide around surfaces that
/// are truly seen from behind.
[[nodiscard]] inline bool counts_as_seen(std::span<const std::uint32_t> ids, int width, int height,
                                         int column, int row) {
  const auto at = [&](int x, int y) {
    return ids[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x)];
  };
  const std::uint32_t id = at(column, row);
  if (id == 0 || !is_from_behind(id)) {
    return id != 0;
  }
  for (int y = std::max(row - 1, 0); y <= std::min(row + 1, height - 1); ++y) {
    for (int x = std::max(column - 1, 0); x <= std::min(column + 1, width - 1); ++x) {
      if (!is_from_behind(at(x, y))) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace limn::render
