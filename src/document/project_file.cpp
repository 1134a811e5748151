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
#include "json_writer.h"
#include "limn/files/atomic_file.h"
#include "limn/subdivision/schemes/uniform.h"
#include "project_mesh.h"
#include "files/regular_file.h"
#include "view_json.h"

namespace limn {
namespace {

constexpr std::string_view kFormat = "limn-project";
/// 2 brought creases, corners and texture coordinates, 3 uniform schemes and adaptive Loop. A
/// project is written as the oldest version that holds it, for programs that know no other.
constexpr std::int64_t kVersion = 3;
/// Some five million control faces; a file beyond this is no painting.
constexpr std::size_t kMostProjectBytes = std::size_t{1} << 30U;

constexpr std::array<Named<NonQuadRule>, 2> kNonQuadRules{
    {{"uniform-first-step", NonQuadRule::kUniformFirstStep},
     {"where-painted", NonQuadRule::kWherePainted}}};
constexpr std::array<Named<LegalisationMethod>, 2> kLegalisations{
    {{"greedy", LegalisationMethod::kGreedy}, {"look-ahead", LegalisationMethod::kLookAhead}}};
constexpr std::array<Named<SurfacePoints>, 2> kSurfacePoints{
    {{"level", SurfacePoints::kLevel}, {"limit", SurfacePoints::kLimit}}};
constexpr std::array<Named<TextureRule>, 2> kTextureRules{
    {{"smooth-inside", TextureRule::kSmoothInside}, {"linear", TextureRule::kLinear}}};

constexpr std::array<Named<RefinementScheme>, 2> kRefinementSchemes{
    {{"catmull-clark", RefinementScheme::kCatmullClark}, {"loop", RefinementScheme::kLoop}}};
constexpr std::array<Named<LoopWeights>, 2> kLoopWeights{
    {{"original", LoopWeights::kOriginal}, {"warren", LoopWeights::kWarren}}};

std::array<Named<Scheme>, kSchemeCount> scheme_names() {
  std::array<Named<Scheme>, kSchemeCount> names;
  std::ranges::transform(schemes(), names.begin(), [](const SchemeInfo& info) {
    return Named<Scheme>{info.name, info.scheme};
  });
  return names;
}

// --- writing

/// Whether a program that reads version 1 alone would get the whole document.
bool is_plain(const Document& document) {
  const SubdivisionSettings defaults;
  return document.settings.legalisation == LegalisationMethod::kGreedy &&
         document.settings.points == defaults.points &&
         document.settings.texture == defaults.texture && !has_attributes(*document.control) &&
         (document.opened == nullptr || !has_attributes(*document.opened));
}

std::int64_t version_of(const Document& document) {
  if (document.scheme || document.settings.scheme != RefinementScheme::kCatmullClark) {
    return 3;
  }
  return is_plain(document) ? 1 : 2;
}

void write_scheme(JsonWriter& writer, const SchemeSettings& settings) {
  writer.add(
      fmt::format("  \"scheme\": {{\n    \"name\": \"{}\"", scheme_info(settings.scheme).name));
  if (settings.scheme == Scheme::kLoop) {
    writer.add(fmt::format(",\n    \"weights\": \"{}\"", name_of(settings.weights, kLoopWeights)));
  }
  if (settings.scheme == Scheme::kLinear) {
    writer.add(fmt::format(",\n    \"averages\": {}", settings.averages));
  }
  writer.add("\n  },\n");
}

void write_project(std::ostream& out, const Document& document,
                   const std::optional<ViewState>& view) {
  JsonWriter writer(out);
  const std::string mesh_path = document.mesh_path.string();
  writer.add(fmt::format("{{\n  \"format\": \"{}\",\n  \"version\": {},\n", kFormat,
                         version_of(document)));
  writer.add(fmt::format("  \"name\": {},\n", json_quoted(document.name)));
  // A path that is not UTF-8 cannot be said in JSON; a changed one would name another file.
  writer.add(
      fmt::format("  \"mesh_path\": {},\n", is_utf8(mesh_path) ? json_quoted(mesh_path) : "\"\""));
  const SubdivisionSettings& settings = document.settings;
  writer.add(fmt::format(
      "  \"settings\": {{\n    \"non_quads\": \"{}\",\n    \"legalisation\": \"{}\",\n"
      "    \"corners\": \"{}\"",
      name_of(settings.non_quads, kNonQuadRules), name_of(settings.legalisation, kLegalisations),
      name_of(settings.corners, kCornerRules)));
  // Left out where they are as they were before there was a choice.
  if (settings.points != SubdivisionSettings{}.points) {
    writer.add(
        fmt::format(",\n    \"positions\": \"{}\"", name_of(settings.points, kSurfacePoints)));
  }
  if (settings.texture != SubdivisionSettings{}.texture) {
    writer.add(fmt::format(",\n    \"texture\": \"{}\"", name_of(settings.texture, kTextureRules)));
  }
  if (settings.scheme != SubdivisionSettings{}.scheme) {
    writer.add(fmt::format(",\n    \"adaptive\": \"{}\",\n    \"weights\": \"{}\"",
                           name_of(settings.scheme, kRefinementSchemes),
                           name_of(settings.weights, kLoopWeights)));
  }
  writer.add("\n  },\n");
  if (document.scheme) {
    write_scheme(writer, *document.scheme);
  }
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
  write_project_mesh(writer, *document.control);
  if (document.opened != nullptr && document.opened != document.control) {
    writer.add(",\n  \"opened_mesh\": ");
    write_project_mesh(writer, *document.opened);
  }
  writer.add("\n}\n");
}

bool is_finite(const ControlMesh& mesh) {
  return std::all_of(mesh.positions().begin(), mesh.positions().end(), [](const glm::dvec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  });
}

// --- reading

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
  SubdivisionSettings settings;
  settings.non_quads = fields.choice("/settings/non_quads", kNonQuadRules);
  settings.legalisation = fields.is_absent("/settings/legalisation")
                              ? LegalisationMethod::kGreedy  // There was only one then.
                              : fields.choice("/settings/legalisation", kLegalisations);
  settings.corners = fields.choice("/settings/corners", kCornerRules);
  if (!fields.is_absent("/settings/positions")) {
    settings.points = fields.choice("/settings/positions", kSurfacePoints);
  }
  if (!fields.is_absent("/settings/texture")) {
    settings.texture = fields.choice("/settings/texture", kTextureRules);
  }
  if (!fields.is_absent("/settings/adaptive")) {
    settings.scheme = fields.choice("/settings/adaptive", kRefinementSchemes);
    settings.weights = fields.choice("/settings/weights", kLoopWeights);
  }
  return settings;
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

std::optional<SchemeSettings> read_scheme(FieldReader& fields) {
  if (fields.is_absent("/scheme")) {
    return std::nullopt;
  }
  fields.expect_object("/scheme");
  SchemeSettings settings;
  settings.scheme = fields.choice("/scheme/name", scheme_names());
  if (settings.scheme == Scheme::kLoop) {
    settings.weights = fields.choice("/scheme/weights", kLoopWeights);
  }
  if (settings.scheme == Scheme::kLinear) {
    settings.averages = fields.flag("/scheme/averages");
  }
  return settings;
}

/// The parts of a project that need no mesh.
struct Header {
  std::string name;
  std::string mesh_path;
  SubdivisionSettings settings;
  std::optional<SchemeSettings> scheme;
  Stage stage;
  std::optional<ViewState> view;
  MeshRules mesh;
  std::optional<MeshRules> opened_mesh;
};

Result<Header> read_header(const ProjectText& text, const std::string& source) {
  FieldReader fields(text.fields, source);
  Header header;
  header.name = fields.text("/name");
  header.mesh_path = fields.text("/mesh_path");
  header.settings = read_settings(fields);
  header.scheme = read_scheme(fields);
  header.stage = read_stage(fields);
  if (header.scheme && header.stage.levels > kMostSchemeLevels) {
    fields.complain("/stage/levels",
                    fmt::format("of a uniform scheme must be 0..{}.", kMostSchemeLevels));
  }
  if (!fields.is_absent("/view")) {
    header.view = read_view(fields, "/view");
  }
  fields.expect_long_list("/depths", text.has_depths);
  header.mesh = read_mesh_rules(fields, "/mesh", text.mesh);
  if (!fields.is_absent("/opened_mesh")) {
    header.opened_mesh = read_mesh_rules(fields, "/opened_mesh", text.opened_mesh);
  }
  const std::size_t faces = text.mesh.faces.offsets.size() - 1;
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
  Result<ImportedMesh> control =
      build_project_mesh("/mesh", std::move(text.mesh), header.mesh, source);
  if (!control) {
    return tl::unexpected(std::move(control.error()));
  }
  Project project;
  project.document =
      make_document(*std::move(control), std::move(header.name), std::move(header.mesh_path));
  Document& document = project.document;
  if (header.opened_mesh) {
    Result<ImportedMesh> opened = build_project_mesh("/opened_mesh", std::move(text.opened_mesh),
                                                     *header.opened_mesh, source);
    if (!opened) {
      return tl::unexpected(std::move(opened.error()));
    }
    document.opened = std::move(opened->mesh);
  }
  for (std::size_t f = 0; f < text.depths.size(); ++f) {
    document.depths.set(f, text.depths[f]);
  }
  document.settings = header.settings;
  document.scheme = header.scheme;
  document.stage = header.stage;
  if (document.settings.scheme == RefinementScheme::kLoop) {
    if (auto fits = check_fits(*document.control, Scheme::kLoop); !fits) {
      return fail(ErrorKind::kBadInput, "/settings/adaptive: " + fits.error().message, source);
    }
  }
  if (document.scheme && document.stage.levels > 0) {
    if (auto fits = check_fits(*document.control, document.scheme->scheme); !fits) {
      return fail(ErrorKind::kBadInput, "/scheme: " + fits.error().message, source);
    }
  }
  project.view = header.view;
  return project;
}

}  // namespace

Result<void> save_project(const std::filesystem::path& path, const Document& document,
                          const std::optional<ViewState>& view) {
  LIMN_EXPECTS(document.control != nullptr);
  LIMN_EXPECTS(document.depths.size() == document.control->face_count());
  LIMN_EXPECTS(document.stage.levels >= 0 &&
               document.stage.levels <= (document.scheme ? kMostSchemeLevels : kAllLevels));
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
