// A mesh looks and picks alike whatever its unit and wherever it lies: in millionths and in
// millions, at the origin and far from it.
#include <memory>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "limn/mesh/bundled.h"
#include "limn/subdivision/label_subdivision.h"
#include "render/mesh_renderer.h"
#include "render/named_views.h"
#include "render/navigation.h"
#include "render/picking/face_picker.h"
#include "support/gl_fixture.h"
#include "support/image_compare.h"
#include "support/shapes.h"

namespace limn::render {
namespace {

using test::MeshPointer;

constexpr FramebufferSize kPicture{240, 180};

struct Placing {
  double scale = 1.0;
  glm::dvec3 shift{0.0};  ///< In units of the scale.
};

std::vector<Placing> placings() {
  std::vector<Placing> all;
  for (const double scale : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    all.push_back({scale});
    // A hundred thousand times as far out as it is large.
    all.push_back({scale, {3e5, -2e5, 1e5}});
  }
  return all;
}

class Scales : public test::GlFixture {
 protected:
  void SetUp() override {
    GlFixture::SetUp();
    renderer_ = std::make_unique<MeshRenderer>();
    picker_ = std::make_unique<FacePicker>();
  }
  void TearDown() override {
    renderer_.reset();
    picker_.reset();
    GlFixture::TearDown();
  }

  static MeshPointer placed(const PolygonSoup& soup, const Placing& placing) {
    PolygonSoup moved = soup;
    for (glm::dvec3& position : moved.positions) {
      position = placing.scale * (position + placing.shift);
    }
    return test::control_mesh(moved);
  }
  static PolygonSoup soup_of(const ControlMesh& mesh) {
    PolygonSoup soup;
    soup.positions.assign(mesh.positions().begin(), mesh.positions().end());
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      soup.add_face(mesh.face(f));
    }
    return soup;
  }

  /// The picture, and the faces under a grid of pixels.
  struct Seen {
    Image picture;
    std::vector<std::int64_t> faces;
  };
  Seen look(const SurfaceBuffers& surface, const ControlMesh& mesh, const ViewState& view) {
    const Camera camera = make_camera(view, mesh.bounds(), kPicture);
    FacePaint paint;
    paint.reset(std::vector<std::uint8_t>(mesh.face_count(), 1));
    Scene scene;
    scene.surface = &surface;
    scene.paint = &paint;
    Seen seen;
    seen.picture = draw_picture(*renderer_, camera, scene, {}).value_or(Image());
    for (int y = 5; y < kPicture.height; y += 10) {
      for (int x = 5; x < kPicture.width; x += 10) {
        const auto picked = picker_->pick({surface, camera}, {x + 0.5, y + 0.5});
        seen.faces.push_back(picked ? std::int64_t{picked->control_face} : -1);
      }
    }
    return seen;
  }

  static void expect_alike(const Seen& a, const Seen& b) {
    const auto difference = test::compare_images(a.picture, b.picture);
    std::size_t other_faces = 0;
    for (std::size_t i = 0; i < a.faces.size(); ++i) {
      other_faces += a.faces[i] != b.faces[i] ? 1 : 0;
    }
    // Positions are rounded to floats: single pixels at edges may differ.
    EXPECT_LT(difference.pixels, a.picture.rgba.size() / 4 / 50)
        << "at most " << difference.largest;
    EXPECT_LE(other_faces, a.faces.size() / 50);
  }

  std::unique_ptr<MeshRenderer> renderer_;
  std::unique_ptr<FacePicker> picker_;
};

/// The same view of a placed mesh.
ViewState placed_view(ViewState view, const Placing& placing) {
  view.target = placing.scale * (view.target + placing.shift);
  view.distance *= placing.scale;
  return view;
}

TEST_F(Scales, PictureAndPicksAreTheSameFromMillionthsToMillions) {
  const Result<ImportedMesh> imported = load_bundled_mesh("creature");
  ASSERT_TRUE(imported);
  const PolygonSoup soup = soup_of(*imported->mesh);
  for (const bool is_orthographic : {false, true}) {
    std::optional<Seen> whole;
    std::optional<Seen> close;
    for (const Placing& placing : placings()) {
      SCOPED_TRACE(fmt::format("scale {}, {} out", placing.scale, placing.shift.x));
      const MeshPointer mesh = placed(soup, placing);
      SurfaceBuffers surface;
      ASSERT_TRUE(surface.upload(make_surface(*mesh), 1));
      ViewState view = default_view(mesh->positions(), kPicture.aspect());
      view.orthographic = is_orthographic;
      const Seen seen = look(surface, *mesh, view);
      // A hundred times closer to what is seen in the middle.
      const Camera camera = make_camera(view, mesh->bounds(), kPicture);
      const auto middle = picker_->pick({surface, camera}, {120.5, 90.5});
      ASSERT_TRUE(middle);
      for (int i = 0; i < 100; ++i) {
        view = dolly(view, 0.955, middle->position, mesh->bounds());
      }
      const Seen nearer = look(surface, *mesh, view);
      const auto still =
          picker_->pick({surface, make_camera(view, mesh->bounds(), kPicture)}, {120.5, 90.5});
      ASSERT_TRUE(still) << "nothing is cut away before the eye";
      EXPECT_EQ(still->control_face, middle->control_face);
      if (!whole) {
        whole = seen;
        close = nearer;
      }
      expect_alike(*whole, seen);
      EXPECT_EQ(close->faces, nearer.faces);
    }
  }
}

TEST_F(Scales, SheetsFarBehindSomethingCloseDoNotFlicker) {
  // A tiny square before the eye, and far behind it two sheets nearly in one plane: the front one
  // must win in every pixel.
  for (const Placing& placing : placings()) {
    SCOPED_TRACE(fmt::format("scale {}, {} out", placing.scale, placing.shift.x));
    if (placing.shift != glm::dvec3(0.0)) {
      continue;  // The sheets would be one within the digits of a float.
    }
    PolygonSoup soup;
    const auto add_square = [&](double half, double z) {
      const auto first = static_cast<std::uint32_t>(soup.positions.size());
      for (const glm::dvec2 corner : {glm::dvec2{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        soup.positions.emplace_back(half * corner.x, half * corner.y, z);
      }
      soup.add_face(std::vector{first, first + 1, first + 2, first + 3});
    };
    add_square(1e-3, 0.0);
    add_square(1.0, -1.0);
    add_square(1.0, -1.0 - 1e-4);
    const MeshPointer mesh = placed(soup, placing);
    SurfaceBuffers surface;
    ASSERT_TRUE(surface.upload(make_surface(*mesh), 1));
    ViewState view;
    view.distance = 1e-2;
    view = placed_view(view, placing);
    const Camera camera = make_camera(view, mesh->bounds(), kPicture);
    int behind = 0;
    for (int y = 0; y < kPicture.height; y += 4) {
      for (int x = 0; x < kPicture.width; x += 4) {
        const auto picked = picker_->pick({surface, camera}, {x + 0.5, y + 0.5});
        ASSERT_TRUE(picked);
        EXPECT_NE(picked->control_face, 2U) << x << ", " << y;
        behind += picked->control_face == 1U ? 1 : 0;
      }
    }
    EXPECT_GT(behind, 100);
  }
}

TEST_F(Scales, TinyRefinedFacesKeepTheirNormals) {
  // The smooth and the flat picture of a refined cube are those of scale 1.
  const PolygonSoup soup = test::cube_soup();
  std::optional<Image> first;
  for (const double scale : {1.0, 1e-6, 1e6}) {
    SCOPED_TRACE(scale);
    const MeshPointer mesh = placed(soup, {scale});
    IgnoreProgress progress;
    const auto refined = refine(*mesh, VertexLabels(8, 5), {}, {}, progress);
    ASSERT_TRUE(refined);
    SurfaceBuffers surface;
    ASSERT_TRUE(surface.upload(make_surface(*refined, mesh->bounds().centre(), 6), 1));
    const Seen seen = look(surface, *mesh, default_view(mesh->positions(), kPicture.aspect()));
    if (!first) {
      first = seen.picture;
    }
    EXPECT_LT(test::compare_images(*first, seen.picture).pixels, 300U);
  }
}

}  // namespace
}  // namespace limn::render
