#include "limn/painting/face_depths.h"

#include <algorithm>

namespace limn {

int FaceDepths::deepest() const noexcept {
  // Not std::max_element: without a place to remember, the compiler takes many at a time.
  std::uint8_t deepest = 0;
  for (const std::uint8_t depth : values_) {
    deepest = std::max(deepest, depth);
  }
  return deepest;
}

std::array<std::size_t, kMaxDepth + 1> FaceDepths::histogram() const noexcept {
  std::array<std::size_t, kMaxDepth + 1> counts{};
  for (const std::uint8_t depth : values_) {
    ++counts[depth];
  }
  return counts;
}

}  // namespace limn
