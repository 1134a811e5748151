#include "render/surface/crease_lines.h"

#include <algorithm>

#include "limn/contract.h"
#include "limn/painting/crease_palette.h"

namespace limn::render {
namespace {

/// As shaders/creases.vert.glsl reads it.
struct CreaseRecord {
  glm::vec3 from;
  std::uint32_t colour;
  glm::vec3 to;
  float width;
};
static_assert(sizeof(CreaseRecord) == 32);

constexpr float kThinnest = 2.0F;  ///< Units of the interface.
constexpr float kThickest = 3.5F;
constexpr float kDotWidth = 8.0F;

CreaseRecord record_of(const CreaseLine& line) {
  const std::size_t band = sharpness_band(line.sharpness);
  const Rgb colour = crease_palette()[band];
  const float part = static_cast<float>(band) / static_cast<float>(kSharpnessBands - 1);
  const bool is_dot = line.from == line.to;
  return {line.from,
          colour.red | static_cast<std::uint32_t>(colour.green) << 8U |
              static_cast<std::uint32_t>(colour.blue) << 16U,
          line.to, is_dot ? kDotWidth : kThinnest + part * (kThickest - kThinnest)};
}

}  // namespace

std::vector<CreaseLine> crease_lines(const ControlMesh& mesh) {
  const glm::dvec3 origin = mesh.bounds().centre();
  const auto place = [&](std::uint32_t v) { return glm::vec3(mesh.positions()[v] - origin); };
  const Creases& creases = mesh.creases();
  std::vector<CreaseLine> lines;
  for (std::size_t e = 0; e < creases.edge_sharpness.size(); ++e) {
    if (creases.edge_sharpness[e] > 0.0F) {
      const auto [a, b] = mesh.topology().edge_vertices[e];
      lines.push_back({place(a), place(b), creases.edge_sharpness[e]});
    }
  }
  for (std::uint32_t v = 0; v < creases.vertex_sharpness.size(); ++v) {
    if (creases.vertex_sharpness[v] > 0.0F) {
      lines.push_back({place(v), place(v), creases.vertex_sharpness[v]});
    }
  }
  return lines;
}

std::vector<CreaseLine> crease_lines(const RefinedMesh& mesh, const glm::dvec3& origin) {
  const auto place = [&](std::uint32_t v) { return glm::vec3(mesh.position(v) - origin); };
  std::vector<CreaseLine> lines;
  lines.reserve(mesh.creases.size() + mesh.corners.size());
  for (const RefinedCrease& crease : mesh.creases) {
    lines.push_back({place(crease.vertices[0]), place(crease.vertices[1]), crease.sharpness});
  }
  for (const RefinedCorner& corner : mesh.corners) {
    lines.push_back({place(corner.vertex), place(corner.vertex), corner.sharpness});
  }
  return lines;
}

CreaseBuffers::CreaseBuffers()
    : no_attributes_(gl::VertexArray::create("creases")), records_(gl::Buffer::create("creases")) {}

void CreaseBuffers::upload(std::span<const CreaseLine> lines) {
  std::vector<CreaseRecord> records(lines.size());
  std::ranges::transform(lines, records.begin(), record_of);
  records_.upload(records);
  count_ = records.size();
}

void CreaseBuffers::draw() const {
  if (count_ == 0) {
    return;
  }
  records_.bind_storage(8);
  no_attributes_.bind();
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(count_ * 6));
}

}  // namespace limn::render
