// The KHR_debug callback may not throw through the driver's C frames, so it only takes notes.
#include "render/gl/debug_monitor.h"

#include <utility>

#include <glad/gl.h>

#include "render/environment_error.h"

namespace limn::render::gl {
namespace {

void GLAD_API_PTR on_message(GLenum source, GLenum type, GLuint, GLenum, GLsizei length,
                             const GLchar* message, const void* user) {
  // What the shader compiler has to say is in the log that ShaderProgram throws.
  if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) {
    return;
  }
  if (type != GL_DEBUG_TYPE_ERROR && type != GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR) {
    return;
  }
  auto* errors = static_cast<std::vector<std::string>*>(const_cast<void*>(user));
  if (length < 0) {
    errors->emplace_back(message);
  } else {
    errors->emplace_back(message, static_cast<std::size_t>(length));
  }
}

}  // namespace

DebugMonitor::DebugMonitor() : errors_(std::make_unique<std::vector<std::string>>()) {
  glEnable(GL_DEBUG_OUTPUT);
  // Called before the offending call returns, so a debugger's stack shows the culprit.
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(on_message, errors_.get());
}

DebugMonitor::~DebugMonitor() {
  glDebugMessageCallback(nullptr, nullptr);
  glDisable(GL_DEBUG_OUTPUT);
}

std::vector<std::string> DebugMonitor::take_errors() {
  return std::exchange(*errors_, {});
}

void DebugMonitor::require_no_errors() {
  const std::vector<std::string> errors = take_errors();
  if (errors.empty()) {
    return;
  }
  std::string message = "OpenGL reported errors:";
  for (const std::string& error : errors) {
    message += "\n  " + error;
  }
  throw EnvironmentError(message);
}

}  // namespace limn::render::gl
