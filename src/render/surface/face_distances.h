#pragma once

#include <cstddef>
#include <span>

#include "limn/mesh/control_mesh.h"
#include "limn/mesh/refined_mesh.h"
#include "render/gl/buffer.h"

namespace limn::render {

/// How far each drawn face of a surface is from something, on the GPU: a byte a face, from
/// nothing to the greatest. Upload where they change, never a frame.
class FaceDistances {
 public:
  /// Needs a current context.
  FaceDistances();

  /// One for each face of the mesh, in its order.
  void upload(const RefinedMesh& mesh, std::span<const float> of_faces, double greatest);
  void upload(const ControlMesh& mesh, std::span<const float> of_faces, double greatest);
  [[nodiscard]] std::size_t count() const noexcept { return count_; }
  /// Slot 10 of shaders/surface.vert.glsl.
  void bind() const { bytes_.bind_storage(10); }

 private:
  template <class SidesOf>
  void upload_sorted(const SidesOf& sides_of, std::span<const float> of_faces, double greatest);

  gl::Buffer bytes_;
  std::size_t count_ = 0;
};

}  // namespace limn::render
