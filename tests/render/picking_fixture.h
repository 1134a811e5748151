#pragma once

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "render/camera.h"
#include "render/context/gl_context.h"
#include "render/gl/debug_monitor.h"
#include "render/picking/face_picker.h"
#include "render/picking/seen.h"
#include "render/surface/surface.h"
#include "support/raycaster.h"

namespace limn::test {

/// A mesh as picking sees it and as the ray caster does, made independently of each other.
struct PickedMesh {
  render::Surface surface;
  Polygons polygons;
  std::vector<std::uint32_t> control_faces;  ///< Of each face of `polygons`.
  Bounds bounds;

  /// Face of `polygons` for each drawn face: a surface is ordered by number of sides.
  [[nodiscard]] std::vector<std::uint32_t> drawn_order() const;
};

[[nodiscard]] PickedMesh picked_mesh(const ControlMesh& mesh);
[[nodiscard]] PickedMesh picked_mesh(const ControlMesh& control, const RefinedMesh& mesh);

/// A control mesh painted in a few places to different depths and refined.
[[nodiscard]] RefinedMesh refined_in_places(const ControlMesh& mesh);

/// Cameras of all kinds: outside and inside the scene, in both projections, along axes, where edges
/// run through pixel centres.
struct NamedCamera {
  std::string name;
  render::Camera camera;
};
[[nodiscard]] std::vector<NamedCamera> cameras_around(const Bounds& scene);

/// The image row by row from the top: drawn face + 1, 0 where nothing is.
[[nodiscard]] std::vector<std::uint32_t> all_ids(const render::FacePicker& picker);

/// The same with 0 where the pixel does not make its face a seen one.
[[nodiscard]] std::vector<std::uint32_t> seen_ids(const render::FacePicker& picker);

/// A test of picking that runs on OSMesa and on EGL. An absent context is a failure.
class PickingTest : public testing::TestWithParam<render::HeadlessKind> {
 protected:
  void SetUp() override;
  void TearDown() override;

  /// Uploads a surface with a revision of its own.
  void upload(render::SurfaceBuffers& buffers, const render::Surface& surface);

 private:
  std::unique_ptr<render::GlContext> context_;
  std::unique_ptr<render::gl::DebugMonitor> monitor_;
  std::uint64_t revision_ = 0;
};

/// For INSTANTIATE_TEST_SUITE_P.
[[nodiscard]] inline auto both_contexts() {
  return testing::Values(render::HeadlessKind::kOsmesa, render::HeadlessKind::kEgl);
}
[[nodiscard]] std::string context_name(const testing::TestParamInfo<render::HeadlessKind>& info);

}  // namespace limn::test
