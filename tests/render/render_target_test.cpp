#include <gmock/gmock.h>

#include "render/environment_error.h"
#include "render/render_target.h"
#include "support/gl_fixture.h"

namespace limn::render {
namespace {

class RenderTargets : public test::GlFixture {};

TEST_F(RenderTargets, ReadsRowsFromTheTop) {
  RenderTarget target;
  target.resize({8, 6});
  target.bind();
  glClearColor(1, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 5, 2, 1);  // OpenGL's uppermost row.
  glClearColor(0, 1, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
  const Image image = target.read();
  EXPECT_EQ(image.pixel(0, 0)[1], 255);
  EXPECT_EQ(image.pixel(2, 0)[0], 255);
  EXPECT_EQ(image.pixel(0, 5)[0], 255);
  EXPECT_EQ(image.pixel(0, 0)[3], 255) << "a picture is opaque";
}

TEST_F(RenderTargets, ResizingDiscardsTheOldSize) {
  RenderTarget target;
  target.resize({8, 6});
  target.resize({20, 10});
  EXPECT_EQ(target.read().size, glm::ivec2(20, 10));
}

TEST_F(RenderTargets, TooLargeIsRefusedInWords) {
  RenderTarget target;
  try {
    target.resize({largest_target_side() + 1, 16});
    FAIL() << "a picture larger than the limit was accepted";
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("too large"));
  }
}

}  // namespace
}  // namespace limn::render
