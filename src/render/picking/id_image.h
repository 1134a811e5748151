#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/coordinates.h"
#include "render/gl/framebuffer.h"
#include "render/gl/texture.h"

namespace limn::render {

/// A picture of face numbers: one unsigned integer and one depth for each pixel, never blended and
/// never multisampled, since a mix of two numbers is the number of some third face.
///
/// 0 is "nothing"; what else the numbers mean is for whoever draws them to say.
class IdImage {
 public:
  /// Empty; `resize` before use.
  IdImage() noexcept = default;

  /// Makes it this many pixels; does nothing where it is so already. An empty size frees the
  /// memory. Throws EnvironmentError where the driver cannot make an image of that size.
  void resize(FramebufferSize size);
  [[nodiscard]] FramebufferSize size() const noexcept { return size_; }

  /// Draws go here from now on: cleared, viewport set to all of it, depth test on, nothing blended
  /// or culled.
  void begin() const;

  /// The numbers in a rectangle within the image, row by row from the top, rect.area() of them.
  /// Copies that rectangle alone; waits for the GPU.
  void read(PixelRect rect, std::span<std::uint32_t> out) const;
  /// The depth buffer's value at a pixel within the image.
  [[nodiscard]] float read_depth(int x, int y) const;

  /// For shaders: R32UI, rows from the bottom.
  [[nodiscard]] const gl::Texture& texture() const noexcept { return ids_; }

 private:
  FramebufferSize size_;
  gl::Texture ids_;
  gl::Texture depth_;
  gl::Framebuffer framebuffer_;
};

}  // namespace limn::render
