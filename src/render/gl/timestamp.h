#pragma once

#include "render/gl/handle.h"

namespace limn::render::gl {

void delete_query(GLuint id);

/// A moment on the GPU's own clock.
class Timestamp {
 public:
  /// Empty: id 0.
  Timestamp() noexcept = default;
  [[nodiscard]] static Timestamp create();

  /// The moment when the GPU has done all that was asked of it before.
  void record() const;
  /// The moment last recorded, in seconds from some start. Waits for it.
  [[nodiscard]] double seconds() const;

 private:
  Handle<delete_query> handle_;
};

}  // namespace limn::render::gl
