// limn_gpu_bench [--faces=N,N,...] [--size=WxH] [--repeat=N]
// What this machine's GPU does: how fast it refines, draws what it refined, and finds what is under
// the pointer. Prints a page of Markdown. Medians of N runs, each waited for.
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glad/gl.h>

#include "limn/mesh/build.h"
#include "limn/subdivision/label_subdivision.h"
#include "meshes.h"
#include "paintings.h"
#include "render/context/gl_context.h"
#include "render/environment_error.h"
#include "render/mesh_renderer.h"
#include "render/named_views.h"
#include "render/navigation.h"
#include "render/picking/face_picker.h"
#include "render/refinement/gpu_refiner.h"

namespace limn::bench {
namespace {

using render::FramebufferSize;

struct Options {
  std::vector<std::uint64_t> faces{1'000'000, 10'000'000, 50'000'000};
  FramebufferSize size{1920, 1080};
  int repeat = 9;
};

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

/// Seconds that `work` and what it asks of the GPU take: the median of some runs, after one that
/// does not count.
double time_of(int repeat, const std::function<void()>& work) {
  std::vector<double> seconds;
  for (int run = -1; run < repeat; ++run) {
    glFinish();
    const auto start = std::chrono::steady_clock::now();
    work();
    glFinish();
    if (run >= 0) {
      seconds.push_back(
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
  }
  return median(std::move(seconds));
}

/// "12.3 M" faces a second.
std::string rate(double faces, double seconds) {
  return fmt::format("{:.1f}", faces / seconds * 1e-6);
}

std::string milliseconds(double seconds) {
  return fmt::format("{:.3g}", seconds * 1e3);
}

bool has_extension(std::string_view name) {
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i) {
    const auto* text = reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, GLuint(i)));
    if (text != nullptr && name == text) {
      return true;
    }
  }
  return false;
}

/// Memory of the device that is free, where the driver tells.
std::optional<std::uint64_t> free_bytes() {
  constexpr GLenum kNvidiaAvailable = 0x9049;  // GL_GPU_MEMORY_INFO_CURRENT_AVAILABLE_VIDMEM_NVX
  constexpr GLenum kAmdFree = 0x87FC;          // GL_TEXTURE_FREE_MEMORY_ATI
  GLint kilobytes[4] = {};
  if (has_extension("GL_NVX_gpu_memory_info")) {
    glGetIntegerv(kNvidiaAvailable, kilobytes);
  } else if (has_extension("GL_ATI_meminfo")) {
    glGetIntegerv(kAmdFree, kilobytes);
  } else {
    return std::nullopt;
  }
  return std::uint64_t(std::uint32_t(kilobytes[0])) << 10U;
}

/// Why so many faces cannot be held; empty where they can. Each takes 16 bytes of corners, 4 of
/// record, and as a vertex 12 of position and 12 of normal.
std::string refusal(std::uint64_t faces) {
  constexpr std::uint64_t kBytes = 44;
  GLint64 most = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
  if (16 * faces > std::uint64_t(most)) {
    return fmt::format("their corners take {} MB; GL_MAX_SHADER_STORAGE_BLOCK_SIZE is {} MB",
                       16 * faces >> 20U, most >> 20U);
  }
  const std::optional<std::uint64_t> free = free_bytes();
  if (free && kBytes * faces > *free) {
    return fmt::format("they take {} MB; the device has {} MB free", kBytes * faces >> 20U,
                       *free >> 20U);
  }
  return {};
}

/// A closed torus of about `faces` quads, gently bumpy.
std::shared_ptr<const ControlMesh> torus(std::uint64_t faces) {
  const auto n = static_cast<std::uint32_t>(std::max(3.0, std::round(std::sqrt(double(faces)))));
  PolygonSoup soup;
  constexpr double kTurn = 6.283185307179586;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      const double u = kTurn * i / n;
      const double v = kTurn * j / n;
      const double tube = 0.4 + 0.03 * std::sin(5.0 * u) * std::cos(7.0 * v);
      const double out = 1.0 + tube * std::cos(v);
      soup.positions.emplace_back(out * std::cos(u), tube * std::sin(v), out * -std::sin(u));
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = (i + 1) % n;
      const std::uint32_t b = (j + 1) % n;
      soup.add_face(std::vector<std::uint32_t>{i * n + j, i * n + b, a * n + b, a * n + j});
    }
  }
  return build_control_mesh(soup).value().mesh;
}

/// One for the whole program.
struct Stage {
  render::GpuRefiner refiner;
  render::SurfaceBuffers surface;
  IgnoreProgress progress;

  Result<render::GpuRefinement> refine(const ControlMesh& mesh, const VertexLabels& labels,
                                       bool normals) {
    RefineLimits limits;
    limits.normals = normals;
    return refiner.refine({mesh, labels, {}, limits}, progress, surface);
  }
};

/// A line of the table of rates.
void report_refinement(Stage& stage, const Options& options, const std::string& name,
                       const ControlMesh& mesh, const VertexLabels& labels, bool normals) {
  const std::uint64_t faces = predict_refinement(mesh, labels).faces;
  if (const std::string why = refusal(faces); !why.empty()) {
    fmt::print("| {} | {} | refused: {} | | | | |\n", name, faces, why);
    return;
  }
  std::vector<double> plan;
  std::vector<double> upload;
  std::vector<double> gpu;
  for (int run = -1; run < options.repeat; ++run) {
    if (auto done = stage.refine(mesh, labels, normals); !done) {
      fmt::print("| {} | {} | refused: {} | | | | |\n", name, faces, done.error().message);
      return;
    }
    const render::GpuRefinementTimes times = stage.refiner.times();
    if (run >= 0) {
      plan.push_back(times.plan);
      upload.push_back(times.upload);
      gpu.push_back(times.gpu);
    }
  }
  const double on_gpu = median(gpu);
  const double all = median(plan) + median(upload) + on_gpu;
  fmt::print("| {} | {} | {} | {} | {} | {} | {} |\n", name, faces, milliseconds(median(plan)),
             milliseconds(median(upload)), milliseconds(on_gpu),
             rate(static_cast<double>(faces), on_gpu), rate(static_cast<double>(faces), all));
}

void report_refinements(Stage& stage, const Options& options) {
  const std::uint64_t most = std::ranges::max(options.faces);
  fmt::print(
      "\n## Refinement\n\nFrom legal labels to a surface that can be drawn; the second rate counts "
      "the CPU's part, too.\n\n| mesh | faces | plan, ms | upload, ms | GPU, ms | M faces/s on the "
      "GPU | M faces/s in all |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: |\n");
  for (const char* name : {"creature", "asteroid_15k", "asteroid_61k", "asteroid_246k"}) {
    const ControlMesh& mesh = control_mesh(name);
    for (int level = 1; level <= kMaxDepth && mesh.face_count() << 2 * level <= most; ++level) {
      const VertexLabels labels(mesh.vertex_count(), static_cast<std::uint8_t>(level));
      const std::string title = fmt::format("{}, {} level{}", name, level, level == 1 ? "" : "s");
      report_refinement(stage, options, title, mesh, labels, false);
      if (mesh.face_count() << 2 * (level + 1) > most) {
        report_refinement(stage, options, title + ", normals", mesh, labels, true);
      }
    }
  }
  const ControlMesh& painted = control_mesh("asteroid_61k");
  for (const Painting& painting : deepest_paintings()) {
    const VertexLabels labels = legal_labels_of(painted, painting);
    if (predict_refinement(painted, labels).faces <= most) {
      report_refinement(stage, options, "asteroid_61k, " + path_of(painting), painted, labels,
                        false);
    }
  }
}

/// Draws and picks a surface of about so many faces.
void report_surface(Stage& stage, const Options& options, std::uint64_t faces) {
  int level = 0;
  while (level < 6 && faces >> 2 * (level + 1) >= 1000) {
    ++level;
  }
  const std::shared_ptr<const ControlMesh> mesh = torus(faces >> 2 * level);
  const VertexLabels labels(mesh->vertex_count(), static_cast<std::uint8_t>(level));
  const std::uint64_t count = mesh->face_count() << 2 * level;
  if (const std::string why = refusal(count); !why.empty()) {
    fmt::print("| {} | refused: {} | | | | | |\n", count, why);
    return;
  }
  if (auto done = stage.refine(*mesh, labels, true); !done) {
    fmt::print("| {} | refused: {} | | | | | |\n", count, done.error().message);
    return;
  }
  render::FacePaint paint;
  paint.reset(std::vector<std::uint8_t>(mesh->face_count(), static_cast<std::uint8_t>(level)));
  render::Scene scene;
  scene.surface = &stage.surface;
  scene.paint = &paint;
  render::RenderTarget target;
  target.resize({options.size.width, options.size.height});
  render::MeshRenderer renderer;
  ViewState view = render::default_view(mesh->bounds(), options.size.aspect());
  const auto camera = [&] { return make_camera(view, mesh->bounds(), options.size); };
  const auto draw_time = [&](render::Shading shading, bool has_wireframe) {
    render::DrawSettings settings;
    settings.shading = shading;
    settings.has_wireframe = has_wireframe;
    return time_of(options.repeat, [&] {
      view = render::orbit(view, 0.01, 0.0);
      renderer.draw(target, camera(), scene, settings);
    });
  };
  const double flat = draw_time(render::Shading::kFlat, false);
  const double smooth = draw_time(render::Shading::kSmooth, true);

  render::FacePicker picker;
  const render::FramebufferPoint middle{0.5 * options.size.width, 0.62 * options.size.height};
  const double redraw = time_of(options.repeat, [&] {
    view = render::orbit(view, 0.01, 0.0);
    (void)picker.pick({stage.surface, camera()}, middle);
  });
  const double pick = time_of(options.repeat, [&] {
    (void)picker.pick({stage.surface, camera()}, middle);
  });
  const double brush = time_of(options.repeat, [&] {
    (void)picker.brush({stage.surface, camera()}, {middle, middle, 20.0});
  });
  const double visible = time_of(options.repeat, [&] {
    (void)picker.visible_faces({stage.surface, camera()});
  });
  fmt::print("| {} | {} ({}) | {} ({}) | {} | {} | {} | {} |\n", count, milliseconds(flat),
             rate(static_cast<double>(count), flat), milliseconds(smooth),
             rate(static_cast<double>(count), smooth), milliseconds(redraw), milliseconds(pick),
             milliseconds(brush), milliseconds(visible));
}

void report_surfaces(Stage& stage, const Options& options) {
  fmt::print(
      "\n## Drawing and picking\n\nA refined torus, {} by {} pixels, from a new side in every "
      "picture; ms, and M faces/s in brackets. Picking draws the image of faces where the side is "
      "new, and answers from it where the picture is still.\n\n| faces | draw, flat | draw, smooth "
      "with wireframe | pick, new side | pick, still | brush of 20 pixels | all visible |\n| ---: "
      "| "
      "---: | ---: | ---: | ---: | ---: | ---: |\n",
      options.size.width, options.size.height);
  for (const std::uint64_t faces : options.faces) {
    report_surface(stage, options, faces);
  }
}

template <class T>
bool read_number(std::string_view& text, T& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return error == std::errc() && number > 0;
}

/// Nothing where an argument is not understood.
std::optional<Options> read_arguments(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    std::string_view text = argv[i];
    const std::string_view name = text.substr(0, text.find('=') + 1);
    text.remove_prefix(name.size());
    bool is_read = false;
    if (name == "--faces=") {
      options.faces.clear();
      do {
        is_read = read_number(text, options.faces.emplace_back());
        text.remove_prefix(text.starts_with(',') ? 1 : 0);
      } while (is_read && !text.empty());
    } else if (name == "--size=") {
      is_read = read_number(text, options.size.width) && text.starts_with('x');
      text.remove_prefix(is_read ? 1 : 0);
      is_read = is_read && read_number(text, options.size.height);
    } else if (name == "--repeat=") {
      is_read = read_number(text, options.repeat);
    }
    if (!is_read || !text.empty()) {
      return std::nullopt;
    }
  }
  return options;
}

void report(const Options& options) {
  const std::unique_ptr<render::GlContext> context = render::create_headless_context();
  const std::optional<std::uint64_t> free = free_bytes();
  GLint64 most = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
  fmt::print("# What the GPU does\n\n| | |\n|---|---|\n| Renderer | {} |\n| OpenGL | {} ({}) |\n",
             context->info().renderer, context->info().version, context->name());
  fmt::print("| Free memory | {} |\n| Largest buffer a shader sees | {} MB |\n| Runs | {} |\n",
             free ? fmt::format("{} MB", *free >> 20U) : "not told", most >> 20U, options.repeat);
  Stage stage;
  report_refinements(stage, options);
  report_surfaces(stage, options);
}

}  // namespace
}  // namespace limn::bench

int main(int argc, char** argv) {
  try {
    const std::optional<limn::bench::Options> options = limn::bench::read_arguments(argc, argv);
    if (!options) {
      fmt::print(stderr, "limn_gpu_bench [--faces=N,N,...] [--size=WxH] [--repeat=N]\n");
      return 2;
    }
    limn::bench::report(*options);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "limn_gpu_bench: {}\n", error.what());
    return 1;
  }
}
