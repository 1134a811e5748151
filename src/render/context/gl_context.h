#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "render/context/load_gl.h"

namespace limn::render {

/// An OpenGL 4.5 core context without a window. Its own framebuffer is of no use: draw into a
/// gl::Framebuffer.
///
/// The functions of OpenGL are process-wide pointers: use contexts from one thread at a time, and
/// let every GL object die while the context it was made in is current.
class GlContext {
 public:
  GlContext() = default;
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;
  virtual ~GlContext() = default;

  /// Makes this the current context of the calling thread and loads the functions of OpenGL from
  /// it. Throws EnvironmentError.
  virtual void make_current() = 0;
  /// "EGL", "OSMesa".
  [[nodiscard]] virtual std::string_view name() const noexcept = 0;
  /// What the driver says of itself; filled by the first `make_current`.
  [[nodiscard]] const GlInfo& info() const noexcept { return info_; }

 protected:
  void set_info(GlInfo info) { info_ = std::move(info); }

 private:
  GlInfo info_;
};

enum class HeadlessKind {
  kAny,     ///< EGL, else OSMesa.
  kEgl,     ///< EGL without a surface: what a server with a GPU has.
  kOsmesa,  ///< Mesa's off-screen software renderer.
};

/// Creates a context and makes it current. With kAny the environment variable LIMN_HEADLESS, `egl`
/// or `osmesa`, decides.
/// Throws EnvironmentError that says what was tried, why each failed and what to install.
[[nodiscard]] std::unique_ptr<GlContext> create_headless_context(
    HeadlessKind kind = HeadlessKind::kAny);

}  // namespace limn::render
