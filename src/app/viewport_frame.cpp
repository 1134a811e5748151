// Places in the window become places in the picture of one half: the second half is a copy of the
// first, moved.
#include "app/viewport_frame.h"

#include <algorithm>

#include "app/session.h"

namespace limn::app {

render::FramebufferPoint ViewportPlace::to_pixel(ui::WindowPoint point) const noexcept {
  const double width = std::max(rect.size.width, 1.0);
  const double height = std::max(rect.size.height, 1.0);
  return {(point.x - rect.origin.x) * size.width / width,
          (point.y - rect.origin.y) * size.height / height};
}

double ViewportPlace::density() const noexcept {
  return rect.size.height > 0.0 ? size.height / rect.size.height : 1.0;
}

render::Camera ViewportFrame::camera() const {
  return render::make_camera(session.view(), session.document().control->bounds(), place.size);
}

render::FramebufferPoint ViewportFrame::to_pixel(ui::WindowPoint at) const {
  if (is_in_second && place.second) {
    at.x += place.rect.origin.x - place.second->x;
    at.y += place.rect.origin.y - place.second->y;
  }
  return place.to_pixel(at);
}

ShownFaces ViewportPicker::shown_faces_in(const render::ScreenRegion& region, Reach reach) {
  ShownFaces shown{nullptr, faces_in(region, reach)};
  std::ranges::sort(shown.faces);
  return shown;
}

ShownFaces ViewportPicker::shown_face_at(render::FramebufferPoint point) {
  ShownFaces shown = shown_faces_in(render::BrushCapsule{point, point, 0.0}, Reach::kVisible);
  if (shown.faces.size() > 1) {
    shown.faces.erase(shown.faces.begin() + 1, shown.faces.end());
  }
  return shown;
}

std::optional<render::PickedFace> ViewportFrame::pick(render::FramebufferPoint at) const {
  return is_in_second ? std::nullopt : picker.pick(at);
}

}  // namespace limn::app
