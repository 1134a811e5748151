// Mutable storage by direct state access. The capacity only grows; a moved-from buffer keeps its
// numbers but has no id, and every use asserts that there is one.
#include "render/gl/buffer.h"

#include <fmt/format.h>

#include "render/environment_error.h"
#include "render/gl/label.h"

namespace limn::render::gl {

void delete_buffer(GLuint id) {
  glDeleteBuffers(1, &id);
}

Buffer Buffer::create(std::string_view label) {
  GLuint id = 0;
  glCreateBuffers(1, &id);
  Buffer buffer;
  buffer.handle_ = Handle<delete_buffer>(id);
  set_label(GL_BUFFER, id, label);
  return buffer;
}

void Buffer::resize(std::size_t bytes) {
  LIMN_EXPECTS(handle_);
  if (bytes > capacity_) {
    glNamedBufferData(id(), static_cast<GLsizeiptr>(bytes), nullptr, GL_DYNAMIC_DRAW);
    if (glGetError() == GL_OUT_OF_MEMORY) {
      size_ = capacity_ = 0;
      throw OutOfVideoMemory(
          fmt::format("The graphics driver has no {} MB of memory left.", (bytes >> 20U) + 1));
    }
    capacity_ = bytes;
  }
  size_ = bytes;
}

void Buffer::upload_bytes(std::span<const std::byte> bytes) {
  resize(bytes.size());
  write_bytes(0, bytes);
}

void Buffer::write_bytes(std::size_t offset, std::span<const std::byte> bytes) {
  LIMN_EXPECTS(handle_ && offset <= size_ && bytes.size() <= size_ - offset);
  if (!bytes.empty()) {
    glNamedBufferSubData(id(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes.size()),
                         bytes.data());
  }
}

void Buffer::clear() {
  LIMN_EXPECTS(handle_);
  if (size_ > 0) {
    glClearNamedBufferSubData(id(), GL_R8UI, 0, static_cast<GLsizeiptr>(size_), GL_RED_INTEGER,
                              GL_UNSIGNED_BYTE, nullptr);
  }
}

void Buffer::read_bytes(std::size_t offset, std::span<std::byte> out) const {
  LIMN_EXPECTS(handle_ && offset <= size_ && out.size() <= size_ - offset);
  if (!out.empty()) {
    glGetNamedBufferSubData(id(), static_cast<GLintptr>(offset),
                            static_cast<GLsizeiptr>(out.size()), out.data());
  }
}

namespace {

void bind_range(GLenum target, GLuint slot, GLuint id, std::size_t size) {
  if (size == 0) {
    glBindBufferBase(target, slot, 0);
  } else {
    glBindBufferRange(target, slot, id, 0, static_cast<GLsizeiptr>(size));
  }
}

}  // namespace

void Buffer::bind_storage(GLuint slot) const {
  LIMN_EXPECTS(handle_);
  bind_range(GL_SHADER_STORAGE_BUFFER, slot, id(), size_);
}

void Buffer::bind_uniform(GLuint slot) const {
  LIMN_EXPECTS(handle_);
  bind_range(GL_UNIFORM_BUFFER, slot, id(), size_);
}

void Buffer::bind_draw_indirect() const {
  LIMN_EXPECTS(handle_);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, id());
}

}  // namespace limn::render::gl
