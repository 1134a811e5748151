// Text is gathered in a buffer that is handed to the stream a megabyte at a time: fmt's numbers are
// the shortest that read back to the same bits, and iostreams never see a number.
#include "limn/mesh/export.h"

#include <array>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "limn/contract.h"
#include "limn/files/atomic_file.h"

namespace limn {
namespace {

/// A stream's buffered text.
class TextWriter {
 public:
  explicit TextWriter(std::ostream& out) : out_(out) {}

  template <class... Args>
  void print(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<Args>(args)...);
    if (buffer_.size() >= flush_size) {
      flush();
    }
  }
  void flush() {
    out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    buffer_.clear();
  }

 private:
  static constexpr std::size_t flush_size = std::size_t{1} << 20U;
  std::ostream& out_;
  fmt::memory_buffer buffer_;
};

/// A vec3 or dvec3: the shortest digits that tell the number apart from others of its kind.
template <class Position>
void write_position(TextWriter& text, const Position& p) {
  text.print("v {} {} {}\n", p.x, p.y, p.z);
}

template <class Uv>
void write_uv(TextWriter& text, const Uv& uv) {
  text.print("vt {} {}\n", uv.x, uv.y);
}

/// One-based, wide enough for the last 32-bit number.
std::uint64_t obj_index(std::uint32_t i) {
  return i + std::uint64_t{1};
}

/// A face's corners: vertices, and for each the texture point, where there are any; a vertex's
/// normal has its number.
struct FaceCorners {
  std::span<const std::uint32_t> vertices;
  std::span<const std::uint32_t> uvs;
  bool has_normals = false;
};

void write_face(TextWriter& text, const FaceCorners& corners) {
  text.print("f");
  for (std::size_t i = 0; i < corners.vertices.size(); ++i) {
    const std::uint64_t v = obj_index(corners.vertices[i]);
    if (corners.uvs.empty()) {
      corners.has_normals ? text.print(" {}//{}", v, v) : text.print(" {}", v);
    } else {
      const std::uint64_t uv = obj_index(corners.uvs[i]);
      corners.has_normals ? text.print(" {}/{}/{}", v, uv, v) : text.print(" {}/{}", v, uv);
    }
  }
  text.print("\n");
}

FaceCorners corners_of(const ControlMesh& mesh, std::size_t f) {
  FaceCorners corners{mesh.face(f), {}, false};
  if (!mesh.texture().empty()) {
    corners.uvs = std::span(mesh.texture().corner_values)
                      .subspan(mesh.topology().face_offsets[f], corners.vertices.size());
  }
  return corners;
}

FaceCorners corners_of(const RefinedMesh& mesh, std::size_t f) {
  FaceCorners corners{mesh.face(f), {}, !mesh.normals.empty()};
  if (f < mesh.quad_uvs.size()) {
    corners.uvs = mesh.quad_uvs[f];
  } else if (!mesh.polygon_uvs.empty()) {
    corners.uvs =
        std::span(mesh.polygon_uvs)
            .subspan(mesh.polygon_offsets[f - mesh.quads.size()], corners.vertices.size());
  }
  return corners;
}

/// Faces keep their order, so that a group statement stands wherever the depth changes.
template <class Mesh, class DepthOf>
void write_faces(TextWriter& text, const Mesh& mesh, bool has_depths, const DepthOf& depth_of) {
  int current = -1;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (has_depths && depth_of(f) != current) {
      current = depth_of(f);
      text.print("usemtl depth_{}\n", current);
    }
    write_face(text, corners_of(mesh, f));
  }
}

// Vertices of tags count from 0.

void write_crease(TextWriter& text, const std::array<std::uint32_t, 2>& ends, float sharpness) {
  text.print("t crease 2/1/0 {} {} {}\n", ends[0], ends[1], sharpness);
}

void write_corner(TextWriter& text, std::size_t vertex, float sharpness) {
  text.print("t corner 1/1/0 {} {}\n", vertex, sharpness);
}

void write_rules(TextWriter& text, std::optional<CornerRule> corners, CreasingMethod creasing) {
  if (corners) {
    text.print("t interpolateboundary 1/0/0 {}\n", *corners == CornerRule::kSharp ? 1 : 2);
  }
  if (creasing == CreasingMethod::kChaikin) {
    text.print("t creasemethod 0/0/1 chaikin\n");
  }
}

void write_tags(TextWriter& text, const ControlMesh& mesh) {
  const Creases& creases = mesh.creases();
  for (std::size_t e = 0; e < creases.edge_sharpness.size(); ++e) {
    if (creases.edge_sharpness[e] > 0.0f) {
      write_crease(text, mesh.topology().edge_vertices[e], creases.edge_sharpness[e]);
    }
  }
  for (std::size_t v = 0; v < creases.vertex_sharpness.size(); ++v) {
    if (creases.vertex_sharpness[v] > 0.0f) {
      write_corner(text, v, creases.vertex_sharpness[v]);
    }
  }
  write_rules(text, mesh.attributes().corners, creases.method);
}

void write_tags(TextWriter& text, const RefinedMesh& mesh) {
  for (const RefinedCrease& crease : mesh.creases) {
    write_crease(text, crease.vertices, crease.sharpness);
  }
  for (const RefinedCorner& corner : mesh.corners) {
    write_corner(text, corner.vertex, corner.sharpness);
  }
  write_rules(text, mesh.corner_rule, mesh.creasing);
}

template <class Mesh>
Result<void> export_to(const std::filesystem::path& path, const Mesh& mesh,
                       std::span<const std::uint8_t> depths) {
  return write_file_atomically(path, [&](std::ostream& out) { write_obj(out, mesh, depths); });
}

}  // namespace

void write_obj(std::ostream& out, const RefinedMesh& mesh, std::span<const std::uint8_t> depths) {
  TextWriter text(out);
  const bool are_world_positions = mesh.origin == glm::dvec3(0.0);
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    if (are_world_positions) {
      write_position(text, mesh.positions[v]);
    } else {
      write_position(text, mesh.position(v));
    }
  }
  for (const glm::vec2& uv : mesh.uvs) {
    write_uv(text, uv);
  }
  for (const glm::vec3& normal : mesh.normals) {
    text.print("vn {} {} {}\n", normal.x, normal.y, normal.z);
  }
  write_faces(text, mesh, !depths.empty(), [&](std::size_t f) {
    const std::uint32_t control_face = mesh.face_control_faces[f];
    LIMN_EXPECTS(control_face < depths.size());
    return static_cast<int>(depths[control_face]);
  });
  write_tags(text, mesh);
  text.flush();
}

void write_obj(std::ostream& out, const ControlMesh& mesh, std::span<const std::uint8_t> depths) {
  LIMN_EXPECTS(depths.empty() || depths.size() == mesh.face_count());
  TextWriter text(out);
  for (const glm::dvec3& position : mesh.positions()) {
    write_position(text, position);
  }
  if (!mesh.texture().empty()) {
    for (const glm::dvec2& uv : mesh.texture().values) {
      write_uv(text, uv);
    }
  }
  write_faces(text, mesh, !depths.empty(),
              [&](std::size_t f) { return static_cast<int>(depths[f]); });
  write_tags(text, mesh);
  text.flush();
}

Result<void> export_obj(const std::filesystem::path& path, const RefinedMesh& mesh,
                        std::span<const std::uint8_t> depths) {
  return export_to(path, mesh, depths);
}

Result<void> export_obj(const std::filesystem::path& path, const ControlMesh& mesh,
                        std::span<const std::uint8_t> depths) {
  return export_to(path, mesh, depths);
}

}  // namespace limn
