#pragma once

namespace limn::test {

/// How much of the work of a test that could go on for ever is to be done: 1, or a quarter in a
/// sanitized build, where every step takes some ten times as long.
[[nodiscard]] double effort() noexcept;

}  // namespace limn::test
