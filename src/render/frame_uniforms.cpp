#include "render/frame_uniforms.h"

#include <algorithm>
#include <cmath>

#include "limn/comparison/distance_palette.h"

namespace limn::render {
namespace {

// The bits of shaders/frame.glsl.
constexpr std::int32_t kSmoothNormals = 1;
constexpr std::int32_t kLit = 2;
constexpr std::int32_t kWireframe = 4;
constexpr std::int32_t kColourByDepth = 8;
constexpr std::int32_t kColourByLevel = 16;
constexpr std::int32_t kShowIllegal = 32;
constexpr std::int32_t kFilled = 64;
constexpr std::int32_t kMaterialShift = 7;
constexpr std::int32_t kColourByDistance = 512;

constexpr Rgb kClay{0xc4, 0x8a, 0x6c};
constexpr Rgb kStone{0x4a, 0x4e, 0x57};
constexpr Rgb kPearl{0xcf, 0xd4, 0xda};

constexpr Rgb kBlack{0, 0, 0};
constexpr Rgb kDarkCage{0xe6, 0xe6, 0xe6};
constexpr Rgb kLightCage{0x3c, 0x40, 0x46};

float linear(std::uint8_t value) {
  const float v = static_cast<float>(value) / 255.0F;
  return v <= 0.04045F ? v / 12.92F : std::pow((v + 0.055F) / 1.055F, 2.4F);
}

glm::vec4 linear_rgb(Rgb colour) {
  return {linear(colour.red), linear(colour.green), linear(colour.blue), 1.0F};
}

std::int32_t option_bits(const DrawSettings& settings) {
  std::int32_t bits = 0;
  bits |= settings.shading == Shading::kSmooth ? kSmoothNormals : 0;
  bits |= settings.is_lit ? kLit : 0;
  bits |= settings.has_wireframe ? kWireframe : 0;
  bits |= settings.colour == FaceColour::kDepth ? kColourByDepth : 0;
  bits |= settings.colour == FaceColour::kLevel ? kColourByLevel : 0;
  bits |= settings.colour == FaceColour::kDistance ? kColourByDistance : 0;
  bits |= settings.shows_illegal_faces ? kShowIllegal : 0;
  bits |= settings.has_faces ? kFilled : 0;
  bits |= static_cast<std::int32_t>(settings.material) << kMaterialShift;
  return bits;
}

}  // namespace

Rgb colour_of(Material material) noexcept {
  switch (material) {
    case Material::kClay:
      return kClay;
    case Material::kDark:
      return kStone;
    case Material::kShiny:
      return kPearl;
    case Material::kStudio:
      break;
  }
  return depth_palette()[0];
}

Background background_of(Theme theme) noexcept {
  if (theme == Theme::kLight) {
    return {{0xee, 0xf0, 0xf3}, {0xd7, 0xda, 0xe0}};
  }
  return {{0x2b, 0x2d, 0x31}, {0x1b, 0x1c, 0x1f}};
}

glm::vec4 srgb(Rgb colour, float alpha) noexcept {
  return {static_cast<float>(colour.red) / 255.0F, static_cast<float>(colour.green) / 255.0F,
          static_cast<float>(colour.blue) / 255.0F, alpha};
}

FrameUniforms frame_uniforms(const Camera& camera, const glm::dvec3& origin,
                             const DrawSettings& settings) {
  FrameUniforms frame{};
  frame.clip_from_local = clip_from_local(camera, origin);
  frame.view_from_local = view_from_local(camera, origin);
  frame.projection = glm::mat4(camera.projection);
  frame.viewport = {static_cast<float>(camera.size.width), static_cast<float>(camera.size.height),
                    settings.scale, 0.0F};
  for (std::size_t depth = 0; depth < frame.palette.size(); ++depth) {
    const Rgb colour = depth > 0 ? depth_palette()[depth] : colour_of(settings.material);
    frame.palette[depth] = linear_rgb(colour);
    frame.palette_text[depth] = srgb(text_colour_on(colour));
  }
  if (settings.colour == FaceColour::kDistance) {
    std::ranges::transform(distance_palette(), frame.palette.begin(), linear_rgb);
  }
  for (std::size_t band = 0; band < frame.valences.size(); ++band) {
    frame.valences[band] = srgb(valence_palette()[band]);
    frame.valence_text[band] = srgb(text_colour_on(valence_palette()[band]));
  }
  frame.illegal = srgb(kIllegalColour);
  frame.relabelled = srgb(kRelabelledColour);
  frame.accent = srgb(kAccentColour);
  frame.wire = srgb(kBlack, 0.35F);
  frame.cage = settings.theme == Theme::kDark ? srgb(kDarkCage, 0.75F) : srgb(kLightCage, 0.65F);
  frame.options = option_bits(settings);
  return frame;
}

}  // namespace limn::render
