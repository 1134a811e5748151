// Written line by line, a position and a face a line, so that a project can be read and compared by
// people; read in one pass (json_lists.h), then checked from the outside in: format, version,
// lists, settings, and last the mesh itself, by the same builder that mesh files go through.
#include "limn/document/project_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "field_reader.h"
#include "json_lists.h"
#include "limn/atomic_file.h"
#include "limn/mesh/build.h"
#include "limn/mesh/polygon_soup.h"
#include "regular_file.h"
#include "view_json.h"

namespace limn {
namespace {

constexpr std::string_view kFormat = "limn-project";
constexpr std::int64_t kVersion = 1;
/// Some five million control faces; a file beyond this is no painting.
constexpr std::size_t kMostProjectBytes = std::size_t{1} << 30U;

constexpr std::array<Named<NonQuadRule>, 2> kNonQuadRules{
    {{"uniform-first-step", NonQuadRule::kUniformFirstStep},
     {"where-painted", NonQuadRule::kWherePainted}}};
constexpr std::array<Named<LegalisationMethod>, 1> kLegalisations{
    {{"greedy", LegalisationMethod::kGreedy}}};
constexpr std::array<Named<CornerRule>, 2> kCornerRules{
    {{"sharp", CornerRule::kSharp}, {"smooth", CornerRule::kSmooth}}};

template <class T, std::size_t n>
std::string_view name_of(T value, const std::array<Named<T>, n>& choices) {
  const auto found = std::find_if(choices.begin(), choices.end(),
                                  [&](const Named<T>& choice) { return choice.value == value; });
  LIMN_EXPECTS(found != choices.end());
  return found->name;
}

// --- writing

/// Text on its way to a stream, handed over in large pieces.
class Writer {
 public:
  explicit Writer(std::ostream& out) : out_(out) {}
  ~Writer() { flush(); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  void add(std::string_view text) {
    buffer_.append(text);
    if (buffer_.size() > kPiece) {
      flush();
    }
  }
  template <class Range>
  void add_list(const Range& items, std::string_view separator, auto&& text_of) {
    add("[");
    std::string_view before;
    for (const auto& item : items) {
      add(before);
      add(text_of(item));
      before = separator;
    }
    add("]");
  }

 private:
  static constexpr std::size_t kPiece = std::size_t{1} << 16U;

  void flush() {
    out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    buffer_.clear();
  }

  std::ostream& out_;
  fmt::basic_memory_buffer<char, 2 * kPiece> buffer_;
};

void write_mesh(Writer& writer, const ControlMesh& mesh) {
  writer.add("{\n    \"positions\": [");
  std::string_view before = "\n      ";
  for (const glm::dvec3& p : mesh.positions()) {
    writer.add(before);
    writer.add(fmt::format("[{}, {}, {}]", json_number(p.x), json_number(p.y), json_number(p.z)));
    before = ",\n      ";
  }
  writer.add("\n    ],\n    \"faces\": [");
  before = "\n      ";
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    writer.add(before);
    writer.add_list(mesh.face(f), ", ", [](std::uint32_t v) { return fmt::format_int(v).str(); });
    before = ",\n      ";
  }
  writer.add("\n    ]\n  }");
}

void write_project(std::ostream& out, const Document& document,
                   const std::optional<ViewState>& view) {
  Writer writer(out);
  const std::string mesh_path = document.mesh_path.string();
  writer.add(fmt::format("{{\n  \"format\": \"{}\",\n  \"version\": {},\n", kFormat, kVersion));
  writer.add(fmt::format("  \"name\": {},\n", json_quoted(document.name)));
  // A path that is not UTF-8 cannot be said in JSON; a changed one would name another file.
  writer.add(
      fmt::format("  \"mesh_path\": {},\n", is_utf8(mesh_path) ? json_quoted(mesh_path) : "\"\""));
  const SubdivisionSettings& settings = document.settings;
  writer.add(fmt::format(
      "  \"settings\": {{\n    \"non_quads\": \"{}\",\n    \"legalisation\": \"{}\",\n"
      "    \"corners\": \"{}\"\n  }},\n",
      name_of(settings.non_quads, kNonQuadRules), name_of(settings.legalisation, kLegalisations),
      name_of(settings.corners, kCornerRules)));
  const Stage& stage = document.stage;
  writer.add(fmt::format("  \"stage\": {{\n    \"legalised\": {},\n    \"levels\": {}\n  }},\n",
                         stage.is_legalised,
                         stage.levels == kAllLevels ? "\"all\"" : std::to_string(stage.levels)));
  if (view) {
    writer.add(fmt::format("  \"view\": {},\n", view_json(*view, "  ")));
  }
  writer.add("  \"depths\": ");
  writer.add_list(document.depths.values(), ", ",
                  [](std::uint8_t depth) { return fmt::format_int(depth).str(); });
  writer.add(",\n  \"mesh\": ");
  write_mesh(writer, *document.control);
  if (document.opened != nullptr && document.opened != document.control) {
    writer.add(",\n  \"opened_mesh\": ");
    write_mesh(writer, *document.opened);
  }
  writer.add("\n}\n");
}

bool is_finite(const ControlMesh& mesh) {
  return std::all_of(mesh.positions().begin(), mesh.positions().end(), [](const glm::dvec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  });
}

// --- reading

/// Complaints about a list as a whole: not there, or something else in its place.
void expect_long_list(FieldReader& fields, std::string_view path, bool is_there) {
  if (!is_there) {
    fields.complain(path, fields.find(path) == nullptr ? "is missing." : "must be a list.");
  }
}

/// The first face corner that names a vertex which is not there.
void check_vertex_numbers(FieldReader& fields, const std::string& path, const MeshLists& lists) {
  const std::size_t vertices = lists.positions.size() / 3;
  const auto beyond = std::find_if(lists.face_vertices.begin(), lists.face_vertices.end(),
                                   [&](std::uint32_t v) { return v >= vertices; });
  if (beyond == lists.face_vertices.end()) {
    return;
  }
  const auto corner = static_cast<std::uint32_t>(beyond - lists.face_vertices.begin());
  const auto end = std::upper_bound(lists.face_offsets.begin(), lists.face_offsets.end(), corner);
  const auto face = end - lists.face_offsets.begin() - 1;
  fields.complain(fmt::format("{}/faces/{}/{}", path, face, corner - *(end - 1)),
                  fmt::format("there is no vertex {}; the mesh has {}.", *beyond, vertices));
}

Result<ImportedMesh> build(const std::string& path, MeshLists lists, const std::string& source) {
  PolygonSoup soup;
  soup.positions.reserve(lists.positions.size() / 3);
  for (std::size_t i = 0; i + 2 < lists.positions.size(); i += 3) {
    soup.positions.emplace_back(lists.positions[i], lists.positions[i + 1], lists.positions[i + 2]);
  }
  soup.face_offsets = std::move(lists.face_offsets);
  soup.face_vertices = std::move(lists.face_vertices);
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
  return mesh;
}

/// "Not ours" and "newer than this program" come before any other complaint.
std::optional<Error> check_format(const ProjectText& text, const std::string& source) {
  FieldReader fields(text.fields, source);
  const JsonValue* format = fields.find("/format");
  const auto* name = format == nullptr ? nullptr : std::get_if<std::string>(format);
  if (name == nullptr || *name != kFormat) {
    fields.complain("/format", fmt::format("is not \"{}\"; this is no Limn project.", kFormat));
    return fields.error();
  }
  const std::int64_t version =
      fields.whole_number("/version", 1, std::numeric_limits<std::int64_t>::max());
  if (version > kVersion) {
    fields.complain("/version",
                    fmt::format("{} is newer than this program reads ({}); update Limn to open it.",
                                version, kVersion));
  }
  return fields.error();
}

SubdivisionSettings read_settings(FieldReader& fields) {
  fields.expect_object("/settings");
  return {fields.choice("/settings/non_quads", kNonQuadRules),
          fields.choice("/settings/legalisation", kLegalisations),
          fields.choice("/settings/corners", kCornerRules)};
}

Stage read_stage(FieldReader& fields) {
  fields.expect_object("/stage");
  Stage stage;
  stage.is_legalised = fields.flag("/stage/legalised");
  const JsonValue* levels = fields.find("/stage/levels");
  const auto* word = levels == nullptr ? nullptr : std::get_if<std::string>(levels);
  if (word == nullptr) {
    stage.levels = static_cast<int>(fields.whole_number("/stage/levels", 0, kAllLevels));
  } else if (*word == "all") {
    stage.levels = kAllLevels;
  } else {
    fields.complain("/stage/levels", "must be a number of levels or \"all\".");
  }
  return stage;
}

/// The parts of a project that need no mesh.
struct Header {
  std::string name;
  std::string mesh_path;
  SubdivisionSettings settings;
  Stage stage;
  std::optional<ViewState> view;
  bool has_opened_mesh = false;
};

Result<Header> read_header(const ProjectText& text, const std::string& source) {
  FieldReader fields(text.fields, source);
  Header header;
  header.name = fields.text("/name");
  header.mesh_path = fields.text("/mesh_path");
  header.settings = read_settings(fields);
  header.stage = read_stage(fields);
  if (!fields.is_absent("/view")) {
    header.view = read_view(fields, "/view");
  }
  expect_long_list(fields, "/depths", text.has_depths);
  fields.expect_object("/mesh");
  expect_long_list(fields, "/mesh/positions", text.mesh.has_positions);
  expect_long_list(fields, "/mesh/faces", text.mesh.has_faces);
  check_vertex_numbers(fields, "/mesh", text.mesh);
  header.has_opened_mesh = !fields.is_absent("/opened_mesh");
  if (header.has_opened_mesh) {
    fields.expect_object("/opened_mesh");
    expect_long_list(fields, "/opened_mesh/positions", text.opened_mesh.has_positions);
    expect_long_list(fields, "/opened_mesh/faces", text.opened_mesh.has_faces);
    check_vertex_numbers(fields, "/opened_mesh", text.opened_mesh);
  }
  const std::size_t faces = text.mesh.face_offsets.size() - 1;
  if (text.depths.size() != faces) {
    fields.complain("/depths",
                    fmt::format("has {} entries for {} faces.", text.depths.size(), faces));
  }
  if (fields.error()) {
    return tl::unexpected(*fields.error());
  }
  return header;
}

Result<Project> assemble(ProjectText text, Header header, const std::string& source) {
  Result<ImportedMesh> control = build("/mesh", std::move(text.mesh), source);
  if (!control) {
    return tl::unexpected(std::move(control.error()));
  }
  Project project;
  project.document =
      make_document(*std::move(control), std::move(header.name), std::move(header.mesh_path));
  Document& document = project.document;
  if (header.has_opened_mesh) {
    Result<ImportedMesh> opened = build("/opened_mesh", std::move(text.opened_mesh), source);
    if (!opened) {
      return tl::unexpected(std::move(opened.error()));
    }
    document.opened = std::move(opened->mesh);
  }
  for (std::size_t f = 0; f < text.depths.size(); ++f) {
    document.depths.set(f, text.depths[f]);
  }
  document.settings = header.settings;
  document.stage = header.stage;
  project.view = header.view;
  return project;
}

}  // namespace

Result<void> save_project(const std::filesystem::path& path, const Document& document,
                          const std::optional<ViewState>& view) {
  LIMN_EXPECTS(document.control != nullptr);
  LIMN_EXPECTS(document.depths.size() == document.control->face_count());
  LIMN_EXPECTS(document.stage.levels >= 0 && document.stage.levels <= kAllLevels);
  if (view) {
    if (std::string fault = fault_of(*view); !fault.empty()) {
      return fail(ErrorKind::kFailed, std::move(fault), path.string());
    }
  }
  if (!is_finite(*document.control) ||
      (document.opened != nullptr && !is_finite(*document.opened))) {
    return fail(ErrorKind::kFailed,
                "The mesh has vertices at infinity, which a project cannot hold.", path.string());
  }
  return write_file_atomically(path,
                               [&](std::ostream& out) { write_project(out, document, view); });
}

Result<Project> load_project(const std::filesystem::path& path) {
  const std::string source = path.string();
  Result<ProjectText> text =
      read_regular_file(path, kMostProjectBytes).and_then([&](const std::string& bytes) {
        return parse_project_text(bytes, source);
      });
  if (!text) {
    return tl::unexpected(std::move(text.error()));
  }
  if (std::optional<Error> error = check_format(*text, source)) {
    return tl::unexpected(*std::move(error));
  }
  if (text->misfit) {
    return tl::unexpected(*std::move(text->misfit));
  }
  Result<Header> header = read_header(*text, source);
  if (!header) {
    return tl::unexpected(std::move(header.error()));
  }
  Result<Project> project = assemble(*std::move(text), *std::move(header), source);
  if (project) {
    project->document.project_path = path;
  }
  return project;
}

}  // namespace limn
