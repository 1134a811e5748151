#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "limn/mesh/control_mesh.h"
#include "limn/mesh/refined_mesh.h"
#include "render/camera.h"
#include "render/picking/screen_region.h"

namespace limn::render {

/// Tells which faces lie in a part of the picture whether they show or not: those that are painted
/// "through" the mesh. No picture is looked at; faces are projected on the CPU, and that is kept as
/// long as mesh and camera are the same, so that a drag asks again and again at little cost.
class ThroughPicker {
 public:
  /// The control faces whose projection has any point in common with the region, ascending: of the
  /// mesh itself, or of the refined faces that lie in them. What is before the near plane does not
  /// count.
  [[nodiscard]] std::vector<std::uint32_t> faces_in(const std::shared_ptr<const ControlMesh>& mesh,
                                                    const Camera& camera,
                                                    const ScreenRegion& region);
  /// The same by the refined faces that lie in the control faces; `control_faces` is how many there
  /// are.
  [[nodiscard]] std::vector<std::uint32_t> faces_in(const std::shared_ptr<const RefinedMesh>& mesh,
                                                    std::size_t control_faces, const Camera& camera,
                                                    const ScreenRegion& region);
  /// The refined faces themselves, ascending.
  [[nodiscard]] std::vector<std::uint32_t> refined_faces_in(
      const std::shared_ptr<const RefinedMesh>& mesh, const Camera& camera,
      const ScreenRegion& region);

 private:
  /// Low and high corner on the screen; empty (low over high) where nothing can show.
  struct Box {
    glm::vec2 low{0.0F};
    glm::vec2 high{0.0F};
  };

  template <class Mesh>
  void project_all(const std::shared_ptr<const Mesh>& mesh, const Camera& camera);
  template <class Mesh>
  [[nodiscard]] bool meets(const Mesh& mesh, const Camera& camera, const ScreenRegion& region,
                           std::size_t face);
  template <class Mesh, class ControlFace>
  [[nodiscard]] std::vector<std::uint32_t> gather(const Mesh& mesh, std::size_t control_faces,
                                                  const Camera& camera, const ScreenRegion& region,
                                                  ControlFace&& control_face);

  std::weak_ptr<const void> mesh_;  ///< What was projected: known again without being kept alive.
  glm::dmat4 view_projection_{0.0};
  FramebufferSize size_;
  std::vector<glm::dvec2> points_;   ///< Of vertices, on the screen;
  std::vector<bool> is_before_;      ///< of those before the near plane nothing is known.
  std::vector<Box> boxes_;           ///< Of faces.
  std::vector<glm::dvec2> polygon_;  ///< Kept to save allocations.
};

}  // namespace limn::render
