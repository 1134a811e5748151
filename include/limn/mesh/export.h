#pragma once

#include <cstdint>
#include <filesystem>
#include <ostream>
#include <span>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/mesh/refined_mesh.h"

namespace limn {

/// Writes a refined mesh as OBJ text, in world coordinates. Positions have as many digits as give
/// the same number back: the float, or the double where the mesh has an origin of its own.
/// `depths[f]`, the depth of control face f, groups the faces by `usemtl depth_N`, which other
/// programs keep. Pass an empty span to leave the groups out. Faces keep their order, so a group
/// statement stands wherever the depth changes. Texture coordinates and limit normals are written
/// where the mesh has them, and what is still sharp as `t crease` and `t corner` tags with the
/// sharpness that remains, so that whoever goes on subdividing gets the same surface (forms:
/// mesh/import.h).
void write_obj(std::ostream& out, const RefinedMesh& mesh, std::span<const std::uint8_t> depths);

/// The same for a control mesh. Read back, the text gives the same mesh and attributes to the last
/// bit, texture coordinates that no corner uses excepted.
void write_obj(std::ostream& out, const ControlMesh& mesh, std::span<const std::uint8_t> depths);

/// Writes the same text to a file atomically: it holds the old contents or all of the new ones,
/// never a part. Errors: kFailed, naming the path.
[[nodiscard]] Result<void> export_obj(const std::filesystem::path& path, const RefinedMesh& mesh,
                                      std::span<const std::uint8_t> depths);
/// The same for a control mesh.
[[nodiscard]] Result<void> export_obj(const std::filesystem::path& path, const ControlMesh& mesh,
                                      std::span<const std::uint8_t> depths);

}  // namespace limn
