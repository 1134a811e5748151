#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"

namespace limn::bench {

/// The control mesh of a name: a bundled mesh, or `asteroid_15k`, `asteroid_61k`, `asteroid_246k`.
/// Made when first asked for and kept until the program ends.
///
/// An asteroid is a closed, bumpy sphere of 15,360, 61,440 or 245,760 quads. One vertex in 32 is
/// extraordinary (valence 3 or 6, and twelve of 5), evenly spread, as in a character that was
/// modelled or remeshed by quads. Uniform refinement by 4, 3 or 2 levels makes 3,932,160 faces.
/// Broken contract where there is no such mesh.
[[nodiscard]] const ControlMesh& control_mesh(const std::string& name);

/// Makes an OBJ file a control mesh, named as the file is without its ending. Errors: those of
/// `import_mesh`.
[[nodiscard]] Result<std::string> add_control_mesh(const std::filesystem::path& file);

/// Vertices and faces of a mesh.
struct Counts {
  std::size_t vertices = 0;
  std::size_t faces = 0;
  [[nodiscard]] bool operator==(const Counts&) const = default;
};

/// What uniform Catmull-Clark makes of a mesh, from its numbers of vertices, edges and faces.
[[nodiscard]] Counts uniform_counts(const ControlMesh& mesh, int levels);

/// A control mesh and how many times it is refined.
struct Work {
  std::string mesh;
  int levels = 0;
};

/// The mesh that is painted.
inline constexpr const char* kLargestMesh = "asteroid_246k";

/// The asteroids, each to 3,932,160 faces.
[[nodiscard]] const std::vector<Work>& large_works();

/// `MESH/LEVELS`, the part of a case's name.
[[nodiscard]] std::string path_of(const Work& work);

}  // namespace limn::bench
