// OpenGL's rows run upwards and ours downwards; the two meet in `read` and `read_depth` alone.

#include "render/picking/id_image.h"

#include <algorithm>

#include <fmt/format.h>

#include "limn/contract.h"
#include "render/environment_error.h"
#include "render/render_target.h"

namespace limn::render {
namespace {

bool is_within(PixelRect rect, FramebufferSize size) {
  return rect.x >= 0 && rect.y >= 0 && rect.x + rect.width <= size.width &&
         rect.y + rect.height <= size.height;
}

/// Reads part of a texture into memory without padding between rows.
void read_texture(const gl::Texture& texture, PixelRect from_bottom, GLenum format, GLenum type,
                  std::span<std::byte> out) {
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureSubImage(texture.id(), 0, from_bottom.x, from_bottom.y, 0, from_bottom.width,
                       from_bottom.height, 1, format, type, static_cast<GLsizei>(out.size()),
                       out.data());
}

}  // namespace

void IdImage::resize(FramebufferSize size) {
  if (size == size_) {
    return;
  }
  *this = IdImage();
  if (size.is_empty()) {
    return;
  }
  if (const int most = largest_target_side(); size.width > most || size.height > most) {
    throw EnvironmentError(
        fmt::format("Faces cannot be picked in a view of {} by {} pixels: this graphics driver "
                    "draws at most {} pixels a side.",
                    size.width, size.height, most));
  }
  const glm::ivec2 pixels(size.width, size.height);
  ids_ = gl::Texture::create_2d(pixels, GL_R32UI, "face ids");
  depth_ = gl::Texture::create_2d(pixels, GL_DEPTH_COMPONENT32F, "face id depth");
  framebuffer_ = gl::Framebuffer::create("face ids");
  framebuffer_.attach(GL_COLOR_ATTACHMENT0, ids_);
  framebuffer_.attach(GL_DEPTH_ATTACHMENT, depth_);
  framebuffer_.require_complete();
  size_ = size;
}

void IdImage::begin() const {
  LIMN_EXPECTS(!size_.is_empty());
  framebuffer_.bind();
  glViewport(0, 0, size_.width, size_.height);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  constexpr GLuint kNothing[4] = {0, 0, 0, 0};
  constexpr GLfloat kFarthest = 0.0F;
  glClearNamedFramebufferuiv(framebuffer_.id(), GL_COLOR, 0, kNothing);
  glClearNamedFramebufferfv(framebuffer_.id(), GL_DEPTH, 0, &kFarthest);
}

void IdImage::read(PixelRect rect, std::span<std::uint32_t> out) const {
  LIMN_EXPECTS(out.size() == rect.area());
  if (rect.is_empty()) {
    return;
  }
  LIMN_EXPECTS(is_within(rect, size_));
  const PixelRect from_bottom{rect.x, size_.height - rect.y - rect.height, rect.width, rect.height};
  read_texture(ids_, from_bottom, GL_RED_INTEGER, GL_UNSIGNED_INT, std::as_writable_bytes(out));
  const auto row = [&](int y) { return out.begin() + static_cast<std::ptrdiff_t>(y) * rect.width; };
  for (int y = 0; y < rect.height / 2; ++y) {
    std::swap_ranges(row(y), row(y + 1), row(rect.height - 1 - y));
  }
}

float IdImage::read_depth(int x, int y) const {
  LIMN_EXPECTS(is_within({x, y, 1, 1}, size_));
  float depth = 0.0F;
  read_texture(depth_, {x, size_.height - 1 - y, 1, 1}, GL_DEPTH_COMPONENT, GL_FLOAT,
               std::as_writable_bytes(std::span(&depth, 1)));
  return depth;
}

}  // namespace limn::render
