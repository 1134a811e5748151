#include "editing/triangles_only.h"

#include <fmt/format.h>

namespace limn {

Result<void> check_triangles(const ControlMesh& mesh) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (const std::size_t sides = mesh.face(f).size(); sides != 3) {
      return fail(ErrorKind::kFailed,
                  fmt::format("Face {} has {} sides, but all faces are to be triangles. "
                              "Triangulate the mesh first.",
                              f, sides));
    }
  }
  return {};
}

}  // namespace limn
