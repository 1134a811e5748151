// Framebuffers and renderbuffers by direct state access.
#include "render/gl/framebuffer.h"

#include <fmt/format.h>

#include "limn/contract.h"
#include "render/environment_error.h"
#include "render/gl/label.h"

namespace limn::render::gl {

void delete_renderbuffer(GLuint id) {
  glDeleteRenderbuffers(1, &id);
}
void delete_framebuffer(GLuint id) {
  glDeleteFramebuffers(1, &id);
}

Renderbuffer Renderbuffer::create(glm::ivec2 size, GLenum internal_format, int samples,
                                  std::string_view label) {
  LIMN_EXPECTS(size.x > 0 && size.y > 0 && samples >= 0);
  GLuint id = 0;
  glCreateRenderbuffers(1, &id);
  Renderbuffer renderbuffer;
  renderbuffer.handle_ = Handle<delete_renderbuffer>(id);
  set_label(GL_RENDERBUFFER, id, label);
  glNamedRenderbufferStorageMultisample(id, samples, internal_format, size.x, size.y);
  return renderbuffer;
}

Framebuffer Framebuffer::create(std::string_view label) {
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  Framebuffer framebuffer;
  framebuffer.handle_ = Handle<delete_framebuffer>(id);
  set_label(GL_FRAMEBUFFER, id, label);
  return framebuffer;
}

void Framebuffer::attach(GLenum attachment, const Texture& texture) {
  LIMN_EXPECTS(handle_ && texture);
  glNamedFramebufferTexture(id(), attachment, texture.id(), 0);
}

void Framebuffer::attach(GLenum attachment, const Renderbuffer& renderbuffer) {
  LIMN_EXPECTS(handle_ && renderbuffer);
  glNamedFramebufferRenderbuffer(id(), attachment, GL_RENDERBUFFER, renderbuffer.id());
}

void Framebuffer::require_complete() const {
  LIMN_EXPECTS(handle_);
  const GLenum status = glCheckNamedFramebufferStatus(id(), GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    throw EnvironmentError(
        fmt::format("The graphics driver cannot draw into an image of this kind (framebuffer "
                    "status {:#x}). Try a smaller picture or a newer driver.",
                    status));
  }
}

void Framebuffer::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, id());
}

}  // namespace limn::render::gl
