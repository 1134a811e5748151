// The linker puts __wrap_write in the place of write, and so on, for whatever is linked statically.
#include "files/failing_calls.h"

#include <algorithm>
#include <cerrno>
#include <cstdarg>

#include <sys/stat.h>
#include <sys/types.h>

// NOLINTBEGIN(bugprone-reserved-identifier, readability-identifier-naming): as the linker has
// it.
namespace {

using limn::test::Call;
using limn::test::kCallCount;

struct State {
  std::array<int, kCallCount> counts{};
  Call call{};
  int nth = 0;  ///< 0: none fails.
  int error = 0;
  bool is_for_ever = false;
  std::size_t most_bytes = 0;  ///< 0: as many as asked for.
  bool is_interrupted = false;
};
State state;

bool fails(Call call) {
  const int count = ++state.counts.at(static_cast<std::size_t>(call));
  if (state.nth == 0 || call != state.call ||
      (state.is_for_ever ? count < state.nth : count != state.nth)) {
    return false;
  }
  errno = state.error;
  return true;
}

}  // namespace

extern "C" {

int __real_open(const char* path, int flags, ...);
int __wrap_open(const char* path, int flags, ...);
int __wrap_open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const auto mode = va_arg(rest, mode_t);
  va_end(rest);
  return fails(Call::kOpen) ? -1 : __real_open(path, flags, mode);
}

ssize_t __real_write(int file, const void* bytes, std::size_t count);
ssize_t __wrap_write(int file, const void* bytes, std::size_t count);
ssize_t __wrap_write(int file, const void* bytes, std::size_t count) {
  if (fails(Call::kWrite)) {
    return -1;
  }
  if (state.most_bytes == 0) {
    return __real_write(file, bytes, count);
  }
  state.is_interrupted = !state.is_interrupted;
  if (state.is_interrupted) {
    errno = EINTR;
    return -1;
  }
  return __real_write(file, bytes, std::min(count, state.most_bytes));
}

int __real_fsync(int file);
int __wrap_fsync(int file);
int __wrap_fsync(int file) {
  return fails(Call::kFsync) ? -1 : __real_fsync(file);
}

int __real_close(int file);
int __wrap_close(int file);
int __wrap_close(int file) {
  // As on Linux: the descriptor is gone, whatever is said about it.
  const int closed = __real_close(file);
  return fails(Call::kClose) ? -1 : closed;
}

int __real_rename(const char* from, const char* to);
int __wrap_rename(const char* from, const char* to);
int __wrap_rename(const char* from, const char* to) {
  return fails(Call::kRename) ? -1 : __real_rename(from, to);
}

int __real_renameat2(int folder, const char* from, int other, const char* to, unsigned flags);
int __wrap_renameat2(int folder, const char* from, int other, const char* to, unsigned flags);
int __wrap_renameat2(int folder, const char* from, int other, const char* to, unsigned flags) {
  return fails(Call::kExchange) ? -1 : __real_renameat2(folder, from, other, to, flags);
}

int __real_fchmod(int file, mode_t mode);
int __wrap_fchmod(int file, mode_t mode);
int __wrap_fchmod(int file, mode_t mode) {
  return fails(Call::kFchmod) ? -1 : __real_fchmod(file, mode);
}

}  // extern "C"
// NOLINTEND(bugprone-reserved-identifier, readability-identifier-naming)

namespace limn::test {

FailingCall::FailingCall(Call call, int nth, int error, bool for_ever) {
  state.counts = {};
  state.call = call;
  state.nth = nth;
  state.error = error;
  state.is_for_ever = for_ever;
}
FailingCall::~FailingCall() {
  state.nth = 0;
}

HaltingWrites::HaltingWrites(std::size_t most_bytes) {
  state.most_bytes = most_bytes;
}
HaltingWrites::~HaltingWrites() {
  state.most_bytes = 0;
}

std::array<int, kCallCount> counted_calls() {
  return state.counts;
}
void forget_calls() {
  state.counts = {};
}

}  // namespace limn::test
