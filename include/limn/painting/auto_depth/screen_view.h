#pragma once

#include <functional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "limn/error.h"

namespace limn {

/// A camera and its picture, as far as sizes on the screen are concerned. Lengths are mesh units.
struct ScreenView {
  glm::dvec3 eye{0.0};
  glm::dvec3 right{1.0, 0.0, 0.0};  ///< Unit and at right angles, as are the next two.
  glm::dvec3 up{0.0, 1.0, 0.0};
  glm::dvec3 back{0.0, 0.0, 1.0};  ///< From what is seen towards the eye.
  bool is_orthographic = false;
  double near_plane = 0.0;   ///< Nothing nearer to the eye than this, along the view, shows.
  double half_height = 1.0;  ///< Half of what is seen from top to bottom: at distance 1 from the
                             ///< eye in perspective, anywhere in orthographic.
  double width = 1920.0;     ///< Of the picture, in pixels.
  double height = 1080.0;
};

/// Answers which cameras a rule means: the file of one, or the one in force where the name is
/// empty. Supplied by whoever has cameras. Errors: those of reading the file.
using ScreenViews = std::function<Result<ScreenView>(const std::string& name)>;

}  // namespace limn
