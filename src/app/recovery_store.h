#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "files/descriptor.h"
#include "limn/document/project_file.h"
#include "limn/error.h"

/// Copies of unsaved work on disk, for when the program is killed.
///
/// Each run of the program that has something to lose has a folder of its own in a common one, with
/// the newest copies as projects and a file that it keeps locked for as long as it lives: a folder
/// that is not locked is of a run that was killed.
namespace limn::app {

/// What a killed run has left. As long as this lives no other run takes it.
struct LostWork {
  std::filesystem::path folder;
  Descriptor lock;
  std::vector<std::filesystem::path> copies;  ///< Newest first; at least one.
  std::string name;                           ///< Of the document.
  std::filesystem::path project_path;         ///< Where it was last saved; empty if nowhere.
  std::filesystem::file_time_type written_at;
};

/// All there is in the common folder, newest first. Folders without anything in them are removed.
[[nodiscard]] std::vector<LostWork> find_lost_work(const std::filesystem::path& common);

/// The newest copy that can be read, with the project path it had.
/// Errors: what is wrong with the newest one, where none can be read.
[[nodiscard]] Result<Project> load_lost_work(const LostWork& work);

/// Removes it from disk.
void discard_lost_work(LostWork work);

/// The folder of this run. For one thread at a time.
class RecoveryStore {
 public:
  static constexpr std::size_t kKeptCopies = 3;

  /// Nothing is made before there is something to keep.
  explicit RecoveryStore(std::filesystem::path common) : common_(std::move(common)) {}

  /// Writes a copy and removes the oldest beyond those that are kept.
  /// Errors: kFailed with the system's reason.
  [[nodiscard]] Result<void> keep(const Document& document, const std::optional<ViewState>& view);
  /// There is nothing to lose any more: removes the folder.
  void clear();
  /// Takes over what another run has left as this run's own.
  void adopt(LostWork work);

 private:
  [[nodiscard]] Result<void> make_folder();
  void describe(const Document& document);

  std::filesystem::path common_;
  std::filesystem::path folder_;  ///< Empty: none yet.
  Descriptor lock_;
  std::string described_;  ///< What the description on disk says.
  unsigned next_ = 1;      ///< Number of the next copy.
};

}  // namespace limn::app
