// STL and its triangles are the one format that needs a mesh of its own.
#include "limn/mesh/export.h"

#include <algorithm>

#include <fmt/format.h>

#include "limn/files/atomic_file.h"
#include "limn/mesh/triangulate.h"
#include "mesh/formats/depth_material.h"
#include "mesh/formats/mesh_view.h"
#include "mesh/formats/writers.h"
#include "mesh/printable.h"

namespace limn {
namespace {

using detail::MeshView;

std::shared_ptr<const ControlMesh> triangles_of(const ControlMesh& mesh) {
  return triangulated(mesh);
}

std::shared_ptr<const ControlMesh> triangles_of(const RefinedMesh& mesh) {
  return triangulated(*to_control_mesh(mesh));
}

template <class Mesh>
void write_as(std::ostream& out, MeshFormat format, const Mesh& mesh,
              const ExportSettings& settings) {
  switch (format) {
    case MeshFormat::kObj:
      return detail::write_obj(out, MeshView(mesh, settings), !settings.depth_colours.empty());
    case MeshFormat::kPly:
      return detail::write_ply(out, MeshView(mesh, settings), settings.is_text);
    case MeshFormat::kOff:
      return detail::write_off(out, MeshView(mesh, settings));
    case MeshFormat::kStl:
      return detail::write_stl(out, *triangles_of(mesh));
  }
}

/// The library is there before the file that names it.
Result<void> export_depth_library(const std::filesystem::path& path,
                                  const ExportSettings& settings) {
  const int deepest = *std::max_element(settings.depths.begin(), settings.depths.end());
  return write_file_atomically(path.parent_path() / detail::DepthLibrary, [&](std::ostream& out) {
    detail::write_depth_library(out, settings.depth_colours, deepest);
  });
}

template <class Mesh>
Result<void> export_to(const std::filesystem::path& path, const Mesh& mesh,
                       const ExportSettings& settings, std::optional<MeshFormat> format) {
  format = format ? format : format_by_ending(path);
  if (!format) {
    return fail(ErrorKind::kUsage,
                fmt::format("Meshes are not written with the ending \"{}\"; take .obj, .ply, .off "
                            "or .stl.",
                            detail::printable(path.extension().string())),
                path.string());
  }
  const bool has_depth_library = *format == MeshFormat::kObj && !settings.depth_colours.empty() &&
                                 detail::has_depth_materials(MeshView(mesh, settings));
  if (has_depth_library) {
    if (auto written = export_depth_library(path, settings); !written) {
      return written;
    }
  }
  return write_file_atomically(path,
                               [&](std::ostream& out) { write_as(out, *format, mesh, settings); });
}

}  // namespace

void write_mesh(std::ostream& out, MeshFormat format, const ControlMesh& mesh,
                const ExportSettings& settings) {
  write_as(out, format, mesh, settings);
}

void write_mesh(std::ostream& out, MeshFormat format, const RefinedMesh& mesh,
                const ExportSettings& settings) {
  write_as(out, format, mesh, settings);
}

Result<void> export_mesh(const std::filesystem::path& path, const ControlMesh& mesh,
                         const ExportSettings& settings, std::optional<MeshFormat> format) {
  return export_to(path, mesh, settings, format);
}

Result<void> export_mesh(const std::filesystem::path& path, const RefinedMesh& mesh,
                         const ExportSettings& settings, std::optional<MeshFormat> format) {
  return export_to(path, mesh, settings, format);
}

}  // namespace limn
