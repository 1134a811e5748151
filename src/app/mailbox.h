#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <iterator>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace limn::app {

/// Decides how much of what other threads have found is taken in at a time, so that what a person
/// did can be played back: whoever records writes down how much it was, and whoever plays back
/// waits until there is as much again.
class Arrivals {
 public:
  /// A box as it is asked about.
  class Box {
   public:
    [[nodiscard]] virtual std::string_view name() const noexcept = 0;
    [[nodiscard]] virtual std::size_t ready() const = 0;
    /// Waits until at least `count` pieces are there; false where they do not come in time.
    [[nodiscard]] virtual bool wait_for(std::size_t count, std::chrono::seconds patience) const = 0;

   protected:
    ~Box() = default;
  };

  virtual ~Arrivals() = default;
  /// How many pieces the owner may take out of the box now; at most `box.ready()` afterwards.
  [[nodiscard]] virtual std::size_t admit(const Box& box) = 0;
};

/// What a worker has to tell its owner, in order.
///
/// `put` is called from any thread, all else from the owner's.
template <class T>
class Mailbox final : public Arrivals::Box {
 public:
  /// `arrivals` may be null: then whatever is there is taken. It must outlive the box.
  Mailbox(std::string name, Arrivals* arrivals) : name_(std::move(name)), arrivals_(arrivals) {}
  virtual ~Mailbox() = default;

  void put(T piece) {
    {
      const std::lock_guard lock(mutex_);
      pieces_.push_back(std::move(piece));
    }
    changed_.notify_all();
  }

  /// Throws away what was not taken.
  void clear() {
    const std::lock_guard lock(mutex_);
    pieces_.clear();
  }

  [[nodiscard]] std::vector<T> take() {
    const std::size_t count = arrivals_ != nullptr ? arrivals_->admit(*this) : ready();
    const std::lock_guard lock(mutex_);
    const auto end = pieces_.begin() + static_cast<std::ptrdiff_t>(std::min(count, pieces_.size()));
    std::vector<T> taken(std::make_move_iterator(pieces_.begin()), std::make_move_iterator(end));
    pieces_.erase(pieces_.begin(), end);
    return taken;
  }

  [[nodiscard]] std::string_view name() const noexcept override { return name_; }
  [[nodiscard]] std::size_t ready() const override {
    const std::lock_guard lock(mutex_);
    return pieces_.size();
  }
  [[nodiscard]] bool wait_for(std::size_t count, std::chrono::seconds patience) const override {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, patience, [&] { return pieces_.size() >= count; });
  }

 private:
  std::string name_;
  Arrivals* arrivals_;
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::vector<T> pieces_;
};

}  // namespace limn::app
