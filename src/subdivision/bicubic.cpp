// Tensor product: rows first, then columns, with the cubic B-spline's weights.
#include "subdivision/bicubic.h"

namespace limn {
namespace {

// Divisions take long.
constexpr double kSixth = 1.0 / 6.0;
constexpr double k48th = 1.0 / 48.0;

struct CurveSample {
  Point value;
  Point first;
  Point second;
};

/// Of the cubic B-spline with these points: at the start, in the middle and at the end of its
/// middle segment.
std::array<CurveSample, kSamplesAlong> sample_curve(const Point& a, const Point& b, const Point& c,
                                                    const Point& d) noexcept {
  return {
      {{(a + b * 4.0 + c) * kSixth, (c - a) * 0.5, a - b * 2.0 + c},
       {((b + c) * 23.0 + a + d) * k48th, ((c - b) * 5.0 + d - a) * 0.125, (a - b - c + d) * 0.5},
       {(b + c * 4.0 + d) * kSixth, (d - b) * 0.5, b - c * 2.0 + d}}};
}

/// The parts of `sample_curve` that a second pass needs of values, firsts and seconds.
std::array<Point, kSamplesAlong> sample_values(const Point& a, const Point& b, const Point& c,
                                               const Point& d) noexcept {
  return {(a + b * 4.0 + c) * kSixth, ((b + c) * 23.0 + a + d) * k48th, (b + c * 4.0 + d) * kSixth};
}

}  // namespace

BicubicSamples sample_bicubic(const BicubicPoints& points) noexcept {
  std::array<std::array<CurveSample, kSamplesAlong>, 4> rows;
  for (std::size_t y = 0; y < 4; ++y) {
    const Point* row = points.data() + 4 * y;
    rows[y] = sample_curve(row[0], row[1], row[2], row[3]);
  }
  BicubicSamples samples;
  for (std::size_t x = 0; x < kSamplesAlong; ++x) {
    const auto values =
        sample_curve(rows[0][x].value, rows[1][x].value, rows[2][x].value, rows[3][x].value);
    const auto firsts =
        sample_curve(rows[0][x].first, rows[1][x].first, rows[2][x].first, rows[3][x].first);
    const auto seconds =
        sample_values(rows[0][x].second, rows[1][x].second, rows[2][x].second, rows[3][x].second);
    for (std::size_t y = 0; y < kSamplesAlong; ++y) {
      samples[y * kSamplesAlong + x] = {firsts[y].value, values[y].first, seconds[y],
                                        firsts[y].first, values[y].second};
    }
  }
  return samples;
}

}  // namespace limn
