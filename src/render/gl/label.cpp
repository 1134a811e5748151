#include "render/gl/label.h"

#include <algorithm>

namespace limn::render::gl {

void set_label(GLenum identifier, GLuint id, std::string_view name) {
  // The shortest limit that OpenGL lets a driver set for labels is 256 characters.
  const auto length = static_cast<GLsizei>(std::min<std::size_t>(name.size(), 255));
  if (length > 0) {
    glObjectLabel(identifier, id, length, name.data());
  }
}

}  // namespace limn::render::gl
