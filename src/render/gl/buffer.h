#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "limn/contract.h"
#include "render/gl/handle.h"

namespace limn::render::gl {

void delete_buffer(GLuint id);

/// A run of bytes in the GPU's memory. Grows by `upload` and `resize`, never shrinks its
/// allocation, so that re-uploading something of about the same size allocates nothing.
class Buffer {
 public:
  /// Empty: id 0, no memory. Every other member function needs a created buffer.
  Buffer() noexcept = default;
  [[nodiscard]] static Buffer create(std::string_view label);

  /// Replaces the contents; the size becomes that of `bytes`.
  void upload_bytes(std::span<const std::byte> bytes);
  /// Replaces part of the contents, within the size.
  void write_bytes(std::size_t offset, std::span<const std::byte> bytes);
  /// Sets the size; contents are undefined afterwards where it grew beyond what was allocated.
  /// Throws EnvironmentError where there is not that much memory.
  void resize(std::size_t bytes);
  /// Sets every byte of the contents to 0.
  void clear();
  /// Copies part of the contents back, waiting for the GPU.
  void read_bytes(std::size_t offset, std::span<std::byte> out) const;

  template <class T>
  void upload(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    upload_bytes(std::as_bytes(values));
  }
  template <class T>
  void upload(const std::vector<T>& values) {
    upload(std::span<const T>(values));
  }
  template <class T>
  void write(std::size_t offset, std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    write_bytes(offset, std::as_bytes(values));
  }
  /// The whole contents as values of T; the size must be a multiple of sizeof(T).
  template <class T>
  [[nodiscard]] std::vector<T> read() const {
    static_assert(std::is_trivially_copyable_v<T>);
    LIMN_EXPECTS(size_ % sizeof(T) == 0);
    std::vector<T> values(size_ / sizeof(T));
    read_bytes(0, std::as_writable_bytes(std::span(values)));
    return values;
  }

  /// Binds the contents for shaders: `layout(std430, binding = slot) buffer`. Binding an empty
  /// content unbinds the slot, since OpenGL has no ranges of length 0.
  void bind_storage(GLuint slot) const;
  /// `layout(std140, binding = slot) uniform`.
  void bind_uniform(GLuint slot) const;
  /// Binds as the source of indirect draw commands.
  void bind_draw_indirect() const;

  [[nodiscard]] GLuint id() const noexcept { return handle_.id(); }
  [[nodiscard]] explicit operator bool() const noexcept { return static_cast<bool>(handle_); }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }

 private:
  Handle<delete_buffer> handle_;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

}  // namespace limn::render::gl
