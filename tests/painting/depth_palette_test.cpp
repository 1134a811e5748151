// Lightness is CIE L* (D65). Colour-vision deficiencies are simulated with the severity-1.0
// matrices of Machado, Oliveira & Fernandes 2009, in linear RGB.
#include "limn/painting/depth_palette.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace limn {
namespace {

using Vec = std::array<double, 3>;
using Matrix = std::array<Vec, 3>;

constexpr Matrix kNormal{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr Matrix kProtanopia{{{0.152286, 1.052583, -0.204868},
                              {0.114503, 0.786281, 0.099216},
                              {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix kDeuteranopia{{{0.367322, 0.860646, -0.227968},
                                {0.280085, 0.672501, 0.047413},
                                {-0.011820, 0.042940, 0.968881}}};
constexpr Matrix kTritanopia{{{1.255528, -0.076749, -0.178779},
                              {-0.078411, 0.930809, 0.147602},
                              {0.004733, 0.691367, 0.303900}}};

double linear(std::uint8_t value) {
  const double v = value / 255.0;
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

double lightness(Rgb colour, const Matrix& eye) {
  const Vec rgb{linear(colour.red), linear(colour.green), linear(colour.blue)};
  Vec seen{};
  for (std::size_t row = 0; row < 3; ++row) {
    const double value = eye[row][0] * rgb[0] + eye[row][1] * rgb[1] + eye[row][2] * rgb[2];
    seen[row] = std::clamp(value, 0.0, 1.0);
  }
  const double y = 0.2126 * seen[0] + 0.7152 * seen[1] + 0.0722 * seen[2];
  return y > 216.0 / 24389.0 ? 116.0 * std::cbrt(y) - 16.0 : y * 24389.0 / 27.0;
}

/// The smallest fall of lightness from one painted depth to the next.
double smallest_step(const Matrix& eye) {
  double smallest = 100.0;
  for (int depth = 1; depth + 1 < kDepthColours; ++depth) {
    smallest = std::min(
        smallest, lightness(depth_colour(depth), eye) - lightness(depth_colour(depth + 1), eye));
  }
  return smallest;
}

TEST(DepthPalette, LightnessFallsEvenly) {
  EXPECT_GE(smallest_step(kNormal), 11.0);
  EXPECT_NEAR(lightness(depth_colour(1), kNormal), 91.0, 1.5);
  EXPECT_NEAR(lightness(depth_colour(7), kNormal), 20.0, 2.0);
}

TEST(DepthPalette, OrderIsSeenWithColourVisionDeficiencies) {
  EXPECT_GE(smallest_step(kProtanopia), 9.0);
  EXPECT_GE(smallest_step(kDeuteranopia), 9.0);
  EXPECT_GE(smallest_step(kTritanopia), 9.0);
}

TEST(DepthPalette, UnpaintedIsNeutralAndApartFromEveryDepth) {
  const Rgb clay = depth_colour(0);
  const auto [low, high] = std::minmax({clay.red, clay.green, clay.blue});
  EXPECT_LE(high - low, 12);
  for (int depth = 1; depth < kDepthColours; ++depth) {
    const Rgb colour = depth_colour(depth);
    const int difference = std::abs(colour.red - clay.red) + std::abs(colour.green - clay.green) +
                           std::abs(colour.blue - clay.blue);
    EXPECT_GT(difference, 100) << "depth " << depth;
  }
}

TEST(DepthPalette, DepthsBeyondTheLastShareItsColour) {
  EXPECT_EQ(depth_colour(7), depth_colour(10));
  EXPECT_NE(depth_colour(6), depth_colour(7));
}

TEST(DepthPalette, TextContrasts) {
  EXPECT_EQ(text_colour_on(depth_colour(1)), (Rgb{0, 0, 0}));
  EXPECT_EQ(text_colour_on(depth_colour(7)), (Rgb{255, 255, 255}));
}

}  // namespace
}  // namespace limn
