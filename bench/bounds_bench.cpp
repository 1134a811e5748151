// How fast the machine lets anyone write: memory that was touched before, memory that is touched
// for the first time, on small and on huge pages, and copying. Each thread has a block of its own.
#include <sys/mman.h>

#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "cases.h"
#include "limn/contract.h"
#include "memory.h"

namespace limn::bench {
namespace {

constexpr std::size_t kBytes = std::size_t{192} << 20;  // Well beyond any cache.
constexpr std::size_t kHugePage = std::size_t{2} << 20;

/// Untouched memory, aligned for huge pages, which it is on or not.
class Block {
 public:
  explicit Block(bool huge) {
    mapped_ = mmap(nullptr, kBytes + kHugePage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS,
                   -1, 0);
    LIMN_EXPECTS(mapped_ != MAP_FAILED);
    const auto address = reinterpret_cast<std::uintptr_t>(mapped_);
    data_ = static_cast<std::byte*>(mapped_) + (kHugePage - address % kHugePage) % kHugePage;
    madvise(data_, kBytes, huge ? MADV_HUGEPAGE : MADV_NOHUGEPAGE);
  }
  ~Block() { munmap(mapped_, kBytes + kHugePage); }
  Block(const Block&) = delete;
  Block& operator=(const Block&) = delete;

  [[nodiscard]] std::byte* data() const { return data_; }

 private:
  void* mapped_ = nullptr;
  std::byte* data_ = nullptr;
};

enum class Kind { kCopy, kFill, kFirstTouchSmall, kFirstTouchHuge };

void write_memory(benchmark::State& state, Kind kind, std::size_t threads) {
  warm_free_memory(threads * (kBytes + kHugePage));
  std::vector<std::unique_ptr<Block>> from(threads);
  std::vector<std::unique_ptr<Block>> to(threads);
  for (std::size_t t = 0; t < threads; ++t) {
    to[t] = std::make_unique<Block>(kind != Kind::kFirstTouchSmall);
    if (kind == Kind::kCopy) {
      from[t] = std::make_unique<Block>(true);
      std::memset(from[t]->data(), 1, kBytes);
    }
    if (kind == Kind::kCopy || kind == Kind::kFill) {
      std::memset(to[t]->data(), 2, kBytes);
    }
  }
  const auto write = [&](std::size_t t) {
    if (kind == Kind::kCopy) {
      std::memcpy(to[t]->data(), from[t]->data(), kBytes);
    } else {
      std::memset(to[t]->data(), 3, kBytes);
    }
    benchmark::ClobberMemory();
  };
  time_run(state, [&] {
    std::vector<std::jthread> others;
    for (std::size_t t = 1; t < threads; ++t) {
      others.emplace_back(write, t);
    }
    write(0);
  });
  state.counters["written_bytes"] = static_cast<double>(kBytes * threads);
}

}  // namespace

void register_bounds(Extent extent) {
  const int repetitions = extent == Extent::kQuick ? 3 : 7;
  const auto add = [&](const std::string& name, Kind kind) {
    for (const std::size_t threads : {std::size_t{1}, std::size_t{2}}) {
      add_case("bounds/" + name + "/" + std::to_string(threads), repetitions,
               [kind, threads](benchmark::State& state) { write_memory(state, kind, threads); });
    }
  };
  add("copy", Kind::kCopy);
  add("fill", Kind::kFill);
  add("first_touch_4_kib", Kind::kFirstTouchSmall);
  add("first_touch_2_mib", Kind::kFirstTouchHuge);
}

}  // namespace limn::bench
