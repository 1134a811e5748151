// One binding point, 0, is enough: attributes are interleaved or absent.
#include "render/gl/vertex_array.h"

#include "limn/contract.h"
#include "render/gl/label.h"

namespace limn::render::gl {

void delete_vertex_array(GLuint id) {
  glDeleteVertexArrays(1, &id);
}

VertexArray VertexArray::create(std::string_view label) {
  GLuint id = 0;
  glCreateVertexArrays(1, &id);
  VertexArray array;
  array.handle_ = Handle<delete_vertex_array>(id);
  set_label(GL_VERTEX_ARRAY, id, label);
  return array;
}

void VertexArray::add_attribute(const Attribute& attribute) {
  LIMN_EXPECTS(handle_);
  glEnableVertexArrayAttrib(id(), attribute.location);
  glVertexArrayAttribFormat(id(), attribute.location, attribute.components, attribute.type,
                            attribute.is_normalised ? GL_TRUE : GL_FALSE, attribute.offset);
  glVertexArrayAttribBinding(id(), attribute.location, 0);
}

void VertexArray::set_vertex_buffer(const Buffer& buffer, GLsizei stride) {
  LIMN_EXPECTS(handle_ && buffer);
  glVertexArrayVertexBuffer(id(), 0, buffer.id(), 0, stride);
}

void VertexArray::set_index_buffer(const Buffer& buffer) {
  LIMN_EXPECTS(handle_ && buffer);
  glVertexArrayElementBuffer(id(), buffer.id());
}

void VertexArray::bind() const {
  LIMN_EXPECTS(handle_);
  glBindVertexArray(id());
}

}  // namespace limn::render::gl
