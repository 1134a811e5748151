// The id image as a picture: every control face in a colour of its own. Drawn by OSMesa's software
// renderer, whose pixels are the same on every machine with the same Mesa.
#include <algorithm>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "limn/mesh/bundled.h"
#include "render/image.h"
#include "render/named_views.h"
#include "render/picking_fixture.h"
#include "support/gl_fixture.h"
#include "support/image_compare.h"

namespace limn::test {
namespace {

class PickingGolden : public GlFixture {
 protected:
  void SetUp() override {
    GlFixture::SetUp();
    auto imported = load_bundled_mesh(kDefaultMesh);
    ASSERT_TRUE(imported);
    control_ = imported->mesh;
  }

  /// Neighbouring numbers get unrelated colours.
  static void paint(std::uint8_t* pixel, std::uint32_t number) {
    std::uint32_t hash = (number + 1) * 0x9E3779B1U;
    hash ^= hash >> 15U;
    hash *= 0x85EBCA77U;
    for (unsigned channel = 0; channel < 3; ++channel) {
      pixel[channel] = static_cast<std::uint8_t>(64 + (hash >> (8 * channel)) % 192);
    }
  }

  /// The default view of a surface; white where nothing is.
  static render::Image picture(const PickedMesh& mesh) {
    constexpr render::FramebufferSize kSize{400, 320};
    render::SurfaceBuffers buffers;
    EXPECT_TRUE(buffers.upload(mesh.surface, 1));
    render::FacePicker picker;
    const render::Camera camera =
        make_camera(render::default_view(mesh.bounds, kSize.aspect()), mesh.bounds, kSize);
    (void)picker.visible_faces({buffers, camera});
    const std::vector<std::uint32_t> ids = all_ids(picker);
    render::Image image({kSize.width, kSize.height});
    std::fill(image.rgba.begin(), image.rgba.end(), std::uint8_t{255});
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (ids[i] != 0) {
        paint(&image.rgba[4 * i], buffers.face_control_faces()[ids[i] - 1]);
      }
    }
    return image;
  }

  std::shared_ptr<const ControlMesh> control_;
};

TEST_F(PickingGolden, ControlFacesOfTheCreature) {
  EXPECT_TRUE(matches_golden(picture(picked_mesh(*control_)), "ids_control"));
}

TEST_F(PickingGolden, ControlFacesUnderItsRefinement) {
  EXPECT_TRUE(
      matches_golden(picture(picked_mesh(*control_, refined_in_places(*control_))), "ids_refined"));
}

}  // namespace
}  // namespace limn::test
