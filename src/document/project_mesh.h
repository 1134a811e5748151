#pragma once

#include <optional>
#include <string>

#include "field_reader.h"
#include "json_lists.h"
#include "json_writer.h"
#include "limn/error.h"
#include "limn/mesh/build.h"
#include "limn/mesh/creases.h"

// A control mesh in a project file: `mesh` and `opened_mesh`.
namespace limn {

/// Whether a mesh has anything that the first version of the format has no words for.
[[nodiscard]] bool has_attributes(const ControlMesh& mesh);
/// Whether it has what the fourth brought: names of faces, vertices in no face.
[[nodiscard]] bool has_names(const ControlMesh& mesh);

/// Writes the mesh as a JSON object, a position and a face a line.
void write_project_mesh(JsonWriter& writer, const ControlMesh& mesh);

/// The members of a mesh that are no long lists.
struct MeshRules {
  CreasingMethod creasing = CreasingMethod::kUniform;
  std::optional<CornerRule> corners;
};

/// Reads them, and complains of lists that are missing or do not fit each other. `path` is "/mesh"
/// or "/opened_mesh".
[[nodiscard]] MeshRules read_mesh_rules(FieldReader& fields, const std::string& path,
                                        const MeshLists& lists);

/// Builds the mesh of lists that `read_mesh_rules` had no complaint about.
/// Errors: kBadInput, also for whatever an import would mend: what was painted belongs to the mesh
/// as it was saved.
[[nodiscard]] Result<ImportedMesh> build_project_mesh(const std::string& path, MeshLists lists,
                                                      const MeshRules& rules,
                                                      const std::string& source);

/// How corner rules are called, here and in the settings.
inline constexpr std::array<Named<CornerRule>, 2> kCornerRules{
    {{"sharp", CornerRule::kSharp}, {"smooth", CornerRule::kSmooth}}};

}  // namespace limn
