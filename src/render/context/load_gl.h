#pragma once

#include <string>

namespace limn::render {

/// Looks up an OpenGL function of the current context; what glfwGetProcAddress is.
using GlFunction = void (*)();
using GlLoader = GlFunction (*)(const char* name);

/// What the driver says of itself.
struct GlInfo {
  std::string renderer;  ///< "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string vendor;
  std::string version;  ///< "4.5 (Core Profile) Mesa 22.3.6"
  int major = 0;
  int minor = 0;
};

/// Renderer and version of the current context on one line, for people and to tell drivers apart.
[[nodiscard]] std::string renderer_text();

/// Loads the functions of OpenGL for the current context and checks that it is what Limn draws
/// with: 4.5 core or newer, with GL_ARB_shader_draw_parameters.
/// Throws EnvironmentError that names the renderer and version found, and what to do.
GlInfo load_gl(GlLoader loader);

}  // namespace limn::render
