#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "limn/painting/face_depths.h"

namespace limn {

/// What painting does to a face: raise or lower it, set it outright, or hold it to a least or
/// greatest depth. The result stays within 0..kMaxDepth.
struct DepthChange {
  enum class Kind { kAdd, kSet, kAtLeast, kAtMost };
  Kind kind = Kind::kAdd;
  int amount = 1;

  [[nodiscard]] static DepthChange add(int amount) noexcept { return {Kind::kAdd, amount}; }
  [[nodiscard]] static DepthChange set(int depth) noexcept { return {Kind::kSet, depth}; }
  [[nodiscard]] static DepthChange at_least(int depth) noexcept { return {Kind::kAtLeast, depth}; }
  [[nodiscard]] static DepthChange at_most(int depth) noexcept { return {Kind::kAtMost, depth}; }
  [[nodiscard]] int operator()(int depth) const noexcept;
  [[nodiscard]] bool operator==(const DepthChange&) const = default;
};

/// One face's change: what undo needs, and no more.
struct DepthEdit {
  std::uint32_t face = 0;
  std::uint8_t before = 0;
  std::uint8_t after = 0;

  [[nodiscard]] bool operator==(const DepthEdit&) const = default;
};

/// The edits that `change` makes to `faces`; faces it leaves as they are, and repeats, are left
/// out.
[[nodiscard]] std::vector<DepthEdit> plan_edits(const FaceDepths& depths,
                                                std::span<const std::uint32_t> faces,
                                                DepthChange change);

/// Sets each face to what it is after the edits.
void apply_edits(FaceDepths& depths, std::span<const DepthEdit> edits);
/// Sets each face to what it was before the edits.
void revert_edits(FaceDepths& depths, std::span<const DepthEdit> edits);

}  // namespace limn
