// Time to draw the id image of a large quad mesh, and to answer from it.
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <benchmark/benchmark.h>

#include "cases.h"
#include "render/context/gl_context.h"
#include "render/environment_error.h"
#include "render/named_views.h"
#include "render/navigation.h"
#include "render/picking/face_picker.h"

namespace limn::render {
namespace {

/// n by n quads of a wavy sheet.
Surface wavy_sheet(std::uint32_t n, Bounds& bounds) {
  Surface surface;
  for (std::uint32_t y = 0; y <= n; ++y) {
    for (std::uint32_t x = 0; x <= n; ++x) {
      const double u = 2.0 * x / n - 1.0;
      const double v = 2.0 * y / n - 1.0;
      surface.positions.emplace_back(u, v, 0.1 * std::sin(9.0 * u) * std::cos(7.0 * v));
      surface.normals.emplace_back(0.0F, 0.0F, 1.0F);
    }
  }
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t v = y * (n + 1) + x;
      for (const std::uint32_t corner : {v, v + 1, v + n + 2, v + n + 1}) {
        surface.corners.push_back(corner);
      }
      surface.face_control_faces.push_back(y * n + x);
    }
  }
  surface.control_face_count = surface.face_control_faces.size();
  surface.face_levels.assign(surface.control_face_count, 0);
  surface.groups = {{4, 0, n * n, 0}};
  bounds = {{-1.0, -1.0, -0.1}, {1.0, 1.0, 0.1}};
  return surface;
}

/// A context, the sheet on the GPU and a camera that looks down on it.
struct Stage {
  explicit Stage(std::uint32_t n) : context(create_headless_context()) {
    const Surface surface = wavy_sheet(n, bounds);
    (void)buffers.emplace().upload(surface, 1);
    view = named_view(NamedView::kFront, bounds, 1.0);
    view.pitch = 20.0;
    picker.emplace();
  }
  [[nodiscard]] Camera camera() const { return make_camera(view, bounds, {1024, 1024}); }

  std::unique_ptr<GlContext> context;
  Bounds bounds;
  ViewState view;
  std::optional<SurfaceBuffers> buffers;
  std::optional<FacePicker> picker;
};

constexpr std::uint32_t kSide = 632;  // 399,424 quads.

/// The stage of all cases, set up when the first one runs. Throws EnvironmentError.
Stage& stage() {
  static Stage the_stage(kSide);
  return the_stage;
}

/// Times `calls` calls of `ask`. Without OpenGL the case is left out of the record, saying why.
void time_calls(benchmark::State& state, int calls, const std::function<void(Stage&)>& ask) {
  try {
    ask(stage());  // What is drawn once for a still picture is drawn here.
    state.SetLabel(stage().context->info().renderer);
    bench::time_run(
        state,
        [&] {
          for (int call = 0; call < calls; ++call) {
            ask(stage());
          }
        },
        calls);
    state.counters["faces"] = kSide * kSide;
  } catch (const EnvironmentError& error) {
    state.SkipWithError(error.what());
  }
}

}  // namespace
}  // namespace limn::render

namespace limn::bench {

using render::Stage;

void register_picking(Extent extent) {
  const int repetitions = extent == Extent::kQuick ? 1 : 5;
  add_case("picking/draw", repetitions, [](benchmark::State& state) {
    render::time_calls(state, 1, [](Stage& stage) {
      stage.view.yaw += 0.01;  // A picture that is not drawn yet.
      benchmark::DoNotOptimize(
          stage.picker->pick({*stage.buffers, stage.camera()}, {512.0, 512.0}));
    });
  });
  add_case("picking/pick", repetitions, [](benchmark::State& state) {
    render::time_calls(state, 100, [](Stage& stage) {
      benchmark::DoNotOptimize(
          stage.picker->pick({*stage.buffers, stage.camera()}, {512.0, 512.0}));
    });
  });
  for (const int radius : {5, 20, 100}) {
    add_case(
        "picking/brush_" + std::to_string(radius), repetitions, [radius](benchmark::State& state) {
          render::time_calls(state, 100, [radius](Stage& stage) {
            benchmark::DoNotOptimize(stage.picker->brush(
                {*stage.buffers, stage.camera()}, {{500.0, 500.0}, {520.0, 510.0}, 1.0 * radius}));
          });
        });
  }
  add_case("picking/visible", repetitions, [](benchmark::State& state) {
    render::time_calls(state, 1, [](Stage& stage) {
      benchmark::DoNotOptimize(stage.picker->visible_faces({*stage.buffers, stage.camera()}));
    });
  });
}

}  // namespace limn::bench
