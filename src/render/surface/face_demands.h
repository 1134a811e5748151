#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "render/gl/buffer.h"

namespace limn::render {

/// The depths that are demanded of the drawn faces of a refined surface, on the GPU, a byte a face:
/// a face is coloured by that where it is more than its control face's. Uploaded with the surface.
class FaceDemands {
 public:
  /// Needs a current context.
  FaceDemands();

  /// Surface::face_demands.
  void upload(std::span<const std::uint8_t> of_drawn_faces);
  [[nodiscard]] std::size_t count() const noexcept { return count_; }
  /// Slot 10 of shaders/face_bytes.glsl.
  void bind() const { bytes_.bind_storage(10); }

 private:
  gl::Buffer bytes_;
  std::size_t count_ = 0;
};

}  // namespace limn::render
