#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace limn {

/// Memory for `bytes` bytes, on huge pages where that pays and the system has them.
/// Throws std::bad_alloc.
[[nodiscard]] void* allocate_pages(std::size_t bytes);
void release_pages(void* memory, std::size_t bytes) noexcept;

/// Allocates whole pages and leaves elements unset where a vector would zero them: an array of
/// millions is written once, by the loop that has its values.
template <class T>
class PageAllocator {
 public:
  using value_type = T;

  PageAllocator() = default;
  template <class U>
  PageAllocator(const PageAllocator<U>&) noexcept {}  // NOLINT: allocators convert implicitly.

  [[nodiscard]] T* allocate(std::size_t n) {
    if (n > static_cast<std::size_t>(-1) / sizeof(T)) {
      throw std::bad_array_new_length();
    }
    return static_cast<T*>(allocate_pages(n * sizeof(T)));
  }
  void deallocate(T* memory, std::size_t n) noexcept { release_pages(memory, n * sizeof(T)); }

  template <class U, class... Arguments>
  void construct(U* at, Arguments&&... arguments) {
    if constexpr (sizeof...(Arguments) == 0) {
      ::new (static_cast<void*>(at)) U;  // Trivial elements stay as they are.
    } else {
      std::construct_at(at, std::forward<Arguments>(arguments)...);
    }
  }

  template <class U>
  [[nodiscard]] bool operator==(const PageAllocator<U>&) const noexcept {
    return true;
  }
};

/// A vector for the large arrays of trivial elements: `resize` leaves new elements unset.
template <class T>
using LargeArray = std::vector<T, PageAllocator<T>>;

}  // namespace limn
