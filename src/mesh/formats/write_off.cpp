#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/formats/output.h"
#include "mesh/formats/writers.h"

namespace limn::detail {

void write_off(std::ostream& stream, const MeshView& mesh) {
  Output out(stream);
  const std::optional<std::vector<std::uint32_t>> uvs = mesh.vertex_uvs();
  out.text(uvs ? "STOFF\n" : "OFF\n");
  out.bare_number(mesh.vertex_count() + mesh.loose_vertices().size());
  out.number(mesh.face_count());
  out.text(" 0\n");  // The number of edges, which readers are to ignore.
  const auto write_position = [&out](const auto& p) {
    out.bare_number(p.x);
    out.number(p.y);
    out.number(p.z);
  };
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    mesh.is_single_precision() ? write_position(glm::vec3(mesh.position(v)))
                               : write_position(mesh.position(v));
    if (uvs) {
      const glm::dvec2 uv = mesh.uv((*uvs)[v]);
      mesh.is_refined() ? out.number(static_cast<float>(uv.x)) : out.number(uv.x);
      mesh.is_refined() ? out.number(static_cast<float>(uv.y)) : out.number(uv.y);
    }
    out.end_line();
  }
  for (const glm::dvec3& p : mesh.loose_vertices()) {
    write_position(p);
    out.end_line();
  }
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto vertices = mesh.face(f);
    out.bare_number(vertices.size());
    for (const std::uint32_t v : vertices) {
      out.number(v);
    }
    out.end_line();
  }
}

}  // namespace limn::detail
