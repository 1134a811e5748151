#pragma once

#include <filesystem>
#include <string>

#include "limn/document/project_file.h"
#include "limn/error.h"
#include "limn/mesh/build.h"
#include "limn/mesh/export.h"
#include "render/image.h"
#include "ui/model.h"

namespace limn::app {

/// Everything a session reads and writes outside of itself, so that a recording can hold what was
/// read, and playing it back writes over nobody's files.
class FileAccess {
 public:
  virtual ~FileAccess() = default;

  /// As `open_document`.
  [[nodiscard]] virtual Result<Project> open(const std::string& name) = 0;
  /// As `import_mesh`.
  [[nodiscard]] virtual Result<ImportedMesh> import(const std::filesystem::path& path) = 0;
  /// As `save_project`.
  [[nodiscard]] virtual Result<void> save(const std::filesystem::path& path,
                                          const Document& document, const ViewState& view) = 0;
  /// As `export_mesh`; called from a worker, one file at a time.
  [[nodiscard]] virtual Result<void> write_mesh(const std::filesystem::path& path,
                                                const RefinedMesh& mesh,
                                                const ExportSettings& settings) = 0;
  /// As `list_folder`.
  [[nodiscard]] virtual ui::PathPrompt list(ui::PathPrompt::Purpose purpose,
                                            const std::filesystem::path& folder) = 0;
  [[nodiscard]] virtual std::filesystem::path working_folder() = 0;
  /// A name in the pictures' folder that is not taken yet: `stem-001.png`.
  [[nodiscard]] virtual std::filesystem::path new_picture(const std::string& stem) = 0;
  [[nodiscard]] virtual Result<void> write_picture(const std::filesystem::path& path,
                                                   const render::Image& image) = 0;
};

/// The disk itself.
class DiskAccess final : public FileAccess {
 public:
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
};

/// The one that is used where nobody says otherwise.
[[nodiscard]] FileAccess& disk();

}  // namespace limn::app
