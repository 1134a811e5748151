// Order: background, surface (with depth), cage hidden then visible, creases, numbers, markers,
// then what lies flat on the screen. Everything after the surface is blended and leaves the depth
// buffer as it is.
#include "render/mesh_renderer.h"

#include <array>
#include <cstring>
#include <vector>

#include <fmt/format.h>

#include "limn/contract.h"
#include "render/digit_strokes.h"
#include "render/environment_error.h"
#include "render/frame_uniforms.h"
#include "render/shader_library.h"

namespace limn::render {
namespace {

constexpr float kCageWidth = 1.5F;
constexpr float kHiddenCageStrength = 0.15F;
constexpr float kVisibleCageStrength = 1.0F;

/// As shaders/overlay.vert.glsl reads it.
struct SegmentRecord {
  glm::vec4 ends;
  glm::vec4 colour;
  float width;
  std::array<float, 3> unused;
};
static_assert(sizeof(SegmentRecord) == 48);

gl::Buffer digit_buffer() {
  const DigitStrokes font = make_digit_strokes();
  // Twelve words of offsets, then the strokes: the block of shaders/markers.frag.glsl.
  std::vector<std::byte> bytes(12 * sizeof(std::uint32_t) +
                               font.strokes.size() * sizeof(glm::vec4));
  std::memcpy(bytes.data(), font.first.data(), font.first.size() * sizeof(std::uint32_t));
  std::memcpy(bytes.data() + 12 * sizeof(std::uint32_t), font.strokes.data(),
              font.strokes.size() * sizeof(glm::vec4));
  gl::Buffer buffer = gl::Buffer::create("digit strokes");
  buffer.upload_bytes(bytes);
  return buffer;
}

void begin_blending() {
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDepthMask(GL_FALSE);
}

void end_blending() {
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

}  // namespace

MeshRenderer::MeshRenderer()
    : no_attributes_(gl::VertexArray::create("no attributes")),
      frame_(gl::Buffer::create("frame")),
      digits_(digit_buffer()),
      segments_(gl::Buffer::create("overlay segments")),
      background_program_(load_program("fullscreen.vert.glsl", "background.frag.glsl")),
      surface_program_(load_program("surface.vert.glsl", "surface.frag.glsl")),
      edges_program_(load_program("edges.vert.glsl", "edges.frag.glsl")),
      creases_program_(load_program("creases.vert.glsl", "creases.frag.glsl")),
      numbers_program_(load_program("numbers.vert.glsl", "markers.frag.glsl")),
      markers_program_(load_program("markers.vert.glsl", "markers.frag.glsl")),
      overlay_program_(load_program("overlay.vert.glsl", "overlay.frag.glsl")),
      ring_program_(load_program("ring.vert.glsl", "ring.frag.glsl")) {}

void MeshRenderer::draw(const RenderTarget& target, const Camera& camera, const Scene& scene,
                        const DrawSettings& wanted) {
  DrawSettings settings = wanted;
  if (settings.colour == FaceColour::kDistance && scene.distances == nullptr) {
    settings.colour = FaceColour::kPlain;
  }
  LIMN_EXPECTS(camera.size.width == target.size().x && camera.size.height == target.size().y);
  LIMN_EXPECTS(scene.surface == nullptr || scene.paint != nullptr);

  const glm::dvec3 origin = scene.surface != nullptr ? scene.surface->origin()
                            : scene.cage != nullptr  ? scene.cage->origin()
                                                     : glm::dvec3(0.0);
  FrameUniforms frame = frame_uniforms(camera, origin, settings);
  frame.options |=
      (scene.demands != nullptr && settings.colour != FaceColour::kDistance ? kHasDemands : 0) |
      (scene.lit != nullptr ? kLightsDrawn : 0);
  frame_.upload(std::span<const FrameUniforms>(&frame, 1));
  frame_.bind_uniform(0);

  target.bind();
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  glClearDepth(0.0);  // The farthest: see Camera.
  glClear(GL_DEPTH_BUFFER_BIT);

  glDisable(GL_DEPTH_TEST);
  draw_background(settings);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  if (scene.surface != nullptr) {
    draw_surface(scene, settings);
  }
  begin_blending();
  if (scene.cage != nullptr) {
    draw_cage(*scene.cage, settings);
  }
  draw_creases(scene);
  if (settings.has_numbers && scene.surface != nullptr) {
    draw_numbers(scene, settings);
  }
  for (const MarkerBuffers* markers : {scene.markers, scene.valences}) {
    if (markers != nullptr) {
      draw_markers(*markers);
    }
  }
  glDisable(GL_DEPTH_TEST);
  draw_overlay(scene);
  end_blending();
}

void MeshRenderer::draw_background(const DrawSettings& settings) const {
  const Background colours = background_of(settings.theme);
  background_program_.set(0, srgb(settings.has_background ? colours.top : colours.bottom));
  background_program_.set(1, srgb(colours.bottom));
  background_program_.use();
  no_attributes_.bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void MeshRenderer::bind_face_bytes(const Scene& scene, const DrawSettings& settings) {
  if (settings.colour == FaceColour::kDistance) {
    LIMN_EXPECTS(scene.distances->count() == scene.surface->face_count());
    scene.distances->bind();
  } else if (scene.demands != nullptr) {
    LIMN_EXPECTS(scene.demands->count() == scene.surface->face_count());
    scene.demands->bind();
  }
}

void MeshRenderer::draw_surface(const Scene& scene, const DrawSettings& settings) const {
  LIMN_EXPECTS(scene.paint->face_count() == scene.surface->control_face_count());
  surface_program_.use();
  scene.paint->bind();
  if (scene.lit != nullptr) {
    scene.lit->bind_storage(6);
  }
  bind_face_bytes(scene, settings);
  if (!settings.has_faces) {
    glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  }
  scene.surface->draw();
  glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
}

void MeshRenderer::draw_cage(const SurfaceBuffers& cage, const DrawSettings& settings) const {
  edges_program_.set(0, kCageWidth * settings.scale);
  edges_program_.use();
  glDepthFunc(GL_LESS);
  edges_program_.set(1, kHiddenCageStrength);
  cage.draw_edges();
  glDepthFunc(GL_GEQUAL);
  edges_program_.set(1, kVisibleCageStrength);
  cage.draw_edges();
  glDepthFunc(GL_GREATER);
}

void MeshRenderer::draw_creases(const Scene& scene) const {
  creases_program_.use();
  for (const int is_casing : {1, 0}) {
    creases_program_.set(0, is_casing);
    for (const CreaseBuffers* creases : {scene.creases, scene.cage_creases}) {
      if (creases != nullptr) {
        creases->draw();
      }
    }
  }
}

void MeshRenderer::draw_numbers(const Scene& scene, const DrawSettings& settings) const {
  const bool is_listed = scene.numbered != nullptr;
  numbers_program_.set(0, scene.surface->group_count());
  numbers_program_.set(1, is_listed ? 1 : 0);
  numbers_program_.use();
  scene.paint->bind();
  bind_face_bytes(scene, settings);
  digits_.bind_storage(9);
  if (is_listed) {
    scene.numbered->bind();
  }
  const std::size_t count = is_listed ? scene.numbered->count() : scene.surface->face_count();
  scene.surface->draw_vertices(3 * count);
}

void MeshRenderer::draw_markers(const MarkerBuffers& markers) const {
  markers_program_.use();
  digits_.bind_storage(9);
  markers.draw();
}

void MeshRenderer::draw_overlay(const Scene& scene) {
  no_attributes_.bind();
  if (!scene.segments.empty()) {
    std::vector<SegmentRecord> records;
    records.reserve(scene.segments.size());
    for (const OverlaySegment& segment : scene.segments) {
      records.push_back({glm::vec4(segment.from, segment.to),
                         srgb(segment.colour, segment.opacity),
                         segment.width,
                         {}});
    }
    segments_.upload(records);
    segments_.bind_storage(8);
    overlay_program_.use();
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(records.size() * 6));
  }
  if (scene.ring) {
    ring_program_.set(0, glm::vec4(scene.ring->centre, scene.ring->radius, scene.ring->line_width));
    ring_program_.use();
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
}

Result<Image> draw_picture(MeshRenderer& renderer, const Camera& camera, const Scene& scene,
                           const DrawSettings& settings) {
  RenderTarget target;
  try {
    target.resize({camera.size.width, camera.size.height});
  } catch (const EnvironmentError& error) {
    return fail(ErrorKind::kEnvironment, error.what());
  }
  renderer.draw(target, camera, scene, settings);
  return target.read();
}

}  // namespace limn::render
