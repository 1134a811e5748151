// Pictures, compared exactly with those in tests/golden. All are drawn by OSMesa's software
// renderer, whose frames are the same bytes on every run.
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "limn/mesh/bundled.h"
#include "limn/subdivision/label_subdivision.h"
#include "render/mesh_renderer.h"
#include "render/named_views.h"
#include "support/attribute_shapes.h"
#include "support/gl_fixture.h"
#include "support/image_compare.h"
#include "support/shapes.h"

namespace limn::render {
namespace {

constexpr FramebufferSize kSize{320, 240};

using MeshPointer = std::shared_ptr<const ControlMesh>;

/// What the pictures were drawn with.
constexpr SubdivisionSettings kGreedy{.legalisation = LegalisationMethod::kGreedy};

class Goldens : public test::GlFixture {
 protected:
  void SetUp() override {
    GlFixture::SetUp();
    renderer = std::make_unique<MeshRenderer>();
    control = std::make_unique<SurfaceBuffers>();
    refined = std::make_unique<SurfaceBuffers>();
    markers = std::make_unique<MarkerBuffers>();
    paint = std::make_unique<FacePaint>();
    settings.has_wireframe = false;
  }
  void TearDown() override {
    renderer.reset();
    control.reset();
    refined.reset();
    markers.reset();
    paint.reset();
    GlFixture::TearDown();
  }

  void show(const MeshPointer& shown, const std::vector<std::uint8_t>& painted) {
    mesh = shown;
    depths = painted;
    view = default_view(mesh->bounds(), kSize.aspect());
    // The bundled creature is wide, so there is room to come closer.
    view->distance *= mesh->face_count() > 500 ? 0.75 : 1.0;
    ASSERT_TRUE(control->upload(make_surface(*mesh), 1));
    paint->reset(depths);
    scene.surface = control.get();
    scene.paint = paint.get();
  }
  /// Nothing is painted.
  void show(const MeshPointer& shown) {
    show(shown, std::vector<std::uint8_t>(shown->face_count(), 0));
  }
  void show_refined() {
    IgnoreProgress progress;
    const auto labels = legal_labels(*mesh, depths, kGreedy, progress);
    ASSERT_TRUE(labels);
    RefineLimits limits;
    limits.normals = true;
    const auto result = refine(*mesh, labels->labels, {}, limits, progress);
    ASSERT_TRUE(result);
    const Surface surface = make_surface(*result, mesh->bounds().centre(), mesh->face_count());
    ASSERT_TRUE(refined->upload(surface, 1));
    scene.surface = refined.get();
  }

  Image draw() {
    const Result<Image> picture =
        draw_picture(*renderer, make_camera(*view, mesh->bounds(), kSize), scene, settings);
    EXPECT_TRUE(picture);
    return picture.value_or(Image());
  }

  std::unique_ptr<MeshRenderer> renderer;
  std::unique_ptr<SurfaceBuffers> control;
  std::unique_ptr<SurfaceBuffers> refined;
  std::unique_ptr<MarkerBuffers> markers;
  std::unique_ptr<FacePaint> paint;
  MeshPointer mesh;
  std::vector<std::uint8_t> depths;
  std::optional<ViewState> view;
  Scene scene;
  DrawSettings settings;
};

MeshPointer bundled(std::string_view name) {
  const Result<ImportedMesh> imported = load_bundled_mesh(name);
  EXPECT_TRUE(imported) << to_string(imported.error());
  return imported->mesh;
}

/// Depths 0..7 and more, by height: what a painted mesh looks like.
std::vector<std::uint8_t> depths_by_height(const ControlMesh& mesh, int deepest) {
  std::vector<std::uint8_t> depths;
  const Bounds& bounds = mesh.bounds();
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    double height = 0.0;
    for (const std::uint32_t vertex : mesh.face(f)) {
      height += mesh.positions()[vertex].y / static_cast<double>(mesh.face(f).size());
    }
    const double part = (height - bounds.low.y) / (bounds.high.y - bounds.low.y);
    depths.push_back(static_cast<std::uint8_t>(std::floor(part * (deepest + 0.999))));
  }
  return depths;
}

TEST_F(Goldens, CubeFlat) {
  show(test::cube());
  EXPECT_TRUE(test::matches_golden(draw(), "cube_flat"));
}

/// A cube with an edge of every band of sharpness on the faces that show, and two sharp vertices.
TEST_F(Goldens, CreasesByTheirSharpness) {
  show(test::with_tags(test::cube_soup(),
                       {{{3, 7}, 0.5F},
                        {{7, 6}, 1.5F},
                        {{6, 2}, 2.5F},
                        {{2, 3}, 3.5F},
                        {{6, 5}, 6.0F},
                        {{4, 5}, kInfiniteSharpness},
                        {{5, 1}, kInfiniteSharpness},
                        {{0, 1}, 1.0F}},
                       {{7, 1.0F}, {5, kInfiniteSharpness}}));
  CreaseBuffers creases;
  creases.upload(crease_lines(*mesh));
  EXPECT_EQ(creases.count(), 10U);
  scene.creases = &creases;
  EXPECT_TRUE(test::matches_golden(draw(), "creases"));
}

TEST_F(Goldens, CubeUnlitIsThePaletteExactly) {
  show(test::cube(), {1, 2, 3, 4, 5, 6});
  settings.is_lit = false;
  view = named_view(NamedView::kFront, mesh->bounds(), kSize.aspect());
  const Image image = draw();
  const std::uint8_t* centre = image.pixel(160, 120);
  EXPECT_EQ((Rgb{centre[0], centre[1], centre[2]}), depth_colour(6));
}

TEST_F(Goldens, MixedFlatWireframe) {
  show(test::mixed_prism(), {0, 1, 2, 3, 4, 5, 6, 7});
  settings.has_wireframe = true;
  EXPECT_TRUE(test::matches_golden(draw(), "mixed_flat_wireframe"));
}

TEST_F(Goldens, MixedSmooth) {
  show(test::mixed_prism());
  settings.shading = Shading::kSmooth;
  EXPECT_TRUE(test::matches_golden(draw(), "mixed_smooth"));
}

TEST_F(Goldens, DepthColours) {
  std::vector<std::uint8_t> ramp(16, 10);
  std::iota(ramp.begin(), ramp.begin() + 10, std::uint8_t{0});
  show(test::grid(4), ramp);
  settings.has_wireframe = true;
  MarkerBuffers numbers;
  numbers.upload(depth_markers(*mesh, depths), 1);
  scene.markers = &numbers;
  view = named_view(NamedView::kFront, mesh->bounds(), kSize.aspect());
  EXPECT_TRUE(test::matches_golden(draw(), "depth_colours"));
}

TEST_F(Goldens, CreaturePaintedDark) {
  const MeshPointer creature = bundled("creature");
  show(creature, depths_by_height(*creature, 7));
  settings.has_wireframe = true;
  EXPECT_TRUE(test::matches_golden(draw(), "creature_painted_dark"));
}

TEST_F(Goldens, CreaturePaintedLight) {
  const MeshPointer creature = bundled("creature");
  show(creature, depths_by_height(*creature, 7));
  settings.has_wireframe = true;
  settings.theme = Theme::kLight;
  EXPECT_TRUE(test::matches_golden(draw(), "creature_painted_light"));
}

TEST_F(Goldens, CreatureRefinedSmooth) {
  const MeshPointer creature = bundled("creature");
  show(creature, depths_by_height(*creature, 2));
  show_refined();
  settings.shading = Shading::kSmooth;
  EXPECT_TRUE(test::matches_golden(draw(), "creature_refined_smooth"));
}

TEST_F(Goldens, CreatureRefinedWireframeLight) {
  const MeshPointer creature = bundled("creature");
  show(creature, depths_by_height(*creature, 2));
  show_refined();
  settings.has_wireframe = true;
  settings.theme = Theme::kLight;
  EXPECT_TRUE(test::matches_golden(draw(), "creature_refined_wireframe_light"));
}

TEST_F(Goldens, CageOverRefinedCube) {
  show(test::cube(), {0, 5, 0, 0, 0, 0});
  show_refined();
  settings.has_wireframe = true;
  scene.cage = control.get();
  EXPECT_TRUE(test::matches_golden(draw(), "cube_cage"));
}

TEST_F(Goldens, CageOverRefinedLight) {
  const MeshPointer creature = bundled("creature");
  show(creature, depths_by_height(*creature, 2));
  show_refined();
  settings.shading = Shading::kSmooth;
  settings.theme = Theme::kLight;
  scene.cage = control.get();
  EXPECT_TRUE(test::matches_golden(draw(), "creature_cage_light"));
}

TEST_F(Goldens, LabelsAndIllegalMarks) {
  std::vector<std::uint8_t> painted(36, 0);
  painted[14] = 2;
  painted[21] = 3;
  painted[22] = 1;
  show(test::grid(6), painted);
  const VertexLabels labels = vertex_labels(*mesh, depths);
  markers->upload(label_markers(*mesh, labels, illegal_vertices(*mesh, labels), {}), 1);
  paint->set_illegal(illegal_faces(*mesh, labels));
  settings.shows_illegal_faces = true;
  settings.has_wireframe = true;
  scene.markers = markers.get();
  EXPECT_TRUE(test::matches_golden(draw(), "labels_illegal"));
}

TEST_F(Goldens, LabelsRelabelled) {
  std::vector<std::uint8_t> painted(36, 0);
  painted[14] = 2;
  painted[21] = 3;
  painted[22] = 1;
  show(test::grid(6), painted);
  IgnoreProgress progress;
  const auto legal = legal_labels(*mesh, depths, kGreedy, progress);
  ASSERT_TRUE(legal);
  std::vector<std::uint32_t> raised;
  for (const LegalisationStep& step : legal->steps) {
    raised.push_back(step.vertex);
  }
  markers->upload(label_markers(*mesh, legal->labels, {}, raised), 1);
  settings.has_wireframe = true;
  settings.theme = Theme::kLight;
  scene.markers = markers.get();
  EXPECT_TRUE(test::matches_golden(draw(), "labels_relabelled"));
}

TEST_F(Goldens, EveryDigitInADot) {
  show(test::grid(3));
  std::vector<Marker> dots;
  for (int number = 0; number <= 11; ++number) {
    const auto n = static_cast<float>(number);
    dots.push_back({glm::vec3(std::fmod(n, 4.0F) * 0.8F - 1.2F, 1.0F - std::floor(n / 4.0F), 0),
                    MarkerStyle::kLabel, static_cast<std::uint8_t>(number)});
  }
  markers->upload(dots, 1);
  scene.markers = markers.get();
  settings.scale = 2.0F;
  view = named_view(NamedView::kFront, mesh->bounds(), kSize.aspect());
  EXPECT_TRUE(test::matches_golden(draw(), "digits"));
}

TEST_F(Goldens, BrushHighlightAndRing) {
  show(bundled("torus_open"));
  std::vector<std::uint32_t> under_brush;
  for (std::uint32_t f = 0; f < mesh->face_count(); ++f) {
    if (f % 7 < 2) {
      under_brush.push_back(f);
    }
  }
  paint->set_highlighted(under_brush);
  scene.ring = OverlayRing{{160.0F, 110.0F}, 40.0F, 1.5F};
  settings.has_wireframe = true;
  EXPECT_TRUE(test::matches_golden(draw(), "brush"));
}

TEST_F(Goldens, SegmentsOverAnEmptyScene) {
  show(test::cube());
  scene.surface = nullptr;
  const std::vector<OverlaySegment> frame{{{40, 40}, {280, 40}, kAccentColour, 1.0F, 1.5F},
                                          {{280, 40}, {280, 200}, kAccentColour, 0.5F, 1.5F},
                                          {{280, 200}, {40, 40}, kIllegalColour, 1.0F, 4.0F}};
  scene.segments = frame;
  EXPECT_TRUE(test::matches_golden(draw(), "segments"));
}

TEST_F(Goldens, InsideOfAnOpenMeshIsDarker) {
  show(test::grid(2), {0, 1, 2, 3});
  view = named_view(NamedView::kBack, mesh->bounds(), kSize.aspect());
  EXPECT_TRUE(test::matches_golden(draw(), "grid_inside"));
}

TEST_F(Goldens, SameFrameTwiceIsTheSame) {
  const MeshPointer creature = bundled("creature");
  show(creature, depths_by_height(*creature, 7));
  settings.has_wireframe = true;
  EXPECT_EQ(draw(), draw());
}

TEST_F(Goldens, TooLargeAPictureIsRefusedInWords) {
  show(test::cube());
  const Camera camera = make_camera(*view, mesh->bounds(), {largest_target_side() + 1, 16});
  const Result<Image> picture = draw_picture(*renderer, camera, scene, settings);
  ASSERT_FALSE(picture);
  EXPECT_EQ(picture.error().kind, ErrorKind::kEnvironment);
  EXPECT_NE(picture.error().message.find("too large"), std::string::npos);
}

TEST_F(Goldens, RecolouringEqualsAFreshUpload) {
  const MeshPointer creature = bundled("creature");
  const std::vector<std::uint8_t> painted = depths_by_height(*creature, 5);
  show(creature, painted);
  const Image fresh = draw();
  show(creature);
  paint->set_depths(painted);
  EXPECT_EQ(draw(), fresh);
}

/// A scene that uses every shader of the surface, in whatever context is current.
Image draw_painted_torus() {
  const MeshPointer mesh = bundled("torus_open");
  const std::vector<std::uint8_t> depths = depths_by_height(*mesh, 7);
  MeshRenderer renderer;
  SurfaceBuffers surface;
  FacePaint paint;
  MarkerBuffers markers;
  EXPECT_TRUE(surface.upload(make_surface(*mesh), 1));
  paint.reset(depths);
  markers.upload(depth_markers(*mesh, depths), 1);
  Scene scene;
  scene.surface = &surface;
  scene.paint = &paint;
  scene.cage = &surface;
  scene.markers = &markers;
  const Camera camera =
      make_camera(default_view(mesh->bounds(), kSize.aspect()), mesh->bounds(), kSize);
  return draw_picture(renderer, camera, scene, {}).value_or(Image());
}

TEST(Pictures, EglAndOsmesaDrawTheSameBytes) {
  const auto osmesa = create_headless_context(HeadlessKind::kOsmesa);
  const Image by_osmesa = draw_painted_torus();
  const auto egl = create_headless_context(HeadlessKind::kEgl);
  const Image by_egl = draw_painted_torus();
  ASSERT_EQ(by_egl.size, by_osmesa.size);
  if (egl->info().renderer == osmesa->info().renderer) {
    EXPECT_EQ(by_egl, by_osmesa);
  } else {
    // Another driver rounds differently: edges may fall half a pixel apart, faces may not.
    EXPECT_LT(test::compare_images(by_egl, by_osmesa).pixels, by_egl.rgba.size() / 4 / 10);
  }
}

}  // namespace
}  // namespace limn::render
