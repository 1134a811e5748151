#pragma once

#include "render/context/gl_context.h"

namespace limn::render {

/// EGL without any surface: Mesa's surfaceless platform, else the first EGL device (a GPU of a
/// server without a display). libEGL is opened with dlopen.
class EglSurfacelessContext final : public GlContext {
 public:
  /// Does not make it current. Throws EnvironmentError.
  EglSurfacelessContext();
  ~EglSurfacelessContext() override;

  void make_current() override;
  [[nodiscard]] std::string_view name() const noexcept override { return "EGL"; }

 private:
  struct Library;
  [[nodiscard]] static const Library& library();

  const Library& egl_;
  void* display_ = nullptr;
  void* context_ = nullptr;
};

}  // namespace limn::render
