#include "render/refinement/drawn_faces.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace limn::render {

DrawnFaces group_faces(const FlatPlan& plan) {
  DrawnFaces drawn;
  const auto sides = [&plan](std::uint32_t polygon) {
    return plan.polygon_offsets[polygon + 1] - plan.polygon_offsets[polygon];
  };
  drawn.polygons.resize(plan.polygon_control_faces.size());
  std::iota(drawn.polygons.begin(), drawn.polygons.end(), 0U);
  std::ranges::stable_sort(drawn.polygons, {}, sides);
  SurfaceGroup group;
  const auto begin_group = [&](std::uint32_t next_sides) {
    if (group.face_count > 0) {
      drawn.groups.push_back(group);
    }
    group.first_face += group.face_count;
    group.first_corner += group.face_count * group.sides;
    group.sides = next_sides;
    group.face_count = 0;
  };
  const auto put_quads = [&] {
    begin_group(4);
    group.face_count = static_cast<std::uint32_t>(plan.quad_count);
    drawn.first_quad = group.first_face;
    drawn.first_corner = group.first_corner;
  };
  bool has_quads = false;
  for (const std::uint32_t polygon : drawn.polygons) {
    if (!has_quads && sides(polygon) > 4) {
      has_quads = true;
      put_quads();
    }
    if (group.face_count == 0 || group.sides != sides(polygon)) {
      begin_group(sides(polygon));
    }
    ++group.face_count;
  }
  if (!has_quads) {
    put_quads();
  }
  begin_group(0);
  return drawn;
}

void write_polygons(const FlatPlan& plan, const DrawnFaces& drawn, const SurfaceContents& surface) {
  std::size_t next = 0;
  for (const SurfaceGroup& group : drawn.groups) {
    if (group.sides == 4) {
      continue;
    }
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> faces;
    for (std::uint32_t i = 0; i < group.face_count; ++i, ++next) {
      const std::uint32_t polygon = drawn.polygons[next];
      const auto from = plan.polygon_vertices.begin() + plan.polygon_offsets[polygon];
      corners.insert(corners.end(), from, from + group.sides);
      faces.push_back(plan.polygon_control_faces[polygon]);
    }
    surface.corners->write(group.first_corner * sizeof(std::uint32_t),
                           std::span<const std::uint32_t>(corners));
    surface.faces->write(group.first_face * sizeof(std::uint32_t),
                         std::span<const std::uint32_t>(faces));
  }
}

}  // namespace limn::render
