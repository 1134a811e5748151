// Ears are clipped in the plane of the face, the one with the shortest diagonal first. That is done
// for every face alone; then all diagonals and edges are sorted by their ends, and a face with a
// diagonal that is there twice is cut from its centroid instead.
#include "limn/mesh/triangulate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "limn/contract.h"
#include "limn/mesh/build.h"

namespace limn {
namespace {

constexpr std::size_t kMostSidesToClip = 32;

using Triangle = std::array<std::uint32_t, 3>;  ///< Places in a face.

/// Twice the area vector of a polygon (Newell).
glm::dvec3 area_vector(std::span<const glm::dvec3> points) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 2; i < points.size(); ++i) {
    sum += glm::cross(points[i - 1] - points[0], points[i] - points[0]);
  }
  return sum;
}

/// The polygon seen against `normal`, from which it runs counter-clockwise.
std::vector<glm::dvec2> seen_along(const glm::dvec3& normal, std::span<const glm::dvec3> points) {
  const glm::dvec3 magnitude = glm::abs(normal);
  const glm::dvec3 aside = magnitude.x <= magnitude.y && magnitude.x <= magnitude.z
                               ? glm::dvec3(1.0, 0.0, 0.0)
                           : magnitude.y <= magnitude.z ? glm::dvec3(0.0, 1.0, 0.0)
                                                        : glm::dvec3(0.0, 0.0, 1.0);
  const glm::dvec3 right = glm::normalize(glm::cross(aside, normal));
  const glm::dvec3 up = glm::cross(normal, right);
  std::vector<glm::dvec2> seen;
  seen.reserve(points.size());
  for (const glm::dvec3& point : points) {
    seen.emplace_back(glm::dot(point - points[0], right), glm::dot(point - points[0], up));
  }
  return seen;
}

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Cuts one face; keeps its memory for the next.
class EarClipper {
 public:
  /// The triangles of a face, or nothing where no cut stays inside.
  [[nodiscard]] const std::vector<Triangle>* clip(std::span<const glm::dvec3> points) {
    triangles_.clear();
    const glm::dvec3 area = area_vector(points);
    const double length = glm::length(area);
    if (!(length > 0.0) || !std::isfinite(length)) {
      return nullptr;
    }
    seen_ = seen_along(area / length, points);
    left_.resize(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      left_[i] = i;
    }
    while (left_.size() > 3) {
      const std::optional<std::size_t> ear = best_ear(points);
      if (!ear) {
        return nullptr;
      }
      triangles_.push_back(at(*ear));
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(*ear));
    }
    triangles_.push_back({left_[0], left_[1], left_[2]});
    return &triangles_;
  }

 private:
  [[nodiscard]] Triangle at(std::size_t i) const {
    const std::size_t n = left_.size();
    return {left_[(i + n - 1) % n], left_[i], left_[(i + 1) % n]};
  }

  [[nodiscard]] bool is_ear(const Triangle& t) const {
    const glm::dvec2& a = seen_[t[0]];
    const glm::dvec2& b = seen_[t[1]];
    const glm::dvec2& c = seen_[t[2]];
    if (turn(a, b, c) <= 0.0) {
      return false;
    }
    return std::ranges::none_of(left_, [&](std::uint32_t v) {
      return v != t[0] && v != t[1] && v != t[2] && turn(a, b, seen_[v]) >= 0.0 &&
             turn(b, c, seen_[v]) >= 0.0 && turn(c, a, seen_[v]) >= 0.0;
    });
  }

  /// In a quad both diagonals are ears of two corners; the first is taken.
  [[nodiscard]] std::optional<std::size_t> best_ear(std::span<const glm::dvec3> points) const {
    std::optional<std::size_t> best;
    double least = 0.0;
    for (std::size_t i = 0; i < left_.size(); ++i) {
      const Triangle t = at(i);
      const glm::dvec3 diagonal = points[t[2]] - points[t[0]];
      const double length = glm::dot(diagonal, diagonal);
      if ((!best || length < least) && is_ear(t)) {
        best = i;
        least = length;
      }
    }
    return best;
  }

  std::vector<glm::dvec2> seen_;
  std::vector<std::uint32_t> left_;
  std::vector<Triangle> triangles_;
};

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
    bool is_fan = false;
    if (face.size() == 3) {
      cuts.triangles.push_back({0, 1, 2});
    } else {
      points.clear();
      for (const std::uint32_t v : face) {
        points.push_back(mesh.positions()[v]);
      }
      const std::vector<Triangle>* triangles =
          face.size() <= kMostSidesToClip ? clipper.clip(points) : nullptr;
      is_fan = triangles == nullptr;
      if (!is_fan) {
        cuts.triangles.insert(cuts.triangles.end(), triangles->begin(), triangles->end());
      }
    }
    cuts.is_fan.push_back(is_fan);
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
