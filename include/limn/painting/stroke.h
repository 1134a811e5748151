#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "limn/painting/depth_change.h"

namespace limn {

/// One brush stroke from press to release: every face it touches changes once.
class Stroke {
 public:
  Stroke(const FaceDepths& before, DepthChange change);

  /// Paints `faces` into `depths`; those already touched by this stroke stay. Returns true where
  /// anything changed.
  bool touch(FaceDepths& depths, std::span<const std::uint32_t> faces);

  /// All edits so far, in the order they were made.
  [[nodiscard]] std::span<const DepthEdit> edits() const noexcept { return edits_; }

 private:
  DepthChange change_;
  std::vector<bool> touched_;
  std::vector<DepthEdit> edits_;
};

}  // namespace limn
