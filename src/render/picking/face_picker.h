#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/mat4x4.hpp>

#include "render/camera.h"
#include "render/gl/buffer.h"
#include "render/gl/shader_program.h"
#include "render/picking/id_image.h"
#include "render/picking/picked_face.h"
#include "render/picking/screen_region.h"
#include "render/surface/surface_buffers.h"

namespace limn::render {

/// What is asked about: a surface (the control mesh or a refined one) as a camera sees it.
struct PickScene {
  const SurfaceBuffers& surface;
  const Camera& camera;
};

/// Tells which faces show where.
///
/// Every drawn face writes its number into an image of the framebuffer's size; what the mouse and
/// the rules ask is answered from that image. It is drawn again only where the surface, what
/// was uploaded to it, the camera or the size differ from the last question's, so that moving the
/// mouse over a still picture draws nothing. The image holds drawn faces, and the surface's own
/// face records lead from them to control faces: painting on a refined surface paints the control
/// face.
///
/// Every member function needs the context of construction to be current, and leaves its own
/// framebuffer, program and depth test set. All throw EnvironmentError where the driver cannot make
/// the image.
class FacePicker {
 public:
  FacePicker();

  /// The nearest face at a place of the image; nothing beside the surface or outside the image.
  [[nodiscard]] std::optional<PickedFace> pick(const PickScene& scene, FramebufferPoint point);

  /// The control faces that are seen (seen.h) in a pixel of the region, each once, in the order of
  /// their first pixel from the top left. Reads back only the rectangle around the region; takes
  /// time proportional to its pixels.
  [[nodiscard]] std::vector<std::uint32_t> faces_in(const PickScene& scene,
                                                    const ScreenRegion& region);
  /// The drawn faces themselves, ascending.
  [[nodiscard]] std::vector<std::uint32_t> drawn_faces_in(const PickScene& scene,
                                                          const ScreenRegion& region);
  /// Those under a brush.
  [[nodiscard]] std::vector<std::uint32_t> brush(const PickScene& scene,
                                                 const BrushCapsule& capsule) {
    return faces_in(scene, ScreenRegion(capsule));
  }

  /// The control faces that are seen (seen.h) in at least one pixel, ascending. They are gathered
  /// on the GPU, from the finished image, so that a face which is drawn first and then covered does
  /// not count; what is read back is one bit for each control face.
  [[nodiscard]] std::vector<std::uint32_t> visible_faces(const PickScene& scene);

  /// The numbers themselves (seen.h says what they hold), as of the last question.
  [[nodiscard]] const IdImage& image() const noexcept { return image_; }
  /// How often the image has been drawn.
  [[nodiscard]] std::uint64_t draw_count() const noexcept { return draw_count_; }

 private:
  /// What the image shows.
  struct Key {
    std::uint64_t upload_id = 0;
    glm::mat4 clip_from_local{0.0F};
    FramebufferSize size;

    [[nodiscard]] bool operator==(const Key&) const = default;
  };

  /// Brings the image up to date. False where there is nothing to see.
  [[nodiscard]] bool update(const PickScene& scene);
  /// Replaces `drawn_` by the faces that are seen in the region, those of many pixels many times.
  void gather_drawn(const PickScene& scene, const ScreenRegion& region);
  /// Replaces `controls_` by the control faces of `drawn_`.
  void look_up_control_faces(const SurfaceBuffers& surface);

  gl::ShaderProgram draw_ids_;
  gl::ShaderProgram look_up_;
  gl::ShaderProgram gather_visible_;
  IdImage image_;
  gl::Buffer visible_bits_;
  Key key_;
  std::uint64_t draw_count_ = 0;

  gl::Buffer asked_;  ///< Drawn faces, and their control faces.
  gl::Buffer answers_;

  // Kept to save allocations.
  std::vector<std::uint32_t> pixels_;    ///< The region's rectangle.
  std::vector<PixelSpan> spans_;         ///< Of one row.
  std::vector<std::uint32_t> drawn_;     ///< Drawn faces in question.
  std::vector<std::uint32_t> controls_;  ///< Their control faces.
  /// For each control face the number of the last question of `faces_in` that met it.
  std::vector<std::uint32_t> last_met_;
  std::uint32_t question_count_ = 0;
};

}  // namespace limn::render
