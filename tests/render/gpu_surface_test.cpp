// What is refined on the GPU is drawn and picked like what the CPU refined and uploaded.
#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/mesh/bundled.h"
#include "render/context/gl_context.h"
#include "render/mesh_renderer.h"
#include "render/named_views.h"
#include "render/navigation.h"
#include "render/picking/face_picker.h"
#include "render/refinement/gpu_refiner.h"
#include "support/image_compare.h"
#include "support/shapes.h"

namespace limn::render {
namespace {

using test::MeshPointer;

constexpr FramebufferSize kPixels{320, 240};

/// A painted mesh refined by both, on one kind of context.
class GpuSurface : public testing::TestWithParam<HeadlessKind> {
 protected:
  void SetUp() override {
    context_ = create_headless_context(GetParam());
    renderer_ = std::make_unique<MeshRenderer>();
    refiner_ = std::make_unique<GpuRefiner>();
  }
  void TearDown() override {
    renderer_.reset();
    paint_.reset();
    refiner_.reset();
    by_cpu_.reset();
    by_gpu_.reset();
    context_.reset();
  }

  void refine_both(const MeshPointer& mesh, const std::vector<std::uint8_t>& depths,
                   const SubdivisionSettings& settings = {}) {
    mesh_ = mesh;
    IgnoreProgress progress;
    const auto legal = legal_labels(*mesh, depths, settings, progress);
    ASSERT_TRUE(legal);
    RefineLimits limits;
    limits.normals = true;
    const auto refined = refine(*mesh, legal->labels, settings, limits, progress);
    ASSERT_TRUE(refined);
    polygons_ = refined->polygon_count();
    by_cpu_ = std::make_unique<SurfaceBuffers>();
    ASSERT_TRUE(
        by_cpu_->upload(make_surface(*refined, mesh->bounds().centre(), mesh->face_count()), 1));
    by_gpu_ = std::make_unique<SurfaceBuffers>();
    ASSERT_TRUE(refiner_->refine({*mesh, legal->labels, settings, limits, 7}, progress, *by_gpu_));
    EXPECT_TRUE(by_gpu_->has(7));
    EXPECT_EQ(by_gpu_->face_count(), by_cpu_->face_count());
    paint_.emplace();
    paint_->reset(depths);
    camera_ = make_camera(default_view(mesh->bounds(), kPixels.aspect()), mesh->bounds(), kPixels);
  }

  Image draw(const SurfaceBuffers& surface, const DrawSettings& settings) {
    Scene scene;
    scene.surface = &surface;
    scene.paint = &*paint_;
    const Result<Image> picture = draw_picture(*renderer_, camera_, scene, settings);
    EXPECT_TRUE(picture);
    return picture.value_or(Image());
  }

  void expect_same_pictures() {
    for (const Shading shading : {Shading::kFlat, Shading::kSmooth}) {
      DrawSettings settings;
      settings.shading = shading;
      const Image expected = draw(*by_cpu_, settings);
      const test::ImageDifference difference =
          test::compare_images(draw(*by_gpu_, settings), expected);
      // A vertex that is a ten-millionth off can change a pixel on an edge.
      EXPECT_LE(difference.pixels, 20U);
      settings.has_wireframe = false;
      const test::ImageDifference shaded =
          test::compare_images(draw(*by_gpu_, settings), draw(*by_cpu_, settings));
      EXPECT_LE(shaded.pixels, 5U);
    }
  }

  void expect_same_picks() {
    FacePicker cpu;
    FacePicker gpu;
    const PickScene cpu_scene{*by_cpu_, camera_};
    const PickScene gpu_scene{*by_gpu_, camera_};
    std::size_t different = 0;
    std::size_t met = 0;
    for (int y = 4; y < kPixels.height; y += 8) {
      for (int x = 4; x < kPixels.width; x += 8) {
        const FramebufferPoint point{x + 0.5, y + 0.5};
        const auto expected = cpu.pick(cpu_scene, point);
        const auto actual = gpu.pick(gpu_scene, point);
        met += expected ? 1 : 0;
        different += expected.has_value() != actual.has_value() ||
                             (expected && (expected->drawn_face != actual->drawn_face ||
                                           expected->control_face != actual->control_face))
                         ? 1
                         : 0;
      }
    }
    EXPECT_GT(met, 100U);
    EXPECT_LE(different, 1U);
    EXPECT_EQ(gpu.visible_faces(gpu_scene), cpu.visible_faces(cpu_scene));
    const BrushCapsule capsule{{140.0, 110.0}, {180.0, 120.0}, 20.0};
    const std::vector<std::uint32_t> brushed = cpu.brush(cpu_scene, capsule);
    EXPECT_GT(brushed.size(), 1U);
    EXPECT_THAT(gpu.brush(gpu_scene, capsule), testing::UnorderedElementsAreArray(brushed));
  }

  MeshPointer mesh_;
  std::size_t polygons_ = 0;  ///< Faces of the refined mesh that are no quads.
  std::unique_ptr<GlContext> context_;
  std::unique_ptr<SurfaceBuffers> by_cpu_;
  std::unique_ptr<SurfaceBuffers> by_gpu_;
  std::unique_ptr<GpuRefiner> refiner_;
  std::unique_ptr<MeshRenderer> renderer_;
  std::optional<FacePaint> paint_;
  Camera camera_;
};

/// A bent grid with four triangles and two hexagons, apart from its first face.
PolygonSoup mixed_soup() {
  const PolygonSoup grid = test::grid_soup(10, 8);
  PolygonSoup soup;
  soup.positions = grid.positions;
  const auto corners = [](std::uint32_t column, std::uint32_t row) {
    const std::uint32_t v = row * 11 + column;
    return std::array<std::uint32_t, 4>{v, v + 1, v + 12, v + 11};
  };
  for (std::uint32_t row = 0; row < 8; ++row) {
    for (std::uint32_t column = 0; column < 10; ++column) {
      const auto [a, b, c, d] = corners(column, row);
      const bool is_pair = row == 5 || row == 7;
      if (is_pair && column == 6) {
        // Joined with the next.
        soup.add_face(std::vector<std::uint32_t>{a, b, b + 1, c + 1, c, d});
      } else if (row == 3 && (column == 6 || column == 8)) {
        soup.add_face(std::vector<std::uint32_t>{a, b, c});
        soup.add_face(std::vector<std::uint32_t>{a, c, d});
      } else if (!(is_pair && column == 7)) {
        soup.add_face(std::vector<std::uint32_t>{a, b, c, d});
      }
    }
  }
  return soup;
}

TEST_P(GpuSurface, LooksAndIsPickedTheSame) {
  const Result<ImportedMesh> creature = load_bundled_mesh("creature");
  ASSERT_TRUE(creature);
  test::Random random(11);
  refine_both(creature->mesh, test::random_depths(*creature->mesh, 0.3, 3, random));
  expect_same_pictures();
  expect_same_picks();

  // Polygons that stay: triangles come before the quads, hexagons after them.
  const MeshPointer mixed = test::control_mesh(mixed_soup());
  std::vector<std::uint8_t> depths(mixed->face_count(), 0);
  depths.front() = 3;
  refine_both(mixed, depths, {.non_quads = NonQuadRule::kWherePainted});
  EXPECT_EQ(polygons_, 6U);
  expect_same_pictures();
  expect_same_picks();
}

INSTANTIATE_TEST_SUITE_P(Contexts, GpuSurface,
                         testing::Values(HeadlessKind::kOsmesa, HeadlessKind::kEgl),
                         [](const testing::TestParamInfo<HeadlessKind>& kind) {
                           return kind.param == HeadlessKind::kEgl ? "Egl" : "Osmesa";
                         });

}  // namespace
}  // namespace limn::render
