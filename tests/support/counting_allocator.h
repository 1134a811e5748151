#pragma once

#include <cstddef>

/// operator new of the whole program, counted and made to fail. Link `limn_test_allocator`: that
/// replaces operator new and delete for all that is in the program.
namespace limn::test {

/// How often operator new was asked since the program began, by any thread.
[[nodiscard]] std::size_t allocation_count() noexcept;

inline constexpr long kUnlimitedAllocations = -1;

/// Lets so many more allocations succeed; every one after them throws std::bad_alloc.
/// kUnlimitedAllocations: all succeed again. Requests of fewer bytes than `smallest` always succeed
/// and do not count towards that.
void allow_allocations(long count, std::size_t smallest = 0) noexcept;

}  // namespace limn::test
