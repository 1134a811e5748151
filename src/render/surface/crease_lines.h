#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "limn/mesh/control_mesh.h"
#include "limn/mesh/refined_mesh.h"
#include "render/gl/buffer.h"
#include "render/gl/vertex_array.h"

namespace limn::render {

/// A sharp edge, or a sharp vertex where both ends are the same. Coloured and widened by how sharp
/// it is (painting/crease_palette.h).
struct CreaseLine {
  glm::vec3 from{0.0F};  ///< Relative to the surface's origin, as is `to`.
  glm::vec3 to{0.0F};
  float sharpness = 0.0F;  ///< Greater than 0.

  [[nodiscard]] bool operator==(const CreaseLine&) const = default;
};

/// What is sharp about a control mesh, relative to the centre of its bounds: edges, then vertices.
[[nodiscard]] std::vector<CreaseLine> crease_lines(const ControlMesh& mesh);

/// What is still sharp about a refined mesh, relative to `origin`.
[[nodiscard]] std::vector<CreaseLine> crease_lines(const RefinedMesh& mesh,
                                                   const glm::dvec3& origin);

/// Crease lines on the GPU. Upload where they change, never a frame.
class CreaseBuffers {
 public:
  /// Needs a current context.
  CreaseBuffers();

  void upload(std::span<const CreaseLine> lines);
  [[nodiscard]] std::size_t count() const noexcept { return count_; }

  /// Binds slot 8 and draws six vertices a line with the program in use.
  void draw() const;

 private:
  gl::VertexArray no_attributes_;
  gl::Buffer records_;
  std::size_t count_ = 0;
};

}  // namespace limn::render
