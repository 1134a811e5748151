// By sorting, since a table of hashes could be made slow by a file that was made to.
#include "mesh/formats/weld.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace limn::detail {

WeldKey weld_key(const glm::dvec3& position) noexcept {
  // Adding 0 makes 0 of -0 and leaves everything else alone.
  return {std::bit_cast<std::uint64_t>(position.x + 0.0),
          std::bit_cast<std::uint64_t>(position.y + 0.0),
          std::bit_cast<std::uint64_t>(position.z + 0.0)};
}

WeldKey corner_key(std::uint32_t vertex, const glm::dvec2& uv) noexcept {
  return {std::bit_cast<std::uint64_t>(uv.x), std::bit_cast<std::uint64_t>(uv.y), vertex};
}

Welding weld(const std::vector<WeldKey>& keys) {
  std::vector<std::uint32_t> sorted(keys.size());
  std::iota(sorted.begin(), sorted.end(), 0U);
  std::sort(sorted.begin(), sorted.end(), [&keys](std::uint32_t a, std::uint32_t b) {
    return keys[a] != keys[b] ? keys[a] < keys[b] : a < b;
  });
  Welding result;
  result.numbers.resize(keys.size());
  // First to the lowest of the equal ones, then to their numbers.
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const bool is_again = i > 0 && keys[sorted[i]] == keys[sorted[i - 1]];
    result.numbers[sorted[i]] = is_again ? result.numbers[sorted[i - 1]] : sorted[i];
  }
  for (std::uint32_t i = 0; i < keys.size(); ++i) {
    const std::uint32_t lowest = result.numbers[i];
    if (lowest == i) {
      result.numbers[i] = static_cast<std::uint32_t>(result.first.size());
      result.first.push_back(i);
    } else {
      result.numbers[i] = result.numbers[lowest];
    }
  }
  return result;
}

}  // namespace limn::detail
