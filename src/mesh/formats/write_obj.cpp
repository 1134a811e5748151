// Faces keep their order, so a statement stands wherever a name or depth changes.
#include <array>
#include <string>

#include "mesh/formats/depth_material.h"
#include "mesh/formats/output.h"
#include "mesh/formats/text_cursor.h"
#include "mesh/formats/writers.h"

namespace limn::detail {
namespace {

/// One-based, wide enough for the last 32-bit number.
std::uint64_t obj_index(std::uint32_t i) {
  return i + std::uint64_t{1};
}

/// A name in such a form that it is read as it is written: words with single blanks between them,
/// none of which looks like a comment, the end of a line or binary data. All other bytes stay.
std::string obj_name(std::string_view name) {
  std::string written;
  for (const char c : name) {
    const bool is_space = is_blank(c) || c == '\n' || c == '\r';
    const bool begins_word = written.empty() || written.back() == ' ';
    if (is_space && begins_word) {
      continue;
    }
    written += is_space ? ' ' : c == '\0' || (c == '#' && begins_word) ? '_' : c;
  }
  while (written.ends_with(' ')) {
    written.pop_back();
  }
  // A backslash at the end of the line would go on with the next one.
  if (written.ends_with('\\')) {
    written += " #";
  }
  return written;
}

/// One kind of names, written where it changes.
class NameStatement {
 public:
  NameStatement(std::string_view keyword, const FaceNames& names) : keyword_(keyword) {
    for (const std::string& name : names.names) {
      names_.push_back(obj_name(name));
    }
    of_faces_ = names.of_faces;
  }
  void write(Output& out, std::uint32_t face) {
    const std::uint32_t name = of_faces_.empty() ? kNone : of_faces_[face];
    if (name == current_) {
      return;
    }
    current_ = name;
    out.text(keyword_);
    if (name != kNone) {
      out.text(" ");
      out.text(names_[name]);
    }
    out.end_line();
  }

 private:
  std::string_view keyword_;
  std::vector<std::string> names_;
  std::span<const std::uint32_t> of_faces_;
  std::uint32_t current_ = kNone;
};

void write_vertices(Output& out, const MeshView& mesh) {
  const auto write = [&out](const auto& p) {
    out.text("v");
    out.number(p.x);
    out.number(p.y);
    out.number(p.z);
    out.end_line();
  };
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    // Refined positions are floats, and are read back as such by whoever wants floats.
    mesh.is_single_precision() ? write(glm::vec3(mesh.position(v))) : write(mesh.position(v));
  }
  for (const glm::dvec3& p : mesh.loose_vertices()) {
    write(p);
  }
}

void write_uvs(Output& out, const MeshView& mesh) {
  for (std::size_t i = 0; mesh.has_uvs() && i < mesh.uv_count(); ++i) {
    const glm::dvec2 uv = mesh.uv(i);
    out.text("vt");
    if (mesh.is_refined()) {
      out.number(static_cast<float>(uv.x));
      out.number(static_cast<float>(uv.y));
    } else {
      out.number(uv.x);
      out.number(uv.y);
    }
    out.end_line();
  }
}

void write_normals(Output& out, const MeshView& mesh) {
  for (const glm::vec3& normal : mesh.normals()) {
    out.text("vn");
    out.number(normal.x);
    out.number(normal.y);
    out.number(normal.z);
    out.end_line();
  }
}

/// A vertex's normal has its number.
void write_face(Output& out, const MeshView& mesh, std::size_t f) {
  const auto vertices = mesh.face(f);
  const auto uvs = mesh.face_uvs(f);
  const bool has_normals = !mesh.normals().empty();
  out.text("f");
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::uint64_t v = obj_index(vertices[i]);
    out.number(v);
    if (!uvs.empty()) {
      out.text("/");
      out.bare_number(obj_index(uvs[i]));
    }
    if (has_normals) {
      out.text(uvs.empty() ? "//" : "/");
      out.bare_number(v);
    }
  }
  out.end_line();
}

void write_faces(Output& out, const MeshView& mesh) {
  const bool has_materials = has_depth_materials(mesh);
  NameStatement objects("o", mesh.names().objects);
  NameStatement groups("g", mesh.names().groups);
  NameStatement materials("usemtl", mesh.names().materials);
  int depth = -1;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const std::uint32_t control_face = mesh.control_face(f);
    objects.write(out, control_face);
    groups.write(out, control_face);
    materials.write(out, control_face);
    if (mesh.has_depths() && mesh.depth(f) != depth) {
      depth = mesh.depth(f);
      out.text(has_materials ? "usemtl depth_" : "t limn_depth 1/0/0 ");
      out.bare_number(depth);
      out.end_line();
    }
    write_face(out, mesh, f);
  }
}

// Vertices of tags count from 0.
void write_tags(Output& out, const MeshView& mesh) {
  for (const CreaseTag& crease : mesh.creases()) {
    out.text("t crease 2/1/0");
    out.number(crease.vertices[0]);
    out.number(crease.vertices[1]);
    out.number(crease.sharpness);
    out.end_line();
  }
  for (const CornerTag& corner : mesh.corners()) {
    out.text("t corner 1/1/0");
    out.number(corner.vertex);
    out.number(corner.sharpness);
    out.end_line();
  }
  if (mesh.corner_rule()) {
    out.text(mesh.corner_rule() == CornerRule::kSharp ? "t interpolateboundary 1/0/0 1\n"
                                                      : "t interpolateboundary 1/0/0 2\n");
  }
  if (mesh.creasing() == CreasingMethod::kChaikin) {
    out.text("t creasemethod 0/0/1 chaikin\n");
  }
}

}  // namespace

bool has_depth_materials(const MeshView& mesh) {
  return mesh.has_depths() && mesh.names().materials.empty();
}

void write_obj(std::ostream& stream, const MeshView& mesh, bool has_depth_library) {
  Output out(stream);
  for (const std::string& library : mesh.names().material_libraries) {
    out.text("mtllib ");
    out.text(obj_name(library));
    out.end_line();
  }
  if (has_depth_library && has_depth_materials(mesh)) {
    out.text("mtllib ");
    out.text(DepthLibrary);
    out.end_line();
  }
  write_vertices(out, mesh);
  write_uvs(out, mesh);
  write_normals(out, mesh);
  write_faces(out, mesh);
  write_tags(out, mesh);
}

void write_depth_library(std::ostream& stream, std::span<const glm::u8vec3> colours, int deepest) {
  Output out(stream);
  constexpr float most = 255.0f;
  for (int depth = 0; depth <= deepest; ++depth) {
    const glm::u8vec3& c =
        colours[std::min<std::size_t>(static_cast<std::size_t>(depth), colours.size() - 1)];
    out.text("newmtl depth_");
    out.bare_number(depth);
    out.text("\nKd");
    for (const auto channel : {c.x, c.y, c.z}) {
      out.text(" ");
      fmt::memory_buffer digits;
      fmt::format_to(std::back_inserter(digits), "{:.3f}", static_cast<float>(channel) / most);
      out.text({digits.data(), digits.size()});
    }
    out.end_line();
  }
}

}  // namespace limn::detail
