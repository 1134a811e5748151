// A lasso has hundreds of sides and is held against thousands of faces, so its sides are sorted
// into bands of rows by counting: a face or a row of pixels looks only at the sides beside it.
// Whether a place is inside is told by winding numbers, from the sides that cross its row.
#include "render/picking/screen_region.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "limn/contract.h"

namespace limn::render {
namespace {

constexpr std::size_t kMostBands = 512;

double cross(const glm::dvec2& a, const glm::dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

bool is_between(const glm::dvec2& point, const glm::dvec2& a, const glm::dvec2& b) {
  return point.x >= std::min(a.x, b.x) && point.x <= std::max(a.x, b.x) &&
         point.y >= std::min(a.y, b.y) && point.y <= std::max(a.y, b.y);
}

/// Both ends of both count.
bool segments_meet(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
                   const glm::dvec2& d) {
  const double c_side = cross(b - a, c - a);
  const double d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c);
  const double b_side = cross(d - c, b - c);
  if (((c_side > 0.0 && d_side < 0.0) || (c_side < 0.0 && d_side > 0.0)) &&
      ((a_side > 0.0 && b_side < 0.0) || (a_side < 0.0 && b_side > 0.0))) {
    return true;
  }
  return (c_side == 0.0 && is_between(c, a, b)) || (d_side == 0.0 && is_between(d, a, b)) ||
         (a_side == 0.0 && is_between(a, c, d)) || (b_side == 0.0 && is_between(b, c, d));
}

/// +1 or -1 where the side from a to b crosses the row of `point` to its right, upwards or
/// downwards; else 0.
int winding(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& point) {
  const bool is_a_above = a.y <= point.y;
  const bool is_b_above = b.y <= point.y;
  if (is_a_above == is_b_above) {
    return 0;
  }
  const double side = cross(b - a, point - a);
  if (is_a_above) {
    return side > 0.0 ? 1 : 0;
  }
  return side < 0.0 ? -1 : 0;
}

bool is_inside(std::span<const glm::dvec2> polygon, const glm::dvec2& point) {
  int turns = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    turns += winding(polygon[i], polygon[i + 1 == polygon.size() ? 0 : i + 1], point);
  }
  return turns != 0;
}

double squared_distance(const glm::dvec2& point, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 along = b - a;
  const double length2 = glm::dot(along, along);
  const double part = length2 > 0.0 ? glm::dot(point - a, along) / length2 : 0.0;
  const glm::dvec2 off = point - (a + std::clamp(part, 0.0, 1.0) * along);
  return glm::dot(off, off);
}

double squared_distance(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
                        const glm::dvec2& d) {
  if (segments_meet(a, b, c, d)) {
    return 0.0;
  }
  return std::min({squared_distance(a, c, d), squared_distance(b, c, d), squared_distance(c, a, b),
                   squared_distance(d, a, b)});
}

bool capsule_meets(const BrushCapsule& capsule, std::span<const glm::dvec2> face) {
  const glm::dvec2 from(capsule.from.x, capsule.from.y);
  const glm::dvec2 to(capsule.to.x, capsule.to.y);
  const double radius = effective_radius(capsule);
  for (std::size_t i = 0; i < face.size(); ++i) {
    const glm::dvec2& next = face[i + 1 == face.size() ? 0 : i + 1];
    if (squared_distance(from, to, face[i], next) <= radius * radius) {
      return true;
    }
  }
  return is_inside(face, from);
}

/// A whole number, kept within what an int holds.
int to_pixel(double value) {
  return static_cast<int>(std::clamp(value, -1e9, 1e9));
}

}  // namespace

ScreenRegion::ScreenRegion(const BrushCapsule& capsule) : capsule_(capsule) {
  const double radius = effective_radius(capsule);
  const glm::dvec2 from(capsule.from.x, capsule.from.y);
  const glm::dvec2 to(capsule.to.x, capsule.to.y);
  box_ = {glm::min(from, to) - radius, glm::max(from, to) + radius};
}

ScreenRegion::ScreenRegion(std::vector<FramebufferPoint> polygon) : polygon_(std::move(polygon)) {
  LIMN_EXPECTS(!polygon_.empty());
  box_.low = box_.high = corner(0);
  for (std::size_t i = 1; i < polygon_.size(); ++i) {
    box_.low = glm::min(box_.low, corner(i));
    box_.high = glm::max(box_.high, corner(i));
  }
  make_bands();
}

ScreenRegion ScreenRegion::rectangle(FramebufferPoint a, FramebufferPoint b) {
  return ScreenRegion({a, {b.x, a.y}, b, {a.x, b.y}});
}

glm::dvec2 ScreenRegion::corner(std::size_t i) const {
  const FramebufferPoint& point = polygon_[i < polygon_.size() ? i : i - polygon_.size()];
  return {point.x, point.y};
}

void ScreenRegion::make_bands() {
  band_offsets_.assign(std::min(polygon_.size(), kMostBands) + 1, 0);
  const auto each_band = [this](auto&& take) {
    for (std::uint32_t side = 0; side < polygon_.size(); ++side) {
      const double a = corner(side).y;
      const double b = corner(side + 1).y;
      const std::size_t last = band_of(std::max(a, b));
      for (std::size_t band = band_of(std::min(a, b)); band <= last; ++band) {
        take(band, side);
      }
    }
  };
  each_band([this](std::size_t band, std::uint32_t) { ++band_offsets_[band + 1]; });
  for (std::size_t band = 1; band < band_offsets_.size(); ++band) {
    band_offsets_[band] += band_offsets_[band - 1];
  }
  band_sides_.resize(band_offsets_.back());
  std::vector<std::uint32_t> next(band_offsets_.begin(), band_offsets_.end() - 1);
  each_band([&](std::size_t band, std::uint32_t side) { band_sides_[next[band]++] = side; });
}

std::size_t ScreenRegion::band_of(double y) const {
  const double height = box_.high.y - box_.low.y;
  const auto bands = static_cast<double>(band_offsets_.size() - 1);
  const double band = height > 0.0 ? (y - box_.low.y) / height * bands : 0.0;
  return static_cast<std::size_t>(std::clamp(band, 0.0, bands - 1.0));
}

bool ScreenRegion::encloses(const glm::dvec2& point) const {
  if (!is_between(point, box_.low, box_.high)) {
    return false;
  }
  int turns = 0;
  const std::size_t band = band_of(point.y);
  for (std::uint32_t i = band_offsets_[band]; i < band_offsets_[band + 1]; ++i) {
    turns += winding(corner(band_sides_[i]), corner(band_sides_[i] + 1), point);
  }
  return turns != 0;
}

bool ScreenRegion::outline_meets(const glm::dvec2& from, const glm::dvec2& to) const {
  const std::size_t last = band_of(std::max(from.y, to.y));
  for (std::size_t band = band_of(std::min(from.y, to.y)); band <= last; ++band) {
    for (std::uint32_t i = band_offsets_[band]; i < band_offsets_[band + 1]; ++i) {
      if (segments_meet(from, to, corner(band_sides_[i]), corner(band_sides_[i] + 1))) {
        return true;
      }
    }
  }
  return false;
}

bool ScreenRegion::meets(std::span<const glm::dvec2> face) const {
  if (face.empty()) {
    return false;
  }
  glm::dvec2 low = face[0];
  glm::dvec2 high = face[0];
  for (const glm::dvec2& point : face) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  if (low.x > box_.high.x || high.x < box_.low.x || low.y > box_.high.y || high.y < box_.low.y) {
    return false;
  }
  if (capsule_) {
    return capsule_meets(*capsule_, face);
  }
  for (std::size_t i = 0; i < face.size(); ++i) {
    if (outline_meets(face[i], face[i + 1 == face.size() ? 0 : i + 1])) {
      return true;
    }
  }
  // Without a crossing one lies wholly within the other, or they are apart.
  return encloses(face[0]) || is_inside(face, corner(0));
}

PixelRect ScreenRegion::pixel_rect(FramebufferSize size) const {
  PixelRect rect;
  rect.x = std::max(to_pixel(std::floor(box_.low.x)), 0);
  rect.y = std::max(to_pixel(std::floor(box_.low.y)), 0);
  rect.width = std::max(std::min(to_pixel(std::ceil(box_.high.x)), size.width) - rect.x, 0);
  rect.height = std::max(std::min(to_pixel(std::ceil(box_.high.y)), size.height) - rect.y, 0);
  return rect;
}

void ScreenRegion::covered_spans(int row, std::vector<PixelSpan>& spans) const {
  spans.clear();
  if (capsule_) {
    if (const PixelSpan span = covered_span(*capsule_, row); span.first < span.last) {
      spans.push_back(span);
    }
    return;
  }
  const double y = row + 0.5;
  if (y < box_.low.y || y > box_.high.y) {
    return;
  }
  std::vector<std::pair<double, int>> crossings;
  const std::size_t band = band_of(y);
  for (std::uint32_t i = band_offsets_[band]; i < band_offsets_[band + 1]; ++i) {
    const glm::dvec2 a = corner(band_sides_[i]);
    const glm::dvec2 b = corner(band_sides_[i] + 1);
    if ((a.y <= y) != (b.y <= y)) {
      crossings.emplace_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x), a.y <= y ? 1 : -1);
    }
  }
  std::ranges::sort(crossings);
  int turns = 0;
  double from = 0.0;
  for (const auto& [x, turn] : crossings) {
    if (turns == 0) {
      from = x;
    }
    turns += turn;
    if (turns == 0) {
      const PixelSpan span{to_pixel(std::ceil(from - 0.5)), to_pixel(std::ceil(x - 0.5))};
      if (span.first >= span.last) {
        continue;
      }
      if (!spans.empty() && spans.back().last >= span.first) {
        spans.back().last = span.last;
      } else {
        spans.push_back(span);
      }
    }
  }
}

}  // namespace limn::render
