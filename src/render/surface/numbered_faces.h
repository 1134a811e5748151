#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/gl/buffer.h"
#include "render/surface/surface.h"

namespace limn::render {

/// A drawn face that holds a number, and how many times its own size may be counted as room for it.
struct NumberedFace {
  std::uint32_t face = 0;
  float scale = 1.0F;

  [[nodiscard]] bool operator==(const NumberedFace&) const = default;
};

/// One drawn face for each control face of a refined surface: that nearest to the middle of what
/// the control face has become. Its scale stands for the others, as if they were alike.
[[nodiscard]] std::vector<NumberedFace> middle_faces(const Surface& surface);

/// Numbered faces on the GPU. Upload where they change, never a frame.
class NumberedFaces {
 public:
  /// Needs a current context.
  NumberedFaces();

  void upload(std::span<const NumberedFace> faces);
  [[nodiscard]] std::size_t count() const noexcept { return count_; }
  /// Slot 8 of shaders/numbers.vert.glsl.
  void bind() const { records_.bind_storage(8); }

 private:
  gl::Buffer records_;
  std::size_t count_ = 0;
};

}  // namespace limn::render
