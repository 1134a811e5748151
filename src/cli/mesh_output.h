#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/mesh/export.h"
#include "limn/mesh/refined_mesh.h"

namespace CLI {
class App;
}

namespace limn::cli {

/// Where a mesh goes, and how.
struct MeshOutput {
  std::string path;                  ///< `-` is standard output; empty: nowhere.
  std::optional<MeshFormat> format;  ///< Nothing: as the ending says, OBJ on standard output.
  bool is_text = false;              ///< PLY as text.
};

/// Adds --format and --ascii.
void add_format_options(CLI::App& command, MeshOutput& output);

/// Adds -o, for a mesh, and the options above.
void add_output_option(CLI::App& command, MeshOutput& output, bool is_required);

/// A CLI::ValidationError where a mesh cannot be written there: an ending that stands for no format
/// (`others` are taken too, as in " or .limn"), or standard output (`-`) that is to hold JSON too.
void check_output(const MeshOutput& output, bool has_json, std::string_view others = {});

/// Writes a mesh there, and notes on standard error what the format does not hold of it.
[[nodiscard]] Result<void> write_mesh(const MeshOutput& output, const ControlMesh& mesh,
                                      ExportSettings settings = {});
[[nodiscard]] Result<void> write_mesh(const MeshOutput& output, const RefinedMesh& mesh,
                                      ExportSettings settings = {});

}  // namespace limn::cli
