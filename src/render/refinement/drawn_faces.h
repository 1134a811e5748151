#pragma once

#include <cstdint>
#include <vector>

#include "render/surface/surface.h"
#include "render/surface/surface_buffers.h"
#include "subdivision/flat_plan.h"

namespace limn::render {

/// In which order the faces of a refinement are drawn: by number of sides, as in make_surface.
struct DrawnFaces {
  std::vector<SurfaceGroup> groups;
  std::uint32_t first_quad = 0;
  std::uint32_t first_corner = 0;       ///< Of quads.
  std::vector<std::uint32_t> polygons;  ///< Faces that are no quads, as they are drawn.
};

[[nodiscard]] DrawnFaces group_faces(const FlatPlan& plan);

/// Writes the faces that are no quads.
void write_polygons(const FlatPlan& plan, const DrawnFaces& drawn, const SurfaceContents& surface);

}  // namespace limn::render
