#pragma once

#include <array>
#include <cstddef>

/// Makes calls of the operating system fail, in programs that are linked with `limn_fail_calls`.
namespace limn::test {

enum class Call { kOpen, kWrite, kFsync, kClose, kRename, kExchange, kFchmod };
inline constexpr std::size_t kCallCount = 7;

/// While it lives, the `nth` call (from 1) of a kind in this process fails with `error`; all from
/// there on where `for_ever`. One at a time.
class FailingCall {
 public:
  FailingCall(Call call, int nth, int error, bool for_ever = false);
  ~FailingCall();
  FailingCall(const FailingCall&) = delete;
  FailingCall& operator=(const FailingCall&) = delete;
};

/// While it lives, writes write at most so many bytes at once and are interrupted every other time.
class HaltingWrites {
 public:
  explicit HaltingWrites(std::size_t most_bytes);
  ~HaltingWrites();
  HaltingWrites(const HaltingWrites&) = delete;
  HaltingWrites& operator=(const HaltingWrites&) = delete;
};

/// How often each kind was called since the last `forget_calls`.
[[nodiscard]] std::array<int, kCallCount> counted_calls();
void forget_calls();

}  // namespace limn::test
