// Every face is cut alone, by clipping ears; then all diagonals and edges are sorted by their ends,
// and a face with a diagonal that is there twice is cut from its centroid instead.
#include "limn/mesh/triangulate.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "limn/contract.h"
#include "limn/mesh/build.h"
#include "mesh/ear_clipper.h"

namespace limn {
namespace {

using Triangle = EarClipper::Triangle;

/// How the faces are cut: the triangles of all faces one after the other; a face that is cut from
/// its centroid has none.
struct Cuts {
  std::vector<Triangle> triangles;
  std::vector<std::size_t> offsets{0};  ///< F + 1.
  std::vector<bool> is_fan;             ///< F.
};

Cuts clip_faces(const ControlMesh& mesh) {
  Cuts cuts;
  EarClipper clipper;
  std::vector<glm::dvec3> points;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    points.clear();
    for (const std::uint32_t v : face) {
      points.push_back(mesh.positions()[v]);
    }
    const std::vector<Triangle>* triangles = clipper.clip(points);
    if (triangles != nullptr) {
      cuts.triangles.insert(cuts.triangles.end(), triangles->begin(), triangles->end());
    }
    cuts.is_fan.push_back(triangles == nullptr);
    cuts.offsets.push_back(cuts.triangles.size());
  }
  return cuts;
}

/// An edge of the mesh, or a side of a triangle in a face's interior.
struct Join {
  std::array<std::uint32_t, 2> ends;  ///< Lower first.
  std::uint32_t face;                 ///< kNone for an edge: those come last of equal ones.
};

Join join(std::uint32_t a, std::uint32_t b, std::uint32_t face) {
  return {{std::min(a, b), std::max(a, b)}, face};
}

void add_diagonals(const ControlMesh& mesh, const Cuts& cuts, std::uint32_t f,
                   std::vector<Join>& joins) {
  const auto face = mesh.face(f);
  for (std::size_t i = cuts.offsets[f]; i < cuts.offsets[f + 1]; ++i) {
    const Triangle& t = cuts.triangles[i];
    for (std::size_t side = 0; side < 3; ++side) {
      const std::uint32_t a = t[side];
      const std::uint32_t b = t[(side + 1) % 3];
      // Each diagonal is a side of two triangles, once in either direction.
      const bool is_side = (a + 1) % face.size() == b;
      if (!is_side && a < b && !(a == 0 && b + 1 == face.size())) {
        joins.push_back(join(face[a], face[b], f));
      }
    }
  }
}

/// Gives faces up whose diagonals join what is joined already.
void leave_doubled_diagonals(const ControlMesh& mesh, Cuts& cuts) {
  std::vector<Join> joins;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face(f).size() > 3 && !cuts.is_fan[f]) {
      add_diagonals(mesh, cuts, f, joins);
    }
  }
  for (const auto& [a, b] : mesh.topology().edge_vertices) {
    joins.push_back(join(a, b, kNone));
  }
  std::ranges::sort(joins, {}, [](const Join& j) { return std::pair(j.ends, j.face); });
  for (std::size_t i = 1; i < joins.size(); ++i) {
    if (joins[i].ends == joins[i - 1].ends) {
      cuts.is_fan[joins[i - 1].face] = true;
    }
  }
}

void add_triangle(std::span<const std::uint32_t> face, const Triangle& t, PolygonSoup& soup) {
  const std::array<std::uint32_t, 3> corners{face[t[0]], face[t[1]], face[t[2]]};
  soup.add_face(corners);
}

void add_fan(const ControlMesh& mesh, std::size_t f, PolygonSoup& soup) {
  const auto face = mesh.face(f);
  const auto centre = static_cast<std::uint32_t>(soup.positions.size());
  glm::dvec3 sum(0.0);
  for (const std::uint32_t v : face) {
    sum += mesh.positions()[v];
  }
  soup.positions.push_back(sum / static_cast<double>(face.size()));
  const std::span<const std::uint32_t> uvs =
      mesh.texture().empty() ? std::span<const std::uint32_t>()
                             : std::span(mesh.texture().corner_values)
                                   .subspan(mesh.topology().face_offsets[f], face.size());
  const auto centre_uv = static_cast<std::uint32_t>(soup.uvs.size());
  if (!uvs.empty()) {
    glm::dvec2 uv_sum(0.0);
    for (const std::uint32_t uv : uvs) {
      uv_sum += mesh.texture().values[uv];
    }
    soup.uvs.push_back(uv_sum / static_cast<double>(face.size()));
  }
  for (std::size_t i = 0; i < face.size(); ++i) {
    const std::size_t j = (i + 1) % face.size();
    soup.add_face(std::array<std::uint32_t, 3>{face[i], face[j], centre});
    if (!uvs.empty()) {
      soup.face_uvs.insert(soup.face_uvs.end(), {uvs[i], uvs[j], centre_uv});
    }
  }
}

void add_tags(const ControlMesh& mesh, PolygonSoup& soup) {
  const Creases& creases = mesh.creases();
  for (std::size_t e = 0; e < creases.edge_sharpness.size(); ++e) {
    if (creases.edge_sharpness[e] > 0.0f) {
      soup.creases.push_back({mesh.topology().edge_vertices[e], creases.edge_sharpness[e]});
    }
  }
  for (std::uint32_t v = 0; v < creases.vertex_sharpness.size(); ++v) {
    if (creases.vertex_sharpness[v] > 0.0f) {
      soup.corners.push_back({v, creases.vertex_sharpness[v]});
    }
  }
  soup.creasing = creases.method;
  soup.corner_rule = mesh.attributes().corners;
}

}  // namespace

std::shared_ptr<const ControlMesh> triangulated(const ControlMesh& mesh) {
  Cuts cuts = clip_faces(mesh);
  leave_doubled_diagonals(mesh, cuts);
  PolygonSoup soup;
  soup.positions.assign(mesh.positions().begin(), mesh.positions().end());
  soup.uvs = mesh.texture().values;
  std::vector<std::uint32_t> sources;  // Filled up for a face before the next one is cut.
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    sources.resize(soup.face_count(), static_cast<std::uint32_t>(f - 1));
    if (cuts.is_fan[f]) {
      add_fan(mesh, f, soup);
      continue;
    }
    for (std::size_t i = cuts.offsets[f]; i < cuts.offsets[f + 1]; ++i) {
      add_triangle(mesh.face(f), cuts.triangles[i], soup);
      if (!mesh.texture().empty()) {
        const std::uint32_t first = mesh.topology().face_offsets[f];
        for (const std::uint32_t place : cuts.triangles[i]) {
          soup.face_uvs.push_back(mesh.texture().corner_values[first + place]);
        }
      }
    }
  }
  sources.resize(soup.face_count(), static_cast<std::uint32_t>(mesh.face_count() - 1));
  add_tags(mesh, soup);
  soup.names = names_by_source(mesh.attributes().names, sources);
  Result<ImportedMesh> built = build_control_mesh(soup);
  LIMN_EXPECTS(built.has_value() && !built->report.is_mended());
  MeshAttributes attributes = built->mesh->attributes();
  attributes.loose_vertices = mesh.attributes().loose_vertices;
  return std::make_shared<const ControlMesh>(built->mesh->with_attributes(std::move(attributes)));
}

}  // namespace limn
