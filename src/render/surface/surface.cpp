// Faces are sorted by number of sides with a counting sort, which keeps their order within a group.
// Normals gather Newell's normal of every face at its corners: its length is twice the face's area,
// so the sum is area-weighted, also for polygons that are not planar.
#include "render/surface/surface.h"

#include <algorithm>
#include <span>

#include <glm/geometric.hpp>

#include "limn/contract.h"

namespace limn::render {
namespace {

/// Faces of some mesh: `corners(f)` are the vertices of face f, f < count.
template <class Corners>
void group_faces(Surface& surface, std::size_t count, const Corners& corners,
                 std::vector<std::uint32_t>& source_faces) {
  std::size_t most_sides = 0;
  for (std::size_t f = 0; f < count; ++f) {
    most_sides = std::max(most_sides, corners(f).size());
  }
  std::vector<std::uint32_t> faces_with(most_sides + 1, 0);
  for (std::size_t f = 0; f < count; ++f) {
    ++faces_with[corners(f).size()];
  }
  std::vector<std::uint32_t> next_face(most_sides + 1, 0);
  SurfaceGroup group;
  for (std::size_t sides = 0; sides <= most_sides; ++sides) {
    if (faces_with[sides] == 0) {
      continue;
    }
    LIMN_EXPECTS(sides >= 3);
    group.sides = static_cast<std::uint32_t>(sides);
    group.face_count = faces_with[sides];
    next_face[sides] = group.first_face;
    surface.groups.push_back(group);
    group.first_face += group.face_count;
    group.first_corner += group.face_count * group.sides;
  }
  source_faces.resize(count);
  surface.corners.resize(group.first_corner);
  std::vector<SurfaceGroup> by_sides(most_sides + 1);
  for (const SurfaceGroup& each : surface.groups) {
    by_sides[each.sides] = each;
  }
  for (std::size_t f = 0; f < count; ++f) {
    const std::span<const std::uint32_t> from = corners(f);
    const SurfaceGroup& to = by_sides[from.size()];
    const std::uint32_t drawn = next_face[from.size()]++;
    source_faces[drawn] = static_cast<std::uint32_t>(f);
    const std::size_t first = to.first_corner + std::size_t{drawn - to.first_face} * to.sides;
    std::copy(from.begin(), from.end(),
              surface.corners.begin() + static_cast<std::ptrdiff_t>(first));
  }
}

void compute_normals(Surface& surface) {
  surface.normals.assign(surface.positions.size(), glm::vec3(0.0F));
  for (const SurfaceGroup& group : surface.groups) {
    for (std::uint32_t f = 0; f < group.face_count; ++f) {
      const std::uint32_t* face = &surface.corners[group.first_corner + f * group.sides];
      // Relative to one corner, so that small faces far from the origin lose no digits.
      const glm::vec3 base = surface.positions[face[0]];
      glm::vec3 normal(0.0F);
      for (std::uint32_t i = 1; i + 1 < group.sides; ++i) {
        normal +=
            glm::cross(surface.positions[face[i]] - base, surface.positions[face[i + 1]] - base);
      }
      for (std::uint32_t i = 0; i < group.sides; ++i) {
        surface.normals[face[i]] += normal;
      }
    }
  }
  for (glm::vec3& normal : surface.normals) {
    // In double: the square of the area of a tiny face is no float any more.
    const glm::dvec3 sum(normal);
    const double length = glm::length(sum);
    normal = length > 0.0 ? glm::vec3(sum / length) : glm::vec3(0.0F, 0.0F, 1.0F);
  }
}

/// Normals of the limit surface, and averages over the faces where it has none.
void take_normals(std::span<const glm::vec3> limit, Surface& surface) {
  if (std::ranges::any_of(limit, [](const glm::vec3& n) { return n == glm::vec3(0.0F); })) {
    compute_normals(surface);
  } else {
    surface.normals.resize(limit.size());
  }
  for (std::size_t v = 0; v < limit.size(); ++v) {
    if (limit[v] != glm::vec3(0.0F)) {
      surface.normals[v] = limit[v];
    }
  }
}

}  // namespace

Surface make_surface(const ControlMesh& mesh) {
  Surface surface;
  surface.origin = mesh.bounds().centre();
  surface.control_face_count = mesh.face_count();
  surface.positions.reserve(mesh.vertex_count());
  for (const glm::dvec3& position : mesh.positions()) {
    surface.positions.emplace_back(position - surface.origin);
  }
  group_faces(
      surface, mesh.face_count(), [&mesh](std::size_t f) { return mesh.face(f); },
      surface.face_control_faces);
  surface.face_levels.assign(mesh.face_count(), 0);
  surface.edges = mesh.topology().edge_vertices;
  compute_normals(surface);
  return surface;
}

Surface make_surface(const RefinedMesh& mesh, const glm::dvec3& origin,
                     std::size_t control_face_count) {
  Surface surface;
  surface.origin = origin;
  surface.control_face_count = control_face_count;
  surface.positions.reserve(mesh.vertex_count());
  const glm::dvec3 shift = mesh.origin - origin;
  for (const glm::vec3& position : mesh.positions) {
    surface.positions.emplace_back(glm::dvec3(position) + shift);
  }
  const std::size_t count = mesh.face_count();
  std::vector<std::uint32_t> source_faces;
  group_faces(
      surface, count,
      [&mesh](std::size_t f) -> std::span<const std::uint32_t> {
        if (f < mesh.quads.size()) {
          return mesh.quads[f];
        }
        const std::size_t polygon = f - mesh.quads.size();
        return std::span(mesh.polygon_vertices)
            .subspan(mesh.polygon_offsets[polygon],
                     mesh.polygon_offsets[polygon + 1] - mesh.polygon_offsets[polygon]);
      },
      source_faces);
  surface.face_control_faces.resize(count);
  surface.face_levels.resize(count);
  for (std::size_t f = 0; f < count; ++f) {
    surface.face_control_faces[f] = mesh.face_control_faces[source_faces[f]];
    surface.face_levels[f] = mesh.face_levels[source_faces[f]];
  }
  if (mesh.normals.empty()) {
    compute_normals(surface);
  } else {
    take_normals(mesh.normals, surface);
  }
  return surface;
}

}  // namespace limn::render
