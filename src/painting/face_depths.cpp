#include "limn/painting/face_depths.h"

#include <algorithm>

namespace limn {

int FaceDepths::deepest() const noexcept {
  const auto found = std::max_element(values_.begin(), values_.end());
  return found == values_.end() ? 0 : *found;
}

std::array<std::size_t, kMaxDepth + 1> FaceDepths::histogram() const noexcept {
  std::array<std::size_t, kMaxDepth + 1> counts{};
  for (const std::uint8_t depth : values_) {
    ++counts[depth];
  }
  return counts;
}

}  // namespace limn
