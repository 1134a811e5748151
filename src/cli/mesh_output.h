#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/mesh/refined_mesh.h"

namespace CLI {
class App;
}

namespace limn::cli {

/// Adds -o, for a mesh.
void add_output_option(CLI::App& command, std::string& output, bool is_required);

/// A CLI::ValidationError where a mesh cannot be written there: an ending that is not among
/// `endings`, of which meshes have ".obj"; or standard output (`-`) that is to hold JSON too.
void check_output(const std::string& output, bool has_json, std::string_view endings = ".obj");

/// Writes OBJ text; `-` is standard output. For `depths` see write_obj (mesh/export.h).
[[nodiscard]] Result<void> write_mesh(const std::string& output, const ControlMesh& mesh,
                                      std::span<const std::uint8_t> depths = {});
[[nodiscard]] Result<void> write_mesh(const std::string& output, const RefinedMesh& mesh,
                                      std::span<const std::uint8_t> depths = {});

}  // namespace limn::cli
