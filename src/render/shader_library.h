#pragma once

#include <string>
#include <string_view>

#include "render/gl/shader_program.h"

namespace limn::render {

/// The text of an embedded shader ("mesh.vert.glsl"), with its `#include "file.glsl"` lines
/// replaced by the files they name (each once). The file must be listed in
/// src/render/CMakeLists.txt.
[[nodiscard]] std::string shader_source(std::string_view name);

/// Links the named vertex and fragment shaders. Throws EnvironmentError with the driver's log.
[[nodiscard]] gl::ShaderProgram load_program(std::string_view vertex, std::string_view fragment);

/// Links a compute shader, with a macro defined where one is given. Throws EnvironmentError with
/// the driver's log.
[[nodiscard]] gl::ShaderProgram load_compute_program(std::string_view compute,
                                                     std::string_view macro = {});

}  // namespace limn::render
