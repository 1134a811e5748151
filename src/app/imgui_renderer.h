#pragma once

#include <cstdint>
#include <optional>

#include "render/gl/buffer.h"
#include "render/gl/shader_program.h"
#include "render/gl/texture.h"
#include "render/gl/vertex_array.h"

struct ImDrawData;
struct ImFontAtlas;

namespace limn::app {

/// Draws what Dear ImGui made of a frame through our own OpenGL layer, in any of our contexts.
///
/// The only texture is the font atlas: text, lines and fills all come from it. Vertex offsets are
/// heeded, so the context may have ImGuiBackendFlags_RendererHasVtxOffset.
class ImguiRenderer {
 public:
  /// Needs a current context. Throws render::EnvironmentError where the shaders do not compile.
  ImguiRenderer();

  /// Uploads the atlas where `revision` is not the one uploaded last, and tells the atlas which
  /// texture it is.
  void set_atlas(ImFontAtlas& atlas, std::uint64_t revision);

  /// Draws over what the current framebuffer holds: `DisplaySize` window units, scaled by
  /// `FramebufferScale` to pixels. Leaves blending and scissoring off.
  void draw(const ImDrawData& data);

 private:
  void upload(const ImDrawData& data);

  render::gl::ShaderProgram program_;
  render::gl::VertexArray vertex_array_;
  render::gl::Buffer vertices_;
  render::gl::Buffer indices_;
  render::gl::Texture atlas_;
  std::optional<std::uint64_t> atlas_revision_;
};

}  // namespace limn::app
