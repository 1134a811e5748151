#pragma once

#include <utility>

#include <glad/gl.h>

namespace limn::render::gl {

/// The name of one OpenGL object and the duty to delete it: move-only, id 0 is empty.
///
/// `Delete` is the function that deletes one name; it also tells kinds of objects apart, so that a
/// buffer's handle is never taken for a texture's. An empty handle calls nothing and needs no
/// context; a full one must die while its context is current.
template <void (*Delete)(GLuint)>
class Handle {
 public:
  Handle() noexcept = default;
  explicit Handle(GLuint id) noexcept : id_(id) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    if (this != &other) {
      reset();
      id_ = std::exchange(other.id_, 0);
    }
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { reset(); }

  [[nodiscard]] GLuint id() const noexcept { return id_; }
  [[nodiscard]] explicit operator bool() const noexcept { return id_ != 0; }

  void reset() noexcept {
    if (id_ != 0) {
      Delete(std::exchange(id_, 0));
    }
  }

 private:
  GLuint id_ = 0;
};

}  // namespace limn::render::gl
