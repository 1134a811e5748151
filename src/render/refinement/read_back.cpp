// The parts of a refinement that are on the GPU, then those that only the plan knows.
#include <algorithm>

#include "limn/contract.h"
#include "render/refinement/gpu_refiner.h"

namespace limn::render {
namespace {

constexpr std::uint32_t kControlFaceBits = 28;

template <class T>
LargeArray<T> read(const gl::Buffer& buffer, std::size_t first, std::size_t count) {
  LargeArray<T> values(count);
  buffer.read_bytes(first, std::as_writable_bytes(std::span(values)));
  return values;
}

}  // namespace

RefinedMesh GpuRefiner::read_back(const GpuRefinementRequest& request,
                                  const SurfaceBuffers& surface) const {
  const FlatPlan& plan = planner_.result();
  LIMN_EXPECTS(request.has_vertex_levels && surface.has(request.revision));
  std::uint32_t first_quad = 0;
  std::uint32_t first_corner = 0;
  for (std::size_t i = 0; i < plan.polygon_control_faces.size(); ++i) {
    if (plan.polygon_offsets[i + 1] - plan.polygon_offsets[i] == 3) {
      ++first_quad;
      first_corner += 3;
    }
  }

  RefinedMesh mesh;
  mesh.origin = surface.origin();
  mesh.positions = read<glm::vec3>(surface.positions(), 0, plan.vertex_count);
  if (surface.normals().size() > 0) {
    mesh.normals = read<glm::vec3>(surface.normals(), 0, plan.vertex_count);
  }
  const auto levels = read<std::uint32_t>(vertex_levels_, 0, plan.vertex_count);
  mesh.vertex_levels.resize(levels.size());
  std::ranges::transform(levels, mesh.vertex_levels.begin(),
                         [](std::uint32_t level) { return static_cast<std::uint8_t>(level); });
  mesh.quads = read<std::array<std::uint32_t, 4>>(
      surface.corners(), first_corner * sizeof(std::uint32_t), plan.quad_count);
  const auto records =
      read<std::uint32_t>(surface.faces(), first_quad * sizeof(std::uint32_t), plan.quad_count);
  const std::size_t faces = plan.quad_count + plan.polygon_control_faces.size();
  mesh.face_control_faces.resize(faces);
  mesh.face_levels.resize(faces);
  for (std::size_t q = 0; q < records.size(); ++q) {
    mesh.face_control_faces[q] = records[q] & ((1U << kControlFaceBits) - 1);
    mesh.face_levels[q] = static_cast<std::uint8_t>(records[q] >> kControlFaceBits);
  }
  for (std::size_t i = 0; i < plan.polygon_control_faces.size(); ++i) {
    mesh.face_control_faces[plan.quad_count + i] = plan.polygon_control_faces[i];
    mesh.face_levels[plan.quad_count + i] = 0;
  }
  mesh.polygon_offsets = plan.polygon_offsets;
  mesh.polygon_vertices = plan.polygon_vertices;
  planner_.list_creases(mesh);
  mesh.creasing = request.mesh.creases().method;
  mesh.corner_rule =
      request.mesh.is_closed() ? std::nullopt : std::optional(request.settings.corners);
  return mesh;
}

}  // namespace limn::render
