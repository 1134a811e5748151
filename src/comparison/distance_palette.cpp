#include "limn/comparison/distance_palette.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace limn {
namespace {

constexpr std::array<Rgb, kDepthColours> kViridis{{
    {0x44, 0x01, 0x54},
    {0x46, 0x33, 0x7e},
    {0x36, 0x5c, 0x8d},
    {0x27, 0x7f, 0x8e},
    {0x1f, 0xa1, 0x87},
    {0x4a, 0xc1, 0x6d},
    {0x9f, 0xda, 0x3a},
    {0xfd, 0xe7, 0x25},
}};

}  // namespace

const std::array<Rgb, kDepthColours>& distance_palette() noexcept {
  return kViridis;
}

Rgb distance_colour(double part) noexcept {
  constexpr std::size_t kLast = kDepthColours - 1;
  const double place = std::clamp(part, 0.0, 1.0) * static_cast<double>(kLast);
  const std::size_t below = std::min(static_cast<std::size_t>(place), kLast - 1);
  const double share = place - static_cast<double>(below);
  const auto mixed = [share](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround((1.0 - share) * a + share * b));
  };
  const Rgb& a = kViridis[below];
  const Rgb& b = kViridis[below + 1];
  return {mixed(a.red, b.red), mixed(a.green, b.green), mixed(a.blue, b.blue)};
}

}  // namespace limn
