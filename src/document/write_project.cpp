// Written line by line, a position and a face a line, so that a project can be read and compared by
// people. The checksum comes last, when all that it sums up is out.
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "checksum.h"
#include "json_lists.h"
#include "json_writer.h"
#include "limn/document/project_file.h"
#include "project_mesh.h"
#include "project_names.h"
#include "view_json.h"

namespace limn {
namespace {

/// Whether a program that reads version 1 alone would get the whole document.
bool is_plain(const Document& document) {
  const SubdivisionSettings defaults;
  return document.settings.legalisation == LegalisationMethod::kGreedy &&
         document.settings.points == defaults.points &&
         document.settings.texture == defaults.texture && !has_attributes(*document.control) &&
         (document.opened == nullptr || !has_attributes(*document.opened));
}

std::int64_t version_of(const Document& document) {
  if (!document.demands.empty()) {
    return 5;
  }
  if (has_names(*document.control) || (document.opened != nullptr && has_names(*document.opened))) {
    return 4;
  }
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

}  // namespace

void write_project(std::ostream& out, const Document& document,
                   const std::optional<ViewState>& view) {
  JsonWriter writer(out);
  const std::string mesh_path = document.mesh_path.string();
  writer.add(fmt::format("{{\n  \"format\": \"{}\",\n  \"version\": {},\n", kProjectFormat,
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
  if (!document.demands.empty()) {
    writer.add(",\n  \"demands\": ");
    writer.add_list(document.demands.all(), ",\n    ", [](const FineDemand& demand) {
      const FineFace& face = demand.face;
      return fmt::format("{}, {}, {}, {}, {}, {}", face.control_face, face.corner, face.level,
                         face.column, face.row, demand.depth);
    });
  }
  writer.add(",\n  \"mesh\": ");
  write_project_mesh(writer, *document.control);
  if (document.opened != nullptr && document.opened != document.control) {
    writer.add(",\n  \"opened_mesh\": ");
    write_project_mesh(writer, *document.opened);
  }
  writer.add(",\n  ");
  writer.add(checksum_member(writer.checksum()));
}

}  // namespace limn
