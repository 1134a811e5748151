#pragma once

#include <glm/vec2.hpp>

#include "render/gl/framebuffer.h"
#include "render/image.h"

namespace limn::render {

/// A framebuffer of our own to draw pictures into, with several samples a pixel and a depth buffer,
/// and what it resolves to. Never for ids: those are not to be mixed.
class RenderTarget {
 public:
  static constexpr int kSamples = 4;

  /// Empty; `resize` before use.
  RenderTarget() noexcept = default;

  /// Makes it this many pixels; does nothing where it is so already. Throws EnvironmentError where
  /// the driver cannot make an image of that size.
  void resize(glm::ivec2 size);
  [[nodiscard]] glm::ivec2 size() const noexcept { return size_; }

  /// Draws go here from now on; sets the viewport to all of it.
  void bind() const;
  /// Averages the samples into the single-sampled image.
  void resolve() const;
  /// Resolves, then copies into a framebuffer (0: the window's) at least as large, so that the
  /// picture's lower left corner comes to lie at this pixel.
  void resolve_to(GLuint framebuffer, glm::ivec2 lower_left = glm::ivec2(0)) const;
  /// Resolves and reads the picture back, opaque.
  [[nodiscard]] Image read() const;

 private:
  glm::ivec2 size_{0};
  gl::Renderbuffer colour_;
  gl::Renderbuffer depth_;
  gl::Texture resolved_colour_;
  gl::Framebuffer samples_;
  gl::Framebuffer resolved_;
};

/// The largest side of a picture that this context can draw in one go.
[[nodiscard]] int largest_target_side();

}  // namespace limn::render
