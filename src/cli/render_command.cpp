#include <map>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/input.h"
#include "cli/picture.h"
#include "cli/report.h"
#include "cli/scheme_options.h"
#include "cli/view_options.h"
#include "limn/document/measured_refinement.h"
#include "limn/subdivision/schemes/uniform.h"
#include "render/png.h"

namespace limn::cli {
namespace {

/// What refines what is drawn.
enum class RefineOn { kCpu, kGpu };

struct RenderOptions {
  PaintingOptions painting;
  SchemeOptions scheme;  ///< Where it names one, that is drawn and no refinement of the painting.
  ViewOptions view;
  PictureSettings picture;
  RefineOn refine_on = RefineOn::kCpu;
  std::string output;
  bool json = false;
};

/// What is to be drawn, and its numbers.
struct Drawable {
  Document document;
  Derived derived;
  PictureSettings picture;
  nlohmann::ordered_json report;
};

/// How far what is drawn is from the limit surface: the refinement, or the control mesh where there
/// is none.
Result<LimitDistance> measure_drawn(const Document& document, const Derived& derived, int levels) {
  TerminalProgress progress;
  if (derived.refinement) {
    return measure_limit_distance(*document.control, labels_up_to(derived.labels, levels),
                                  document.settings, *derived.refinement->mesh, progress);
  }
  Document control;
  control.control = document.control;
  control.settings = document.settings;
  control.settings.points = SurfacePoints::kLevel;
  return measure_refinement(control, derived.labels, 0, nullptr, progress)
      .map([](MeasuredRefinement measured) { return std::move(measured.distance); });
}

/// The painting, refined.
Result<Drawable> make_refinement(const RenderOptions& options, const Project& project) {
  PaintingOptions painting = options.painting;
  PictureSettings picture = options.picture;
  if (options.picture.show == PictureSettings::Show::kControl) {
    painting.levels = 0;
  } else if (options.refine_on == RefineOn::kGpu) {
    picture.on_gpu = GpuReach{painting.levels, painting.face_budget};
    painting.levels = 0;  // Labels alone.
  }
  Result<Derived> derived = derive(project, painting);
  if (!derived) {
    return tl::unexpected(std::move(derived.error()));
  }
  if (picture.draw.colour == render::FaceColour::kDistance) {
    Result<LimitDistance> distance = measure_drawn(project.document, *derived, painting.levels);
    if (!distance) {
      return tl::unexpected(std::move(distance.error()));
    }
    picture.distance = std::make_shared<const LimitDistance>(*std::move(distance));
  }
  return Drawable{project.document, *std::move(derived), picture, {}};
}

/// The mesh, subdivided by a scheme.
Result<Drawable> make_uniform(const RenderOptions& options, const Project& project) {
  SchemeOptions scheme = options.scheme;
  scheme.corners = options.painting.corners;
  const SchemeSettings settings = scheme_settings(scheme, project.document);
  Result<std::shared_ptr<const ControlMesh>> mesh =
      fit_mesh(project.document.control, settings.scheme, scheme.is_fitted, project.document.name);
  if (!mesh) {
    return tl::unexpected(std::move(mesh.error()));
  }
  const int levels = options.painting.levels == kAllLevels ? 1 : options.painting.levels;
  TerminalProgress progress;
  Result<RefinedMesh> refined = subdivide(
      **mesh, settings, {.levels = levels, .face_budget = options.painting.face_budget}, progress);
  if (!refined) {
    return tl::unexpected(std::move(refined.error()));
  }
  Drawable drawable{
      make_document({*std::move(mesh), {}}, project.document.name), {}, options.picture, {}};
  drawable.report = {{"scheme", scheme_info(settings.scheme).name},
                     {"levels", levels},
                     {"vertices", refined->vertex_count()},
                     {"faces", refined->face_count()}};
  drawable.derived.refinement.emplace().mesh =
      std::make_shared<const RefinedMesh>(*std::move(refined));
  return drawable;
}

Result<void> render_and_write(const RenderOptions& options) {
  const Result<Project> project = open_painted(options.painting, paint_context_from(options.view));
  if (!project) {
    return tl::unexpected(project.error());
  }
  const Result<ViewState> view = resolve_view(options.view, *project);
  if (!view) {
    return tl::unexpected(view.error());
  }
  const std::shared_ptr<void> limit = limit_threads(options.painting.threads);
  Result<Drawable> drawable =
      options.scheme.scheme ? make_uniform(options, *project) : make_refinement(options, *project);
  if (!drawable) {
    return tl::unexpected(std::move(drawable.error()));
  }
  const render::Camera camera =
      render::make_camera(*view, project->document.control->bounds(), options.view.size);
  const Result<render::Image> image =
      draw_document(drawable->document, drawable->derived, camera, drawable->picture);
  if (!image) {
    return tl::unexpected(image.error());
  }
  if (auto written = render::write_png(options.output, *image); !written) {
    return written;
  }
  if (options.json) {
    const auto report = options.scheme.scheme
                            ? drawable->report
                            : refinement_report(drawable->document, drawable->derived);
    fmt::print("{}\n", report.dump(2));
  }
  return {};
}

/// What goes with painting, and not with a scheme that knows no depths.
void add_render_scheme_options(CLI::App& command, SchemeOptions& options) {
  add_scheme_options(command, options);
  CLI::Option* scheme = command.get_option("--scheme");
  scheme->description("Draw the mesh subdivided by a uniform scheme instead: " + scheme_words() +
                      "; --levels says how often (1)");
  for (const char* name :
       {"--paint", "--legalize", "--non-quads", "--positions", "--texture", "--adaptive",
        "--adaptive-weights", "--refine-on", "--labels", "--illegal"}) {
    scheme->excludes(name);
  }
  for (const char* name : {"--weights", "--average", "--fit"}) {
    command.get_option(name)->needs(scheme);
  }
}

}  // namespace

void add_render_command(CLI::App& program, Work& work) {
  CLI::App* command =
      program.add_subcommand("render", "Draw a painted mesh or its refinement into a PNG picture");
  const auto options = std::make_shared<RenderOptions>();
  PictureSettings& picture = options->picture;
  add_input_option(*command, options->painting.input);
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
  using Colour = render::FaceColour;
  command
      ->add_option("--colours", picture.draw.colour,
                   "depth (as painted), level (how often each refined face was subdivided), "
                   "distance (of each "
                   "refined face from the limit surface), or none")
      ->transform(
          CLI::CheckedTransformer(std::map<std::string, Colour>{{"depth", Colour::kDepth},
                                                                {"level", Colour::kLevel},
                                                                {"distance", Colour::kDistance},
                                                                {"none", Colour::kPlain}})
              .description(""))
      ->type_name("WORD")
      ->default_str("depth");
  using render::Material;
  command
      ->add_option("--material", picture.draw.material,
                   "studio (matt), clay, dark (stone), or shiny (polish)")
      ->transform(
          CLI::CheckedTransformer(std::map<std::string, Material>{{"studio", Material::kStudio},
                                                                  {"clay", Material::kClay},
                                                                  {"dark", Material::kDark},
                                                                  {"shiny", Material::kShiny}})
              .description(""))
      ->type_name("WORD")
      ->default_str("studio");
  command->add_flag("--numbers", picture.draw.has_numbers,
                    "The number that its colour stands for on each face large enough to hold it");
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
  add_render_scheme_options(*command, options->scheme);
  command->callback([options, &work] {
    check_scheme_options(options->scheme);
    if (options->picture.draw.colour == Colour::kDistance &&
        (options->scheme.scheme || options->refine_on == RefineOn::kGpu)) {
      throw CLI::ValidationError(
          "--colours",
          "distance is of the control mesh, or of what is painted and refined on the cpu");
    }
    if (const int levels = options->painting.levels;
        options->scheme.scheme && levels != kAllLevels && levels > kMostSchemeLevels) {
      throw CLI::ValidationError(
          "--levels", fmt::format("a scheme is subdivided up to {} times", kMostSchemeLevels));
    }
    work = [options] { return render_and_write(*options); };
  });
}

}  // namespace limn::cli
