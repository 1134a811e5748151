#pragma once

#include <cstddef>
#include <cstring>

#include "subdivision/point.h"

// Internal to this folder.
namespace limn {

using FloatPoint [[gnu::vector_size(16)]] = float;

/// Writes points one after the other; lanes that are not wanted are overwritten by the next.
template <std::size_t kWidth>
class FloatWriter {
 public:
  explicit FloatWriter(float* out) : out_(out) {}
  void put(const Point& point) noexcept {
    const auto rounded = __builtin_convertvector(point, FloatPoint);
    std::memcpy(out_, &rounded, (kWidth == 3 ? 4 : kWidth) * sizeof(float));
    out_ += kWidth;
  }
  void put_last(const Point& point) noexcept {
    const auto rounded = __builtin_convertvector(point, FloatPoint);
    std::memcpy(out_, &rounded, kWidth * sizeof(float));
  }

 private:
  float* out_;
};

}  // namespace limn
