// Text is gathered in a buffer that is handed to the stream a megabyte at a time: fmt's numbers are
// the shortest that read back to the same bits, and iostreams never see a number.
#include "limn/mesh/export.h"

#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "limn/atomic_file.h"
#include "limn/contract.h"

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

void write_face(TextWriter& text, std::span<const std::uint32_t> vertices) {
  text.print("f");
  for (const std::uint32_t v : vertices) {
    text.print(" {}", v + std::uint64_t{1});
  }
  text.print("\n");
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
    write_face(text, mesh.face(f));
  }
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
  write_faces(text, mesh, !depths.empty(), [&](std::size_t f) {
    const std::uint32_t control_face = mesh.face_control_faces[f];
    LIMN_EXPECTS(control_face < depths.size());
    return static_cast<int>(depths[control_face]);
  });
  text.flush();
}

void write_obj(std::ostream& out, const ControlMesh& mesh, std::span<const std::uint8_t> depths) {
  LIMN_EXPECTS(depths.empty() || depths.size() == mesh.face_count());
  TextWriter text(out);
  for (const glm::dvec3& position : mesh.positions()) {
    write_position(text, position);
  }
  write_faces(text, mesh, !depths.empty(),
              [&](std::size_t f) { return static_cast<int>(depths[f]); });
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
