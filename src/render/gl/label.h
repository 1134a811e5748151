#pragma once

#include <string_view>

#include <glad/gl.h>

namespace limn::render::gl {

/// Names an object for debuggers and for the driver's messages. `identifier` is the namespace of
/// the id (GL_BUFFER, GL_TEXTURE, ...). An empty name does nothing.
void set_label(GLenum identifier, GLuint id, std::string_view name);

}  // namespace limn::render::gl
