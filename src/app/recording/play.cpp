#include "app/recording/play.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <glad/gl.h>

#include "app/fonts.h"
#include "app/offscreen.h"
#include "app/window.h"
#include "render/context/load_gl.h"
#include "render/gl/framebuffer.h"
#include "render/gl/texture.h"
#include "render/png.h"

namespace limn::app {
namespace {

WorkbenchHost host_of(Player& player) {
  WorkbenchHost host = player.host();
  host.fonts = load_fonts();
  return host;
}

void prepare(Workbench& workbench, const Player& player) {
  workbench.session().set_memory_budget(player.head().memory_budget);
}

Played played(const Player& player, const Workbench& workbench) {
  Played result{player.report(), workbench.session().document(), workbench.session().view()};
  result.has_same_fonts = checksum_of(load_fonts()) == player.head().fonts;
  return result;
}

/// A picture of the recorded screen's size to draw into.
struct Canvas {
  render::gl::Texture colour;
  render::gl::Framebuffer framebuffer;
  render::FramebufferSize size;

  void resize(const render::FramebufferSize& wanted) {
    if (size == wanted) {
      return;
    }
    size = wanted;
    framebuffer = render::gl::Framebuffer::create("recorded window");
    colour = render::gl::Texture::create_2d({size.width, size.height}, GL_RGBA8, "recorded window");
    framebuffer.attach(GL_COLOR_ATTACHMENT0, colour);
  }
};

/// As large as it fits, in the middle of the window.
void show(const Canvas& canvas, Window& window) {
  const render::FramebufferSize room = window.framebuffer_size();
  const double scale = std::min({1.0, static_cast<double>(room.width) / canvas.size.width,
                                 static_cast<double>(room.height) / canvas.size.height});
  const int width = static_cast<int>(canvas.size.width * scale);
  const int height = static_cast<int>(canvas.size.height * scale);
  const int left = (room.width - width) / 2;
  const int low = (room.height - height) / 2;
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, room.width, room.height);
  glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  glBlitNamedFramebuffer(canvas.framebuffer.id(), 0, 0, 0, canvas.size.width, canvas.size.height,
                         left, low, left + width, low + height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
  window.swap_buffers();
}

/// Whether the person wants no more.
bool is_stopped(Window& window) {
  bool is_escape = false;
  while (window.input().has_pending()) {
    const ui::InputFrame input = window.input().next_frame();
    is_escape |= std::ranges::any_of(
        input.presses, [](const ui::KeyPress& press) { return press.key == ui::Key::kEscape; });
  }
  return is_escape || window.take_close_request();
}

}  // namespace

Result<Played> play_headless(Recording recording, const PlayOptions& options, Progress& progress) {
  Player player(std::move(recording));
  player.set_pictures_folder(options.pictures);
  player.set_patience(options.patience);
  auto project = player.open_first();
  if (!project) {
    return tl::unexpected(std::move(project.error()));
  }
  Offscreen offscreen(host_of(player), player.head().preferences, *std::move(project),
                      player.screen());
  const std::string renderer = render::renderer_text();
  player.set_renderer(renderer);
  prepare(offscreen.workbench(), player);
  const std::size_t turns = player.turns();
  while (!player.is_at_end()) {
    player.play_turn(offscreen.workbench(),
                     [&](const ui::InputFrame& input, const Screen& screen, double now) {
                       offscreen.set_screen(screen);
                       return offscreen.frame(input, now);
                     });
    const double done = static_cast<double>(player.report().turns) / static_cast<double>(turns);
    if (!progress.report(done, "Playing")) {
      return fail(ErrorKind::kCancelled, "Stopped.");
    }
  }
  if (!options.pictures.empty()) {
    if (auto written = render::write_png(options.pictures / "end.png", offscreen.picture());
        !written) {
      return tl::unexpected(std::move(written.error()));
    }
  }
  Played result = played(player, offscreen.workbench());
  result.compared_pictures = renderer == player.head().renderer;
  return result;
}

Result<Played> play_in_window(Recording recording, double speed) {
  Player player(std::move(recording));
  auto project = player.open_first();
  if (!project) {
    return tl::unexpected(std::move(project.error()));
  }
  const Screen& recorded = player.screen();
  Window window({.title = "Limn: played back",
                 .size = {recorded.framebuffer.width / 1.0, recorded.framebuffer.height / 1.0}});
  Workbench workbench(host_of(player), player.head().preferences, *std::move(project), recorded);
  workbench.build_graphics();
  prepare(workbench, player);
  Canvas canvas;
  const double began = Window::now();
  const double first = player.is_at_end() ? 0.0 : player.next_time();
  bool is_over = false;
  while (!is_over && !player.is_at_end()) {
    const double wait = (player.next_time() - first) / speed - (Window::now() - began);
    if (wait > 0.0) {
      window.wait_events(wait);
    } else {
      window.poll_events();
      player.play_turn(workbench,
                       [&](const ui::InputFrame& input, const Screen& screen, double now) {
                         canvas.resize(screen.framebuffer);
                         return workbench.frame(input, screen, now, canvas.framebuffer.id());
                       });
    }
    is_over = is_stopped(window);
    if (canvas.framebuffer) {
      show(canvas, window);
    }
  }
  return played(player, workbench);
}

}  // namespace limn::app
