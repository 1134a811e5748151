// All lists of a frame go up as one vertex and one index buffer; each command is then one draw with
// its scissor rectangle, its first index and its base vertex, so that 16-bit indices reach more
// than 65,536 vertices.
#include "app/imgui_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include <imgui.h>
#include <glm/vec4.hpp>

#include "embedded/interface_shaders.h"
#include "limn/contract.h"

namespace limn::app {
namespace {

namespace gl = render::gl;

constexpr GLenum kIndexType = sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
constexpr GLint kScaleOffset = 0;

gl::ShaderStage stage(GLenum type, std::string_view name) {
  for (const auto& file : interface_shaders::files()) {
    if (file.name == name) {
      return {type, std::string(name), std::string(file.text)};
    }
  }
  LIMN_EXPECTS(false && "the shader is not embedded");
  return {};
}

gl::VertexArray make_vertex_array() {
  auto array = gl::VertexArray::create("interface");
  array.add_attribute({0, 2, GL_FLOAT, false, offsetof(ImDrawVert, pos)});
  array.add_attribute({1, 2, GL_FLOAT, false, offsetof(ImDrawVert, uv)});
  array.add_attribute({2, 4, GL_UNSIGNED_BYTE, true, offsetof(ImDrawVert, col)});
  return array;
}

/// A command's clip rectangle in pixels, origin lower left; empty where nothing of it shows.
struct Scissor {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

Scissor scissor_of(const ImDrawData& data, const ImVec4& clip) {
  const auto pixel = [](float value, float limit) {
    return static_cast<int>(std::lround(std::clamp(value, 0.0F, limit)));
  };
  const float width = data.DisplaySize.x * data.FramebufferScale.x;
  const float height = data.DisplaySize.y * data.FramebufferScale.y;
  const int left = pixel((clip.x - data.DisplayPos.x) * data.FramebufferScale.x, width);
  const int top = pixel((clip.y - data.DisplayPos.y) * data.FramebufferScale.y, height);
  const int right = pixel((clip.z - data.DisplayPos.x) * data.FramebufferScale.x, width);
  const int bottom = pixel((clip.w - data.DisplayPos.y) * data.FramebufferScale.y, height);
  return {left, static_cast<int>(std::lround(height)) - bottom, right - left, bottom - top};
}

void draw_list(const ImDrawData& data, const ImDrawList& list, std::size_t first_vertex,
               std::size_t first_index) {
  for (const ImDrawCmd& command : list.CmdBuffer) {
    if (command.UserCallback != nullptr) {
      if (command.UserCallback != ImDrawCallback_ResetRenderState) {
        command.UserCallback(&list, &command);
      }
      continue;
    }
    const Scissor scissor = scissor_of(data, command.ClipRect);
    if (scissor.width <= 0 || scissor.height <= 0) {
      continue;
    }
    glScissor(scissor.x, scissor.y, scissor.width, scissor.height);
    const std::size_t offset = (first_index + command.IdxOffset) * sizeof(ImDrawIdx);
    glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), kIndexType,
                             reinterpret_cast<const void*>(offset),
                             static_cast<GLint>(first_vertex + command.VtxOffset));
  }
}

}  // namespace

ImguiRenderer::ImguiRenderer()
    : program_(gl::ShaderProgram::link(
          "interface", std::array{stage(GL_VERTEX_SHADER, "interface.vert.glsl"),
                                  stage(GL_FRAGMENT_SHADER, "interface.frag.glsl")})),
      vertex_array_(make_vertex_array()),
      vertices_(gl::Buffer::create("interface vertices")),
      indices_(gl::Buffer::create("interface indices")) {}

void ImguiRenderer::set_atlas(ImFontAtlas& atlas, std::uint64_t revision) {
  if (atlas_revision_ == revision) {
    return;
  }
  unsigned char* texels = nullptr;
  int width = 0;
  int height = 0;
  atlas.GetTexDataAsAlpha8(&texels, &width, &height);
  atlas_ = gl::Texture::create_2d({width, height}, GL_R8, "font atlas");
  atlas_.set_linear_filter();
  const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  atlas_.upload(GL_RED, GL_UNSIGNED_BYTE, std::as_bytes(std::span(texels, count)));
  atlas.SetTexID(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(atlas_.id())));
  atlas_revision_ = revision;
}

void ImguiRenderer::upload(const ImDrawData& data) {
  vertices_.resize(static_cast<std::size_t>(data.TotalVtxCount) * sizeof(ImDrawVert));
  indices_.resize(static_cast<std::size_t>(data.TotalIdxCount) * sizeof(ImDrawIdx));
  std::size_t vertex_bytes = 0;
  std::size_t index_bytes = 0;
  for (const ImDrawList* list :
       std::span(data.CmdLists, static_cast<std::size_t>(data.CmdListsCount))) {
    const std::span vertices(list->VtxBuffer.Data, static_cast<std::size_t>(list->VtxBuffer.Size));
    const std::span indices(list->IdxBuffer.Data, static_cast<std::size_t>(list->IdxBuffer.Size));
    vertices_.write(vertex_bytes, std::span<const ImDrawVert>(vertices));
    indices_.write(index_bytes, std::span<const ImDrawIdx>(indices));
    vertex_bytes += vertices.size_bytes();
    index_bytes += indices.size_bytes();
  }
  // Growing may have moved them to other objects.
  vertex_array_.set_vertex_buffer(vertices_, sizeof(ImDrawVert));
  vertex_array_.set_index_buffer(indices_);
}

void ImguiRenderer::draw(const ImDrawData& data) {
  const float width = data.DisplaySize.x * data.FramebufferScale.x;
  const float height = data.DisplaySize.y * data.FramebufferScale.y;
  if (width < 1.0F || height < 1.0F || data.TotalVtxCount == 0) {
    return;
  }
  LIMN_EXPECTS(atlas_);
  upload(data);

  glViewport(0, 0, static_cast<GLsizei>(std::lround(width)),
             static_cast<GLsizei>(std::lround(height)));
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glEnable(GL_SCISSOR_TEST);
  program_.use();
  program_.set(kScaleOffset, glm::vec4(2.0F / data.DisplaySize.x, -2.0F / data.DisplaySize.y,
                                       -1.0F - data.DisplayPos.x * 2.0F / data.DisplaySize.x,
                                       1.0F + data.DisplayPos.y * 2.0F / data.DisplaySize.y));
  atlas_.bind(0);
  vertex_array_.bind();

  std::size_t first_vertex = 0;
  std::size_t first_index = 0;
  for (const ImDrawList* list :
       std::span(data.CmdLists, static_cast<std::size_t>(data.CmdListsCount))) {
    draw_list(data, *list, first_vertex, first_index);
    first_vertex += static_cast<std::size_t>(list->VtxBuffer.Size);
    first_index += static_cast<std::size_t>(list->IdxBuffer.Size);
  }
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
}

}  // namespace limn::app
