#include <map>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/input.h"
#include "cli/picture.h"
#include "cli/report.h"
#include "cli/view_options.h"
#include "render/png.h"

namespace limn::cli {
namespace {

/// What refines what is drawn.
enum class RefineOn { kCpu, kGpu };

struct RenderOptions {
  PaintingOptions painting;
  ViewOptions view;
  PictureSettings picture;
  RefineOn refine_on = RefineOn::kCpu;
  std::string output;
  bool json = false;
};

Result<void> render_and_write(const RenderOptions& options) {
  const Result<Project> project = open_painted(options.painting, visible_faces_from(options.view));
  if (!project) {
    return tl::unexpected(project.error());
  }
  const Result<ViewState> view = resolve_view(options.view, *project);
  if (!view) {
    return tl::unexpected(view.error());
  }
  PaintingOptions painting = options.painting;
  PictureSettings picture = options.picture;
  if (options.picture.show == PictureSettings::Show::kControl) {
    painting.levels = 0;
  } else if (options.refine_on == RefineOn::kGpu) {
    picture.on_gpu = GpuReach{painting.levels, painting.face_budget};
    painting.levels = 0;  // Labels alone.
  }
  const std::shared_ptr<void> limit = limit_threads(painting.threads);
  Result<Derived> derived = derive(*project, painting);
  if (!derived) {
    return tl::unexpected(derived.error());
  }
  const Document& document = project->document;
  const render::Camera camera =
      render::make_camera(*view, document.control->bounds(), options.view.size);
  const Result<render::Image> image = draw_document(document, *derived, camera, picture);
  if (!image) {
    return tl::unexpected(image.error());
  }
  if (auto written = render::write_png(options.output, *image); !written) {
    return written;
  }
  if (options.json) {
    fmt::print("{}\n", refinement_report(document, *derived).dump(2));
  }
  return {};
}

}  // namespace

void add_render_command(CLI::App& program, Work& work) {
  CLI::App* command =
      program.add_subcommand("render", "Draw a painted mesh or its refinement into a PNG picture");
  const auto options = std::make_shared<RenderOptions>();
  PictureSettings& picture = options->picture;
  add_painting_options(*command, options->painting);
  add_view_options(*command, options->view);
  command->add_option("-o,--output", options->output, "The picture (.png)")
      ->type_name("OUT")
      ->required();

  using Show = PictureSettings::Show;
  command
      ->add_option(
          "--show", picture.show,
          "control (the painted mesh), refined, or both (the control cage over the refined "
          "surface)")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Show>{{"control", Show::kControl},
                                                                      {"refined", Show::kRefined},
                                                                      {"both", Show::kBoth}})
                      .description(""))
      ->type_name("WORD")
      ->default_str("refined");
  command
      ->add_option("--refine-on", options->refine_on,
                   "cpu, or gpu: refine with compute shaders where the picture is drawn. What is "
                   "drawn is the same")
      ->transform(CLI::CheckedTransformer(std::map<std::string, RefineOn>{{"cpu", RefineOn::kCpu},
                                                                          {"gpu", RefineOn::kGpu}})
                      .description(""))
      ->type_name("WORD")
      ->default_str("cpu");
  command
      ->add_flag("--wireframe,!--no-wireframe", picture.draw.has_wireframe,
                 "Polygon edges over the shading, or not")
      ->default_str("on");
  command->add_flag_callback(
      "--smooth", [&picture] { picture.draw.shading = render::Shading::kSmooth; },
      "Smooth shading instead of flat");
  command
      ->add_flag("--light,!--no-light", picture.draw.is_lit, "Shading by light, or plain colours")
      ->default_str("on");
  command->add_flag("--labels", picture.has_labels, "Vertex labels as numbered dots");
  command->add_flag("--illegal", picture.has_illegal,
                    "Illegal faces hatched and illegal vertices as dots, as painted");
  command
      ->add_flag("--creases,!--no-creases", picture.has_creases,
                 "Sharp edges and vertices, coloured by sharpness, or not")
      ->default_str("on");
  command->add_flag("--legend", picture.has_legend,
                    "The colours of the depths, and of creases where there are any, with counts");
  command->add_flag_callback(
      "--light-theme", [&picture] { picture.draw.theme = render::Theme::kLight; },
      "Light background instead of dark");
  command->add_flag("--json", options->json, "The numbers as JSON on standard output");
  command->callback([options, &work] { work = [options] { return render_and_write(*options); }; });
}

}  // namespace limn::cli
