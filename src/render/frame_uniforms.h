#pragma once

#include <array>
#include <cstdint>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "limn/painting/valence_palette.h"
#include "render/camera.h"
#include "render/draw_settings.h"

namespace limn::render {

/// Bits of `options` that follow from what is drawn; those of shaders/frame.glsl.
inline constexpr std::int32_t kHasDemands = 1024;
inline constexpr std::int32_t kLightsDrawn = 2048;

/// The uniform block of shaders/frame.glsl, member for member in std140 layout.
struct FrameUniforms {
  glm::mat4 clip_from_local;
  glm::mat4 view_from_local;
  glm::mat4 projection;
  glm::vec4 viewport;
  std::array<glm::vec4, kDepthColours> palette;
  std::array<glm::vec4, kDepthColours> palette_text;
  std::array<glm::vec4, kValenceBands> valences;
  std::array<glm::vec4, kValenceBands> valence_text;
  glm::vec4 illegal;
  glm::vec4 relabelled;
  glm::vec4 accent;
  glm::vec4 wire;
  glm::vec4 cage;
  std::int32_t options;
  std::array<std::int32_t, 3> padding;
};

/// sRGB as the numbers shaders write.
[[nodiscard]] glm::vec4 srgb(Rgb colour, float alpha = 1.0F) noexcept;

/// Everything for one frame; positions are relative to `origin`.
[[nodiscard]] FrameUniforms frame_uniforms(const Camera& camera, const glm::dvec3& origin,
                                           const DrawSettings& settings);

}  // namespace limn::render
