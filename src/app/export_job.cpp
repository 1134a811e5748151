// Everything a file is made of is shared and never changes, so that painting goes on meanwhile.
#include "app/export_job.h"

#include <new>
#include <utility>

namespace limn::app {
namespace {

Result<void> write(FileAccess& files, const std::filesystem::path& path, const RefinedMesh& mesh,
                   const ExportSettings& settings) {
  try {
    return files.write_mesh(path, mesh, settings);
  } catch (const std::bad_alloc&) {
    return fail(ErrorKind::kFailed, "There is not enough memory to write this mesh.",
                path.string());
  }
}

}  // namespace

void ExportJob::start(std::filesystem::path path, std::shared_ptr<const RefinedMesh> mesh,
                      std::shared_ptr<const ControlMesh> control, const ExportSettings& settings) {
  wait_until_idle();
  is_busy_ = true;
  std::vector<std::uint8_t> depths(settings.depths.begin(), settings.depths.end());
  worker_ = std::jthread([this, path = std::move(path), mesh = std::move(mesh),
                          control = std::move(control), depths = std::move(depths),
                          copy = settings]() mutable {
    copy.depths = depths;
    copy.control = control.get();
    outcomes_.put({path, mesh->face_count(), write(files_, path, *mesh, copy)});
    wake_();
  });
}

void ExportJob::wait_until_idle() {
  if (worker_.joinable()) {
    worker_.join();
  }
}

std::optional<ExportJob::Outcome> ExportJob::take_outcome() {
  std::vector<Outcome> outcomes = outcomes_.take();
  if (outcomes.empty()) {
    return std::nullopt;
  }
  is_busy_ = false;
  return std::move(outcomes.back());
}

}  // namespace limn::app
