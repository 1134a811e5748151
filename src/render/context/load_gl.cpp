// glad reads version and extensions once its functions are loaded; the rest is saying plainly what
// is missing.
#include "render/context/load_gl.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include "render/environment_error.h"

namespace limn::render {
namespace {

std::string text_of(GLenum name) {
  const auto* text = reinterpret_cast<const char*>(glGetString(name));
  return text == nullptr ? "unknown" : text;
}

constexpr const char* kAdvice =
    "Update the graphics driver, or use Mesa's software renderer by setting "
    "LIBGL_ALWAYS_SOFTWARE=1.";

}  // namespace

std::string renderer_text() {
  return text_of(GL_RENDERER) + ", " + text_of(GL_VERSION);
}

GlInfo load_gl(GlLoader loader) {
  if (gladLoadGL(loader) == 0) {
    throw EnvironmentError(fmt::format(
        "OpenGL could not be loaded: no context is current or its library is broken. {}", kAdvice));
  }
  GlInfo info;
  info.renderer = text_of(GL_RENDERER);
  info.vendor = text_of(GL_VENDOR);
  info.version = text_of(GL_VERSION);
  glGetIntegerv(GL_MAJOR_VERSION, &info.major);
  glGetIntegerv(GL_MINOR_VERSION, &info.minor);
  if (GLAD_GL_VERSION_4_5 == 0) {
    throw EnvironmentError(fmt::format("Limn needs OpenGL 4.5, but {} offers {}. {}", info.renderer,
                                       info.version, kAdvice));
  }
  if (GLAD_GL_ARB_shader_draw_parameters == 0) {
    throw EnvironmentError(
        fmt::format("Limn needs the OpenGL extension GL_ARB_shader_draw_parameters, which {} ({}) "
                    "lacks. {}",
                    info.renderer, info.version, kAdvice));
  }
  // Depths from 0 to 1, as render/camera.h projects them.
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  return info;
}

}  // namespace limn::render
