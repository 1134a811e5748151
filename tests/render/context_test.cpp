#include <cstdlib>
#include <memory>

#include <gmock/gmock.h>

#include "render/context/egl_context.h"
#include "render/context/gl_context.h"
#include "render/context/osmesa_context.h"
#include "render/environment_error.h"
#include "render/gl/vertex_array.h"
#include "render/render_target.h"
#include "render/shader_library.h"

namespace limn::render {
namespace {

using testing::HasSubstr;

Image gradient() {
  const gl::ShaderProgram program = load_program("fullscreen.vert.glsl", "background.frag.glsl");
  program.set(0, glm::vec4(0.9F, 0.4F, 0.1F, 1.0F));
  program.set(1, glm::vec4(0.1F, 0.2F, 0.3F, 1.0F));
  const gl::VertexArray none = gl::VertexArray::create("no attributes");
  RenderTarget target;
  target.resize({64, 48});
  target.bind();
  program.use();
  none.bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  return target.read();
}

class HeadlessContext : public testing::TestWithParam<HeadlessKind> {};

TEST_P(HeadlessContext, OffersCore45) {
  const auto context = create_headless_context(GetParam());
  EXPECT_GE(context->info().major * 10 + context->info().minor, 45);
  GLint profile = 0;
  glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
  EXPECT_TRUE((profile & GL_CONTEXT_CORE_PROFILE_BIT) != 0);
  EXPECT_FALSE(context->info().renderer.empty());
}

TEST_P(HeadlessContext, DrawsTopAndBottomWhereTheyBelong) {
  const auto context = create_headless_context(GetParam());
  const Image image = gradient();
  EXPECT_NEAR(image.pixel(32, 0)[0], 0.9 * 255, 5);
  EXPECT_NEAR(image.pixel(32, 47)[0], 0.1 * 255, 5);
  EXPECT_NEAR(image.pixel(32, 24)[2], 0.2 * 255, 5);
  EXPECT_EQ(image.pixel(0, 0)[3], 255);
}

TEST_P(HeadlessContext, CanBeMadeAgainAfterwards) {
  for (int i = 0; i < 3; ++i) {
    const auto context = create_headless_context(GetParam());
    EXPECT_EQ(gradient().size, glm::ivec2(64, 48));
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, HeadlessContext,
                         testing::Values(HeadlessKind::kEgl, HeadlessKind::kOsmesa),
                         [](const auto& kind) {
                           return kind.param == HeadlessKind::kEgl ? "Egl" : "Osmesa";
                         });

TEST(HeadlessContexts, TakeTurnsInOneProcess) {
  OsmesaContext first;
  EglSurfacelessContext second;
  first.make_current();
  const Image by_osmesa = gradient();
  second.make_current();
  const Image by_egl = gradient();
  if (second.info().renderer == first.info().renderer) {
    EXPECT_EQ(by_egl, by_osmesa) << "the same software renderer draws the same pixels";
  }
  first.make_current();
  EXPECT_EQ(gradient(), by_osmesa);
  second.make_current();
  EXPECT_EQ(gradient(), by_egl);
}

TEST(HeadlessContexts, EnvironmentChoosesTheKind) {
  ASSERT_EQ(setenv("LIMN_HEADLESS", "osmesa", 1), 0);
  EXPECT_EQ(create_headless_context()->name(), "OSMesa");
  ASSERT_EQ(setenv("LIMN_HEADLESS", "egl", 1), 0);
  EXPECT_EQ(create_headless_context()->name(), "EGL");
  ASSERT_EQ(setenv("LIMN_HEADLESS", "vulkan", 1), 0);
  try {
    static_cast<void>(create_headless_context());
    ADD_FAILURE() << "an unknown kind was accepted";
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), HasSubstr("vulkan"));
  }
  ASSERT_EQ(unsetenv("LIMN_HEADLESS"), 0);
}

GlFunction no_functions(const char*) {
  return nullptr;
}

TEST(LoadGl, SaysWhenThereIsNoOpenGl) {
  EXPECT_THROW(load_gl(no_functions), EnvironmentError);
}

}  // namespace
}  // namespace limn::render
