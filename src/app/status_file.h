#pragma once

#include <filesystem>
#include <span>

#include "app/viewport_frame.h"
#include "limn/error.h"
#include "render/camera.h"
#include "ui/gui.h"

namespace limn::app {

class Session;

/// What a status file tells.
struct Status {
  const Session& session;
  std::span<const ui::ItemRect> items;
  const ViewportPlace& place;
  ui::WindowSize window;
  render::FramebufferSize framebuffer;
  render::Camera camera;
};

/// Writes the state of the window as JSON, atomically: what whoever drives it from outside (the
/// end-to-end tests) needs to know to aim the mouse and to wait for an effect instead of for time.
/// Errors: kFailed.
[[nodiscard]] Result<void> write_status_file(const std::filesystem::path& path,
                                             const Status& status);

}  // namespace limn::app
