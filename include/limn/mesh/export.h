#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/mesh/mesh_format.h"
#include "limn/mesh/refined_mesh.h"

namespace limn {

/// What goes out with a mesh.
struct ExportSettings {
  /// Depth of every control face, or empty: the painting stays behind.
  std::span<const std::uint8_t> depths = {};
  /// For a refined mesh the control mesh that it was made of, whose names of faces and loose
  /// vertices go with it; null: they stay behind.
  const ControlMesh* control = nullptr;
  /// sRGB colours of the depths, the last one for all deeper; where there are some, OBJ with
  /// depths as materials names a library `limn_depths.mtl`, which export_mesh writes beside it.
  std::span<const glm::u8vec3> depth_colours = {};
  bool is_text = false;  ///< PLY as text, not as little-endian binary data.
};

/// Writes a mesh in world coordinates.
///
/// OBJ holds everything. Depths are `usemtl depth_N`, which other programs keep, or where the mesh
/// has materials of its own `t limn_depth` (mesh/import.h); sharpness is `t crease` and `t corner`.
/// PLY holds everything but names and seams between equal texture coordinates: texture coordinates
/// as `s` and `t` of vertices, or where there are seams as `texcoord` of corners; `limn_depth` of
/// faces, `limn_sharpness` of vertices and edges. OFF holds the surface and texture coordinates
/// without seams (STOFF). STL is written as binary data, in triangles (mesh/triangulate.h) and
/// single precision.
///
/// Numbers in text have as many digits as give the same number back: the float of a refined mesh
/// near the origin, else the double. Read back, OBJ and PLY give the same control mesh and
/// attributes to the last bit; OFF the same surface, and STL the same triangles where coordinates
/// are floats and no two vertices share a place. Faces and vertices keep their order. What is still
/// sharp in a refined mesh goes out with the sharpness that remains, so that whoever goes on
/// subdividing gets the same surface.
void write_mesh(std::ostream& out, MeshFormat format, const ControlMesh& mesh,
                const ExportSettings& settings = {});
void write_mesh(std::ostream& out, MeshFormat format, const RefinedMesh& mesh,
                const ExportSettings& settings = {});

/// Writes a mesh to a file atomically: it holds the old contents or all of the new ones, never a
/// part. The format is the one of the name's ending unless given. Errors: kUsage for another
/// ending, kFailed where writing fails, naming the path.
[[nodiscard]] Result<void> export_mesh(const std::filesystem::path& path, const ControlMesh& mesh,
                                       const ExportSettings& settings = {},
                                       std::optional<MeshFormat> format = std::nullopt);
[[nodiscard]] Result<void> export_mesh(const std::filesystem::path& path, const RefinedMesh& mesh,
                                       const ExportSettings& settings = {},
                                       std::optional<MeshFormat> format = std::nullopt);

/// What a file of this format would not hold of the mesh, as phrases: "12 creases", "texture
/// coordinates". Empty where nothing is lost.
[[nodiscard]] std::vector<std::string> lost_in(MeshFormat format, const ControlMesh& mesh,
                                               const ExportSettings& settings = {});
[[nodiscard]] std::vector<std::string> lost_in(MeshFormat format, const RefinedMesh& mesh,
                                               const ExportSettings& settings = {});

/// The same as one sentence for people; empty where nothing is lost.
[[nodiscard]] std::string loss_sentence(MeshFormat format, std::span<const std::string> lost);

}  // namespace limn
