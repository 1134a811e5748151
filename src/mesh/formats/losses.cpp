#include <algorithm>

#include <fmt/format.h>

#include "limn/mesh/export.h"
#include "mesh/counted.h"
#include "mesh/formats/mesh_view.h"
#include "mesh/formats/weld.h"

namespace limn {
namespace {

using detail::counted;
using detail::MeshView;

class Losses {
 public:
  void add(std::size_t count, std::string_view one, std::string_view many) {
    if (count > 0) {
      phrases.push_back(counted(count, one, many));
    }
  }
  void add_if(bool is_lost, std::string phrase) {
    if (is_lost) {
      phrases.push_back(std::move(phrase));
    }
  }
  std::vector<std::string> phrases;
};

void add_names(Losses& lost, const MeshView& mesh) {
  const FaceNaming& names = mesh.names();
  lost.add(names.objects.names.size(), "object name", "object names");
  lost.add(names.groups.names.size(), "group", "groups");
  lost.add(names.materials.names.size(), "material", "materials");
}

void add_sharpness(Losses& lost, const MeshView& mesh) {
  lost.add(mesh.creases().size(), "crease", "creases");
  lost.add(mesh.corners().size(), "sharp corner", "sharp corners");
  lost.add_if(mesh.corner_rule().has_value(), "the rule for boundary corners");
}

/// Vertices that share their place with an earlier one, in single precision.
std::size_t welded_vertices(const MeshView& mesh) {
  std::vector<detail::WeldKey> keys;
  keys.reserve(mesh.vertex_count());
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    keys.push_back(detail::weld_key(glm::dvec3(glm::vec3(mesh.position(v)))));
  }
  return keys.size() - detail::weld(keys).first.size();
}

/// Corners of a vertex that have another point of the texture with the same coordinates.
std::size_t hidden_seam_corners(const MeshView& mesh) {
  if (!mesh.has_uvs() || mesh.vertex_uvs()) {
    return 0;
  }
  std::vector<detail::WeldKey> keys;
  std::vector<std::uint32_t> points;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face(f);
    const auto uvs = mesh.face_uvs(f);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      keys.push_back(detail::corner_key(corners[i], mesh.uv(uvs[i])));
      points.push_back(uvs[i]);
    }
  }
  const detail::Welding welding = detail::weld(keys);
  std::size_t hidden = 0;
  for (std::size_t c = 0; c < points.size(); ++c) {
    hidden += points[c] != points[welding.first[welding.numbers[c]]] ? 1 : 0;
  }
  return hidden;
}

std::size_t polygons(const MeshView& mesh) {
  std::size_t count = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    count += mesh.face(f).size() == 3 ? 0 : 1;
  }
  return count;
}

std::vector<std::string> lost_of(MeshFormat format, const MeshView& mesh) {
  Losses lost;
  if (format == MeshFormat::kObj) {
    return {};
  }
  add_names(lost, mesh);
  if (format == MeshFormat::kPly) {
    lost.add_if(hidden_seam_corners(mesh) > 0,
                "texture seams that have the same coordinates on both sides");
    return lost.phrases;
  }
  add_sharpness(lost, mesh);
  lost.add_if(mesh.has_depths(), "the painted depths");
  lost.add_if(!mesh.normals().empty(), "normals of the limit surface");
  if (format == MeshFormat::kOff) {
    lost.add_if(mesh.has_uvs() && !mesh.vertex_uvs(), "texture coordinates, which have seams");
    return lost.phrases;
  }
  lost.add_if(mesh.has_uvs(), "texture coordinates");
  lost.add(mesh.loose_vertices().size(), "vertex in no face", "vertices in no face");
  lost.add(polygons(mesh), "face that is no triangle (it is cut into triangles)",
           "faces that are no triangles (they are cut into triangles)");
  lost.add_if(!mesh.are_floats(), "digits of coordinates beyond single precision");
  lost.add(welded_vertices(mesh), "vertex in the place of another (they become one)",
           "vertices in the place of others (they become one)");
  return lost.phrases;
}

}  // namespace

std::vector<std::string> lost_in(MeshFormat format, const ControlMesh& mesh,
                                 const ExportSettings& settings) {
  return lost_of(format, MeshView(mesh, settings));
}

std::vector<std::string> lost_in(MeshFormat format, const RefinedMesh& mesh,
                                 const ExportSettings& settings) {
  return lost_of(format, MeshView(mesh, settings));
}

std::string loss_sentence(MeshFormat format, std::span<const std::string> lost) {
  if (lost.empty()) {
    return {};
  }
  std::string list;
  for (std::size_t i = 0; i < lost.size(); ++i) {
    list += i == 0 ? "" : i + 1 == lost.size() ? " and " : ", ";
    list += lost[i];
  }
  return fmt::format("{} files do not hold: {}.", name_of(format), list);
}

}  // namespace limn
