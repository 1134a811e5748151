// Read in one pass (json_lists.h), then checked from the outside in: format, version, checksum,
// lists, settings, and last the mesh itself, by the same builder that mesh files go through.
#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "checksum.h"
#include "field_reader.h"
#include "json_lists.h"
#include "limn/document/project_file.h"
#include "limn/subdivision/schemes/uniform.h"
#include "project_mesh.h"
#include "project_names.h"
#include "view_json.h"

namespace limn {
namespace {

constexpr std::size_t kDemandNumbers = 6;

/// "Not ours" and "newer than this program" come before any other complaint.
std::optional<Error> check_format(const ProjectText& text, const std::string& source) {
  FieldReader fields(text.fields, source);
  const JsonValue* format = fields.find("/format");
  const auto* name = format == nullptr ? nullptr : std::get_if<std::string>(format);
  if (name == nullptr || *name != kProjectFormat) {
    fields.complain("/format",
                    fmt::format("is not \"{}\"; this is no Limn project.", kProjectFormat));
    return fields.error();
  }
  const std::int64_t version =
      fields.whole_number("/version", 1, std::numeric_limits<std::int64_t>::max());
  if (version > kProjectVersion) {
    fields.complain("/version",
                    fmt::format("{} is newer than this program reads ({}); update Limn to open it.",
                                version, kProjectVersion));
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
  if (!text.has_demands && !fields.is_absent("/demands")) {
    fields.expect_long_list("/demands", false);
  }
  if (text.demands.size() % kDemandNumbers != 0) {
    fields.complain("/demands", fmt::format("has {} numbers; a demand has {}.", text.demands.size(),
                                            kDemandNumbers));
  }
  if (fields.error()) {
    return tl::unexpected(*fields.error());
  }
  return header;
}

/// Face, corner, level, column, row and depth, six numbers a demand.
Result<FineDemands> read_demands(const std::vector<std::uint32_t>& numbers,
                                 const ControlMesh& control, const std::string& source) {
  constexpr std::uint32_t kMostNarrow = 0xFFFF;
  std::vector<FineDemand> demands;
  demands.reserve(numbers.size() / kDemandNumbers);
  for (std::size_t i = 0; i < numbers.size(); i += kDemandNumbers) {
    const auto at = std::span(numbers).subspan(i, kDemandNumbers);
    const bool is_narrow = std::ranges::all_of(
        at.subspan(2), [](std::uint32_t number) { return number <= kMostNarrow; });
    const auto as_byte = [](std::uint32_t number) {
      return static_cast<std::uint8_t>(std::min<std::uint32_t>(number, 0xFF));
    };
    const FineDemand demand{{at[0], at[1], as_byte(at[2]), static_cast<std::uint16_t>(at[3]),
                             static_cast<std::uint16_t>(at[4])},
                            as_byte(at[5])};
    if (!is_narrow || !is_demand_on(control, demand)) {
      return fail(
          ErrorKind::kBadInput,
          fmt::format("/demands/{}: is no demand on a face of the mesh: face {}, corner {}, "
                      "level {}, column {}, row {}, depth {}.",
                      i, at[0], at[1], at[2], at[3], at[4], at[5]),
          source);
    }
    demands.push_back(demand);
  }
  return FineDemands(demands);
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
  Result<FineDemands> demands = read_demands(text.demands, *document.control, source);
  if (!demands) {
    return tl::unexpected(std::move(demands.error()));
  }
  document.demands = *std::move(demands);
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

/// Text that was cut short or changed since it was saved is refused, whatever it says.
std::optional<Error> check_sum(std::string_view bytes, const ProjectText& text,
                               const std::string& source) {
  FieldReader fields(text.fields, source);
  if (fields.find("/checksum") != nullptr && !fits_checksum(bytes, fields.text("/checksum"))) {
    fields.complain(
        "/checksum",
        "does not fit: the file was damaged or changed after it was saved. If you changed "
        "it yourself, remove the checksum to open it.");
  }
  return fields.error();
}

}  // namespace

Result<Project> parse_project(std::string_view bytes, const std::string& source) {
  Result<ProjectText> text = parse_project_text(bytes, source);
  if (!text) {
    return tl::unexpected(std::move(text.error()));
  }
  if (std::optional<Error> error = check_format(*text, source)) {
    return tl::unexpected(*std::move(error));
  }
  if (std::optional<Error> error = check_sum(bytes, *text, source)) {
    return tl::unexpected(*std::move(error));
  }
  if (text->misfit) {
    return tl::unexpected(*std::move(text->misfit));
  }
  Result<Header> header = read_header(*text, source);
  if (!header) {
    return tl::unexpected(std::move(header.error()));
  }
  return assemble(*std::move(text), *std::move(header), source);
}

}  // namespace limn
