#include "mesh/formats/mesh_view.h"

#include <algorithm>

#include "limn/contract.h"

namespace limn::detail {
namespace {

const FaceNaming kNoNames;

bool is_float(double x) {
  return static_cast<double>(static_cast<float>(x)) == x;
}

bool are_floats(std::span<const glm::dvec3> points) {
  return std::all_of(points.begin(), points.end(), [](const glm::dvec3& p) {
    return is_float(p.x) && is_float(p.y) && is_float(p.z);
  });
}

}  // namespace

MeshView::MeshView(const ControlMesh& mesh, const ExportSettings& settings)
    : control_(&mesh),
      vertex_count_(mesh.vertex_count()),
      face_count_(mesh.face_count()),
      are_floats_(detail::are_floats(mesh.positions())),
      has_uvs_(!mesh.texture().empty()),
      are_uvs_floats_(
          std::all_of(mesh.texture().values.begin(), mesh.texture().values.end(),
                      [](const glm::dvec2& uv) { return is_float(uv.x) && is_float(uv.y); })),
      creasing_(mesh.creases().method),
      corner_rule_(mesh.attributes().corners),
      loose_(mesh.attributes().loose_vertices),
      names_(&mesh.attributes().names) {
  LIMN_EXPECTS(settings.depths.empty() || settings.depths.size() == mesh.face_count());
  const Creases& creases = mesh.creases();
  for (std::size_t e = 0; e < creases.edge_sharpness.size(); ++e) {
    if (creases.edge_sharpness[e] > 0.0f) {
      creases_.push_back({mesh.topology().edge_vertices[e], creases.edge_sharpness[e]});
    }
  }
  for (std::uint32_t v = 0; v < creases.vertex_sharpness.size(); ++v) {
    if (creases.vertex_sharpness[v] > 0.0f) {
      corners_.push_back({v, creases.vertex_sharpness[v]});
    }
  }
  take_settings(settings);
}

MeshView::MeshView(const RefinedMesh& mesh, const ExportSettings& settings)
    : refined_(&mesh),
      vertex_count_(mesh.vertex_count()),
      face_count_(mesh.face_count()),
      are_floats_(mesh.origin == glm::dvec3(0.0)),
      has_uvs_(!mesh.quad_uvs.empty() || !mesh.polygon_uvs.empty()),
      are_uvs_floats_(true),
      creasing_(mesh.creasing),
      corner_rule_(mesh.corner_rule),
      names_(&kNoNames) {
  creases_.reserve(mesh.creases.size());
  for (const RefinedCrease& crease : mesh.creases) {
    creases_.push_back({crease.vertices, crease.sharpness});
  }
  corners_.reserve(mesh.corners.size());
  for (const RefinedCorner& corner : mesh.corners) {
    corners_.push_back({corner.vertex, corner.sharpness});
  }
  if (settings.control != nullptr) {
    names_ = &settings.control->attributes().names;
    loose_ = settings.control->attributes().loose_vertices;
  }
  take_settings(settings);
}

void MeshView::take_settings(const ExportSettings& settings) {
  depths_ = settings.depths;
  are_floats_ = are_floats_ && detail::are_floats(loose_);
  if (refined_ != nullptr && !depths_.empty() && !refined_->face_control_faces.empty()) {
    LIMN_EXPECTS(*std::max_element(refined_->face_control_faces.begin(),
                                   refined_->face_control_faces.end()) < depths_.size());
  }
}

std::span<const std::uint32_t> MeshView::face_uvs(std::size_t f) const noexcept {
  if (!has_uvs_) {
    return {};
  }
  const std::size_t sides = face(f).size();
  if (control_ != nullptr) {
    return std::span(control_->texture().corner_values)
        .subspan(control_->topology().face_offsets[f], sides);
  }
  if (f < refined_->quads.size()) {
    return refined_->quad_uvs[f];
  }
  return std::span(refined_->polygon_uvs)
      .subspan(refined_->polygon_offsets[f - refined_->quads.size()], sides);
}

std::optional<std::vector<std::uint32_t>> MeshView::vertex_uvs() const {
  if (!has_uvs_ || !loose_.empty()) {
    return std::nullopt;
  }
  std::vector<std::uint32_t> points(vertex_count_, kNone);
  for (std::size_t f = 0; f < face_count_; ++f) {
    const auto corners = face(f);
    const auto uvs = face_uvs(f);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      std::uint32_t& point = points[corners[i]];
      if (point != kNone && point != uvs[i]) {
        return std::nullopt;
      }
      point = uvs[i];
    }
  }
  // A vertex in no face, which refined meshes have none of.
  return std::find(points.begin(), points.end(), kNone) == points.end() ? std::optional(points)
                                                                        : std::nullopt;
}

std::span<const glm::vec3> MeshView::normals() const noexcept {
  return refined_ != nullptr ? std::span<const glm::vec3>(refined_->normals)
                             : std::span<const glm::vec3>();
}

}  // namespace limn::detail
