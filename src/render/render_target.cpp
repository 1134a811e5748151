#include "render/render_target.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include <fmt/format.h>

#include "limn/contract.h"
#include "render/environment_error.h"

namespace limn::render {

int largest_target_side() {
  GLint texture = 0;
  GLint renderbuffer = 0;
  GLint viewport[2] = {0, 0};
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &renderbuffer);
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  return std::min({texture, renderbuffer, viewport[0], viewport[1]});
}

void RenderTarget::resize(glm::ivec2 size) {
  LIMN_EXPECTS(size.x > 0 && size.y > 0);
  if (size == size_) {
    return;
  }
  if (const int most = largest_target_side(); size.x > most || size.y > most) {
    throw EnvironmentError(
        fmt::format("A picture of {} by {} pixels is too large for this graphics driver: it draws "
                    "at most {} pixels a side.",
                    size.x, size.y, most));
  }
  // The old images go first: a large window holds a few hundred megabytes of samples.
  *this = RenderTarget();
  colour_ = gl::Renderbuffer::create(size, GL_RGBA8, kSamples, "picture samples");
  depth_ = gl::Renderbuffer::create(size, GL_DEPTH_COMPONENT32F, kSamples, "picture depth samples");
  resolved_colour_ = gl::Texture::create_2d(size, GL_RGBA8, "picture");
  samples_ = gl::Framebuffer::create("picture samples");
  samples_.attach(GL_COLOR_ATTACHMENT0, colour_);
  samples_.attach(GL_DEPTH_ATTACHMENT, depth_);
  samples_.require_complete();
  resolved_ = gl::Framebuffer::create("picture");
  resolved_.attach(GL_COLOR_ATTACHMENT0, resolved_colour_);
  resolved_.require_complete();
  size_ = size;
}

void RenderTarget::bind() const {
  LIMN_EXPECTS(size_.x > 0);
  samples_.bind();
  glViewport(0, 0, size_.x, size_.y);
}

void RenderTarget::resolve() const {
  LIMN_EXPECTS(size_.x > 0);
  glBlitNamedFramebuffer(samples_.id(), resolved_.id(), 0, 0, size_.x, size_.y, 0, 0, size_.x,
                         size_.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void RenderTarget::resolve_to(GLuint framebuffer, glm::ivec2 lower_left) const {
  resolve();
  // In two steps: a multisampled blit needs equal formats, which a window's own need not have.
  const glm::ivec2 upper_right = lower_left + size_;
  glBlitNamedFramebuffer(resolved_.id(), framebuffer, 0, 0, size_.x, size_.y, lower_left.x,
                         lower_left.y, upper_right.x, upper_right.y, GL_COLOR_BUFFER_BIT,
                         GL_NEAREST);
}

Image RenderTarget::read() const {
  resolve();
  Image image(size_);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureImage(resolved_colour_.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                    static_cast<GLsizei>(image.rgba.size()), image.rgba.data());
  // OpenGL's rows run upwards.
  const std::size_t row = static_cast<std::size_t>(size_.x) * 4;
  std::vector<std::uint8_t> spare(row);
  for (int y = 0; y < size_.y / 2; ++y) {
    std::uint8_t* upper = image.pixel(0, y);
    std::uint8_t* lower = image.pixel(0, size_.y - 1 - y);
    std::memcpy(spare.data(), upper, row);
    std::memcpy(upper, lower, row);
    std::memcpy(lower, spare.data(), row);
  }
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    image.rgba[i] = 255;
  }
  return image;
}

}  // namespace limn::render
