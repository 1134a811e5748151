// Only creases are read back: where they run is known on the CPU, but not where their vertices lie.
#include "cli/gpu_refinement.h"

#include <algorithm>
#include <utility>

#include "cli/console.h"
#include "limn/subdivision/prediction.h"
#include "render/refinement/gpu_refiner.h"

namespace limn::cli {
namespace {

bool has_creases(const ControlMesh& mesh) {
  const auto is_sharp = [](float sharpness) { return sharpness > 0.0F; };
  return std::ranges::any_of(mesh.creases().edge_sharpness, is_sharp) ||
         std::ranges::any_of(mesh.creases().vertex_sharpness, is_sharp);
}

}  // namespace

Result<GpuDrawing> refine_on_gpu(const Document& document, const DerivedLabels& labels,
                                 const GpuOptions& options, render::SurfaceBuffers& surface) {
  if (document.settings.scheme != RefinementScheme::kCatmullClark) {
    return fail(ErrorKind::kUsage,
                "The GPU refines by Catmull-Clark alone; leave out --refine-on gpu or --adaptive "
                "loop.");
  }
  if (labels.fine != nullptr) {
    return fail(ErrorKind::kUsage,
                "The GPU refines what is painted on control faces alone, and this painting has "
                "demands on finer faces; leave out --refine-on gpu, or add --fine none.");
  }
  const ControlMesh& control = *document.control;
  const VertexLabels& legal = labels.legal.labels;
  RefineLimits limits;
  limits.levels = options.reach.levels;
  limits.face_budget = options.reach.face_budget;
  limits.normals = options.has_normals;
  const bool draws_creases = options.has_creases && has_creases(control);
  const render::GpuRefinementRequest request{control, legal, document.settings,
                                             limits,  1,     draws_creases};
  render::GpuRefiner refiner;
  TerminalProgress progress;
  const Result<render::GpuRefinement> done = refiner.refine(request, progress, surface);
  if (!done) {
    return tl::unexpected(done.error());
  }
  GpuDrawing drawing;
  const render::GpuRefinementTimes times = refiner.times();
  drawing.refined.seconds = times.plan + times.upload + times.gpu;
  drawing.refined.prediction = predict_refinement(control, legal, options.reach.levels);
  drawing.refined.quads = done->quads;
  drawing.refined.other_faces = done->polygons;
  if (draws_creases) {
    drawing.creases = render::crease_lines(refiner.read_back(request, surface), surface.origin());
  }
  return drawing;
}

}  // namespace limn::cli
