#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "limn/painting/depth_change.h"
#include "render/gl/buffer.h"

namespace limn::render {

/// A set of control faces on the GPU, one bit each. Changing it uploads only the words between the
/// first and the last bit that changed.
class FaceSetBuffer {
 public:
  /// Needs a current context.
  explicit FaceSetBuffer(std::string_view label);

  /// An empty set over this many faces.
  void reset(std::size_t face_count);
  /// Replaces the set; faces in any order, repeats allowed.
  void assign(std::span<const std::uint32_t> faces);
  void bind_storage(GLuint slot) const { bits_.bind_storage(slot); }
  [[nodiscard]] bool empty() const noexcept { return members_.empty(); }

 private:
  gl::Buffer bits_;
  std::vector<std::uint32_t> words_;
  std::vector<std::uint32_t> members_;
};

/// What is painted on control faces, on the GPU: their depths, which of them light up under the
/// brush, and which are illegal. Shared by every surface derived from one control mesh, so painting
/// recolours the refined surface as well, and a change of depth uploads depths alone.
class FacePaint {
 public:
  /// Needs a current context.
  FacePaint();

  /// Another control mesh: all depths, and empty sets.
  void reset(std::span<const std::uint8_t> depths);
  /// All depths again (undo, a rule); the number of faces is as at `reset`.
  void set_depths(std::span<const std::uint8_t> depths);
  /// Some depths again, from face `first` on.
  void set_depths(std::size_t first, std::span<const std::uint8_t> depths);
  /// The `after` of each edit: what a stroke has just changed. Uploads the range of faces from the
  /// lowest to the highest; `depths` are all of them, edits already applied.
  void update_depths(std::span<const DepthEdit> edits, std::span<const std::uint8_t> depths);

  void set_highlighted(std::span<const std::uint32_t> faces) { highlighted_.assign(faces); }
  void set_illegal(std::span<const std::uint32_t> faces) { illegal_.assign(faces); }

  /// Binds slots 4, 6 and 7 of shaders/face_paint.glsl.
  void bind() const;

  [[nodiscard]] std::size_t face_count() const noexcept { return face_count_; }

 private:
  gl::Buffer depths_;
  FaceSetBuffer highlighted_;
  FaceSetBuffer illegal_;
  std::size_t face_count_ = 0;
};

}  // namespace limn::render
