#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "app/file_access.h"
#include "app/mailbox.h"
#include "app/recording/recording.h"

namespace limn::app {

/// How what was played back compares with what was recorded.
struct PlayReport {
  std::size_t turns = 0;
  std::size_t actions = 0;
  std::size_t documents = 0;  ///< Compared.
  std::size_t pictures = 0;   ///< Compared.
  /// "at 12.3 s: the document is another one". At most kMostDifferences.
  std::vector<std::string> differences;

  static constexpr std::size_t kMostDifferences = 20;
};

/// Does again what was recorded: hands a workbench the same input at the same times, the same
/// files, and the same results of its workers in the same turns. Writes over nobody's files.
class Player final : public Arrivals, public FileAccess {
 public:
  explicit Player(Recording recording);
  ~Player() override;
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;

  /// Pictures that the person took are written into this folder, under their names; empty: nowhere.
  void set_pictures_folder(std::filesystem::path folder) { pictures_ = std::move(folder); }

  [[nodiscard]] const RecordingHead& head() const noexcept { return recording_.head; }
  /// What the recorded run began with. Call it once, before the workbench is made.
  [[nodiscard]] Result<Project> open_first();
  /// For the workbench; lives as long as this.
  [[nodiscard]] WorkbenchHost host();
  /// How long to wait for a result that the recorded run had: where it does not come, the two runs
  /// differ.
  void set_patience(std::chrono::seconds patience) { patience_ = patience; }
  /// Another driver may draw other pixels: whether pictures are worth comparing.
  void set_renderer(const std::string& renderer) {
    compares_pictures_ = renderer == recording_.head.renderer;
  }

  [[nodiscard]] std::size_t turns() const noexcept { return recording_.turns.size(); }
  [[nodiscard]] bool is_at_end() const noexcept { return next_ == recording_.turns.size(); }
  /// Of the turn that comes next, in seconds of the recorded run.
  [[nodiscard]] double next_time() const { return recording_.turns[next_].time; }
  /// The screen that the next turn is for.
  [[nodiscard]] const Screen& screen() const noexcept { return screen_; }

  using Draw = std::function<Workbench::Frame(const ui::InputFrame&, const Screen&, double now)>;
  /// Plays the next turn; `draw` is the workbench's frame.
  void play_turn(Workbench& workbench, const Draw& draw);
  [[nodiscard]] const PlayReport& report() const noexcept { return report_; }

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
  /// The next answer, where it is of this kind; otherwise that is a difference.
  template <class T>
  [[nodiscard]] std::optional<T> answer(const char* question);
  void differ(std::string what);
  void compare(const Workbench& workbench, const RecordedTurn& turn);
  /// A file of these bytes in a folder of our own, named as it was.
  [[nodiscard]] std::filesystem::path materialise(const std::string& path,
                                                  const std::string& bytes);

  Recording recording_;
  std::size_t next_ = 0;
  Screen screen_;
  ui::InputQueue queue_;
  std::deque<FileAnswer> answers_;
  const RecordedTurn* turn_ = nullptr;  ///< That is being played.
  double time_ = 0.0;
  bool compares_pictures_ = false;
  std::chrono::seconds patience_{120};
  std::filesystem::path pictures_;
  std::filesystem::path scratch_;  ///< Made when it is first needed.
  std::size_t scratch_files_ = 0;

  std::mutex mutex_;  ///< Over `exports_`: meshes are written by a worker.
  std::deque<WrittenFile> exports_;
  PlayReport report_;
};

}  // namespace limn::app
