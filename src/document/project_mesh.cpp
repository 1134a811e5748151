// A mesh is written as people would read it: sharp edges by their ends and sharp vertices by their
// number, only where there are any. It is read through the builder that mesh files go through.
#include "project_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "limn/mesh/control_mesh.h"
#include "limn/mesh/polygon_soup.h"
#include "project_face_names.h"
#include "view_json.h"

namespace limn {
namespace {

constexpr std::array<Named<CreasingMethod>, 2> kCreasingMethods{
    {{"uniform", CreasingMethod::kUniform}, {"chaikin", CreasingMethod::kChaikin}}};

/// Writes a member that is a list of rows, a row a line, where there are rows.
class RowList {
 public:
  RowList(JsonWriter& writer, std::string_view key) : writer_(writer), key_(key) {}
  ~RowList() {
    if (is_begun_) {
      writer_.add("\n    ]");
    }
  }
  RowList(const RowList&) = delete;
  RowList& operator=(const RowList&) = delete;

  /// Before every row.
  void begin_row() {
    if (is_begun_) {
      writer_.add(",\n      ");
    } else {
      writer_.add(fmt::format(",\n    \"{}\": [\n      ", key_));
      is_begun_ = true;
    }
  }

 private:
  JsonWriter& writer_;
  std::string_view key_;
  bool is_begun_ = false;
};

void write_indices(JsonWriter& writer, std::span<const std::uint32_t> indices) {
  writer.add_list(indices, ", ", [](std::uint32_t i) { return fmt::format_int(i).str(); });
}

void write_texture(JsonWriter& writer, const ControlMesh& mesh) {
  const TextureCoordinates& texture = mesh.texture();
  if (texture.empty()) {
    return;
  }
  {
    RowList uvs(writer, "uvs");
    for (const glm::dvec2& uv : texture.values) {
      uvs.begin_row();
      writer.add(fmt::format("[{}, {}]", json_number(uv.x), json_number(uv.y)));
    }
  }
  RowList faces(writer, "face_uvs");
  const auto& offsets = mesh.topology().face_offsets;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    faces.begin_row();
    write_indices(
        writer, std::span(texture.corner_values).subspan(offsets[f], offsets[f + 1] - offsets[f]));
  }
}

/// Sharpness as a float's own digits, which read back as the same float.
void write_creases(JsonWriter& writer, const ControlMesh& mesh) {
  const Creases& creases = mesh.creases();
  {
    RowList edges(writer, "creases");
    for (std::size_t e = 0; e < creases.edge_sharpness.size(); ++e) {
      if (creases.edge_sharpness[e] > 0.0f) {
        const auto [a, b] = mesh.topology().edge_vertices[e];
        edges.begin_row();
        writer.add(fmt::format("[{}, {}, {}]", a, b, creases.edge_sharpness[e]));
      }
    }
  }
  RowList vertices(writer, "corners");
  for (std::size_t v = 0; v < creases.vertex_sharpness.size(); ++v) {
    if (creases.vertex_sharpness[v] > 0.0f) {
      vertices.begin_row();
      writer.add(fmt::format("[{}, {}]", v, creases.vertex_sharpness[v]));
    }
  }
}

/// The first corner of a face that indexes something which is not there.
void check_indices(FieldReader& fields, const std::string& path, const IndexRows& rows,
                   std::size_t count, std::string_view what) {
  const auto beyond =
      std::ranges::find_if(rows.indices, [&](std::uint32_t i) { return i >= count; });
  if (beyond == rows.indices.end()) {
    return;
  }
  const auto corner = static_cast<std::uint32_t>(beyond - rows.indices.begin());
  const auto end = std::ranges::upper_bound(rows.offsets, corner);
  const auto face = end - rows.offsets.begin() - 1;
  fields.complain(fmt::format("{}/{}/{}", path, face, corner - *(end - 1)),
                  fmt::format("there is no {} {}; the mesh has {}.", what, *beyond, count));
}

void check_texture(FieldReader& fields, const std::string& path, const MeshLists& lists) {
  if (!lists.uvs.is_there && !lists.face_uvs.is_there) {
    return;
  }
  fields.expect_long_list(path + "/uvs", lists.uvs.is_there);
  fields.expect_long_list(path + "/face_uvs", lists.face_uvs.is_there);
  constexpr double largest = 1e18;  // As in mesh files.
  for (std::size_t i = 0; i < lists.uvs.numbers.size(); ++i) {
    if (!(std::abs(lists.uvs.numbers[i]) <= largest)) {
      fields.complain(fmt::format("{}/uvs/{}/{}", path, i / 2, i % 2), "lies too far out.");
      break;
    }
  }
  if (lists.face_uvs.offsets != lists.faces.offsets) {
    fields.complain(path + "/face_uvs", "does not have a texture point for each corner of faces.");
  }
  check_indices(fields, path + "/face_uvs", lists.face_uvs, lists.uvs.numbers.size() / 2,
                "texture point");
}

/// Rows of `ends` vertices and a sharpness.
void check_tags(FieldReader& fields, const std::string& path, const NumberRows& rows,
                std::size_t ends, std::size_t vertices) {
  for (std::size_t i = 0; i < rows.numbers.size(); ++i) {
    const double number = rows.numbers[i];
    const std::size_t column = i % (ends + 1);
    const std::string where = fmt::format("{}/{}/{}", path, i / (ends + 1), column);
    if (column == ends) {
      if (!(number >= 0.0 && number <= std::numeric_limits<float>::max())) {
        fields.complain(where, "must be a sharpness: a number from 0 on.");
        return;
      }
    } else if (!(number >= 0.0 && number < static_cast<double>(vertices) &&
                 number == std::floor(number))) {
      fields.complain(
          where, fmt::format("must be the number of a vertex: a whole number below {}.", vertices));
      return;
    }
  }
}

std::vector<glm::dvec3> points_of(const std::vector<double>& xyz) {
  std::vector<glm::dvec3> points;
  points.reserve(xyz.size() / 3);
  for (std::size_t i = 0; i + 2 < xyz.size(); i += 3) {
    points.emplace_back(xyz[i], xyz[i + 1], xyz[i + 2]);
  }
  return points;
}

PolygonSoup soup_of(MeshLists lists, const MeshRules& rules) {
  PolygonSoup soup;
  soup.positions = points_of(lists.positions.numbers);
  soup.face_offsets = std::move(lists.faces.offsets);
  soup.face_vertices = std::move(lists.faces.indices);

  const std::vector<double>& uv = lists.uvs.numbers;
  soup.uvs.reserve(uv.size() / 2);
  for (std::size_t i = 0; i + 1 < uv.size(); i += 2) {
    soup.uvs.emplace_back(uv[i], uv[i + 1]);
  }
  soup.face_uvs = std::move(lists.face_uvs.indices);

  const auto vertex = [](double number) { return static_cast<std::uint32_t>(number); };
  const std::vector<double>& creases = lists.creases.numbers;
  for (std::size_t i = 0; i + 2 < creases.size(); i += 3) {
    soup.creases.push_back(
        {{vertex(creases[i]), vertex(creases[i + 1])}, static_cast<float>(creases[i + 2])});
  }
  const std::vector<double>& corners = lists.corners.numbers;
  for (std::size_t i = 0; i + 1 < corners.size(); i += 2) {
    soup.corners.push_back({vertex(corners[i]), static_cast<float>(corners[i + 1])});
  }
  soup.creasing = rules.creasing;
  soup.corner_rule = rules.corners;
  return soup;
}

}  // namespace

bool has_names(const ControlMesh& mesh) {
  return !mesh.attributes().names.empty() || !mesh.attributes().loose_vertices.empty();
}

bool has_attributes(const ControlMesh& mesh) {
  return mesh.creases() != Creases{} || mesh.attributes().corners.has_value() ||
         !mesh.texture().empty();
}

namespace {

void write_point(JsonWriter& writer, const glm::dvec3& p) {
  writer.add(fmt::format("[{}, {}, {}]", json_number(p.x), json_number(p.y), json_number(p.z)));
}

}  // namespace

void write_project_mesh(JsonWriter& writer, const ControlMesh& mesh) {
  writer.add("{\n    \"positions\": [");
  std::string_view before = "\n      ";
  for (const glm::dvec3& p : mesh.positions()) {
    writer.add(before);
    write_point(writer, p);
    before = ",\n      ";
  }
  writer.add("\n    ],\n    \"faces\": [");
  before = "\n      ";
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    writer.add(before);
    write_indices(writer, mesh.face(f));
    before = ",\n      ";
  }
  writer.add("\n    ]");
  write_texture(writer, mesh);
  write_creases(writer, mesh);
  {
    RowList loose(writer, "loose_vertices");
    for (const glm::dvec3& p : mesh.attributes().loose_vertices) {
      loose.begin_row();
      write_point(writer, p);
    }
  }
  write_face_names(writer, mesh.attributes().names);
  if (mesh.creases().method != CreasingMethod::kUniform) {
    writer.add(fmt::format(",\n    \"creasing\": \"{}\"",
                           name_of(mesh.creases().method, kCreasingMethods)));
  }
  if (mesh.attributes().corners) {
    writer.add(fmt::format(",\n    \"boundary_corners\": \"{}\"",
                           name_of(*mesh.attributes().corners, kCornerRules)));
  }
  writer.add("\n  }");
}

MeshRules read_mesh_rules(FieldReader& fields, const std::string& path, const MeshLists& lists) {
  fields.expect_object(path);
  fields.expect_long_list(path + "/positions", lists.positions.is_there);
  fields.expect_long_list(path + "/faces", lists.faces.is_there);
  const std::size_t vertices = lists.positions.numbers.size() / 3;
  check_indices(fields, path + "/faces", lists.faces, vertices, "vertex");
  check_texture(fields, path, lists);
  check_tags(fields, path + "/creases", lists.creases, 2, vertices);
  check_tags(fields, path + "/corners", lists.corners, 1, vertices);
  check_face_names(fields, path, lists);
  for (const char* list : {"/creases", "/corners", "/uvs", "/face_uvs", "/loose_vertices",
                           "/object_names", "/face_objects", "/group_names", "/face_groups",
                           "/material_names", "/face_materials", "/material_libraries"}) {
    if (fields.find(path + list) != nullptr) {
      fields.complain(path + list, "must be a list.");
    }
  }
  MeshRules rules;
  if (!fields.is_absent(path + "/creasing")) {
    rules.creasing = fields.choice(path + "/creasing", kCreasingMethods);
  }
  if (!fields.is_absent(path + "/boundary_corners")) {
    rules.corners = fields.choice(path + "/boundary_corners", kCornerRules);
  }
  return rules;
}

Result<ImportedMesh> build_project_mesh(const std::string& path, MeshLists lists,
                                        const MeshRules& rules, const std::string& source) {
  FaceNaming names = face_names_of(lists);
  std::vector<glm::dvec3> loose_vertices = points_of(lists.loose_vertices.numbers);
  PolygonSoup soup = soup_of(std::move(lists), rules);
  soup.source = source;
  Result<ImportedMesh> mesh = build_control_mesh(soup);
  if (!mesh) {
    Error error = std::move(mesh.error());
    error.message = fmt::format("{}: {}", path, error.message);
    error.path = source;
    return tl::unexpected(std::move(error));
  }
  if (mesh->report.is_mended()) {
    // Whatever was painted belongs to the mesh as it was saved; nobody can tell where it would go.
    std::string message = path + ": is damaged and is not mended in a project.";
    for (const std::string& sentence : mesh->report.sentences()) {
      message += " " + sentence;
    }
    return fail(ErrorKind::kBadInput, std::move(message), source);
  }
  LIMN_EXPECTS(mesh->mesh->face_count() == soup.face_count());
  if (!names.empty() || !loose_vertices.empty()) {
    MeshAttributes attributes = mesh->mesh->attributes();
    attributes.names = std::move(names);
    attributes.loose_vertices = std::move(loose_vertices);
    mesh->mesh =
        std::make_shared<const ControlMesh>(mesh->mesh->with_attributes(std::move(attributes)));
  }
  return mesh;
}

}  // namespace limn
