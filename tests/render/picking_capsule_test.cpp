#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "render/picking/brush_capsule.h"

namespace limn::render {
namespace {

double distance_to_segment(const BrushCapsule& c, double x, double y) {
  const double dx = c.to.x - c.from.x;
  const double dy = c.to.y - c.from.y;
  const double squared = dx * dx + dy * dy;
  const double along =
      ((x - c.from.x) * dx + (y - c.from.y) * dy) / (squared > 0.0 ? squared : 1.0);
  const double t = std::clamp(along, 0.0, 1.0);
  return std::hypot(x - c.from.x - t * dx, y - c.from.y - t * dy);
}

TEST(BrushCapsule, CoversExactlyThePixelsWithinTheRadiusOfTheSegment) {
  constexpr FramebufferSize kSize{57, 43};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-20.0, 80.0);
  std::uniform_real_distribution<double> radius(0.0, 25.0);
  for (int i = 0; i < 400; ++i) {
    BrushCapsule c{{place(random), place(random)}, {place(random), place(random)}, radius(random)};
    if (i % 4 == 0) {
      c.to = c.from;
    } else if (i % 4 == 1) {
      c.to.y = c.from.y;
    } else if (i % 4 == 2) {
      c.to.x = c.from.x;
    }
    const double reach = std::max(c.radius, std::sqrt(0.5));
    const PixelRect rect = pixel_rect(c, kSize);
    for (int y = 0; y < kSize.height; ++y) {
      const PixelSpan span = covered_span(c, y);
      for (int x = 0; x < kSize.width; ++x) {
        const double distance = distance_to_segment(c, x + 0.5, y + 0.5);
        if (std::abs(distance - reach) < 1e-9) {
          continue;
        }
        ASSERT_EQ(x >= span.first && x < span.last, distance < reach) << x << ' ' << y;
        if (distance < reach) {
          ASSERT_TRUE(x >= rect.x && x < rect.x + rect.width);
          ASSERT_TRUE(y >= rect.y && y < rect.y + rect.height);
        }
      }
    }
  }
}

TEST(BrushCapsule, TheThinnestBrushCoversEveryPixelOfItsPath) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(0.0, 60.0);
  for (int i = 0; i < 100; ++i) {
    const BrushCapsule c{{place(random), place(random)}, {place(random), place(random)}, 0.0};
    for (int step = 0; step <= 1000; ++step) {
      const double t = step / 1000.0;
      const int x = static_cast<int>(c.from.x + t * (c.to.x - c.from.x));
      const int y = static_cast<int>(c.from.y + t * (c.to.y - c.from.y));
      const PixelSpan span = covered_span(c, y);
      ASSERT_TRUE(x >= span.first && x < span.last);
    }
  }
}

TEST(BrushCapsule, RectIsEmptyOutsideTheImageAndInAnEmptyImage) {
  EXPECT_TRUE(pixel_rect({{-50.0, 10.0}, {-30.0, 10.0}, 5.0}, {100, 100}).is_empty());
  EXPECT_TRUE(pixel_rect({{10.0, 210.0}, {20.0, 210.0}, 5.0}, {100, 100}).is_empty());
  EXPECT_TRUE(pixel_rect({{0.0, 0.0}, {0.0, 0.0}, 5.0}, {}).is_empty());
  EXPECT_EQ(pixel_rect({{-1e300, -1e300}, {1e300, 1e300}, 5.0}, {7, 9}), (PixelRect{0, 0, 7, 9}));
}

}  // namespace
}  // namespace limn::render
