#pragma once

#include "limn/painting/depth_palette.h"

namespace limn::render {

enum class Shading {
  kFlat,    ///< One normal a face: the polygons are seen.
  kSmooth,  ///< One normal a vertex, interpolated.
};

enum class FaceColour {
  kDepth,  ///< The depth painted on the control face, in the depth palette.
  kLevel,  ///< The level a refined face was made at, in the same palette.
  kPlain,  ///< Clay all over.
};

enum class Theme { kDark, kLight };

/// How a scene is drawn. What is drawn is in Scene.
struct DrawSettings {
  Shading shading = Shading::kFlat;
  FaceColour colour = FaceColour::kDepth;
  Theme theme = Theme::kDark;
  bool is_lit = true;
  bool has_wireframe = true;
  bool has_faces = true;             ///< Otherwise the wireframe alone, if there is one.
  bool shows_illegal_faces = false;  ///< Hatches the faces of FacePaint::set_illegal.
  bool has_background = true;        ///< Otherwise the theme's lower colour alone.
  float scale = 1.0F;                ///< Pixels per unit of the interface: 2 on HiDPI monitors.
};

/// The background's colours, for whatever stands beside the viewport.
struct Background {
  Rgb top;
  Rgb bottom;
};
[[nodiscard]] Background background_of(Theme theme) noexcept;

}  // namespace limn::render
