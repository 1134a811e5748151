#include "memory.h"

#include <malloc.h>
#include <sys/mman.h>
#include <sys/prctl.h>

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <new>
#include <string>

namespace limn::bench {
namespace {

constexpr int kMapFrom = 32 << 20;  // The largest threshold that glibc takes.
constexpr std::size_t kHugePage = std::size_t{2} << 20;
constexpr std::size_t kHugeFrom = 4 * kHugePage;

bool huge_pages_for_all = false;

std::atomic<std::size_t> allocations{0};

/// A figure of /proc/self/status in bytes, 0 where it is not there.
std::size_t status_bytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word == name + ":") {
      std::size_t kibibytes = 0;
      status >> kibibytes;
      return kibibytes << 10;
    }
  }
  return 0;
}

/// Lets VmHWM start again from what is held now.
void reset_peak() {
  std::ofstream("/proc/self/clear_refs") << "5";
}

}  // namespace

void settle_allocator() {
  mallopt(M_MMAP_THRESHOLD, kMapFrom);
  mallopt(M_TRIM_THRESHOLD, 2 * kMapFrom);
}

void return_free_memory() {
  malloc_trim(0);
}

void warm_free_memory(std::size_t bytes) {
  void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory != MAP_FAILED) {
    madvise(memory, bytes, MADV_HUGEPAGE);
    std::memset(memory, 1, bytes);
    munmap(memory, bytes);
  }
}

std::size_t allocation_count() {
  return allocations.load();
}

KeepMemory::KeepMemory() {
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
}

KeepMemory::~KeepMemory() {
  constexpr int kDefaultMaps = 65536;
  mallopt(M_MMAP_MAX, kDefaultMaps);
  settle_allocator();
  return_free_memory();
}

PageScope::PageScope(Pages pages) : pages_(pages) {
  if (pages_ == Pages::kSmall) {
    prctl(PR_SET_THP_DISABLE, 1, 0, 0, 0);
  }
  huge_pages_for_all = pages_ == Pages::kHuge;
}

PageScope::~PageScope() {
  if (pages_ == Pages::kSmall) {
    prctl(PR_SET_THP_DISABLE, 0, 0, 0, 0);
  }
  huge_pages_for_all = false;
}

std::size_t peak_of(const std::function<void()>& work) {
  return_free_memory();
  reset_peak();
  const std::size_t before = status_bytes("VmRSS");
  work();
  const std::size_t peak = status_bytes("VmHWM");
  return before == 0 || peak <= before ? 0 : peak - before;
}

}  // namespace limn::bench

// Every block of the program and of the libraries linked into it goes through here, so that they
// can be counted, and peers be given huge pages too.
void* operator new(std::size_t bytes) {
  using limn::bench::kHugeFrom;
  using limn::bench::kHugePage;
  limn::bench::allocations.fetch_add(1, std::memory_order_relaxed);
  void* memory = nullptr;
  if (limn::bench::huge_pages_for_all && bytes >= kHugeFrom) {
    memory = std::aligned_alloc(kHugePage, (bytes + kHugePage - 1) / kHugePage * kHugePage);
    if (memory != nullptr) {
      madvise(memory, bytes / kHugePage * kHugePage, MADV_HUGEPAGE);
    }
  } else {
    memory = std::malloc(bytes == 0 ? 1 : bytes);
  }
  if (memory == nullptr) {
    throw std::bad_alloc();
  }
  return memory;
}

void* operator new(std::size_t bytes, std::align_val_t alignment) {
  limn::bench::allocations.fetch_add(1, std::memory_order_relaxed);
  const auto align = static_cast<std::size_t>(alignment);
  void* memory = std::aligned_alloc(align, (bytes + align - 1) / align * align);
  if (memory == nullptr) {
    throw std::bad_alloc();
  }
  return memory;
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
