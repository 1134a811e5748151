#include "cli/picture.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "app/fonts.h"
#include "app/imgui_renderer.h"
#include "limn/painting/crease_palette.h"
#include "render/context/gl_context.h"
#include "render/mesh_renderer.h"
#include "render/render_target.h"
#include "ui/gui.h"

namespace limn::cli {
namespace {

using Show = PictureSettings::Show;

/// Drawn faces of each level, wherever the surface was made.
ui::DepthCounts level_counts(const render::SurfaceBuffers& surface) {
  constexpr unsigned kLevelShift = 28;  // As in shaders/surface.glsl.
  ui::DepthCounts counts{};
  for (const std::uint32_t face : surface.faces().read<std::uint32_t>()) {
    ++counts[std::min<std::size_t>(face >> kLevelShift, counts.size() - 1)];
  }
  return counts;
}

/// The legend's box, at the same size whatever the picture's, drawn over what the target holds.
void draw_legend_over(const Document& document, const ui::DepthCounts& levels,
                      const PictureSettings& settings, render::FramebufferSize size) {
  const double scale = settings.draw.scale;
  ui::Gui gui(app::load_fonts(), {1.0, scale});
  ui::LegendCounts counts;
  counts.tint = static_cast<ui::Tint>(settings.draw.colour);
  counts.depths = counts.tint == ui::Tint::kLevel ? levels : document.depths.histogram();
  if (settings.distance != nullptr) {
    counts.distance =
        ui::DistanceFigures{settings.distance->to_limit, settings.distance->from_limit,
                            document.control->bounds().diagonal(), settings.distance->is_settled};
  }
  if (settings.has_creases) {
    counts.creases = count_creases(*document.control);
  }
  gui.frame_legend(
      counts, settings.draw.theme == render::Theme::kDark ? ui::Theme::kDark : ui::Theme::kLight,
      {size.width / scale, size.height / scale});
  app::ImguiRenderer renderer;
  renderer.set_atlas(gui.atlas(), gui.atlas_revision());
  renderer.draw(gui.draw_data());
}

}  // namespace

Result<render::Image> draw_document(const Document& document, Derived& derived,
                                    const render::Camera& camera, const PictureSettings& settings) {
  const std::unique_ptr<render::GlContext> context = render::create_headless_context();
  const ControlMesh& control = *document.control;
  // The control mesh stands for the refined one where nothing is painted.
  const bool refines_here =
      settings.on_gpu && settings.on_gpu->levels > 0 && derived.labels.prediction.levels > 0;
  const bool draws_refined =
      settings.show != Show::kControl && (derived.refinement || refines_here);

  const render::Surface control_surface = render::make_surface(control);
  render::SurfaceBuffers control_buffers;
  if (auto uploaded = control_buffers.upload(control_surface, 1); !uploaded) {
    return tl::unexpected(std::move(uploaded.error()));
  }
  render::SurfaceBuffers refined_buffers;
  render::NumberedFaces numbered;
  std::vector<render::CreaseLine> refined_lines;
  if (draws_refined && refines_here) {
    Result<GpuDrawing> drawing = refine_on_gpu(
        document, derived.labels,
        {*settings.on_gpu, settings.draw.shading == render::Shading::kSmooth, settings.has_creases},
        refined_buffers);
    if (!drawing) {
      return tl::unexpected(std::move(drawing.error()));
    }
    derived.on_gpu = std::move(drawing->refined);
    derived.on_gpu->renderer = context->info().renderer;
    refined_lines = std::move(drawing->creases);
  } else if (draws_refined) {
    const render::Surface surface = render::make_surface(
        *derived.refinement->mesh, control_surface.origin, control.face_count());
    if (auto uploaded = refined_buffers.upload(surface, 1); !uploaded) {
      return tl::unexpected(std::move(uploaded.error()));
    }
    if (settings.draw.has_numbers) {
      numbered.upload(render::middle_faces(surface));
    }
  }

  render::FacePaint paint;
  paint.reset(document.depths.values());
  render::MarkerBuffers markers;
  const DerivedLabels& labels = derived.labels;
  if (settings.has_illegal) {
    paint.set_illegal(labels.illegal_faces);
  }
  if (settings.has_labels || settings.has_illegal) {
    std::vector<render::Marker> dots = render::label_markers(
        control, labels.painted,
        settings.has_illegal ? labels.illegal_vertices : std::vector<std::uint32_t>{}, {});
    if (!settings.has_labels) {
      std::erase_if(dots, [](const render::Marker& dot) {
        return dot.style != render::MarkerStyle::kIllegal;
      });
    }
    markers.upload(dots, 1);
  }

  render::CreaseBuffers control_creases;
  render::CreaseBuffers refined_creases;
  if (settings.has_creases) {
    control_creases.upload(render::crease_lines(control));
    if (derived.refinement && draws_refined) {
      refined_lines = render::crease_lines(*derived.refinement->mesh, control_surface.origin);
    }
    refined_creases.upload(refined_lines);
  }

  render::FaceDistances distances;
  if (settings.distance != nullptr) {
    const auto upload = [&](const auto& mesh) {
      distances.upload(mesh, settings.distance->of_faces, settings.distance->greatest());
    };
    draws_refined ? upload(*derived.refinement->mesh) : upload(*document.control);
  }

  render::Scene scene;
  scene.distances = distances.count() > 0 ? &distances : nullptr;
  scene.surface = draws_refined ? &refined_buffers : &control_buffers;
  scene.paint = &paint;
  scene.cage = settings.show == Show::kBoth ? &control_buffers : nullptr;
  scene.creases = draws_refined ? &refined_creases : &control_creases;
  scene.cage_creases = scene.cage != nullptr ? &control_creases : nullptr;
  // Where the refinement is on the GPU alone, every face that can hold its number gets it.
  const bool numbers_each = settings.draw.colour == render::FaceColour::kLevel || refines_here;
  scene.numbered = draws_refined && !numbers_each ? &numbered : nullptr;
  scene.markers = &markers;
  render::DrawSettings draw = settings.draw;
  draw.shows_illegal_faces = settings.has_illegal;

  if (camera.size.width > render::largest_target_side() ||
      camera.size.height > render::largest_target_side()) {
    return fail(ErrorKind::kEnvironment,
                "the picture is larger than this OpenGL driver can draw; choose a smaller --size");
  }
  render::RenderTarget target;
  target.resize({camera.size.width, camera.size.height});
  render::MeshRenderer renderer;
  renderer.draw(target, camera, scene, draw);
  if (settings.has_legend) {
    target.bind();
    draw_legend_over(document, level_counts(draws_refined ? refined_buffers : control_buffers),
                     settings, camera.size);
  }
  return target.read();
}

}  // namespace limn::cli
