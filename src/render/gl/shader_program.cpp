// Shader objects live only until the program is linked. Logs are fetched whole.
#include "render/gl/shader_program.h"

#include <vector>

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include "limn/contract.h"
#include "render/environment_error.h"
#include "render/gl/label.h"

namespace limn::render::gl {
namespace {

void delete_shader(GLuint id) {
  glDeleteShader(id);
}
using Shader = Handle<delete_shader>;

std::string trimmed_log(std::string log, GLsizei written) {
  log.resize(static_cast<std::size_t>(written));
  while (!log.empty() && (log.back() == '\n' || log.back() == '\0')) {
    log.pop_back();
  }
  return log.empty() ? "the driver gave no reason" : log;
}

std::string shader_log(GLuint id) {
  GLint length = 0;
  glGetShaderiv(id, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  GLsizei written = 0;
  glGetShaderInfoLog(id, length, &written, log.data());
  return trimmed_log(std::move(log), written);
}

std::string program_log(GLuint id) {
  GLint length = 0;
  glGetProgramiv(id, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  GLsizei written = 0;
  glGetProgramInfoLog(id, length, &written, log.data());
  return trimmed_log(std::move(log), written);
}

Shader compile(const ShaderStage& stage) {
  Shader shader(glCreateShader(stage.type));
  set_label(GL_SHADER, shader.id(), stage.name);
  const char* text = stage.source.data();
  const auto length = static_cast<GLint>(stage.source.size());
  glShaderSource(shader.id(), 1, &text, &length);
  glCompileShader(shader.id());
  GLint is_compiled = GL_FALSE;
  glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &is_compiled);
  if (is_compiled != GL_TRUE) {
    throw EnvironmentError(fmt::format("The graphics driver cannot compile the shader {}:\n{}",
                                       stage.name, shader_log(shader.id())));
  }
  return shader;
}

}  // namespace

void delete_program(GLuint id) {
  glDeleteProgram(id);
}

ShaderProgram ShaderProgram::link(std::string_view label, std::span<const ShaderStage> stages) {
  LIMN_EXPECTS(!stages.empty());
  std::vector<Shader> shaders;
  shaders.reserve(stages.size());
  for (const ShaderStage& stage : stages) {
    shaders.push_back(compile(stage));
  }
  ShaderProgram program;
  program.handle_ = Handle<delete_program>(glCreateProgram());
  const GLuint id = program.id();
  set_label(GL_PROGRAM, id, label);
  for (const Shader& shader : shaders) {
    glAttachShader(id, shader.id());
  }
  glLinkProgram(id);
  GLint is_linked = GL_FALSE;
  glGetProgramiv(id, GL_LINK_STATUS, &is_linked);
  if (is_linked != GL_TRUE) {
    throw EnvironmentError(fmt::format("The graphics driver cannot link the shader program {}:\n{}",
                                       label, program_log(id)));
  }
  for (const Shader& shader : shaders) {
    glDetachShader(id, shader.id());
  }
  return program;
}

void ShaderProgram::use() const {
  LIMN_EXPECTS(handle_);
  glUseProgram(id());
}

void ShaderProgram::set(GLint location, int value) const {
  glProgramUniform1i(id(), location, value);
}
void ShaderProgram::set(GLint location, unsigned value) const {
  glProgramUniform1ui(id(), location, value);
}
void ShaderProgram::set(GLint location, float value) const {
  glProgramUniform1f(id(), location, value);
}
void ShaderProgram::set(GLint location, glm::vec2 value) const {
  glProgramUniform2fv(id(), location, 1, glm::value_ptr(value));
}
void ShaderProgram::set(GLint location, const glm::vec4& value) const {
  glProgramUniform4fv(id(), location, 1, glm::value_ptr(value));
}
void ShaderProgram::set(GLint location, const glm::mat4& value) const {
  glProgramUniformMatrix4fv(id(), location, 1, GL_FALSE, glm::value_ptr(value));
}

}  // namespace limn::render::gl
