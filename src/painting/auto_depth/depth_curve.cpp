#include "limn/painting/auto_depth/depth_curve.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "limn/contract.h"
#include "limn/subdivision/settings.h"

namespace limn {

Result<DepthCurve> DepthCurve::through(std::vector<DepthCurvePoint> points) {
  if (points.empty()) {
    return fail(ErrorKind::kUsage, "A depth curve needs at least one point, VALUE/DEPTH.");
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [value, depth] = points[i];
    if (!std::isfinite(value) || depth < 0 || depth > kMaxDepth) {
      return fail(ErrorKind::kUsage,
                  fmt::format("{}/{} is no point of a depth curve; write VALUE/DEPTH with a depth "
                              "from 0 to {}.",
                              value, depth, kMaxDepth));
    }
    if (i > 0 && !(points[i - 1].value < value)) {
      return fail(
          ErrorKind::kUsage,
          fmt::format("The values of a depth curve have to grow from point to point, and {} "
                      "follows {}.",
                      value, points[i - 1].value));
    }
  }
  return DepthCurve(std::move(points));
}

int DepthCurve::operator()(double value) const noexcept {
  const auto after = std::ranges::upper_bound(points_, value, {}, &DepthCurvePoint::value);
  if (after == points_.begin() || std::isnan(value)) {
    return points_.front().depth;
  }
  const DepthCurvePoint& low = *(after - 1);
  if (after == points_.end()) {
    return low.depth;
  }
  const double share = (value - low.value) / (after->value - low.value);
  return static_cast<int>(std::lround(low.depth + share * (after->depth - low.depth)));
}

std::vector<std::size_t> histogram(std::span<const double> values, double low, double high,
                                   std::size_t bins) {
  LIMN_EXPECTS(bins > 0 && low < high);
  std::vector<std::size_t> counts(bins, 0);
  for (const double value : values) {
    if (!std::isnan(value)) {
      const double share = std::clamp((value - low) / (high - low), 0.0, 1.0);
      const auto bin = static_cast<std::size_t>(share * static_cast<double>(bins));
      ++counts[std::min(bin, bins - 1)];
    }
  }
  return counts;
}

}  // namespace limn
