// limn_stroke_bench [--repeat=N]
// How soon a stroke of the brush is seen: from the event of the mouse to the frame that shows the
// refined mesh which follows from it, in the program as it is but for its window. Prints a table of
// Markdown; medians and the worst of N strokes.
#include <algorithm>
#include <charconv>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <exception>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <glad/gl.h>

#include "app/fonts.h"
#include "app/offscreen.h"
#include "limn/document/open.h"
#include "limn/mesh/refined_mesh.h"
#include "render/context/gl_context.h"
#include "render/context/load_gl.h"

namespace limn::bench {
namespace {

using Clock = std::chrono::steady_clock;
using namespace limn::app;

/// The main loop of the program: sleeps until something happens.
class Loop {
 public:
  Loop(const std::string& mesh, int depth)
      : offscreen_({.wake = [this] { wake(); }, .fonts = load_fonts()}, Preferences{},
                   open_document(mesh).value(), {{1280.0, 800.0}, {1280, 800}, {1.0, 1.0}}) {
    Session& session = offscreen_.workbench().session();
    session.perform({ui::ActionId::kSetTargetDepth, depth});
    for (int level = 0; level < depth - 1; ++level) {
      session.perform(ui::ActionId::kRaiseAll);
    }
    rest();
  }

  struct Stroke {
    double seconds = 0.0;
    int frames = 0;  ///< After the one that painted.
  };
  /// One dab in the middle of the viewport, set to the depth, and undone.
  Stroke stroke() {
    const ViewportPlace& place = offscreen_.workbench().place();
    const ui::WindowPoint middle{place.rect.origin.x + place.rect.size.width / 2.0,
                                 place.rect.origin.y + place.rect.size.height / 2.0};
    push(ui::MouseMoved{middle});
    turn();
    rest();
    const auto before = Clock::now();
    push(ui::ButtonChanged{ui::MouseButton::kLeft, true});
    Stroke stroke;
    for (turn(); !offscreen_.workbench().stroke_seconds() || shown_ < before; turn()) {
      ++stroke.frames;
    }
    stroke.seconds = std::chrono::duration<double>(shown_ - before).count();
    push(ui::ButtonChanged{ui::MouseButton::kLeft, false});
    turn();
    rest();
    offscreen_.workbench().session().perform(ui::ActionId::kUndo);
    rest();
    return stroke;
  }

  [[nodiscard]] std::size_t control_faces() {
    return offscreen_.workbench().session().document().control->face_count();
  }
  [[nodiscard]] std::size_t refined_faces() {
    return offscreen_.workbench().session().refinement().refined()->mesh->face_count();
  }
  /// Labels and refinement, as the panel tells them.
  [[nodiscard]] double refining_seconds() {
    const auto result = offscreen_.workbench().session().refinement().status().result;
    return result ? result->legalise_seconds + result->refine_seconds : 0.0;
  }

 private:
  void wake() {
    {
      const std::lock_guard lock(mutex_);
      is_awake_ = true;
    }
    awake_.notify_all();
  }
  void sleep() {
    std::unique_lock lock(mutex_);
    awake_.wait_for(lock, std::chrono::milliseconds(200), [this] { return is_awake_; });
    is_awake_ = false;
  }
  [[nodiscard]] double now() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
  }
  void push(decltype(ui::InputEvent::what) what) { queue_.push({now(), {}, what}); }

  void turn() {
    if (!needs_another_ && !queue_.has_pending()) {
      sleep();
    }
    const double time = now();
    Workbench& workbench = offscreen_.workbench();
    if (workbench.take_news({}, time) || needs_another_ || queue_.has_pending()) {
      const auto seen = workbench.stroke_seconds();
      needs_another_ = offscreen_.frame(queue_.next_frame(), time).needs_another_frame;
      glFinish();
      workbench.note_shown(now());
      if (workbench.stroke_seconds() != seen) {
        shown_ = Clock::now();
      }
    }
  }
  void rest() {
    do {
      turn();
    } while (needs_another_ || queue_.has_pending() || offscreen_.workbench().session().is_busy());
  }

  Clock::time_point start_ = Clock::now();
  Clock::time_point shown_;
  std::mutex mutex_;
  std::condition_variable awake_;
  bool is_awake_ = false;
  bool needs_another_ = true;
  ui::InputQueue queue_;
  Offscreen offscreen_;
};

void measure(const std::string& mesh, int depth, int repeat) {
  Loop loop(mesh, depth);
  std::vector<double> seconds;
  int most_frames = 0;
  for (int i = -1; i < repeat; ++i) {
    const Loop::Stroke stroke = loop.stroke();
    if (i >= 0) {
      seconds.push_back(stroke.seconds);
      most_frames = std::max(most_frames, stroke.frames);
    }
  }
  std::ranges::sort(seconds);
  fmt::print("| {} | {} | {} | {:.0f} | {:.0f} | {:.0f} | {} |\n", mesh, loop.control_faces(),
             loop.refined_faces(), 1e3 * loop.refining_seconds(), 1e3 * seconds[seconds.size() / 2],
             1e3 * seconds.back(), most_frames);
}

}  // namespace
}  // namespace limn::bench

int main(int argc, char** argv) {
  int repeat = 15;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    constexpr std::string_view option = "--repeat=";
    const char* end = argument.data() + argument.size();
    if (!argument.starts_with(option) ||
        std::from_chars(argument.data() + option.size(), end, repeat).ptr != end || repeat < 1) {
      fmt::print(stderr, "limn_stroke_bench [--repeat=N]\n");
      return 2;
    }
  }
  try {
    fmt::print(
        "| mesh | control faces | refined faces | of it refining, ms | median, ms | worst, ms | "
        "frames later |\n"
        "|---|--:|--:|--:|--:|--:|--:|\n");
    for (const int depth : {2, 3, 4}) {
      limn::bench::measure("creature", depth, repeat);
    }
    const auto context = limn::render::create_headless_context();
    fmt::print("\n{}, 1280 x 800.\n", limn::render::renderer_text());
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
