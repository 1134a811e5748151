// Every form of operator new comes down to std::aligned_alloc, whose memory std::free takes back
// whatever the alignment.
#include "support/counting_allocator.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> asked{0};
std::atomic<long> allocations_left = limn::test::kUnlimitedAllocations;  ///< From 0 on, all fail.
std::atomic<std::size_t> smallest_counted = 0;                           ///< Bytes.

void* allocate(std::size_t bytes, std::size_t alignment) {
  ++asked;
  if (long left = allocations_left.load();
      left != limn::test::kUnlimitedAllocations && bytes >= smallest_counted) {
    while (left > 0 && !allocations_left.compare_exchange_weak(left, left - 1)) {
    }
    if (left == 0) {
      throw std::bad_alloc();
    }
  }
  const std::size_t rounded =
      (std::max<std::size_t>(bytes, 1) + alignment - 1) / alignment * alignment;
  void* const memory = std::aligned_alloc(alignment, rounded);
  if (memory == nullptr) {
    throw std::bad_alloc();
  }
  return memory;
}

}  // namespace

void* operator new(std::size_t bytes) {
  return allocate(bytes, alignof(std::max_align_t));
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return allocate(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace limn::test {

std::size_t allocation_count() noexcept {
  return asked.load();
}

void allow_allocations(long count, std::size_t smallest) noexcept {
  smallest_counted = smallest;
  allocations_left = count;
}

}  // namespace limn::test
