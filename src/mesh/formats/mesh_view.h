#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "limn/mesh/control_mesh.h"
#include "limn/mesh/export.h"
#include "limn/mesh/polygon_soup.h"
#include "limn/mesh/refined_mesh.h"

namespace limn::detail {

/// What writers see of a control or refined mesh and of what goes with it. The mesh and the
/// settings' arrays must outlive this.
class MeshView {
 public:
  MeshView(const ControlMesh& mesh, const ExportSettings& settings);
  MeshView(const RefinedMesh& mesh, const ExportSettings& settings);

  [[nodiscard]] std::size_t vertex_count() const noexcept { return vertex_count_; }
  [[nodiscard]] std::size_t face_count() const noexcept { return face_count_; }
  [[nodiscard]] glm::dvec3 position(std::size_t v) const noexcept {
    return refined_ != nullptr ? refined_->position(v) : control_->positions()[v];
  }
  [[nodiscard]] std::span<const std::uint32_t> face(std::size_t f) const noexcept {
    return refined_ != nullptr ? refined_->face(f) : control_->face(f);
  }
  /// Whether every coordinate is a float.
  [[nodiscard]] bool are_floats() const noexcept { return are_floats_; }
  [[nodiscard]] bool is_refined() const noexcept { return refined_ != nullptr; }
  /// Whether positions are floats and nothing more, as opposed to doubles with few digits.
  [[nodiscard]] bool is_single_precision() const noexcept {
    return refined_ != nullptr && refined_->origin == glm::dvec3(0.0);
  }
  /// Vertices of the file in no face; they are numbered after the others.
  [[nodiscard]] std::span<const glm::dvec3> loose_vertices() const noexcept { return loose_; }

  [[nodiscard]] bool has_uvs() const noexcept { return has_uvs_; }
  [[nodiscard]] bool are_uvs_floats() const noexcept { return are_uvs_floats_; }
  [[nodiscard]] std::size_t uv_count() const noexcept {
    return refined_ != nullptr ? refined_->uvs.size() : control_->texture().values.size();
  }
  [[nodiscard]] glm::dvec2 uv(std::size_t i) const noexcept {
    return refined_ != nullptr ? glm::dvec2(refined_->uvs[i]) : control_->texture().values[i];
  }
  /// For each corner of face f the point of the texture it has.
  [[nodiscard]] std::span<const std::uint32_t> face_uvs(std::size_t f) const noexcept;
  /// For each vertex the one point that all its corners have; nothing where some have several, or
  /// where there are none or loose vertices, which have no point.
  [[nodiscard]] std::optional<std::vector<std::uint32_t>> vertex_uvs() const;

  /// One per vertex, or none.
  [[nodiscard]] std::span<const glm::vec3> normals() const noexcept;

  [[nodiscard]] const std::vector<CreaseTag>& creases() const noexcept { return creases_; }
  [[nodiscard]] const std::vector<CornerTag>& corners() const noexcept { return corners_; }
  [[nodiscard]] CreasingMethod creasing() const noexcept { return creasing_; }
  [[nodiscard]] std::optional<CornerRule> corner_rule() const noexcept { return corner_rule_; }

  [[nodiscard]] bool has_depths() const noexcept { return !depths_.empty(); }
  [[nodiscard]] int depth(std::size_t f) const noexcept { return depths_[control_face(f)]; }
  [[nodiscard]] const FaceNaming& names() const noexcept { return *names_; }
  /// What the names have for face f.
  [[nodiscard]] std::uint32_t control_face(std::size_t f) const noexcept {
    return refined_ != nullptr && !refined_->face_control_faces.empty()
               ? refined_->face_control_faces[f]
               : static_cast<std::uint32_t>(f);
  }

 private:
  void take_settings(const ExportSettings& settings);

  const ControlMesh* control_ = nullptr;  ///< The mesh is one of these,
  const RefinedMesh* refined_ = nullptr;  ///< and the other is null.
  std::size_t vertex_count_ = 0;
  std::size_t face_count_ = 0;
  bool are_floats_ = false;
  bool has_uvs_ = false;
  bool are_uvs_floats_ = false;
  std::vector<CreaseTag> creases_;
  std::vector<CornerTag> corners_;
  CreasingMethod creasing_ = CreasingMethod::kUniform;
  std::optional<CornerRule> corner_rule_;
  std::span<const std::uint8_t> depths_;
  std::span<const glm::dvec3> loose_;
  const FaceNaming* names_ = nullptr;
};

}  // namespace limn::detail
