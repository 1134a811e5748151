// First everything gets its number (numbering.cpp), a function of labels alone; then the rings of
// irregular vertices are run down the levels (ring_tables.cpp); then every control face writes what
// becomes of it by itself (control_faces.cpp, patch.cpp), out of the points around it, at numbers
// that are its own. No face waits for another, and no level of the whole mesh is ever stored.
// Stopping after N steps is the same as running on the labels min(L, N).
#include "limn/subdivision/label_subdivision.h"

#include <algorithm>

#include <fmt/format.h>

#include "limn/contract.h"
#include "subdivision/cage_refinement.h"
#include "subdivision/invariants.h"
#include "subdivision/refined_creases.h"
#include "subdivision/world_origin.h"

namespace limn {
namespace {

/// Faces and vertices are numbered with 32 bits, and so are the four corners of every quad.
constexpr std::uint64_t kMostFaces = 0x3FFFFFF0u;
/// Where labels of finer levels are given, faces of all levels are numbered so.
constexpr std::uint64_t kMostFacesOfAllLevels = kMostFaces / 2;

/// Faces one thread takes at a time, and how much they may become before progress is reported.
constexpr std::size_t kFaceGrain = 64;
/// How far ahead of the face being refined others' points are fetched.
constexpr std::uint32_t kFacesAhead = 4;
constexpr std::uint64_t kQuadsBetweenReports = std::uint64_t{1} << 20;

tl::unexpected<Error> over_budget(std::uint64_t faces, std::uint64_t budget) {
  return fail(ErrorKind::kOverBudget,
              fmt::format("The refinement would have {} faces, more than the allowed {}. Lower the "
                          "depths, refine fewer levels, or raise the face budget.",
                          faces, budget));
}

tl::unexpected<Error> cancelled() {
  return fail(ErrorKind::kCancelled, "The refinement was cancelled.");
}

/// Makes room without copying what is about to be replaced.
template <class Array>
void make_room(Array& array, std::size_t size) {
  if (array.capacity() < size) {
    array = Array();
  }
  array.resize(size);
}

void make_room(RefinedMesh& result, const RefinedCounts& counts) {
  const std::size_t faces = counts.quads + counts.polygons;
  make_room(result.positions, counts.vertices);
  make_room(result.vertex_levels, counts.vertices);
  make_room(result.quads, counts.quads);
  make_room(result.face_control_faces, faces);
  make_room(result.face_levels, faces);
  make_room(result.polygon_offsets, counts.polygons + 1);
  make_room(result.polygon_vertices, counts.polygon_sides);
  result.polygon_offsets[0] = 0;
}

/// `texture`: what the texture coordinates become; nothing where there are none.
void make_texture_room(RefinedMesh& result, const RefinedCounts& texture) {
  make_room(result.uvs, texture.vertices);
  make_room(result.quad_uvs, texture.quads);
  make_room(result.polygon_uvs, texture.polygon_sides);
}

/// A face that is no quad and stays as it was.
void write_polygon(const RefinementPlan& plan, std::uint32_t f, RefinedMesh& result) {
  const Cage& cage = plan.cage;
  const std::uint32_t polygon = plan.numbering->first_face(f);
  const std::uint32_t first = plan.numbering->first_polygon_side(f);
  const std::uint32_t n = cage.side_count(f);
  std::copy_n(cage.topology->corner_vertices.begin() + cage.first_corner(f), n,
              result.polygon_vertices.begin() + first);
  result.polygon_offsets[polygon + 1] = first + n;
  result.face_control_faces[result.quads.size() + polygon] = f;
  result.face_levels[result.quads.size() + polygon] = 0;
}

void write_polygon_uvs(const RefinementPlan& plan, std::uint32_t f, RefinedMesh& result) {
  const Cage& cage = plan.cage;
  std::copy_n(cage.topology->corner_vertices.begin() + cage.first_corner(f), cage.side_count(f),
              result.polygon_uvs.begin() + plan.numbering->first_polygon_side(f));
}

RefinedArrays surface_arrays(RefinedMesh& result, SurfacePoints points) {
  return {&result.positions.data()->x,
          3,
          result.vertex_levels.data(),
          result.quads.data(),
          result.face_control_faces.data(),
          result.face_levels.data(),
          points == SurfacePoints::kLimit,
          result.normals.empty() ? nullptr : &result.normals.data()->x};
}

RefinedArrays texture_arrays(RefinedMesh& result) {
  RefinedArrays arrays;
  arrays.points = result.uvs.empty() ? nullptr : &result.uvs.data()->x;
  arrays.width = 2;
  arrays.quads = result.quad_uvs.data();
  return arrays;
}

/// The sharpness of the control mesh's edges and vertices for those of its texture surface.
void map_creases(const Creases& creases, const TextureSurface& texture, Creases& mapped) {
  mapped.method = creases.method;
  mapped.edge_sharpness.resize(creases.edge_sharpness.empty() ? 0 : texture.edges.size());
  for (std::size_t e = 0; e < mapped.edge_sharpness.size(); ++e) {
    mapped.edge_sharpness[e] = creases.edge_sharpness[texture.edges[e]];
  }
  mapped.vertex_sharpness.resize(creases.vertex_sharpness.empty() ? 0 : texture.vertices.size());
  for (std::size_t v = 0; v < mapped.vertex_sharpness.size(); ++v) {
    mapped.vertex_sharpness[v] = creases.vertex_sharpness[texture.vertices[v]];
  }
}

}  // namespace

struct Refiner::Workspace {
  CageRefinement surface;
  CageRefinement texture;
  Creases texture_creases;
  std::vector<std::uint64_t> sums;

  void begin(const ControlMesh& mesh, const VertexLabels& labels,
             const SubdivisionSettings& settings, int levels, const glm::dvec3& origin);
};

Refiner::Refiner() : workspace_(std::make_unique<Workspace>()) {}
Refiner::~Refiner() = default;
Refiner::Refiner(Refiner&&) noexcept = default;
Refiner& Refiner::operator=(Refiner&&) noexcept = default;

void Refiner::Workspace::begin(const ControlMesh& mesh, const VertexLabels& labels,
                               const SubdivisionSettings& settings, int levels,
                               const glm::dvec3& origin) {
  Cage cage;
  cage.topology = &mesh.topology();
  cage.creases = &mesh.creases();
  cage.corners = settings.corners;
  cage.is_all_quads = mesh.is_all_quads();
  surface.begin(cage, mesh.positions(), origin);
  std::ranges::transform(labels, surface.labels().begin(), [&](std::uint8_t label) {
    return static_cast<std::uint8_t>(std::min<int>(label, levels));
  });
  if (const TextureSurface* uv = mesh.texture_surface(); uv != nullptr) {
    map_creases(mesh.creases(), *uv, texture_creases);
    cage.topology = &uv->topology;
    cage.creases = &texture_creases;
    cage.averaging =
        settings.texture == TextureRule::kLinear ? Averaging::kBilinear : Averaging::kPinned;
    texture.begin(cage, uv->points, glm::dvec3(0.0));
    std::ranges::transform(uv->vertices, texture.labels().begin(),
                           [&](std::uint32_t v) { return surface.labels()[v]; });
  }
}

Result<void> Refiner::refine(const ControlMesh& mesh, const VertexLabels& labels,
                             const SubdivisionSettings& settings, const RefineLimits& limits,
                             Progress& progress, RefinedMesh& result) {
  LIMN_EXPECTS(labels.size() == mesh.vertex_count());
  Workspace& work = *workspace_;
  const bool has_texture = mesh.texture_surface() != nullptr;
  Sweep sweep(progress, work.sums);
  sweep.begin_stage("Numbering", 0.0, 0.1,
                    (4 * mesh.face_count() + 6 * mesh.vertex_count()) * (has_texture ? 2 : 1));
  result.origin = origin_of(mesh.bounds());
  work.begin(mesh, labels, settings, limits.levels, result.origin);

  const RefinedCounts counts = work.surface.number(sweep, limits.fine, limits.levels);
  if (sweep.is_cancelled()) {
    return cancelled();
  }
  const std::uint64_t faces = counts.quads + counts.polygons;
  if (const std::uint64_t budget =
          std::min(limits.face_budget, limits.fine != nullptr ? kMostFacesOfAllLevels : kMostFaces);
      faces > budget) {
    return over_budget(faces, budget);
  }
  const RefinedCounts texture =
      has_texture ? work.texture.number(sweep, limits.fine, limits.levels) : RefinedCounts{};
  work.surface.run_rings(sweep, limits.normals || settings.points == SurfacePoints::kLimit);
  if (has_texture) {
    work.texture.run_rings(sweep, false);
  }
  if (sweep.is_cancelled()) {
    return cancelled();
  }
  make_room(result, counts);
  make_room(result.normals, limits.normals ? counts.vertices : 0);
  make_texture_room(result, texture);
  const RefinedArrays arrays = surface_arrays(result, settings.points);
  const RefinedArrays uv_arrays = texture_arrays(result);
  work.surface.place_resting(sweep, arrays);
  if (has_texture) {
    work.texture.place_resting(sweep, uv_arrays);
  }

  // Slab by slab, each of about as many quads.
  sweep.begin_stage("Refining", 0.1, 1.0, mesh.face_count());
  const double quads_per_face =
      static_cast<double>(counts.quads + 1) / static_cast<double>(mesh.face_count());
  const auto slab = static_cast<std::size_t>(
      std::max(1.0, std::ceil(static_cast<double>(kQuadsBetweenReports) / quads_per_face)));
  const std::size_t grain = std::max<std::size_t>(1, std::min(kFaceGrain, slab / 16));
  const RefinementPlan plan = work.surface.plan();
  const RefinementPlan uv_plan = work.texture.plan();
  sweep.ranges(mesh.face_count(), slab, grain, 1, [&](std::size_t begin, std::size_t end) {
    Patch patch;
    Patch uv_patch;
    for (auto f = static_cast<std::uint32_t>(begin); f < end; ++f) {
      if (f + 2 * kFacesAhead < end) {
        prefetch_face(plan, f + 2 * kFacesAhead);
        prefetch_around_face(plan, f + kFacesAhead);
      }
      if (plan.is_resting_polygon(f)) {
        write_polygon(plan, f, result);
        if (has_texture) {
          write_polygon_uvs(uv_plan, f, result);
        }
      } else {
        refine_face(plan, f, patch, arrays);
        if (has_texture) {
          refine_face(uv_plan, f, uv_patch, uv_arrays);
        }
      }
    }
  });
  if (sweep.is_cancelled()) {
    return cancelled();
  }
  list_creases(plan, result);
  list_boundary_edges(plan, result);
  result.creasing = mesh.creases().method;
  result.corner_rule =
      mesh.is_closed() ? std::nullopt : std::optional<CornerRule>(settings.corners);
  LIMN_ASSERT(greatest_level_difference(result) <= 1);
  return {};
}

Result<RefinedMesh> refine(const ControlMesh& mesh, const VertexLabels& labels,
                           const SubdivisionSettings& settings, const RefineLimits& limits,
                           Progress& progress) {
  RefinedMesh result;
  Refiner refiner;
  if (auto done = refiner.refine(mesh, labels, settings, limits, progress, result); !done) {
    return tl::unexpected(std::move(done.error()));
  }
  return result;
}

Result<Legalisation> legal_labels(const ControlMesh& mesh, std::span<const std::uint8_t> depths,
                                  const SubdivisionSettings& settings, Progress& progress) {
  return legalise(mesh, apply_non_quad_rule(mesh, vertex_labels(mesh, depths), settings.non_quads),
                  settings, progress);
}

Result<Legalisation> legalise(const ControlMesh& mesh, VertexLabels labels,
                              const SubdivisionSettings& settings, Progress& progress) {
  switch (settings.legalisation) {
    case LegalisationMethod::kGreedy:
      return legalise_greedy(mesh, std::move(labels), settings.non_quads, progress);
    case LegalisationMethod::kLookAhead:
      return legalise_look_ahead(mesh, std::move(labels), settings.non_quads, progress);
  }
  LIMN_EXPECTS(!"a known legalisation method");
  return {};
}

}  // namespace limn
