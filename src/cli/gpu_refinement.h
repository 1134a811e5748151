#pragma once

#include <cstdint>
#include <vector>

#include "cli/input.h"
#include "limn/error.h"
#include "render/surface/crease_lines.h"
#include "render/surface/surface_buffers.h"

namespace limn::cli {

/// How far a refinement on the GPU goes.
struct GpuReach {
  int levels = kAllLevels;
  std::uint64_t face_budget = 0;
};

/// What is to be shown of it.
struct GpuOptions {
  GpuReach reach;
  bool has_normals = false;  ///< For smooth shading.
  bool has_creases = false;
};

/// A refinement on the GPU and the sharp edges to draw over it.
struct GpuDrawing {
  RefinedOnGpu refined;
  std::vector<render::CreaseLine> creases;
};

/// Refines a painted mesh into `surface`, whose context is current, with progress on the terminal.
/// Throws EnvironmentError where the driver cannot. Errors: kOverBudget, kCancelled; kEnvironment
/// where the driver has a limit in the way.
[[nodiscard]] Result<GpuDrawing> refine_on_gpu(const Document& document,
                                               const DerivedLabels& labels,
                                               const GpuOptions& options,
                                               render::SurfaceBuffers& surface);

}  // namespace limn::cli
