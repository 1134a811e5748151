#pragma once

#include <span>
#include <string>
#include <string_view>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "render/gl/handle.h"

namespace limn::render::gl {

void delete_program(GLuint id);

/// One stage of a program: GL_VERTEX_SHADER, GL_FRAGMENT_SHADER or GL_COMPUTE_SHADER, and its GLSL.
struct ShaderStage {
  GLenum type = 0;
  std::string name;  ///< For messages: the file it came from.
  std::string source;
};

/// A linked program. Uniforms are set by their `layout(location = ...)`, without binding.
class ShaderProgram {
 public:
  /// Empty: id 0.
  ShaderProgram() noexcept = default;
  /// Compiles and links. Throws EnvironmentError with the stage's name and the driver's whole log.
  [[nodiscard]] static ShaderProgram link(std::string_view label,
                                          std::span<const ShaderStage> stages);

  void use() const;

  void set(GLint location, int value) const;
  void set(GLint location, unsigned value) const;
  void set(GLint location, float value) const;
  void set(GLint location, glm::vec2 value) const;
  void set(GLint location, const glm::vec4& value) const;
  void set(GLint location, const glm::mat4& value) const;

  [[nodiscard]] GLuint id() const noexcept { return handle_.id(); }
  [[nodiscard]] explicit operator bool() const noexcept { return static_cast<bool>(handle_); }

 private:
  Handle<delete_program> handle_;
};

}  // namespace limn::render::gl
