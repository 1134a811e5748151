// Page faults are what a large fresh array costs most: with 4 KiB pages the kernel clears and maps
// 512 times as often as with 2 MiB ones. Blocks of some megabytes are therefore aligned to 2 MiB
// and the kernel is asked for huge pages there; it may decline, which costs speed and nothing else.
#include "limn/mesh/large_array.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace limn {
namespace {

/// Enough for every vector type.
constexpr std::align_val_t kCacheLine{64};
constexpr std::size_t kHugePage = std::size_t{2} << 20;
/// Below this the last, partly used huge page would weigh more than the faults it saves.
constexpr std::size_t kLarge = 4 * kHugePage;

}  // namespace

void* allocate_pages(std::size_t bytes) {
  if (bytes < kLarge) {
    return ::operator new(bytes, kCacheLine);
  }
  void* memory = ::operator new (bytes, std::align_val_t{kHugePage});
#ifdef __linux__
  // The last page stays small, so that no more is used than was asked for. Advice can fail: see
  // above.
  (void)::madvise(memory, bytes / kHugePage * kHugePage, MADV_HUGEPAGE);
#endif
  return memory;
}

void release_pages(void* memory, std::size_t bytes) noexcept {
  if (bytes < kLarge) {
    ::operator delete(memory, kCacheLine);
  } else {
    ::operator delete (memory, std::align_val_t{kHugePage});
  }
}

}  // namespace limn
