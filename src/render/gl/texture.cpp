// Immutable storage with one level.
#include "render/gl/texture.h"

#include "limn/contract.h"
#include "render/gl/label.h"

namespace limn::render::gl {

void delete_texture(GLuint id) {
  glDeleteTextures(1, &id);
}

Texture Texture::create_2d(glm::ivec2 size, GLenum internal_format, std::string_view label) {
  LIMN_EXPECTS(size.x > 0 && size.y > 0);
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &id);
  Texture texture;
  texture.handle_ = Handle<delete_texture>(id);
  texture.size_ = size;
  texture.internal_format_ = internal_format;
  set_label(GL_TEXTURE, id, label);
  glTextureStorage2D(id, 1, internal_format, size.x, size.y);
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTextureParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

void Texture::upload(GLenum format, GLenum type, std::span<const std::byte> bytes) {
  LIMN_EXPECTS(handle_ && !bytes.empty());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(id(), 0, 0, 0, size_.x, size_.y, format, type, bytes.data());
}

void Texture::set_linear_filter() {
  LIMN_EXPECTS(handle_);
  glTextureParameteri(id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(id(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void Texture::bind(GLuint unit) const {
  LIMN_EXPECTS(handle_);
  glBindTextureUnit(unit, id());
}

void Texture::bind_image(GLuint unit, GLenum access) const {
  LIMN_EXPECTS(handle_);
  glBindImageTexture(unit, id(), 0, GL_FALSE, 0, access, internal_format_);
}

}  // namespace limn::render::gl
