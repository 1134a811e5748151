#pragma once

#include <string_view>

#include "render/gl/buffer.h"
#include "render/gl/handle.h"

namespace limn::render::gl {

void delete_vertex_array(GLuint id);

/// How vertex attributes are fetched. Meshes have none (their shaders pull vertices from storage
/// buffers), but OpenGL draws nothing without a vertex array.
class VertexArray {
 public:
  /// Empty: id 0.
  VertexArray() noexcept = default;
  [[nodiscard]] static VertexArray create(std::string_view label);

  struct Attribute {
    GLuint location = 0;
    GLint components = 4;
    GLenum type = GL_FLOAT;
    bool is_normalised = false;
    GLuint offset = 0;  ///< Bytes from the start of a vertex.
  };
  /// Reads an attribute from the vertex buffer.
  void add_attribute(const Attribute& attribute);
  /// The one interleaved vertex buffer; `stride` in bytes.
  void set_vertex_buffer(const Buffer& buffer, GLsizei stride);
  void set_index_buffer(const Buffer& buffer);

  void bind() const;

  [[nodiscard]] GLuint id() const noexcept { return handle_.id(); }
  [[nodiscard]] explicit operator bool() const noexcept { return static_cast<bool>(handle_); }

 private:
  Handle<delete_vertex_array> handle_;
};

}  // namespace limn::render::gl
