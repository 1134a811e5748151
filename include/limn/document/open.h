#pragma once

#include <string>

#include "limn/document/project_file.h"
#include "limn/error.h"

namespace limn {

/// Opens what a person names: a project (`.limn`), a mesh file, or a bundled mesh by its name
/// ("creature"). A file of that name wins over a bundled mesh.
/// Errors: those of load_project and import_mesh; kBadInput where there is neither, listing the
/// bundled meshes. `settings` are for meshes.
[[nodiscard]] Result<Project> open_document(const std::string& name,
                                            const BuildSettings& settings = {});

}  // namespace limn
