#include "subdivision/flat_shape.h"

#include <algorithm>
#include <bit>

#include "subdivision/sharpness.h"

namespace limn {
namespace {

/// Points of a ring at one level, as one corner sees it: the centre, and an edge beyond each side.
constexpr std::uint32_t kRingPoints = 3;

/// Levels from `level` on, `most` at most, at which something of the side is sharp.
std::uint32_t count_sharp_levels(const SideSharpness& sharpness, int level, std::uint32_t most) {
  for (std::uint32_t r = 0; r < most; ++r) {
    bool is_any_sharp = false;
    for (std::ptrdiff_t e = 0; e < std::ptrdiff_t{1} << r && !is_any_sharp; ++e) {
      is_any_sharp = is_sharp(sharpness.at(level + static_cast<int>(r), e));
    }
    if (!is_any_sharp) {
      return r;
    }
  }
  return most;
}

}  // namespace

void mirror_side(std::size_t i, std::array<Point, 16>& grid) {
  constexpr std::array<std::size_t, 4> kFirst{0, 3, 12, 0};
  constexpr std::array<std::ptrdiff_t, 4> kInwards{4, -1, -4, 1};
  Point* at = grid.data() + kFirst[i];
  for (std::size_t k = 0; k < 4; ++k) {
    *at = at[kInwards[i]] * 2.0 - at[2 * kInwards[i]];
    at += i % 2 == 0 ? 1 : 4;
  }
}

PatchShape::PatchShape(const Patch& patch, const Node& root, bool with_limits)
    : level_(root.level), levels_(std::ranges::max(root.labels)) {
  const std::uint32_t most = with_limits ? static_cast<std::uint32_t>(kInfiniteSharpness) : levels_;
  for (std::size_t i = 0; i < 4; ++i) {
    rings_ |= bit(i, patch.corners[i].ring.exists());
    before_ |= bit(i, patch.corners[i].before != kNone);
    after_ |= bit(i, patch.corners[i].after != kNone);
    const PatchSide& side = patch.sides[i];
    if (side.kind == SideKind::kCurve ||
        (side.kind == SideKind::kSharp && is_infinite(side.sharpness.at(level_, 0)))) {
      curves_ |= bit(i);
    } else if (side.kind == SideKind::kSharp) {
      sharp_levels_[i] = count_sharp_levels(side.sharpness, level_, most);
      if (sharp_levels_[i] > 0) {
        sharp_ |= bit(i);
        corners_ |= static_cast<std::uint8_t>(bit(i) | bit((i + 1) % 4));
      }
    }
  }
  corners_ |= rings_;
}

std::uint64_t PatchShape::piece_count() const noexcept {
  const std::uint32_t sharp = std::min(levels_, std::ranges::max(sharp_levels_));
  const auto corners = static_cast<std::uint64_t>(std::popcount(corners_));
  const auto sides = static_cast<std::uint64_t>(std::popcount(sharp_));
  std::uint64_t count = 1 + (levels_ - 1) * corners;
  for (std::uint32_t r = 1; r < sharp; ++r) {
    count += sides * ((std::uint64_t{1} << r) - 2);
  }
  return count;
}

std::uint32_t PatchShape::ring_point_count(bool with_limits) const noexcept {
  return static_cast<std::uint32_t>(std::popcount(rings_)) *
         (levels_ * kRingPoints + (with_limits ? 2 : 0));
}

std::uint32_t PatchShape::share_count(std::size_t side, bool is_even) const noexcept {
  const std::uint32_t levels = sharp_levels_[side];
  return is_even ? 2 * levels : 2 * ((1U << levels) - 1) + 3 * levels;
}

std::uint32_t PatchShape::bits() const noexcept {
  return levels_ | std::uint32_t{corners_} << 4U | std::uint32_t{rings_} << 8U |
         std::uint32_t{before_} << 12U | std::uint32_t{after_} << 16U |
         std::uint32_t{curves_} << 20U | std::uint32_t{sharp_} << 24U;
}

float* put_shares(const SideSharpness& sharpness, int level, std::ptrdiff_t edges, bool is_even,
                  float* out) {
  const auto of_edge = [&](std::ptrdiff_t e) {
    return sharp_share_of_edge(sharpness.at(level, e), sharpness.at(level + 1, 2 * e),
                               sharpness.at(level + 1, 2 * e + 1));
  };
  const auto of_vertex = [&](std::ptrdiff_t e) {
    return sharp_share_of_vertex(sharpness.at(level, e - 1), sharpness.at(level, e),
                                 sharpness.at(level + 1, 2 * e - 1),
                                 sharpness.at(level + 1, 2 * e));
  };
  if (is_even) {
    *out++ = of_edge(0);
    *out++ = of_vertex(0);
    return out;
  }
  for (std::ptrdiff_t e = -1; e <= edges; ++e) {
    *out++ = of_edge(e);
  }
  for (std::ptrdiff_t e = 0; e <= edges; ++e) {
    *out++ = of_vertex(e);
  }
  return out;
}

}  // namespace limn
