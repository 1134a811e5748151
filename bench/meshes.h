#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"

namespace limn::bench {

/// The control mesh of a name: a bundled mesh, `asteroid_15k`, `asteroid_61k`, `asteroid_98k`,
/// `asteroid_246k`, or `asteroid_31k_triangles`, `asteroid_123k_triangles`, which are the first two
/// cut into triangles. Made when first asked for and kept until the program ends.
///
/// An asteroid is a closed, bumpy sphere of 15,360, 61,440, 98,304 or 245,760 quads. One vertex in
/// 32 is extraordinary (valence 3 or 6, and twelve of 5), evenly spread, as in a character that was
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

/// A scheme that peers have as well.
enum class Rules : std::uint8_t { kCatmullClark, kLoop };

/// A control mesh, how many times it is refined, and how.
struct Work {
  std::string mesh;
  int levels = 0;
  Rules rules = Rules::kCatmullClark;
};

/// What uniform refinement makes of a mesh, from its numbers of vertices, edges and faces.
[[nodiscard]] Counts uniform_counts(const ControlMesh& mesh, const Work& work);

/// The mesh that is painted.
inline constexpr const char* kLargestMesh = "asteroid_246k";

/// The asteroids, each to 3,932,160 faces.
[[nodiscard]] const std::vector<Work>& large_works();

/// Triangle meshes for Loop's scheme, the larger ones to 1,966,080 faces.
[[nodiscard]] const std::vector<Work>& loop_works();

/// `MESH/LEVELS`, the part of a case's name.
[[nodiscard]] std::string path_of(const Work& work);

}  // namespace limn::bench
