#include "limn/document/open.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limn/mesh/bundled.h"
#include "limn/mesh/import.h"

namespace limn {
namespace {

namespace fs = std::filesystem;

Project unpainted(ImportedMesh mesh, std::string name, fs::path path) {
  return Project{make_document(std::move(mesh), std::move(name), std::move(path)), std::nullopt};
}

std::vector<std::string_view> bundled_names() {
  std::vector<std::string_view> names;
  for (const BundledMesh& mesh : bundled_meshes()) {
    names.push_back(mesh.name);
  }
  return names;
}

}  // namespace

Result<Project> open_document(const std::string& name, const BuildSettings& settings) {
  const fs::path path(name);
  std::error_code ignored;
  if (fs::exists(path, ignored)) {
    if (path.extension() == ".limn") {
      return load_project(path);
    }
    return import_mesh(path, settings).map([&](ImportedMesh mesh) {
      return unpainted(std::move(mesh), path.filename().string(), path);
    });
  }
  for (const std::string_view bundled : bundled_names()) {
    if (bundled == name) {
      return load_bundled_mesh(bundled).map(
          [&](ImportedMesh mesh) { return unpainted(std::move(mesh), name, {}); });
    }
  }
  return fail(ErrorKind::kBadInput,
              fmt::format("there is no such file, and no bundled mesh of that name; bundled are {}",
                          fmt::join(bundled_names(), ", ")),
              name);
}

}  // namespace limn
