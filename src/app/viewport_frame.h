#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/paint_tools/shown_faces.h"
#include "render/camera.h"
#include "render/coordinates.h"
#include "render/picking/picked_face.h"
#include "render/picking/screen_region.h"
#include "ui/input.h"

namespace limn::app {

class Session;

/// Which faces a tool takes of those in a part of the picture.
enum class Reach : std::uint8_t {
  kVisible,  ///< That show in it.
  kThrough,  ///< That would, were there nothing before them.
};

/// Answers which faces show where in the viewport, for the camera in force.
class ViewportPicker {
 public:
  virtual ~ViewportPicker() = default;
  [[nodiscard]] virtual std::optional<render::PickedFace> pick(render::FramebufferPoint point) = 0;
  /// Control faces in a part of the picture, each once.
  [[nodiscard]] virtual std::vector<std::uint32_t> faces_in(const render::ScreenRegion& region,
                                                            Reach reach) = 0;
  /// Faces of the mesh that is shown, of a refined one if that has fine faces.
  [[nodiscard]] virtual ShownFaces shown_faces_in(const render::ScreenRegion& region, Reach reach);
  /// The one at a place, as a list.
  [[nodiscard]] ShownFaces shown_face_at(render::FramebufferPoint point);
};

/// Where the viewport lies: its rectangle in the window, and its size in pixels. Where it is split,
/// both are of the first half, and the second is as large.
struct ViewportPlace {
  ui::WindowRect rect;
  render::FramebufferSize size;
  std::optional<ui::WindowPoint> second{};  ///< Upper left corner of the second half.

  /// The pixel of the viewport under a window position; may lie outside.
  [[nodiscard]] render::FramebufferPoint to_pixel(ui::WindowPoint point) const noexcept;
  /// Pixels per window unit.
  [[nodiscard]] double density() const noexcept;
};

/// What the mouse has to work with in one frame.
struct ViewportFrame {
  const ui::ViewportInput& input;
  const ViewportPlace& place;
  Session& session;
  ViewportPicker& picker;
  bool is_in_second = false;  ///< The cursor, or the drag, is in the second half.

  [[nodiscard]] render::Camera camera() const;
  /// The pixel of the half that the cursor is in.
  [[nodiscard]] render::FramebufferPoint to_pixel(ui::WindowPoint at) const;
  /// What shows at a place of the half that the cursor is in; nothing in the second, where there is
  /// nothing to pick.
  [[nodiscard]] std::optional<render::PickedFace> pick(render::FramebufferPoint at) const;
  /// For moving the camera, which is that of both halves: what shows there in the first.
  [[nodiscard]] std::optional<render::PickedFace> pick_in_first(render::FramebufferPoint at) const {
    return picker.pick(at);
  }
};

}  // namespace limn::app
