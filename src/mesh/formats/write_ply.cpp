// The header tells what follows; then text and binary data differ only in how a number is put down.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/formats/output.h"
#include "mesh/formats/writers.h"

namespace limn::detail {
namespace {

/// Puts numbers down in the order of the header.
class PlyOutput {
 public:
  PlyOutput(Output& out, bool is_text) : out_(out), is_text_(is_text) {}

  template <class T>
  void put(T value) {
    if (!is_text_) {
      out_.binary(value);
    } else if (is_first_) {
      out_.bare_number(value);
      is_first_ = false;
    } else {
      out_.number(value);
    }
  }
  /// A float or double, as announced.
  void put_real(double value, bool is_float) {
    is_float ? put(static_cast<float>(value)) : put(value);
  }
  /// The length of a list, as announced.
  void put_length(std::size_t length, bool is_byte) {
    is_byte ? put(static_cast<std::uint8_t>(length)) : put(static_cast<std::uint32_t>(length));
  }
  void end_element() {
    if (is_text_) {
      out_.end_line();
    }
    is_first_ = true;
  }

 private:
  Output& out_;
  bool is_text_;
  bool is_first_ = true;
};

class PlyWriter {
 public:
  PlyWriter(Output& out, const MeshView& mesh, bool is_text)
      : out_(out), mesh_(mesh), is_text_(is_text), vertex_uvs_(mesh.vertex_uvs()) {
    has_wedges_ = mesh.has_uvs() && !vertex_uvs_;
    std::size_t most_sides = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      most_sides = std::max(most_sides, mesh.face(f).size());
    }
    constexpr std::size_t byte = 255;
    is_byte_ = most_sides <= byte;
    are_wedges_byte_ = 2 * most_sides <= byte;
  }
  void write() {
    write_header();
    PlyOutput numbers(out_, is_text_);
    write_vertices(numbers);
    write_faces(numbers);
    write_edges(numbers);
  }

 private:
  template <class... Words>
  void line(const Words&... words) {
    (out_.text(words), ...);
    out_.end_line();
  }
  void element(std::string_view name, std::size_t count) {
    out_.text("element ");
    out_.text(name);
    out_.number(count);
    out_.end_line();
  }
  void write_header();
  void write_vertices(PlyOutput& numbers);
  void write_faces(PlyOutput& numbers);
  void write_edges(PlyOutput& numbers);

  Output& out_;
  const MeshView& mesh_;
  bool is_text_;
  std::optional<std::vector<std::uint32_t>> vertex_uvs_;
  bool has_wedges_ = false;
  bool is_byte_ = false;
  bool are_wedges_byte_ = false;
};

void PlyWriter::write_header() {
  const std::string_view real = mesh_.are_floats() ? "float " : "double ";
  const std::string_view uv_real = mesh_.are_uvs_floats() ? "float " : "double ";
  line("ply\nformat ", is_text_ ? "ascii" : "binary_little_endian", " 1.0");
  if (mesh_.creasing() == CreasingMethod::kChaikin) {
    line("obj_info limn_creasing chaikin");
  }
  if (mesh_.corner_rule()) {
    line("obj_info limn_corners ", mesh_.corner_rule() == CornerRule::kSharp ? "sharp" : "smooth");
  }
  element("vertex", mesh_.vertex_count() + mesh_.loose_vertices().size());
  for (const std::string_view axis : {"x", "y", "z"}) {
    line("property ", real, axis);
  }
  if (!mesh_.normals().empty()) {
    line("property float nx\nproperty float ny\nproperty float nz");
  }
  if (vertex_uvs_) {
    line("property ", uv_real, "s\nproperty ", uv_real, "t");
  }
  if (!mesh_.corners().empty()) {
    line("property float limn_sharpness");
  }
  element("face", mesh_.face_count());
  line("property list ", is_byte_ ? "uchar" : "uint", " int vertex_indices");
  if (has_wedges_) {
    line("property list ", are_wedges_byte_ ? "uchar " : "uint ", uv_real, "texcoord");
  }
  if (mesh_.has_depths()) {
    line("property uchar limn_depth");
  }
  if (!mesh_.creases().empty()) {
    element("edge", mesh_.creases().size());
    line("property int vertex1\nproperty int vertex2\nproperty float limn_sharpness");
  }
  line("end_header");
}

void PlyWriter::write_vertices(PlyOutput& numbers) {
  std::vector<float> sharpness(mesh_.corners().empty() ? 0 : mesh_.vertex_count(), 0.0f);
  for (const CornerTag& corner : mesh_.corners()) {
    sharpness[corner.vertex] = corner.sharpness;
  }
  const auto put_position = [&](const glm::dvec3& p) {
    for (int i = 0; i < 3; ++i) {
      numbers.put_real(p[i], mesh_.are_floats());
    }
  };
  const auto put_normal = [&](const glm::vec3& n) {
    for (int i = 0; i < 3; ++i) {
      numbers.put(n[i]);
    }
  };
  for (std::size_t v = 0; v < mesh_.vertex_count(); ++v) {
    put_position(mesh_.position(v));
    if (!mesh_.normals().empty()) {
      put_normal(mesh_.normals()[v]);
    }
    if (vertex_uvs_) {
      const glm::dvec2 uv = mesh_.uv((*vertex_uvs_)[v]);
      numbers.put_real(uv.x, mesh_.are_uvs_floats());
      numbers.put_real(uv.y, mesh_.are_uvs_floats());
    }
    if (!sharpness.empty()) {
      numbers.put(sharpness[v]);
    }
    numbers.end_element();
  }
  // Loose vertices have no texture coordinates, so neither has any vertex then.
  for (const glm::dvec3& p : mesh_.loose_vertices()) {
    put_position(p);
    if (!mesh_.normals().empty()) {
      put_normal(glm::vec3(0.0f));
    }
    if (!sharpness.empty()) {
      numbers.put(0.0f);
    }
    numbers.end_element();
  }
}

void PlyWriter::write_faces(PlyOutput& numbers) {
  for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
    const auto vertices = mesh_.face(f);
    numbers.put_length(vertices.size(), is_byte_);
    for (const std::uint32_t v : vertices) {
      numbers.put(static_cast<std::int32_t>(v));
    }
    if (has_wedges_) {
      numbers.put_length(2 * vertices.size(), are_wedges_byte_);
      for (const std::uint32_t point : mesh_.face_uvs(f)) {
        const glm::dvec2 uv = mesh_.uv(point);
        numbers.put_real(uv.x, mesh_.are_uvs_floats());
        numbers.put_real(uv.y, mesh_.are_uvs_floats());
      }
    }
    if (mesh_.has_depths()) {
      numbers.put(static_cast<std::uint8_t>(mesh_.depth(f)));
    }
    numbers.end_element();
  }
}

void PlyWriter::write_edges(PlyOutput& numbers) {
  for (const CreaseTag& crease : mesh_.creases()) {
    numbers.put(static_cast<std::int32_t>(crease.vertices[0]));
    numbers.put(static_cast<std::int32_t>(crease.vertices[1]));
    numbers.put(crease.sharpness);
    numbers.end_element();
  }
}

}  // namespace

void write_ply(std::ostream& stream, const MeshView& mesh, bool is_text) {
  Output out(stream);
  PlyWriter(out, mesh, is_text).write();
}

}  // namespace limn::detail
