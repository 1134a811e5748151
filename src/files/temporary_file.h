#pragma once

#include <filesystem>

#include "files/descriptor.h"

namespace limn {

/// A new file with a name of its own, to be written and then put in the place of another. Removed
/// at the end unless it is there.
///
/// It is locked for as long as it is open, so that nobody takes it for one that a crash has left.
class TemporaryFile {
 public:
  /// Made with the rights that the umask allows. Where it cannot be made, `is_made` is false and
  /// `error` is the system's number of the reason.
  explicit TemporaryFile(const std::filesystem::path& folder);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  [[nodiscard]] bool is_made() const noexcept { return is_made_; }
  [[nodiscard]] int error() const noexcept { return error_; }
  [[nodiscard]] int descriptor() const noexcept { return descriptor_.get(); }

  /// False, with errno set, where the system says that something was lost.
  [[nodiscard]] bool close() noexcept { return descriptor_.close(); }
  /// Puts it in the place of `target`. Where there was a file and the file system can exchange
  /// two, the old one is kept under the temporary's name until the end. False, with errno set,
  /// where the system refuses; then all is as it was.
  [[nodiscard]] bool replace(const std::filesystem::path& target) noexcept;
  /// Takes back what `replace` did; false where the old file was not kept.
  [[nodiscard]] bool take_back(const std::filesystem::path& target) noexcept;

 private:
  enum class State { kApart, kNewInPlace, kExchanged };

  std::filesystem::path path_;
  Descriptor descriptor_;
  State state_ = State::kApart;
  bool is_made_ = false;
  bool has_replaced_ = false;  ///< There was a file, and it is gone.
  int error_ = 0;
};

/// Removes what TemporaryFile left in a folder when its process was killed: regular files of such
/// a name, of this user, whose process is gone and which nobody has locked. Whatever cannot be
/// removed stays.
void sweep_temporaries(const std::filesystem::path& folder) noexcept;

}  // namespace limn
