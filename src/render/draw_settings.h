#pragma once

#include "limn/painting/depth_palette.h"

namespace limn::render {

enum class Shading {
  kFlat,    ///< One normal a face: the polygons are seen.
  kSmooth,  ///< One normal a vertex, interpolated.
};

enum class FaceColour {
  kDepth,     ///< The depth painted on the control face, in the depth palette.
  kLevel,     ///< The level a refined face was made at, in the same palette.
  kPlain,     ///< Clay all over.
  kDistance,  ///< How far a refined face is from the limit surface (Scene::distances), in the
              ///< palette of distances; where that is not known, as kPlain.
};

/// What the surface seems to be made of. All but the first are matcaps: light and material as one
/// picture over the directions that a surface may face, worked out in shaders/matcap.glsl.
enum class Material {
  kStudio,  ///< Matt, under a key light, a fill and a rim.
  kClay,    ///< Warm and soft, as what one models with.
  kDark,    ///< Dark stone with light from both sides: shapes by their outlines.
  kShiny,   ///< Polished, with two windows mirrored in it: shows dents and seams of the surface.
};

enum class Theme { kDark, kLight };

/// How a scene is drawn. What is drawn is in Scene.
struct DrawSettings {
  Shading shading = Shading::kFlat;
  FaceColour colour = FaceColour::kDepth;
  Material material = Material::kStudio;
  Theme theme = Theme::kDark;
  bool is_lit = true;
  bool has_wireframe = true;
  bool has_faces = true;             ///< Otherwise the wireframe alone, if there is one.
  bool shows_illegal_faces = false;  ///< Hatches the faces of FacePaint::set_illegal.
  /// Numbers on faces large enough on the screen: what their colour says, but for 0.
  bool has_numbers = false;
  bool has_background = true;  ///< Otherwise the theme's lower colour alone.
  float scale = 1.0F;          ///< Pixels per unit of the interface: 2 on HiDPI monitors.
};

/// What faces without a colour of their own look like.
[[nodiscard]] Rgb colour_of(Material material) noexcept;

/// The background's colours, for whatever stands beside the viewport.
struct Background {
  Rgb top;
  Rgb bottom;
};
[[nodiscard]] Background background_of(Theme theme) noexcept;

}  // namespace limn::render
