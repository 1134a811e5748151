#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "app/file_access.h"
#include "app/mailbox.h"
#include "app/recording/recording.h"
#include "limn/document/document.h"

namespace limn::app {

/// Writes down what a run of the program does, turn by turn, so that the file is of use even where
/// the run ends in a crash.
///
/// Stands between the session and the disk, and beside its mailboxes: both tell it what they say.
class Recorder final : public Arrivals, public FileAccess {
 public:
  /// Begins the file anew; asks the disk itself.
  /// Errors: kFailed where the file cannot be written.
  [[nodiscard]] static Result<std::unique_ptr<Recorder>> create(const std::filesystem::path& path);

  /// As if nothing had been asked for yet. Before `begin`.
  void forget() { turn_ = {}; }
  /// The head, without its files: those asked for until now are added.
  void begin(RecordingHead head);
  void add(const ui::InputEvent& event) { turn_.events.push_back(event); }
  /// What of a turn comes from outside; before the session is told.
  void begin_turn(const Workbench::News& news, double time);
  /// Its frame, where there was one.
  void add_frame(const Screen& screen, const Workbench::Frame& frame);
  /// Writes the turn down unless nothing happened in it.
  void end_turn(const Workbench& workbench);
  /// The state at the end of the run, and the end.
  void end(const Workbench& workbench);
  [[nodiscard]] std::string read_clipboard(const std::string& text);
  /// Why nothing more is written, once.
  [[nodiscard]] std::optional<Error> take_error();

  // Arrivals
  [[nodiscard]] std::size_t admit(const Box& box) override;

  // FileAccess
  [[nodiscard]] Result<Project> open(const std::string& name) override;
  [[nodiscard]] Result<ImportedMesh> import(const std::filesystem::path& path) override;
  [[nodiscard]] Result<void> save(const std::filesystem::path& path, const Document& document,
                                  const ViewState& view) override;
  [[nodiscard]] Result<void> write_mesh(const std::filesystem::path& path, const RefinedMesh& mesh,
                                        const ExportSettings& settings) override;
  [[nodiscard]] ui::PathPrompt list(ui::PathPrompt::Purpose purpose,
                                    const std::filesystem::path& folder) override;
  [[nodiscard]] std::filesystem::path working_folder() override;
  [[nodiscard]] std::filesystem::path new_picture(const std::string& stem) override;
  [[nodiscard]] Result<void> write_picture(const std::filesystem::path& path,
                                           const render::Image& image) override;

 private:
  explicit Recorder(const std::filesystem::path& path);
  void write(const std::string& line);
  void check_document(const Workbench& workbench, bool is_end);

  std::filesystem::path path_;
  std::ofstream out_;
  bool has_failed_ = false;
  std::optional<Error> error_;

  std::mutex mutex_;  ///< Over `turn_.exports`: meshes are written by a worker.
  RecordedTurn turn_;
  double time_ = 0.0;  ///< Of the last turn.
  bool takes_picture_ = false;
  std::optional<Screen> screen_;
  Revisions checked_;  ///< Of the document whose checksum was taken last.
};

}  // namespace limn::app
