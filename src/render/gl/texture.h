#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include <glm/vec2.hpp>

#include "render/gl/handle.h"

namespace limn::render::gl {

void delete_texture(GLuint id);

/// A two-dimensional image without mipmaps, of fixed size and format.
class Texture {
 public:
  /// Empty: id 0.
  Texture() noexcept = default;
  /// `internal_format` is a sized one (GL_RGBA8, GL_R32UI, GL_DEPTH_COMPONENT32F, ...); sides are
  /// at least 1. Sampled without filtering, clamped to the edge.
  [[nodiscard]] static Texture create_2d(glm::ivec2 size, GLenum internal_format,
                                         std::string_view label);

  /// Replaces all texels; `bytes` holds rows from bottom to top without padding.
  void upload(GLenum format, GLenum type, std::span<const std::byte> bytes);
  void set_linear_filter();
  /// For `layout(binding = unit) uniform sampler2D`.
  void bind(GLuint unit) const;
  /// For `layout(binding = unit, ...) uniform image2D`; access is GL_READ_ONLY, ...
  void bind_image(GLuint unit, GLenum access) const;

  [[nodiscard]] GLuint id() const noexcept { return handle_.id(); }
  [[nodiscard]] explicit operator bool() const noexcept { return static_cast<bool>(handle_); }
  [[nodiscard]] glm::ivec2 size() const noexcept { return size_; }
  [[nodiscard]] GLenum internal_format() const noexcept { return internal_format_; }

 private:
  Handle<delete_texture> handle_;
  glm::ivec2 size_{0};
  GLenum internal_format_ = 0;
};

}  // namespace limn::render::gl
