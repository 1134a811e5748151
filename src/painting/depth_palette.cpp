#include "limn/painting/depth_palette.h"

#include <algorithm>
#include <cstddef>

#include "limn/contract.h"

namespace limn {
namespace {

constexpr std::array<Rgb, kDepthColours> kPalette{{
    {0xc8, 0xc4, 0xbd},
    {0xdb, 0xef, 0x89},
    {0x74, 0xda, 0x93},
    {0x09, 0xb9, 0xb1},
    {0x07, 0x93, 0xb7},
    {0x01, 0x70, 0xa9},
    {0x01, 0x4c, 0x9c},
    {0x23, 0x26, 0x74},
}};

}  // namespace

const std::array<Rgb, kDepthColours>& depth_palette() noexcept {
  return kPalette;
}

Rgb depth_colour(int depth) noexcept {
  LIMN_EXPECTS(depth >= 0);
  return kPalette[static_cast<std::size_t>(std::min(depth, kDepthColours - 1))];
}

Rgb text_colour_on(Rgb background) noexcept {
  // Luma of Rec. 601 in thousandths is near enough to tell light from dark.
  const int luma = 299 * background.red + 587 * background.green + 114 * background.blue;
  return luma > 127'500 ? Rgb{0, 0, 0} : Rgb{255, 255, 255};
}

}  // namespace limn
