#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "limn/contract.h"
#include "limn/subdivision/settings.h"

namespace limn {

/// The painting: for every control face how many levels it shall get, 0..kMaxDepth.
class FaceDepths {
 public:
  FaceDepths() = default;
  /// All alike.
  explicit FaceDepths(std::size_t faces, int depth = 0)
      : values_(faces, static_cast<std::uint8_t>(depth)) {
    LIMN_EXPECTS(depth >= 0 && depth <= kMaxDepth);
  }

  [[nodiscard]] std::size_t size() const noexcept { return values_.size(); }
  [[nodiscard]] int operator[](std::size_t face) const noexcept { return values_[face]; }
  [[nodiscard]] std::span<const std::uint8_t> values() const noexcept { return values_; }
  void set(std::size_t face, int depth) {
    LIMN_EXPECTS(face < values_.size() && depth >= 0 && depth <= kMaxDepth);
    values_[face] = static_cast<std::uint8_t>(depth);
  }
  [[nodiscard]] int deepest() const noexcept;
  /// How many faces have each depth.
  [[nodiscard]] std::array<std::size_t, kMaxDepth + 1> histogram() const noexcept;

  [[nodiscard]] bool operator==(const FaceDepths&) const = default;

 private:
  std::vector<std::uint8_t> values_;
};

}  // namespace limn
