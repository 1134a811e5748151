#include "cli/view_options.h"

#include <charconv>
#include <memory>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "render/camera.h"
#include "render/context/gl_context.h"
#include "render/named_views.h"
#include "render/picking/face_picker.h"
#include "render/surface/surface.h"
#include "render/surface/surface_buffers.h"

namespace limn::cli {
namespace {

constexpr int kLargestSide = 16384;

std::optional<int> read_side(std::string_view text) {
  int side = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), side);
  if (error != std::errc{} || end != text.data() + text.size() || side < 1 || side > kLargestSide) {
    return std::nullopt;
  }
  return side;
}

render::FramebufferSize read_size(const std::string& text) {
  const std::size_t cross = text.find('x');
  const auto width = read_side(std::string_view(text).substr(0, cross));
  const auto height = cross == std::string::npos
                          ? std::nullopt
                          : read_side(std::string_view(text).substr(cross + 1));
  if (!width || !height) {
    throw CLI::ValidationError(
        "--size",
        fmt::format("\"{}\" is not WIDTHxHEIGHT in pixels, each 1 to {}", text, kLargestSide));
  }
  return {*width, *height};
}

std::string view_words() {
  std::vector<std::string_view> names;
  for (const render::NamedView view : render::all_named_views()) {
    names.push_back(render::view_name(view));
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

void add_view_options(CLI::App& command, ViewOptions& options) {
  command
      .add_option("--view", options.view_name,
                  "Look from a named side, with all of the mesh in the picture: " + view_words())
      ->type_name("NAME")
      ->check([](const std::string& name) {
        const auto view = render::parse_view_name(name);
        return view ? std::string{} : to_string(view.error());
      });
  command
      .add_option("--camera", options.camera_file,
                  "Look from where a camera file says (JSON, as the view of a project)")
      ->type_name("FILE")
      ->excludes("--view");
  command
      .add_option_function<std::string>(
          "--size", [&options](const std::string& text) { options.size = read_size(text); },
          "Size of the picture in pixels")
      ->type_name("WxH")
      ->default_str(fmt::format("{}x{}", options.size.width, options.size.height));
}

Result<ViewState> resolve_view(const ViewOptions& options, const Project& project) {
  if (!options.camera_file.empty()) {
    return load_view(options.camera_file);
  }
  const auto frame = [&](render::NamedView direction) {
    return render::named_view(direction, project.document.control->positions(),
                              options.size.aspect());
  };
  if (!options.view_name.empty()) {
    return render::parse_view_name(options.view_name).map(frame);
  }
  return project.view.value_or(frame(render::NamedView::kThreeQuarter));
}

MakePaintContext paint_context_from(const ViewOptions& options) {
  return [options](const Project& project) {
    PaintContext context;
    context.visible = [options, &project]() -> Result<std::vector<std::uint32_t>> {
      const Result<ViewState> view = resolve_view(options, project);
      if (!view) {
        return tl::unexpected(view.error());
      }
      const ControlMesh& control = *project.document.control;
      const std::unique_ptr<render::GlContext> context_of_gl = render::create_headless_context();
      render::SurfaceBuffers surface;
      if (auto uploaded = surface.upload(render::make_surface(control), 1); !uploaded) {
        return tl::unexpected(std::move(uploaded.error()));
      }
      const render::Camera camera = render::make_camera(*view, control.bounds(), options.size);
      render::FacePicker picker;
      return picker.visible_faces({surface, camera});
    };
    context.views = [options, &project](const std::string& name) {
      const Result<ViewState> view =
          name.empty() ? resolve_view(options, project) : load_view(name);
      return view.map([&](const ViewState& state) {
        return render::screen_view(
            render::make_camera(state, project.document.control->bounds(), options.size));
      });
    };
    return context;
  };
}

}  // namespace limn::cli
