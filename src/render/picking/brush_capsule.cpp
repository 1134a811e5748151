// A capsule is convex, so a row of pixel centres meets it in one interval: the hull of what it cuts
// out of the two discs and out of the strip between them.

#include "render/picking/brush_capsule.h"

#include <algorithm>
#include <cmath>

namespace limn::render {
namespace {

struct Interval {
  double low = INFINITY;
  double high = -INFINITY;

  void include(double a, double b) {
    low = std::min(low, a);
    high = std::max(high, b);
  }
};

void add_disc(Interval& interval, FramebufferPoint centre, double radius, double y) {
  const double dy = y - centre.y;
  if (std::abs(dy) <= radius) {
    const double half = std::sqrt(radius * radius - dy * dy);
    interval.include(centre.x - half, centre.x + half);
  }
}

/// The part of the row between the capsule's straight sides. A point is in the strip where its
/// place along the segment is in 0..length and its place across it in -radius..radius; both are
/// linear in x.
void add_strip(Interval& interval, const BrushCapsule& capsule, double radius, double y) {
  const double dx = capsule.to.x - capsule.from.x;
  const double dy = capsule.to.y - capsule.from.y;
  const double length = std::hypot(dx, dy);
  if (length == 0.0) {
    return;
  }
  const double ux = dx / length;
  const double uy = dy / length;
  double low = -INFINITY;
  double high = INFINITY;
  // Keeps slope * x + offset within a..b.
  const auto clip = [&](double slope, double offset, double a, double b) {
    if (slope == 0.0) {
      if (offset < a || offset > b) {
        high = -INFINITY;
      }
      return;
    }
    const double s = (a - offset) / slope;
    const double t = (b - offset) / slope;
    low = std::max(low, std::min(s, t));
    high = std::min(high, std::max(s, t));
  };
  const double ry = y - capsule.from.y;
  clip(ux, uy * ry, 0.0, length);
  clip(-uy, ux * ry, -radius, radius);
  if (low <= high) {
    interval.include(capsule.from.x + low, capsule.from.x + high);
  }
}

/// A whole number, kept within what an int holds.
int to_int(double value) {
  return static_cast<int>(std::clamp(value, -1e9, 1e9));
}

}  // namespace

double effective_radius(const BrushCapsule& capsule) noexcept {
  return std::max(capsule.radius, 0.7072);
}

PixelRect pixel_rect(const BrushCapsule& capsule, FramebufferSize size) {
  const double radius = effective_radius(capsule);
  const auto low = [&](double a, double b) {
    return std::max(to_int(std::floor(std::min(a, b) - radius)), 0);
  };
  const auto high = [&](double a, double b, int limit) {
    return std::min(to_int(std::ceil(std::max(a, b) + radius)), limit);
  };
  PixelRect rect;
  rect.x = low(capsule.from.x, capsule.to.x);
  rect.y = low(capsule.from.y, capsule.to.y);
  rect.width = std::max(high(capsule.from.x, capsule.to.x, size.width) - rect.x, 0);
  rect.height = std::max(high(capsule.from.y, capsule.to.y, size.height) - rect.y, 0);
  return rect;
}

PixelSpan covered_span(const BrushCapsule& capsule, int row) {
  const double radius = effective_radius(capsule);
  const double y = row + 0.5;
  Interval interval;
  add_disc(interval, capsule.from, radius, y);
  add_disc(interval, capsule.to, radius, y);
  add_strip(interval, capsule, radius, y);
  if (interval.low > interval.high) {
    return {};
  }
  return {to_int(std::ceil(interval.low - 0.5)), to_int(std::floor(interval.high - 0.5)) + 1};
}

}  // namespace limn::render
