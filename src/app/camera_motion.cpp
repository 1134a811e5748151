#include "app/camera_motion.h"

#include "render/navigation.h"

namespace limn::app {
namespace {

constexpr double kGlideSeconds = 0.15;

}  // namespace

void CameraMotion::set(const ViewState& view) {
  view_ = view;
  glide_.reset();
}

void CameraMotion::glide_to(const ViewState& view, double now) {
  glide_ = Glide{view_, view, now};
}

bool CameraMotion::update(double now) {
  if (!glide_) {
    return false;
  }
  const double t = (now - glide_->start) / kGlideSeconds;
  view_ = render::ease_view(glide_->from, glide_->to, t);
  if (t >= 1.0) {
    glide_.reset();
  }
  return true;
}

}  // namespace limn::app
