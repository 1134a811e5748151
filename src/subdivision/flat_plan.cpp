// The numbering, the rings and the points around each face are those of the refinement itself. What
// each face adds to the arrays is counted and placed by one more parallel prefix sum.
#include "subdivision/flat_plan.h"

#include <algorithm>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "limn/contract.h"
#include "subdivision/cage_refinement.h"
#include "subdivision/flat_filler.h"
#include "subdivision/refined_creases.h"

namespace limn {
namespace {

void add(PlanSizes& sum, const PlanSizes& sizes) {
  std::ranges::transform(sum, sizes, sum.begin(), std::plus<>());
}

/// The four corners of every quad are numbered with 32 bits.
constexpr std::uint64_t kMostPlannedFaces = 0x3FFFFFF0u;

/// Faces one thread takes at a time, and blocks of these between two reports of progress.
constexpr std::size_t kPlanBlock = 1024;
constexpr std::size_t kPlanSlab = 64;

tl::unexpected<Error> plan_cancelled() {
  return fail(ErrorKind::kCancelled, "The refinement was cancelled.");
}

}  // namespace

struct FlatPlanner::Workspace {
  CageRefinement surface;
  std::vector<std::uint64_t> sums;
  FlatPlan plan;
  std::vector<PlanSizes> firsts;  ///< Of each block of faces.

  void make_room(const PlanSizes& sizes, const RefinedCounts& counts);
  void place_control_vertices(Sweep& sweep, std::size_t count);
};

FlatPlanner::FlatPlanner() : workspace_(std::make_unique<Workspace>()) {}
FlatPlanner::~FlatPlanner() = default;
FlatPlanner::FlatPlanner(FlatPlanner&&) noexcept = default;
FlatPlanner& FlatPlanner::operator=(FlatPlanner&&) noexcept = default;

void FlatPlanner::Workspace::make_room(const PlanSizes& sizes, const RefinedCounts& counts) {
  plan.vertex_count = counts.vertices;
  plan.quad_count = counts.quads;
  plan.roots.resize(sizes[kPlanRoots]);
  plan.points.resize(kRootPoints * sizes[kPlanRoots]);
  for (std::size_t kind = 0; kind < kNodeKinds; ++kind) {
    plan.node_counts[kind] = sizes[kPlanNodes + kind];
    plan.first_nodes[kind].resize(sizes[kPlanRoots]);
  }
  plan.specials.resize(sizes[kPlanSpecials]);
  plan.ring_points.resize(sizes[kPlanRingPoints]);
  plan.shares.resize(sizes[kPlanShares]);
  plan.sharp_sides.resize(sizes[kPlanSharpSides]);
  plan.piece_count = sizes[kPlanPieces];
  plan.resting_quads.resize(sizes[kPlanQuads]);
  plan.resting_points.resize(sizes[kPlanPoints]);
  plan.polygon_offsets.assign(counts.polygons + 1, 0);
  plan.polygon_vertices.resize(counts.polygon_sides);
  plan.polygon_control_faces.resize(counts.polygons);
}

void FlatPlanner::Workspace::place_control_vertices(Sweep& sweep, std::size_t count) {
  plan.control_points.assign(count, glm::vec3(0.0f));
  plan.control_normals.assign(plan.has_limits ? count : 0, glm::vec3(0.0f));
  RefinedArrays arrays;
  arrays.points = count == 0 ? nullptr : &plan.control_points.data()->x;
  arrays.has_limit_points = plan.has_limit_points;
  arrays.normals = plan.control_normals.empty() ? nullptr : &plan.control_normals.data()->x;
  surface.place_resting(sweep, arrays);
}

Result<void> FlatPlanner::plan(const ControlMesh& mesh, const VertexLabels& labels,
                               const SubdivisionSettings& settings, const RefineLimits& limits,
                               Progress& progress) {
  LIMN_EXPECTS(labels.size() == mesh.vertex_count());
  Workspace& work = *workspace_;
  FlatPlan& plan = work.plan;
  Sweep sweep(progress, work.sums);
  sweep.begin_stage("Planning", 0.0, 1.0, 7 * mesh.face_count() + 6 * mesh.vertex_count());

  plan.origin = mesh.bounds().centre();
  plan.has_limit_points = settings.points == SurfacePoints::kLimit;
  plan.has_limits = limits.normals || plan.has_limit_points;
  Cage cage;
  cage.topology = &mesh.topology();
  cage.creases = &mesh.creases();
  cage.corners = settings.corners;
  cage.is_all_quads = mesh.is_all_quads();
  work.surface.begin(cage, mesh.positions(), plan.origin);
  std::ranges::transform(labels, work.surface.labels().begin(), [&](std::uint8_t label) {
    return static_cast<std::uint8_t>(std::min<int>(label, limits.levels));
  });
  const RefinedCounts counts = work.surface.number(sweep);
  if (sweep.is_cancelled()) {
    return plan_cancelled();
  }
  const std::uint64_t faces = counts.quads + counts.polygons;
  if (const std::uint64_t budget = std::min(limits.face_budget, kMostPlannedFaces);
      faces > budget) {
    return fail(ErrorKind::kOverBudget,
                fmt::format("The refinement would have {} faces, more than the allowed {}. Lower "
                            "the depths, refine fewer levels, or raise the face budget.",
                            faces, budget));
  }
  work.surface.run_rings(sweep, plan.has_limits);
  work.place_control_vertices(sweep, mesh.vertex_count());

  plan.greatest_label = work.surface.plan().greatest_of_all;
  if (plan.subtrees.label_count() != plan.greatest_label + std::size_t{1}) {
    plan.subtrees = SubtreeTable(plan.greatest_label);
  }
  const RefinementPlan from = work.surface.plan();
  const FlatFiller filler(from, plan);
  // The arrays have their sizes when all faces are counted, before any is filled in.
  const std::size_t blocks = (mesh.face_count() + kPlanBlock - 1) / kPlanBlock;
  const auto for_each_face = [&](std::size_t block, const auto& visit) {
    const std::size_t end = std::min(mesh.face_count(), (block + 1) * kPlanBlock);
    for (auto f = static_cast<std::uint32_t>(block * kPlanBlock); f < end; ++f) {
      visit(f);
    }
  };
  work.firsts.assign(blocks, PlanSizes{});
  sweep.ranges(blocks, kPlanSlab, 1, kPlanBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block) {
      for_each_face(block, [&](std::uint32_t f) { add(work.firsts[block], filler.sizes(f)); });
    }
  });
  PlanSizes next{};
  for (PlanSizes& first : work.firsts) {
    const PlanSizes size = std::exchange(first, next);
    add(next, size);
  }
  work.make_room(next, counts);
  sweep.ranges(blocks, kPlanSlab, 1, kPlanBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block) {
      PlanSizes at = work.firsts[block];
      for_each_face(block, [&](std::uint32_t f) { filler.fill(f, at); });
    }
  });
  return sweep.is_cancelled() ? Result<void>(plan_cancelled()) : Result<void>{};
}

const FlatPlan& FlatPlanner::result() const noexcept {
  return workspace_->plan;
}

void FlatPlanner::list_creases(RefinedMesh& result) const {
  limn::list_creases(workspace_->surface.plan(), result);
}

}  // namespace limn
