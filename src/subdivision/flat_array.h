#pragma once

#include <cstddef>
#include <memory>

// Internal to this folder.
namespace limn {

/// A fixed number of trivial values in one allocation, left unset until a parallel loop sets them.
template <class T>
class FlatArray {
 public:
  FlatArray() = default;
  explicit FlatArray(std::size_t size)
      : values_(std::make_unique_for_overwrite<T[]>(size)), size_(size) {}

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] T& operator[](std::size_t i) noexcept { return values_[i]; }
  [[nodiscard]] const T& operator[](std::size_t i) const noexcept { return values_[i]; }

 private:
  std::unique_ptr<T[]> values_;
  std::size_t size_ = 0;
};

}  // namespace limn
