#pragma once

#include <string_view>

#include <glm/vec2.hpp>

#include "render/gl/handle.h"
#include "render/gl/texture.h"

namespace limn::render::gl {

void delete_renderbuffer(GLuint id);
void delete_framebuffer(GLuint id);

/// An image that is only drawn into: multisampled colour, depth.
class Renderbuffer {
 public:
  /// Empty: id 0.
  Renderbuffer() noexcept = default;
  /// `samples` 0 is single-sampled.
  [[nodiscard]] static Renderbuffer create(glm::ivec2 size, GLenum internal_format, int samples,
                                           std::string_view label);

  [[nodiscard]] GLuint id() const noexcept { return handle_.id(); }
  [[nodiscard]] explicit operator bool() const noexcept { return static_cast<bool>(handle_); }

 private:
  Handle<delete_renderbuffer> handle_;
};

/// What is drawn into. Does not own its attachments: they must outlive it.
class Framebuffer {
 public:
  /// Empty: id 0, which binds the window's own framebuffer.
  Framebuffer() noexcept = default;
  [[nodiscard]] static Framebuffer create(std::string_view label);

  /// `attachment` is GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT, ...
  void attach(GLenum attachment, const Texture& texture);
  void attach(GLenum attachment, const Renderbuffer& renderbuffer);
  /// Throws EnvironmentError where the driver cannot draw into this combination.
  void require_complete() const;

  /// Draws go here from now on, and glReadPixels reads here.
  void bind() const;

  [[nodiscard]] GLuint id() const noexcept { return handle_.id(); }
  [[nodiscard]] explicit operator bool() const noexcept { return static_cast<bool>(handle_); }

 private:
  Handle<delete_framebuffer> handle_;
};

}  // namespace limn::render::gl
