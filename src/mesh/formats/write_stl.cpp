// A header of zeros says nothing that a reader could take for something else.
#include <array>
#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>

#include "limn/contract.h"
#include "mesh/formats/output.h"
#include "mesh/formats/writers.h"

namespace limn::detail {
namespace {

/// Of length 1, or 0 where the triangle has no area.
glm::vec3 facet_normal(const std::array<glm::dvec3, 3>& corners) {
  const glm::dvec3 area = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double length = glm::length(area);
  return length > 0.0 && std::isfinite(length) ? glm::vec3(area / length) : glm::vec3(0.0f);
}

}  // namespace

void write_stl(std::ostream& stream, const ControlMesh& mesh) {
  Output out(stream);
  constexpr std::size_t header_size = 80;
  out.text(std::string(header_size, '\0'));
  out.binary(static_cast<std::uint32_t>(mesh.face_count()));
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto vertices = mesh.face(f);
    LIMN_EXPECTS(vertices.size() == 3);
    const std::array<glm::dvec3, 3> corners{mesh.positions()[vertices[0]],
                                            mesh.positions()[vertices[1]],
                                            mesh.positions()[vertices[2]]};
    const auto put = [&out](const glm::vec3& p) {
      out.binary(p.x);
      out.binary(p.y);
      out.binary(p.z);
    };
    put(facet_normal(corners));
    for (const glm::dvec3& corner : corners) {
      put(glm::vec3(corner));
    }
    out.binary(std::uint16_t{0});
  }
}

}  // namespace limn::detail
