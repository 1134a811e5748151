#include "render/picking_fixture.h"

#include <algorithm>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "limn/subdivision/label_subdivision.h"
#include "render/named_views.h"
#include "render/navigation.h"

namespace limn::test {

using namespace limn::render;  // NOLINT: a test's own source file.

std::vector<std::uint32_t> PickedMesh::drawn_order() const {
  std::vector<std::uint32_t> order(polygons.face_count());
  std::iota(order.begin(), order.end(), 0U);
  const auto sides = [this](std::uint32_t f) {
    return polygons.offsets[f + 1] - polygons.offsets[f];
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return sides(a) < sides(b); });
  return order;
}

PickedMesh picked_mesh(const ControlMesh& mesh) {
  PickedMesh picked{make_surface(mesh), polygons_of(mesh), {}, mesh.bounds()};
  picked.control_faces.resize(mesh.face_count());
  std::iota(picked.control_faces.begin(), picked.control_faces.end(), 0U);
  return picked;
}

PickedMesh picked_mesh(const ControlMesh& control, const RefinedMesh& mesh) {
  return {make_surface(mesh, control.bounds().centre(), control.face_count()),
          polygons_of(mesh),
          {mesh.face_control_faces.begin(), mesh.face_control_faces.end()},
          control.bounds()};
}

RefinedMesh refined_in_places(const ControlMesh& mesh) {
  std::vector<std::uint8_t> depths(mesh.face_count(), 0);
  for (std::size_t f = 0; f < depths.size(); ++f) {
    depths[f] = f % 7 == 0 ? 2 : f % 5 == 0 ? 1 : 0;
  }
  IgnoreProgress progress;
  const SubdivisionSettings settings;
  const auto legal = legal_labels(mesh, depths, settings, progress);
  EXPECT_TRUE(legal);
  auto refined = refine(mesh, legal->labels, settings, {}, progress);
  EXPECT_TRUE(refined);
  return *std::move(refined);
}

std::vector<NamedCamera> cameras_around(const Bounds& scene) {
  std::vector<NamedCamera> cameras;
  const auto add = [&](std::string name, const ViewState& view, FramebufferSize size) {
    cameras.push_back({std::move(name), make_camera(view, scene, size)});
  };
  add("three-quarter", default_view(scene, 317.0 / 213.0), {317, 213});

  ViewState iso = named_view(NamedView::kIso, scene, 204.0 / 331.0);
  iso.orthographic = true;
  add("orthographic iso", iso, {204, 331});

  ViewState top = named_view(NamedView::kTop, scene, 1.0);
  top.orthographic = true;
  add("orthographic top", top, {280, 280});

  ViewState close = default_view(scene, 1.5);
  close.yaw = -140.0;
  close.pitch = -33.0;
  close.distance *= 0.35;
  close.target += 0.1 * (scene.high - scene.low);
  add("close", close, {267, 173});

  // The eye among the faces: some lie behind it, some are cut by the near plane.
  ViewState inside = default_view(scene, 1.2);
  inside.target = glm::mix(scene.low, scene.high, 0.6);
  inside.distance = 0.02 * glm::length(scene.high - scene.low);
  inside.fov_degrees = 90.0;
  add("inside", inside, {187, 144});
  return cameras;
}

std::vector<std::uint32_t> all_ids(const FacePicker& picker) {
  const FramebufferSize size = picker.image().size();
  const PixelRect all{0, 0, size.width, size.height};
  std::vector<std::uint32_t> ids(all.area());
  picker.image().read(all, ids);
  for (std::uint32_t& id : ids) {
    id &= ~render::kFromBehind;
  }
  return ids;
}

std::vector<std::uint32_t> seen_ids(const FacePicker& picker) {
  const FramebufferSize size = picker.image().size();
  std::vector<std::uint32_t> raw(PixelRect{0, 0, size.width, size.height}.area());
  picker.image().read({0, 0, size.width, size.height}, raw);
  std::vector<std::uint32_t> ids(raw.size());
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                      static_cast<std::size_t>(x);
      if (render::counts_as_seen(raw, size.width, size.height, x, y)) {
        ids[at] = raw[at] & ~render::kFromBehind;
      }
    }
  }
  return ids;
}

void PickingTest::SetUp() {
  context_ = create_headless_context(GetParam());
  monitor_ = std::make_unique<gl::DebugMonitor>();
}

void PickingTest::TearDown() {
  for (const std::string& error : monitor_->take_errors()) {
    ADD_FAILURE() << "OpenGL: " << error;
  }
  monitor_.reset();
}

void PickingTest::upload(SurfaceBuffers& buffers, const Surface& surface) {
  ASSERT_TRUE(buffers.upload(surface, ++revision_));
}

std::string context_name(const testing::TestParamInfo<HeadlessKind>& info) {
  return info.param == HeadlessKind::kEgl ? "Egl" : "Osmesa";
}

}  // namespace limn::test
