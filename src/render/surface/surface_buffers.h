#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "limn/error.h"
#include "render/gl/buffer.h"
#include "render/gl/vertex_array.h"
#include "render/surface/surface.h"

namespace limn::render {

/// What a surface that is made on the GPU will hold. Groups as in a Surface.
struct SurfaceShape {
  glm::dvec3 origin{0.0};
  std::size_t vertex_count = 0;
  std::span<const SurfaceGroup> groups;
  std::size_t control_face_count = 0;
  bool has_normals = false;
};

/// Where its contents go, laid out as shaders/surface.glsl reads them: positions and normals three
/// floats a vertex, corners face by face, and for each face its control face | level << 28.
struct SurfaceContents {
  gl::Buffer* positions = nullptr;
  gl::Buffer* normals = nullptr;
  gl::Buffer* corners = nullptr;
  gl::Buffer* faces = nullptr;
};

/// A Surface on the GPU, drawn by vertex pulling: positions, normals, corners, group records and
/// face records lie in storage buffers, and one multi-draw command covers all groups. The shader
/// finds its group by gl_DrawIDARB and its face and corner by gl_VertexID (shaders/surface.glsl),
/// so nothing is duplicated and nothing is drawn face by face.
class SurfaceBuffers {
 public:
  /// Makes the (empty) buffers; needs a current context.
  SurfaceBuffers();

  /// Replaces the contents and remembers `revision`, a number of the caller's choosing that is
  /// never 0. Errors: kEnvironment where an array is larger than this driver lets shaders see; the
  /// old contents stay.
  [[nodiscard]] Result<void> upload(const Surface& surface, std::uint64_t revision);
  /// Makes room for a surface that the caller then writes on the GPU, by shaders or otherwise;
  /// until that is done contents are undefined. Counts as an upload. Without normals it cannot be
  /// shaded smoothly. Errors: those of `upload`.
  [[nodiscard]] Result<SurfaceContents> prepare(const SurfaceShape& shape, std::uint64_t revision);
  /// Whether the last upload was of this revision.
  [[nodiscard]] bool has(std::uint64_t revision) const noexcept { return revision_ == revision; }

  /// A number that no other upload of this program has, of whatever buffers; 0 before the first.
  /// Who derives something from the contents knows by it when to do so again.
  [[nodiscard]] std::uint64_t upload_id() const noexcept { return upload_id_; }

  /// Binds slots 0-3 and 5 of surface.glsl and draws all faces with the program in use.
  void draw() const;
  /// Binds slots 0 and 8 and draws all edges of a control surface, six vertices each, for shaders
  /// that widen lines (edges.vert.glsl).
  void draw_edges() const;

  /// Binds slots 0-3 of surface.glsl for a program that looks faces up by their number, and draws
  /// so many vertices with it.
  void draw_vertices(std::size_t count) const;
  [[nodiscard]] int group_count() const noexcept { return group_count_; }

  /// Binds slot 3 of surface.glsl alone: which control face each drawn face lies in.
  void bind_face_records() const { faces_.bind_storage(3); }
  /// The same on the CPU, one entry for each drawn face; empty where the surface was made on the
  /// GPU (`prepare`).
  [[nodiscard]] std::span<const std::uint32_t> face_control_faces() const noexcept {
    return face_control_faces_;
  }
  [[nodiscard]] const gl::Buffer& positions() const noexcept { return positions_; }
  [[nodiscard]] const gl::Buffer& normals() const noexcept { return normals_; }
  [[nodiscard]] const gl::Buffer& corners() const noexcept { return corners_; }
  [[nodiscard]] const gl::Buffer& faces() const noexcept { return faces_; }

  /// What positions are relative to; see clip_from_local.
  [[nodiscard]] const glm::dvec3& origin() const noexcept { return origin_; }
  [[nodiscard]] std::size_t face_count() const noexcept { return face_count_; }
  [[nodiscard]] std::size_t edge_count() const noexcept { return edge_count_; }
  [[nodiscard]] std::size_t control_face_count() const noexcept { return control_face_count_; }

 private:
  void set_groups(std::span<const SurfaceGroup> groups);

  gl::VertexArray no_attributes_;
  gl::Buffer positions_;
  gl::Buffer normals_;
  gl::Buffer corners_;
  gl::Buffer groups_;
  gl::Buffer faces_;
  gl::Buffer edges_;
  gl::Buffer commands_;
  std::vector<std::uint32_t> face_control_faces_;
  int group_count_ = 0;
  glm::dvec3 origin_{0.0};
  std::size_t face_count_ = 0;
  std::size_t edge_count_ = 0;
  std::size_t control_face_count_ = 0;
  std::uint64_t revision_ = 0;
  std::uint64_t upload_id_ = 0;
};

}  // namespace limn::render
