// The layouts here are those of shaders/surface.glsl.
#include "render/surface/surface_buffers.h"

#include <algorithm>
#include <atomic>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "limn/contract.h"

namespace limn::render {
namespace {

struct GroupRecord {
  std::uint32_t sides;
  std::uint32_t first_face;
  std::uint32_t first_corner;
  std::uint32_t triangles;  ///< Per face.
};

/// DrawArraysIndirectCommand of the OpenGL specification.
struct DrawCommand {
  std::uint32_t count;
  std::uint32_t instance_count;
  std::uint32_t first;
  std::uint32_t base_instance;
};

// std430 packs arrays of float as tightly as C++ does, so a vec3 is three floats there.
static_assert(sizeof(glm::vec3) == 12);

constexpr std::uint32_t kLevelShift = 28;

std::uint64_t next_upload_id() {
  static std::atomic<std::uint64_t> last = 0;
  return ++last;
}

Result<void> require_room(std::size_t bytes, const char* what) {
  GLint64 most = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
  if (bytes > static_cast<std::size_t>(most)) {
    return fail(ErrorKind::kEnvironment,
                fmt::format("The mesh is too large to be shown by this graphics driver: its {} "
                            "take {} MB, and the driver allows {} MB.",
                            what, bytes >> 20U, most >> 20U));
  }
  return {};
}

}  // namespace

SurfaceBuffers::SurfaceBuffers()
    : no_attributes_(gl::VertexArray::create("surface")),
      positions_(gl::Buffer::create("surface positions")),
      normals_(gl::Buffer::create("surface normals")),
      corners_(gl::Buffer::create("surface corners")),
      groups_(gl::Buffer::create("surface groups")),
      faces_(gl::Buffer::create("surface faces")),
      edges_(gl::Buffer::create("surface edges")),
      commands_(gl::Buffer::create("surface draw commands")) {}

Result<void> SurfaceBuffers::upload(const Surface& surface, std::uint64_t revision) {
  LIMN_EXPECTS(revision != 0);
  LIMN_EXPECTS(surface.control_face_count <= (std::size_t{1} << kLevelShift));
  for (const auto& [bytes, what] :
       {std::pair(surface.positions.size() * sizeof(glm::vec3), "vertices"),
        std::pair(surface.corners.size() * sizeof(std::uint32_t), "faces")}) {
    if (Result<void> room = require_room(bytes, what); !room) {
      return room;
    }
  }

  std::vector<std::uint32_t> faces(surface.face_count());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    LIMN_ASSERT(surface.face_levels[f] < 16);
    faces[f] = surface.face_control_faces[f] | static_cast<std::uint32_t>(surface.face_levels[f])
                                                   << kLevelShift;
  }

  positions_.upload(surface.positions);
  normals_.upload(surface.normals);
  corners_.upload(surface.corners);
  faces_.upload(faces);
  edges_.upload(surface.edges);
  set_groups(surface.groups);
  face_control_faces_ = surface.face_control_faces;
  origin_ = surface.origin;
  face_count_ = surface.face_count();
  edge_count_ = surface.edges.size();
  control_face_count_ = surface.control_face_count;
  revision_ = revision;
  upload_id_ = next_upload_id();
  return {};
}

Result<SurfaceContents> SurfaceBuffers::prepare(const SurfaceShape& shape, std::uint64_t revision) {
  LIMN_EXPECTS(revision != 0);
  LIMN_EXPECTS(shape.control_face_count <= (std::size_t{1} << kLevelShift));
  std::size_t faces = 0;
  std::size_t corners = 0;
  for (const SurfaceGroup& group : shape.groups) {
    faces += group.face_count;
    corners += std::size_t{group.face_count} * group.sides;
  }
  const std::size_t vertex_bytes = shape.vertex_count * sizeof(glm::vec3);
  const std::size_t corner_bytes = corners * sizeof(std::uint32_t);
  for (const auto& [bytes, what] :
       {std::pair(vertex_bytes, "vertices"), std::pair(corner_bytes, "faces")}) {
    if (Result<void> room = require_room(bytes, what); !room) {
      return tl::unexpected(std::move(room.error()));
    }
  }
  positions_.resize(vertex_bytes);
  normals_.resize(shape.has_normals ? vertex_bytes : 0);
  corners_.resize(corner_bytes);
  faces_.resize(faces * sizeof(std::uint32_t));
  edges_.resize(0);
  set_groups(shape.groups);
  face_control_faces_.clear();
  origin_ = shape.origin;
  face_count_ = faces;
  edge_count_ = 0;
  control_face_count_ = shape.control_face_count;
  revision_ = revision;
  upload_id_ = next_upload_id();
  return SurfaceContents{&positions_, &normals_, &corners_, &faces_};
}

void SurfaceBuffers::set_groups(std::span<const SurfaceGroup> groups) {
  std::vector<GroupRecord> records;
  std::vector<DrawCommand> commands;
  for (const SurfaceGroup& group : groups) {
    const std::uint32_t triangles = group.sides - 2;
    records.push_back({group.sides, group.first_face, group.first_corner, triangles});
    commands.push_back({group.face_count * triangles * 3, 1, 0, 0});
  }
  groups_.upload(records);
  commands_.upload(commands);
  group_count_ = static_cast<int>(commands.size());
}

void SurfaceBuffers::draw() const {
  if (group_count_ == 0) {
    return;
  }
  positions_.bind_storage(0);
  corners_.bind_storage(1);
  groups_.bind_storage(2);
  faces_.bind_storage(3);
  normals_.bind_storage(5);
  no_attributes_.bind();
  commands_.bind_draw_indirect();
  glMultiDrawArraysIndirect(GL_TRIANGLES, nullptr, group_count_, 0);
}

void SurfaceBuffers::draw_vertices(std::size_t count) const {
  if (group_count_ == 0 || count == 0) {
    return;
  }
  positions_.bind_storage(0);
  corners_.bind_storage(1);
  groups_.bind_storage(2);
  faces_.bind_storage(3);
  no_attributes_.bind();
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(count));
}

void SurfaceBuffers::draw_edges() const {
  if (edge_count_ == 0) {
    return;
  }
  positions_.bind_storage(0);
  edges_.bind_storage(8);
  no_attributes_.bind();
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(edge_count_ * 6));
}

}  // namespace limn::render
