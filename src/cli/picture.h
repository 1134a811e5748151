#pragma once

#include <memory>
#include <optional>

#include "cli/gpu_refinement.h"
#include "cli/input.h"
#include "limn/comparison/limit_distance.h"
#include "limn/error.h"
#include "limn/mesh/refined_mesh.h"
#include "render/camera.h"
#include "render/draw_settings.h"
#include "render/image.h"

namespace limn::cli {

/// What stands in a picture made without a window.
struct PictureSettings {
  enum class Show { kControl, kRefined, kBoth };
  Show show = Show::kRefined;
  render::DrawSettings draw;
  bool has_labels = false;   ///< Vertex labels as numbered dots. Numbers on faces are in `draw`.
  bool has_illegal = false;  ///< Illegal faces hatched, their vertices as dots.
  bool has_creases = true;   ///< Sharp edges and vertices, coloured by sharpness.
  bool has_legend = false;
  /// Of the mesh that is drawn, for FaceColour::kDistance.
  std::shared_ptr<const LimitDistance> distance;
  /// Refine on the GPU what is shown, as far as this; nothing: show what `derived` has refined.
  std::optional<GpuReach> on_gpu;
};

/// Draws a painted mesh, its refinement or both. Sets `derived.on_gpu` where it refines on the GPU.
/// Throws EnvironmentError where there is no OpenGL 4.5. Errors: kEnvironment where the picture is
/// larger than the driver can draw, or the refinement than it can hold; of a refinement, also
/// kOverBudget and kCancelled.
[[nodiscard]] Result<render::Image> draw_document(const Document& document, Derived& derived,
                                                  const render::Camera& camera,
                                                  const PictureSettings& settings);

}  // namespace limn::cli
