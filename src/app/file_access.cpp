#include "app/file_access.h"

#include <system_error>

#include "app/path_prompt.h"
#include "app/user_folders.h"
#include "limn/document/open.h"
#include "limn/mesh/import.h"
#include "render/png.h"

namespace limn::app {

namespace fs = std::filesystem;

Result<Project> DiskAccess::open(const std::string& name) {
  return open_document(name);
}

Result<ImportedMesh> DiskAccess::import(const fs::path& path) {
  return import_mesh(path);
}

Result<void> DiskAccess::save(const fs::path& path, const Document& document,
                              const ViewState& view) {
  return save_project(path, document, view);
}

Result<void> DiskAccess::write_mesh(const fs::path& path, const RefinedMesh& mesh,
                                    const ExportSettings& settings) {
  return export_mesh(path, mesh, settings);
}

ui::PathPrompt DiskAccess::list(ui::PathPrompt::Purpose purpose, const fs::path& folder) {
  return list_folder(purpose, folder);
}

fs::path DiskAccess::working_folder() {
  std::error_code ignored;
  return fs::current_path(ignored);
}

fs::path DiskAccess::new_picture(const std::string& stem) {
  return numbered_file(pictures_folder(), stem, ".png");
}

Result<void> DiskAccess::write_picture(const fs::path& path, const render::Image& image) {
  return render::write_png(path, image);
}

FileAccess& disk() {
  static DiskAccess access;
  return access;
}

}  // namespace limn::app
