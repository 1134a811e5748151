// The vertex pulling itself: a vertex shader writes what it pulled for each of its vertices into a
// buffer, and the test compares that with the surface.
#include <gmock/gmock.h>

#include "render/gl/shader_program.h"
#include "render/shader_library.h"
#include "render/surface/face_paint.h"
#include "render/surface/surface_buffers.h"
#include "support/gl_fixture.h"
#include "support/shapes.h"

namespace limn::render {
namespace {

class SurfaceOnGpu : public test::GlFixture {};

struct Pulled {
  std::uint32_t control_face;
  std::uint32_t vertex;
  std::uint32_t depth;
  std::uint32_t flags;  ///< 1 highlighted, 2 illegal.
  [[nodiscard]] bool operator==(const Pulled&) const = default;
};

/// For drawn face f, what the shader pulled for its `slot`-th vertex (at most 16 a face).
std::vector<Pulled> pull(const SurfaceBuffers& surface, const FacePaint& paint) {
  const std::string source =
      std::string(
          "#version 450\n"
          "#extension GL_ARB_shader_draw_parameters : require\n") +
      shader_source("surface.glsl") + shader_source("face_paint.glsl") +
      "layout(std430, binding = 9) restrict writeonly buffer Out { uvec4 pulled[]; };\n"
      "void main() {\n"
      "  SurfaceCorner corner = pull_surface_corner();\n"
      "  uint slot = corner.triangle * 3 + (corner.is_provoking ? 2u : min(corner.side, 1u));\n"
      "  uint f = corner.control_face;\n"
      "  pulled[corner.face * 16 + slot] = uvec4(f, corner.vertex, depth_of_face(f),\n"
      "      uint(is_highlighted(f)) + 2 * uint(is_illegal(f)));\n"
      "  gl_Position = vec4(2, 2, 2, 1);\n"
      "}\n";
  const std::array stages{
      gl::ShaderStage{GL_VERTEX_SHADER, "pull", source},
      gl::ShaderStage{GL_FRAGMENT_SHADER, "nothing", "#version 450\nvoid main() {}\n"}};
  const gl::ShaderProgram program = gl::ShaderProgram::link("pull", stages);
  gl::Buffer out = gl::Buffer::create("out");
  out.upload(std::vector<Pulled>(surface.face_count() * 16, Pulled{99, 99, 99, 99}));
  out.bind_storage(9);
  paint.bind();
  program.use();
  glEnable(GL_RASTERIZER_DISCARD);
  surface.draw();
  glDisable(GL_RASTERIZER_DISCARD);
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
  return out.read<Pulled>();
}

TEST_F(SurfaceOnGpu, ShaderPullsEveryFanTriangle) {
  const Surface surface = make_surface(*test::mixed_prism());
  SurfaceBuffers buffers;
  ASSERT_TRUE(buffers.upload(surface, 1));
  const std::vector<std::uint8_t> depths{0, 1, 2, 3, 4, 5, 6, 7};
  FacePaint paint;
  paint.reset(depths);
  const std::vector<Pulled> pulled = pull(buffers, paint);
  for (const SurfaceGroup& group : surface.groups) {
    for (std::uint32_t f = 0; f < group.face_count; ++f) {
      const std::uint32_t face = group.first_face + f;
      const std::uint32_t control = surface.face_control_faces[face];
      const std::uint32_t* corners = &surface.corners[group.first_corner + f * group.sides];
      for (std::uint32_t t = 0; t < group.sides - 2; ++t) {
        const std::array fan{corners[0], corners[t + 1], corners[t + 2]};
        for (std::uint32_t k = 0; k < 3; ++k) {
          const Pulled expected{control, fan[k], depths[control], 0};
          EXPECT_EQ(pulled[face * 16 + t * 3 + k], expected)
              << "face " << face << " triangle " << t << " corner " << k;
        }
      }
    }
  }
}

TEST_F(SurfaceOnGpu, PartOfTheDepthsIsReplaced) {
  SurfaceBuffers buffers;
  ASSERT_TRUE(buffers.upload(make_surface(*test::grid(4)), 1));
  FaceDepths depths(16);
  FacePaint paint;
  paint.reset(depths.values());
  const std::vector<DepthEdit> edits{{9, 0, 3}, {5, 0, 7}, {6, 0, 10}};
  for (const DepthEdit& edit : edits) {
    depths.set(edit.face, edit.after);
  }
  paint.update_depths(edits, depths.values());
  const std::vector<Pulled> pulled = pull(buffers, paint);
  for (std::size_t f = 0; f < 16; ++f) {
    EXPECT_EQ(pulled[f * 16].depth, static_cast<std::uint32_t>(depths[f])) << "face " << f;
  }
}

TEST_F(SurfaceOnGpu, SetsOfFacesAreReplacedAsAWhole) {
  SurfaceBuffers buffers;
  ASSERT_TRUE(buffers.upload(make_surface(*test::grid(10)), 1));
  FacePaint paint;
  paint.reset(std::vector<std::uint8_t>(100, 0));
  paint.set_highlighted(std::vector<std::uint32_t>{0, 31, 32, 99});
  paint.set_highlighted(std::vector<std::uint32_t>{33, 98, 33});
  paint.set_illegal(std::vector<std::uint32_t>{98, 2});
  const std::vector<Pulled> pulled = pull(buffers, paint);
  for (std::size_t f = 0; f < 100; ++f) {
    const std::uint32_t expected = (f == 33 || f == 98 ? 1U : 0U) + (f == 98 || f == 2 ? 2U : 0U);
    EXPECT_EQ(pulled[f * 16].flags, expected) << "face " << f;
  }
}

TEST_F(SurfaceOnGpu, UploadReplacesContentsAndRevision) {
  SurfaceBuffers buffers;
  EXPECT_FALSE(buffers.has(1));
  ASSERT_TRUE(buffers.upload(make_surface(*test::cube()), 1));
  EXPECT_TRUE(buffers.has(1));
  EXPECT_EQ(buffers.face_count(), 6U);
  ASSERT_TRUE(buffers.upload(make_surface(*test::grid(2)), 2));
  EXPECT_TRUE(buffers.has(2));
  EXPECT_EQ(buffers.face_count(), 4U);
  FacePaint paint;
  paint.reset(std::vector<std::uint8_t>{1, 2, 3, 4});
  const std::vector<Pulled> pulled = pull(buffers, paint);
  EXPECT_EQ(pulled[std::size_t{3} * 16].depth, 4U);
}

TEST_F(SurfaceOnGpu, EmptySurfaceDrawsNothing) {
  SurfaceBuffers buffers;
  ASSERT_TRUE(buffers.upload(make_surface(RefinedMesh{}, glm::dvec3(0), 0), 1));
  buffers.draw();
  buffers.draw_edges();
}

}  // namespace
}  // namespace limn::render
