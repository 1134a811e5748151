#pragma once

#include <span>
#include <string_view>

#include "limn/error.h"
#include "limn/mesh/build.h"

namespace limn {

/// A mesh that is compiled into the program: there wherever it is started from.
struct BundledMesh {
  std::string_view name;         ///< What the user calls it: "creature", "teapot", "cube".
  std::string_view obj_text;     ///< Its OBJ file.
  std::string_view description;  ///< One sentence for menus and help.
};

/// The mesh the program opens where it is given none.
inline constexpr std::string_view kDefaultMesh = "creature";

/// All of them, the default first, in the order menus show them.
[[nodiscard]] std::span<const BundledMesh> bundled_meshes();

/// Imports a bundled mesh by its name.
///
/// Errors: kUsage for a name that is not in the list, naming those that are.
[[nodiscard]] Result<ImportedMesh> load_bundled_mesh(std::string_view name);

}  // namespace limn
