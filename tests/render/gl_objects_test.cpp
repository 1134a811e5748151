#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include <gmock/gmock.h>

#include "render/environment_error.h"
#include "render/gl/buffer.h"
#include "render/gl/shader_program.h"
#include "render/shader_library.h"
#include "support/gl_fixture.h"

namespace limn::render {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class GlObjects : public test::GlFixture {};

TEST_F(GlObjects, BufferGivesBackWhatWasUploaded) {
  gl::Buffer buffer = gl::Buffer::create("test");
  const std::vector<std::uint32_t> values{1, 2, 3, 4};
  buffer.upload(values);
  EXPECT_EQ(buffer.read<std::uint32_t>(), values);
}

TEST_F(GlObjects, BufferPartIsReplaced) {
  gl::Buffer buffer = gl::Buffer::create("test");
  buffer.upload(std::vector<std::uint32_t>{1, 2, 3, 4});
  const std::array<std::uint32_t, 2> part{9, 8};
  buffer.write(4, std::span<const std::uint32_t>(part));
  EXPECT_THAT(buffer.read<std::uint32_t>(), ElementsAre(1, 9, 8, 4));
}

TEST_F(GlObjects, BufferShrinksAndGrowsWithItsContents) {
  gl::Buffer buffer = gl::Buffer::create("test");
  buffer.upload(std::vector<std::uint32_t>(1000, 5));
  buffer.upload(std::vector<std::uint32_t>{6, 7});
  EXPECT_THAT(buffer.read<std::uint32_t>(), ElementsAre(6, 7));
  std::vector<std::uint32_t> many(5000);
  std::iota(many.begin(), many.end(), 0U);
  buffer.upload(many);
  EXPECT_EQ(buffer.read<std::uint32_t>(), many);
  buffer.clear();
  EXPECT_EQ(buffer.read<std::uint32_t>(), std::vector<std::uint32_t>(5000, 0));
}

TEST_F(GlObjects, EmptyContentsCanBeBound) {
  gl::Buffer buffer = gl::Buffer::create("test");
  buffer.upload(std::vector<std::uint32_t>{});
  buffer.bind_storage(0);
  EXPECT_EQ(buffer.size(), 0U);
}

TEST_F(GlObjects, ShaderErrorCarriesNameAndLog) {
  const std::array stages{
      gl::ShaderStage{GL_VERTEX_SHADER, "broken.vert.glsl",
                      "#version 450\nvoid main() { gl_Position = vec4(undeclared_thing); }\n"}};
  try {
    static_cast<void>(gl::ShaderProgram::link("broken", stages));
    FAIL() << "a broken shader was accepted";
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("broken.vert.glsl"), HasSubstr("undeclared_thing")));
  }
}

TEST_F(GlObjects, LinkErrorCarriesNameAndLog) {
  const std::array stages{
      gl::ShaderStage{GL_VERTEX_SHADER, "a",
                      "#version 450\nout vec3 passed_on;\nvoid main() {\n"
                      "passed_on = vec3(0); gl_Position = vec4(0); }\n"},
      gl::ShaderStage{GL_FRAGMENT_SHADER, "b",
                      "#version 450\nin vec4 passed_on;\nlayout(location = 0) out vec4 c;\n"
                      "void main() { c = passed_on; }\n"}};
  try {
    static_cast<void>(gl::ShaderProgram::link("mismatched program", stages));
    FAIL() << "stages that do not fit were linked";
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("mismatched program"), HasSubstr("passed_on")));
  }
}

TEST_F(GlObjects, DrawParametersCompile) {
  const std::array stages{gl::ShaderStage{
      GL_VERTEX_SHADER, "draw_id.vert.glsl",
      "#version 450\n#extension GL_ARB_shader_draw_parameters : require\n"
      "void main() { gl_Position = vec4(gl_DrawIDARB, gl_BaseInstanceARB, 0, 1); }\n"}};
  EXPECT_TRUE(gl::ShaderProgram::link("draw id", stages));
}

TEST_F(GlObjects, DebugMonitorHearsErrors) {
  gl::DebugMonitor listening;
  glEnable(GL_TEXTURE);  // Not in the core profile.
  EXPECT_THROW(listening.require_no_errors(), EnvironmentError);
  EXPECT_NO_THROW(listening.require_no_errors());
}

}  // namespace
}  // namespace limn::render
