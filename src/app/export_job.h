#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include <glm/vec3.hpp>

#include "app/file_access.h"
#include "app/mailbox.h"
#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/mesh/export.h"
#include "limn/mesh/refined_mesh.h"

namespace limn::app {

/// Writes a refined mesh to a file on a thread of its own.
class ExportJob {
 public:
  /// `wake` is called from the worker when a file is done.
  /// `arrivals` is that of its Mailbox, "export"; `files` must outlive this.
  explicit ExportJob(std::function<void()> wake, FileAccess& files, Arrivals* arrivals = nullptr)
      : wake_(std::move(wake)), files_(files), outcomes_("export", arrivals) {}
  /// Finishes what it is writing.
  ~ExportJob() { wait_until_idle(); }
  ExportJob(const ExportJob&) = delete;
  ExportJob& operator=(const ExportJob&) = delete;

  struct Outcome {
    std::filesystem::path path;
    std::size_t faces = 0;
    Result<void> written;
  };

  /// Waits for the file before, if one is being written. What `settings` point to is copied, but
  /// for colours, which must outlive this.
  void start(std::filesystem::path path, std::shared_ptr<const RefinedMesh> mesh,
             std::shared_ptr<const ControlMesh> control, const ExportSettings& settings);
  /// Whether the outcome of a file is on its way.
  [[nodiscard]] bool is_busy() const noexcept { return is_busy_; }
  void wait_until_idle();
  /// How it went with the file that was done last; once for each.
  [[nodiscard]] std::optional<Outcome> take_outcome();

 private:
  std::function<void()> wake_;
  FileAccess& files_;
  Mailbox<Outcome> outcomes_;
  bool is_busy_ = false;
  std::jthread worker_;
};

}  // namespace limn::app
