#pragma once

#include <functional>

namespace limn::render {

/// Notes that `owner` is about to become the calling thread's current context. Whoever was noted
/// before is released first: two window-system libraries in one process do not know of each other,
/// and each would otherwise believe that its context is still current.
void switch_current(const void* owner, std::function<void()> release);
/// Forgets `owner`, without releasing it.
void forget_current(const void* owner) noexcept;
[[nodiscard]] bool is_current(const void* owner) noexcept;

}  // namespace limn::render
