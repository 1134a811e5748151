#pragma once

#include <cstddef>
#include <functional>

namespace limn::bench {

/// Fixes glibc's allocator at the settings that its own adjustment ends at once large blocks have
/// been freed (blocks from 32 MiB are mapped one by one), so that no run depends on those before
/// it. Call it first.
void settle_allocator();

/// Gives what is free back to the system: the next run takes its memory anew and pays for it.
void return_free_memory();

/// Makes sure that the system has `bytes` to give at once. A virtual machine hands memory that was
/// free for a while back to its host, and taking that again can take ten times as long: a time that
/// would be the host's, and anyone's who happens to come first.
void warm_free_memory(std::size_t bytes);

/// How often memory was asked for by `operator new` so far.
[[nodiscard]] std::size_t allocation_count();

/// While it lives, freed memory stays with the process and is taken again: the nearest a program
/// without a way of its own comes to refining into memory it already has.
class KeepMemory {
 public:
  KeepMemory();
  ~KeepMemory();
  KeepMemory(const KeepMemory&) = delete;
  KeepMemory& operator=(const KeepMemory&) = delete;
};

/// The pages that large blocks come on.
enum class Pages {
  kOwnChoice,  ///< As the program asks: huge ones for Limn, 4 KiB for peers where the kernel's
               ///< setting for transparent huge pages is `madvise`.
  kSmall,      ///< 4 KiB, whatever the program asks.
  kHuge,       ///< 2 MiB for every block from 8 MiB, also of programs that do not ask.
};

/// Sets the pages of what is allocated while it lives.
class PageScope {
 public:
  explicit PageScope(Pages pages);
  ~PageScope();
  PageScope(const PageScope&) = delete;
  PageScope& operator=(const PageScope&) = delete;

 private:
  Pages pages_;
};

/// Peak memory of `work` over what the process held before it, in bytes, as the kernel counts it
/// (VmHWM). 0 where that cannot be told. Meant for a process of its own: memory that is free but
/// not given back would not count.
[[nodiscard]] std::size_t peak_of(const std::function<void()>& work);

}  // namespace limn::bench
