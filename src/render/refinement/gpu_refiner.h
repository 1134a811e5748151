#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/mesh/refined_mesh.h"
#include "limn/progress.h"
#include "limn/subdivision/label_subdivision.h"
#include "limn/subdivision/settings.h"
#include "render/gl/buffer.h"
#include "render/gl/shader_program.h"
#include "render/gl/timestamp.h"
#include "render/surface/surface_buffers.h"
#include "subdivision/flat_plan.h"

namespace limn::render {

/// What to refine; borrowed for the call. `mesh` and `labels` are those of limn::refine.
struct GpuRefinementRequest {
  const ControlMesh& mesh;
  const VertexLabels& labels;
  SubdivisionSettings settings;
  RefineLimits limits;
  std::uint64_t revision = 1;      ///< Of the surface: see SurfaceBuffers::upload.
  bool has_vertex_levels = false;  ///< Keep what `read_back` needs besides the surface.
};

/// What a refinement on the GPU came to.
struct GpuRefinement {
  std::uint64_t vertices = 0;
  std::uint64_t quads = 0;
  std::uint64_t polygons = 0;  ///< Faces that are no quads and stayed.

  std::uint64_t inner_nodes = 0;    ///< Faces of any level that were split or became Y-elements.
  std::uint64_t uniform_nodes = 0;  ///< Faces of any level that were refined as grids.
  std::uint64_t pieces = 0;         ///< Faces of any level beside irregular vertices and creases.
  std::uint64_t placed_quads = 0;   ///< Faces and vertices that were known without refining, and
  std::uint64_t placed_points = 0;  ///< uploaded.
};

/// How long the last refinement took, in seconds.
struct GpuRefinementTimes {
  double plan = 0.0;    ///< On the CPU, linear in the control mesh.
  double upload = 0.0;  ///< Of the plan: what the driver keeps the CPU for.
  double gpu = 0.0;     ///< On the GPU, from the finished upload to the finished surface.
};

/// Label-driven adaptive Catmull-Clark on the GPU, in OpenGL 4.5 compute shaders.
///
/// The result is that of limn::refine: the same vertices, faces, control faces and levels under the
/// same numbers, and positions within 1e-6 of the control mesh's diagonal (shaders compute in
/// single precision, relative to the centre of its bounds). It lies in a SurfaceBuffers, which
/// draws it and which a FacePicker reads, and never leaves the GPU unless it is read back. The same
/// input gives the same bytes on the same driver.
///
/// The CPU numbers the result, runs the rings around irregular vertices down the levels and gathers
/// the points around each control face, in time linear in the control mesh; everything that is
/// proportional to the output happens on the GPU. Texture coordinates are left out.
///
/// Every member function needs the context of construction to be current.
class GpuRefiner {
 public:
  /// Throws EnvironmentError where the driver cannot compile the shaders, or lets them see too few
  /// buffers.
  GpuRefiner();

  /// Replaces the contents of `surface`; its origin is the centre of the mesh's bounds, as that of
  /// the control mesh's own surface. After an error they are unspecified.
  /// Errors: those of limn::refine, and kEnvironment where something is larger than the driver
  /// allows, naming its limit. Throws EnvironmentError where the GPU has no memory left.
  [[nodiscard]] Result<GpuRefinement> refine(const GpuRefinementRequest& request,
                                             Progress& progress, SurfaceBuffers& surface);

  /// Waits until the last refinement is finished.
  [[nodiscard]] GpuRefinementTimes times() const;

  /// The last refinement, made with vertex levels and for a mesh that is still there, as
  /// limn::refine gives it but for texture coordinates, and with the surface's origin. Waits for
  /// the GPU.
  [[nodiscard]] RefinedMesh read_back(const GpuRefinementRequest& request,
                                      const SurfaceBuffers& surface) const;

 private:
  /// Programs that place vertices.
  struct PointPrograms {
    explicit PointPrograms(std::string_view macro);
    gl::ShaderProgram inner_nodes;
    gl::ShaderProgram uniform_points;
    gl::ShaderProgram uniform_rims;
  };

  [[nodiscard]] const PointPrograms& point_programs(bool with_limits);
  void upload_plan(const FlatPlan& plan);
  void run(const FlatPlan& plan, const PointPrograms& points);
  void step_pieces(const FlatPlan& plan) const;
  void run_uniform(const FlatPlan& plan, const PointPrograms& points, std::uint32_t label);
  void bind_tree() const;
  void bind_points() const;

  gl::ShaderProgram step_pieces_;
  gl::ShaderProgram place_quads_;
  gl::ShaderProgram place_points_;
  gl::ShaderProgram find_uniform_nodes_;
  gl::ShaderProgram uniform_quads_;
  std::optional<PointPrograms> level_points_;  ///< Made when first needed,
  std::optional<PointPrograms> limit_points_;  ///< since limits take the driver's compiler long.

  FlatPlanner planner_;
  gl::Buffer weights_;
  gl::Buffer subtree_counts_;
  gl::Buffer roots_;
  gl::Buffer first_nodes_;
  gl::Buffer patch_points_;
  gl::Buffer specials_;
  gl::Buffer sharp_sides_;
  gl::Buffer ring_points_;
  gl::Buffer shares_;
  gl::Buffer placed_quads_;
  gl::Buffer placed_points_;
  gl::Buffer uniform_nodes_;
  gl::Buffer vertex_levels_;
  std::size_t table_labels_ = 0;  ///< Labels that `subtree_counts_` is for.
  GpuRefinementTimes times_;      ///< Without the GPU's.
  gl::Timestamp begin_;
  gl::Timestamp end_;
};

}  // namespace limn::render
