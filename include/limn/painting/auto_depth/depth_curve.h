#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "limn/error.h"

namespace limn {

/// A point that a depth curve goes through.
struct DepthCurvePoint {
  double value = 0.0;  ///< Of a measure, in its units.
  int depth = 0;       ///< 0..kMaxDepth.

  [[nodiscard]] bool operator==(const DepthCurvePoint&) const = default;
};

/// From a measure to depths: straight between points, rounded to the nearest depth, and level
/// before the first and behind the last.
class DepthCurve {
 public:
  /// One or more points with finite, strictly growing values. Errors: kUsage.
  [[nodiscard]] static Result<DepthCurve> through(std::vector<DepthCurvePoint> points);

  [[nodiscard]] std::span<const DepthCurvePoint> points() const noexcept { return points_; }
  /// A value that is no number has the depth of the first point.
  [[nodiscard]] int operator()(double value) const noexcept;

  [[nodiscard]] bool operator==(const DepthCurve&) const = default;

 private:
  explicit DepthCurve(std::vector<DepthCurvePoint> points) : points_(std::move(points)) {}

  std::vector<DepthCurvePoint> points_;
};

/// How many values lie in each of `bins` equal parts of `low`..`high`; those outside count in the
/// first or last.
[[nodiscard]] std::vector<std::size_t> histogram(std::span<const double> values, double low,
                                                 double high, std::size_t bins);

}  // namespace limn
