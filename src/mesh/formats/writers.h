#pragma once

#include <ostream>
#include <span>

#include <glm/vec3.hpp>

#include "mesh/formats/mesh_view.h"

// From a mesh to the bytes of a file; what each format holds is said in mesh/export.h.
namespace limn::detail {

/// With `has_depth_library` the text names the library of the depths' materials where it uses them.
void write_obj(std::ostream& out, const MeshView& mesh, bool has_depth_library);
void write_ply(std::ostream& out, const MeshView& mesh, bool is_text);
void write_off(std::ostream& out, const MeshView& mesh);
/// The mesh is of triangles.
void write_stl(std::ostream& out, const ControlMesh& mesh);

/// Whether the OBJ file of a mesh has depths as materials.
[[nodiscard]] bool has_depth_materials(const MeshView& mesh);
/// The library of the depths' materials.
void write_depth_library(std::ostream& out, std::span<const glm::u8vec3> colours, int deepest);

}  // namespace limn::detail
