#include "render/context/current.h"

#include <utility>

namespace limn::render {
namespace {

struct Current {
  const void* owner = nullptr;
  std::function<void()> release;
};

thread_local Current current;

}  // namespace

void switch_current(const void* owner, std::function<void()> release) {
  Current before = std::exchange(current, {owner, std::move(release)});
  if (before.owner != nullptr && before.owner != owner && before.release) {
    before.release();
  }
}

void forget_current(const void* owner) noexcept {
  if (current.owner == owner) {
    current.owner = nullptr;
    current.release = nullptr;
  }
}

bool is_current(const void* owner) noexcept {
  return current.owner == owner;
}

}  // namespace limn::render
