#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <limits>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <variant>

#include "app/recovery_store.h"
#include "limn/document/document.h"

namespace limn::app {

/// Keeps copies of a document that differs from what is on disk, on a thread of its own: after
/// every refinement, and where there is none after a minute of changes.
class Autosave {
 public:
  static constexpr double kSeconds = 60.0;

  /// `common` is the folder of RecoveryStore; empty: nothing is kept. `wake` is called from the
  /// thread when a copy is done.
  Autosave(std::filesystem::path common, std::function<void()> wake);
  /// Finishes what it is writing. What is kept stays, unless it was cleared.
  ~Autosave();
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  struct State {
    const Document& document;
    const ViewState& view;
    bool is_modified = false;      ///< The document differs from what was saved.
    bool is_stroking = false;      ///< It is about to change; what is there is half an operation.
    std::uint64_t refinement = 0;  ///< Another number after every refinement.
  };
  /// Looks whether a copy is due at `now`, in seconds, never falling; starts it.
  void follow(const State& state, double now);
  /// When `follow` next has something to do of its own accord; infinity where it has not.
  [[nodiscard]] double next() const noexcept { return next_; }

  /// There is nothing to lose any more.
  void clear();
  /// What was recovered is this run's from here on, until it is saved.
  void adopt(LostWork work);

  /// Why copies cannot be kept, once; and again only after one was.
  [[nodiscard]] std::optional<Error> take_error();
  void wait_until_idle() const;

  /// How the copying stands.
  struct Standing {
    std::uint64_t kept = 0;  ///< Copies written so far; grows.
    std::string problem;     ///< Why the last one was not; empty where it was.
    bool is_clear = true;    ///< Nothing is kept, and nothing about to be.
  };
  [[nodiscard]] Standing standing() const;

 private:
  struct Copy {
    Document document;
    ViewState view;
  };
  struct Clear {};
  using Task = std::variant<Copy, Clear, LostWork>;

  void submit(Task task);
  void work(const std::stop_token& stop);
  void carry_out(Task task);
  [[nodiscard]] bool is_busy() const;

  std::filesystem::path common_;
  std::function<void()> wake_;

  // The owner's.
  Revisions kept_;           ///< Of the last copy.
  double changed_at_;        ///< The first change since then; infinity: none.
  double kept_at_;           ///< When that was.
  bool has_copies_ = false;  ///< On disk, or about to be.
  bool is_refined_ = false;  ///< Since the last copy.
  std::uint64_t refinement_ = 0;
  double next_ = std::numeric_limits<double>::infinity();

  RecoveryStore store_;  ///< The worker's.
  mutable std::mutex mutex_;
  mutable std::condition_variable_any changed_;
  std::deque<Task> tasks_;
  bool is_working_ = false;
  double seconds_ = 0.0;  ///< The last copy took.
  bool has_failed_ = false;
  std::optional<Error> error_;
  std::uint64_t kept_copies_ = 0;
  std::string problem_;

  std::jthread worker_;  ///< Last, so that it stops before anything it uses is gone.
};

}  // namespace limn::app
