#pragma once

#include <optional>
#include <span>

#include <glm/vec2.hpp>

#include "render/camera.h"
#include "render/draw_settings.h"
#include "render/gl/buffer.h"
#include "render/gl/shader_program.h"
#include "render/gl/vertex_array.h"
#include "render/render_target.h"
#include "render/surface/crease_lines.h"
#include "render/surface/face_demands.h"
#include "render/surface/face_distances.h"
#include "render/surface/face_paint.h"
#include "render/surface/markers.h"
#include "render/surface/numbered_faces.h"
#include "render/surface/surface_buffers.h"

namespace limn::render {

/// The brush: a circle on the screen, in framebuffer pixels from the upper left.
struct OverlayRing {
  glm::vec2 centre{0.0F};
  float radius = 0.0F;
  float line_width = 1.5F;
};

/// A straight line on the screen, in framebuffer pixels from the upper left: selections, lassos.
struct OverlaySegment {
  glm::vec2 from{0.0F};
  glm::vec2 to{0.0F};
  Rgb colour = kAccentColour;
  float opacity = 1.0F;
  float width = 1.5F;
};

/// What is drawn; borrowed for the call. All surfaces and markers have the same origin.
struct Scene {
  const SurfaceBuffers* surface = nullptr;   ///< Nothing: the background alone.
  const FacePaint* paint = nullptr;          ///< Needed where there is a surface.
  const FaceDistances* distances = nullptr;  ///< Of the faces of `surface`, for kDistance.
  const FaceDemands* demands = nullptr;      ///< Of the faces of `surface`, if there are any.
  /// Faces of `surface` that light up, in place of those control faces that `paint` names.
  const FaceSetBuffer* lit = nullptr;
  const SurfaceBuffers* cage = nullptr;    ///< A control surface whose edges lie over `surface`.
  const CreaseBuffers* creases = nullptr;  ///< Of `surface`.
  const CreaseBuffers* cage_creases = nullptr;  ///< Of `cage`.
  /// Where numbers are drawn: on these faces of `surface` alone, and not on every one.
  const NumberedFaces* numbered = nullptr;
  const MarkerBuffers* markers = nullptr;
  const MarkerBuffers* valences = nullptr;  ///< Markers as well, over the others.
  std::optional<OverlayRing> ring;
  std::span<const OverlaySegment> segments;
};

/// Draws scenes. Holds programs and small buffers of its own; makes nothing anew in a frame.
class MeshRenderer {
 public:
  /// Needs a current context. Throws EnvironmentError where a shader does not compile.
  MeshRenderer();

  /// Draws the scene into `target`, whose size is the camera's. Changes OpenGL's depth, blend and
  /// cull state and leaves depth test, blending and culling off.
  void draw(const RenderTarget& target, const Camera& camera, const Scene& scene,
            const DrawSettings& settings);

 private:
  void draw_background(const DrawSettings& settings) const;
  void draw_surface(const Scene& scene, const DrawSettings& settings) const;
  void draw_cage(const SurfaceBuffers& cage, const DrawSettings& settings) const;
  void draw_creases(const Scene& scene) const;
  static void bind_face_bytes(const Scene& scene, const DrawSettings& settings);
  void draw_numbers(const Scene& scene, const DrawSettings& settings) const;
  void draw_markers(const MarkerBuffers& markers) const;
  void draw_overlay(const Scene& scene);

  gl::VertexArray no_attributes_;
  gl::Buffer frame_;
  gl::Buffer digits_;
  gl::Buffer segments_;
  gl::ShaderProgram background_program_;
  gl::ShaderProgram surface_program_;
  gl::ShaderProgram edges_program_;
  gl::ShaderProgram creases_program_;
  gl::ShaderProgram numbers_program_;
  gl::ShaderProgram markers_program_;
  gl::ShaderProgram overlay_program_;
  gl::ShaderProgram ring_program_;
};

/// Draws a scene into a picture of any size the driver can draw.
/// Errors: kEnvironment, with the largest size, where it cannot.
[[nodiscard]] Result<Image> draw_picture(MeshRenderer& renderer, const Camera& camera,
                                         const Scene& scene, const DrawSettings& settings);

}  // namespace limn::render
