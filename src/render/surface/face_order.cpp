// Quads are one group in both orders. All others are control faces that stayed whole: they ascend
// by their control face in the mesh, and so within a group, and are found by that.
#include "render/surface/face_order.h"

#include <algorithm>

#include "limn/contract.h"

namespace limn::render {
namespace {

/// Where the quads begin among the drawn faces.
std::uint32_t first_quad(const Surface& surface) {
  const auto group = std::ranges::find(surface.groups, 4U, &SurfaceGroup::sides);
  return group != surface.groups.end() ? group->first_face : 0;
}

std::uint32_t find_in(std::span<const std::uint32_t> control_faces, std::uint32_t control_face) {
  const auto found = std::ranges::lower_bound(control_faces, control_face);
  LIMN_EXPECTS(found != control_faces.end() && *found == control_face);
  return static_cast<std::uint32_t>(found - control_faces.begin());
}

}  // namespace

std::vector<std::uint32_t> refined_faces(const Surface& surface, const RefinedMesh& mesh,
                                         std::span<const std::uint32_t> drawn) {
  const auto quads = static_cast<std::uint32_t>(mesh.quads.size());
  const std::uint32_t first = first_quad(surface);
  const auto polygons = std::span(mesh.face_control_faces).subspan(quads);
  std::vector<std::uint32_t> faces;
  faces.reserve(drawn.size());
  for (const std::uint32_t face : drawn) {
    if (face >= first && face - first < quads) {
      faces.push_back(face - first);
    } else {
      faces.push_back(quads + find_in(polygons, surface.face_control_faces[face]));
    }
  }
  std::ranges::sort(faces);
  return faces;
}

std::vector<std::uint32_t> drawn_faces(const Surface& surface, const RefinedMesh& mesh,
                                       std::span<const std::uint32_t> refined) {
  const std::uint32_t first = first_quad(surface);
  std::vector<std::uint32_t> faces;
  faces.reserve(refined.size());
  for (const std::uint32_t face : refined) {
    if (face < mesh.quads.size()) {
      faces.push_back(first + face);
      continue;
    }
    const auto group = std::ranges::find(
        surface.groups, static_cast<std::uint32_t>(mesh.face(face).size()), &SurfaceGroup::sides);
    LIMN_EXPECTS(group != surface.groups.end());
    const auto of_group =
        std::span(surface.face_control_faces).subspan(group->first_face, group->face_count);
    faces.push_back(group->first_face + find_in(of_group, mesh.face_control_faces[face]));
  }
  return faces;
}

std::vector<std::uint8_t> in_drawn_order(const Surface& surface, const RefinedMesh& mesh,
                                         std::span<const std::uint8_t> of_refined) {
  LIMN_EXPECTS(of_refined.size() == surface.face_count());
  std::vector<std::uint8_t> drawn(of_refined.size());
  const std::uint32_t first = first_quad(surface);
  std::ranges::copy(of_refined.first(mesh.quads.size()), drawn.begin() + first);
  std::vector<std::uint32_t> next;  // By the number of sides.
  for (const SurfaceGroup& group : surface.groups) {
    next.resize(std::max<std::size_t>(next.size(), group.sides + 1));
    next[group.sides] = group.first_face;
  }
  for (std::size_t f = mesh.quads.size(); f < of_refined.size(); ++f) {
    drawn[next[mesh.face(f).size()]++] = of_refined[f];
  }
  return drawn;
}

}  // namespace limn::render
