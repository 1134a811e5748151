#pragma once

#include <memory>

#include "render/context/gl_context.h"

namespace limn::render {

/// Mesa's off-screen context, opened with dlopen: the same pixels on every machine with the same
/// Mesa, so the golden images are drawn with it.
class OsmesaContext final : public GlContext {
 public:
  /// Does not make it current. Throws EnvironmentError.
  OsmesaContext();
  ~OsmesaContext() override;

  void make_current() override;
  [[nodiscard]] std::string_view name() const noexcept override { return "OSMesa"; }

 private:
  struct Library;
  [[nodiscard]] static const Library& library();

  void* context_ = nullptr;
  /// OSMesa wants memory to call the window.
  alignas(16) unsigned char pixel_[4] = {};
};

}  // namespace limn::render
