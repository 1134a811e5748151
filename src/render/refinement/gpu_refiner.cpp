// Dispatches, each a list of items (shaders/*.comp.glsl):
//
//   step_pieces         level by level, the points beside irregular vertices and creases
//   place_quads/_points what was known from the start
//   inner_nodes         faces that split and Y-elements: vertices that rest, quads that stay
//   for each label:     find_uniform_nodes, and of these uniform_quads, _points and _rims
//
// No node waits for another: it is found from its root by its number alone, and every vertex is
// computed out of its root's or piece's points. Only pieces need those of the level before.
#include "render/refinement/gpu_refiner.h"

#include <algorithm>
#include <chrono>

#include "limn/contract.h"
#include "render/refinement/drawn_faces.h"
#include "render/refinement/gpu_limits.h"
#include "render/refinement/spline_weights.h"
#include "render/shader_library.h"

namespace limn::render {
namespace {

// As in the shaders.
constexpr GLuint kPositionsSlot = 0;
constexpr GLuint kCornersSlot = 1;
constexpr GLuint kFacesSlot = 3;
constexpr GLuint kVertexLevelsSlot = 4;
constexpr GLuint kNormalsSlot = 5;
constexpr GLuint kInputSlot = 6;  // Roots, or what is placed.
constexpr GLuint kNodesSlot = 7;
constexpr GLuint kSubtreeCountsSlot = 8;
constexpr GLuint kFirstNodesSlot = 9;
constexpr GLuint kPatchPointsSlot = 10;
constexpr GLuint kSpecialsSlot = 11;
constexpr GLuint kWeightsSlot = 13;
constexpr GLuint kRingPointsSlot = 14;
constexpr GLuint kSharesSlot = 15;

constexpr GLint kItemCount = 0;
constexpr GLint kLabelCount = 1;
constexpr GLint kRootCount = 2;
constexpr GLint kFirstQuad = 3;
constexpr GLint kFirstCorner = 4;
constexpr GLint kOptions = 5;
constexpr GLint kLabel = 6;  // Or the level of pieces.
constexpr GLint kAlongSides = 7;

constexpr unsigned kWithLevels = 1;
constexpr unsigned kWithNormals = 2;
constexpr unsigned kWithLimitPoints = 4;

class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// One invocation an item, in rows of groups.
void dispatch(const gl::ShaderProgram& program, std::uint64_t items) {
  if (items == 0) {
    return;
  }
  program.use();
  program.set(kItemCount, static_cast<unsigned>(items));
  const std::uint64_t groups = (items + kGroupSize - 1) / kGroupSize;
  const std::uint64_t rows = (groups + kMostGroupsInRow - 1) / kMostGroupsInRow;
  const std::uint64_t in_row = (groups + rows - 1) / rows;
  glDispatchCompute(static_cast<GLuint>(in_row), static_cast<GLuint>(rows), 1);
}

/// What was written is there for the shaders that follow.
void finish_writing() {
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

template <class T>
void upload(gl::Buffer& buffer, const LargeArray<T>& values) {
  buffer.upload(std::span<const T>(values));
}

std::uint64_t count_uniform(const FlatPlan& plan) {
  std::uint64_t count = 0;
  for (std::size_t label = 1; label < kNodeKinds; ++label) {
    count += plan.node_counts[label];
  }
  return count;
}

}  // namespace

GpuRefiner::PointPrograms::PointPrograms(std::string_view macro)
    : inner_nodes(load_compute_program("inner_nodes.comp.glsl", macro)),
      uniform_points(load_compute_program("uniform_points.comp.glsl", macro)),
      uniform_rims(load_compute_program("uniform_rims.comp.glsl", macro)) {}

const GpuRefiner::PointPrograms& GpuRefiner::point_programs(bool with_limits) {
  std::optional<PointPrograms>& programs = with_limits ? limit_points_ : level_points_;
  if (!programs) {
    programs.emplace(with_limits ? "WITH_LIMITS" : "");
  }
  return *programs;
}

GpuRefiner::GpuRefiner()
    : step_pieces_((require_slots(), load_compute_program("step_pieces.comp.glsl"))),
      place_quads_(load_compute_program("place_quads.comp.glsl")),
      place_points_(load_compute_program("place_points.comp.glsl")),
      find_uniform_nodes_(load_compute_program("find_uniform_nodes.comp.glsl")),
      uniform_quads_(load_compute_program("uniform_quads.comp.glsl")),
      weights_(gl::Buffer::create("spline weights")),
      subtree_counts_(gl::Buffer::create("subtree counts")),
      roots_(gl::Buffer::create("roots")),
      first_nodes_(gl::Buffer::create("first nodes")),
      patch_points_(gl::Buffer::create("patch points")),
      specials_(gl::Buffer::create("special roots")),
      sharp_sides_(gl::Buffer::create("sharp sides")),
      ring_points_(gl::Buffer::create("ring points")),
      shares_(gl::Buffer::create("crease shares")),
      placed_quads_(gl::Buffer::create("placed quads")),
      placed_points_(gl::Buffer::create("placed points")),
      uniform_nodes_(gl::Buffer::create("uniform nodes")),
      vertex_levels_(gl::Buffer::create("vertex levels")),
      begin_(gl::Timestamp::create()),
      end_(gl::Timestamp::create()) {
  weights_.upload(spline_weights(kMaxDepth + 1));
}

void GpuRefiner::upload_plan(const FlatPlan& plan) {
  if (table_labels_ != plan.subtrees.label_count()) {
    table_labels_ = plan.subtrees.label_count();
    const std::vector<SubtreeCounts>& subtrees = plan.subtrees.all();
    std::vector<std::uint32_t> edges;
    for (std::uint32_t a = 0; a < table_labels_; ++a) {
      for (std::uint32_t b = 0; b < table_labels_; ++b) {
        edges.push_back(
            LabelCounts::table().edge(static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b)));
      }
    }
    const std::size_t bytes = subtrees.size() * sizeof(SubtreeCounts);
    subtree_counts_.resize(bytes + edges.size() * sizeof(std::uint32_t));
    subtree_counts_.write(0, std::span<const SubtreeCounts>(subtrees));
    subtree_counts_.write(bytes, std::span<const std::uint32_t>(edges));
  }
  upload(roots_, plan.roots);
  const std::size_t row = plan.roots.size() * sizeof(std::uint32_t);
  first_nodes_.resize(kNodeKinds * row);
  for (std::size_t kind = 0; kind < kNodeKinds; ++kind) {
    first_nodes_.write(kind * row, std::span<const std::uint32_t>(plan.first_nodes[kind]));
  }
  patch_points_.resize(point_bytes(plan));
  patch_points_.write(0, std::span<const glm::vec3>(plan.points));
  upload(specials_, plan.specials);
  upload(sharp_sides_, plan.sharp_sides);
  upload(ring_points_, plan.ring_points);
  upload(shares_, plan.shares);
  upload(placed_quads_, plan.resting_quads);
  upload(placed_points_, plan.resting_points);
}

void GpuRefiner::bind_tree() const {
  roots_.bind_storage(kInputSlot);
  subtree_counts_.bind_storage(kSubtreeCountsSlot);
  first_nodes_.bind_storage(kFirstNodesSlot);
}

void GpuRefiner::bind_points() const {
  patch_points_.bind_storage(kPatchPointsSlot);
  specials_.bind_storage(kSpecialsSlot);
  weights_.bind_storage(kWeightsSlot);
  ring_points_.bind_storage(kRingPointsSlot);
  shares_.bind_storage(kSharesSlot);
}

void GpuRefiner::step_pieces(const FlatPlan& plan) const {
  const gl::ShaderProgram& program = step_pieces_;
  sharp_sides_.bind_storage(kInputSlot);
  for (unsigned level = 0; level < plan.greatest_label && !plan.specials.empty(); ++level) {
    program.set(kLabel, level);
    program.set(kAlongSides, 0U);
    dispatch(program, kPiecePoints * 4 * plan.specials.size());
    if (level > 1) {
      program.set(kAlongSides, 1U);
      dispatch(program, kPiecePoints * (plan.sharp_sides.size() << level));
    }
    finish_writing();
  }
}

void GpuRefiner::run_uniform(const FlatPlan& plan, const PointPrograms& points,
                             std::uint32_t label) {
  const std::uint64_t nodes = plan.node_counts[label];
  if (nodes == 0) {
    return;
  }
  uniform_nodes_.resize(nodes * sizeof(FlatNode));
  uniform_nodes_.bind_storage(kNodesSlot);
  bind_tree();
  find_uniform_nodes_.set(kLabel, label);
  dispatch(find_uniform_nodes_, nodes);
  finish_writing();
  const std::uint64_t n = std::uint64_t{1} << label;
  const std::initializer_list<std::pair<const gl::ShaderProgram*, std::uint64_t>> lists{
      {&uniform_quads_, nodes * n * n},
      {&points.uniform_points, nodes * (n - 1) * (n - 1)},
      {&points.uniform_rims, nodes * 4 * n}};
  for (const auto& [program, items] : lists) {
    program->set(kLabel, label);
    dispatch(*program, items);
  }
  finish_writing();  // Before the next label's nodes take the place of these.
}

GpuRefinementTimes GpuRefiner::times() const {
  GpuRefinementTimes times = times_;
  times.gpu = end_.seconds() - begin_.seconds();
  return times;
}

void GpuRefiner::run(const FlatPlan& plan, const PointPrograms& points) {
  begin_.record();
  step_pieces(plan);
  placed_quads_.bind_storage(kInputSlot);
  dispatch(place_quads_, plan.resting_quads.size());
  placed_points_.bind_storage(kInputSlot);
  dispatch(place_points_, plan.resting_points.size());
  bind_tree();
  dispatch(points.inner_nodes, plan.node_counts[0]);
  for (std::uint32_t label = 1; label < kNodeKinds; ++label) {
    run_uniform(plan, points, label);
  }
  end_.record();
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

Result<GpuRefinement> GpuRefiner::refine(const GpuRefinementRequest& request, Progress& progress,
                                         SurfaceBuffers& surface) {
  const Stopwatch planning;
  if (auto planned =
          planner_.plan(request.mesh, request.labels, request.settings, request.limits, progress);
      !planned) {
    return tl::unexpected(std::move(planned.error()));
  }
  const FlatPlan& plan = planner_.result();
  if (auto room = require_room(plan); !room) {
    return tl::unexpected(std::move(room.error()));
  }
  const DrawnFaces drawn = group_faces(plan);
  const Result<SurfaceContents> contents = surface.prepare(
      {plan.origin, plan.vertex_count, drawn.groups, request.mesh.face_count(), plan.has_limits},
      request.revision);
  if (!contents) {
    return tl::unexpected(contents.error());
  }
  times_.plan = planning.seconds();
  const Stopwatch uploading;
  upload_plan(plan);
  write_polygons(plan, drawn, *contents);
  contents->positions->write(0, std::span<const glm::vec3>(plan.control_points));
  vertex_levels_.resize(request.has_vertex_levels ? plan.vertex_count * sizeof(std::uint32_t) : 0);
  if (request.has_vertex_levels) {
    vertex_levels_.write(
        0, std::span<const std::uint32_t>(std::vector<std::uint32_t>(plan.control_points.size())));
  }

  if (request.limits.normals) {
    contents->normals->write(0, std::span<const glm::vec3>(plan.control_normals));
  }
  times_.upload = uploading.seconds();
  const unsigned options = (request.has_vertex_levels ? kWithLevels : 0U) |
                           (request.limits.normals ? kWithNormals : 0U) |
                           (plan.has_limit_points ? kWithLimitPoints : 0U);

  contents->positions->bind_storage(kPositionsSlot);
  contents->normals->bind_storage(kNormalsSlot);
  contents->corners->bind_storage(kCornersSlot);
  contents->faces->bind_storage(kFacesSlot);
  vertex_levels_.bind_storage(kVertexLevelsSlot);
  bind_points();
  const PointPrograms& points = point_programs(plan.has_limits);
  const auto set = [](GLint location, unsigned value, const auto&... programs) {
    (programs.set(location, value), ...);
  };
  const auto& [inner_nodes, uniform_points, uniform_rims] = points;
  set(kFirstQuad, drawn.first_quad, place_quads_, inner_nodes, uniform_quads_);
  set(kFirstCorner, drawn.first_corner, place_quads_, inner_nodes, uniform_quads_);
  set(kLabelCount, static_cast<unsigned>(plan.subtrees.label_count()), inner_nodes,
      find_uniform_nodes_);
  set(kRootCount, static_cast<unsigned>(plan.roots.size()), step_pieces_, inner_nodes,
      find_uniform_nodes_, uniform_points, uniform_rims);
  set(kOptions, options, place_points_, inner_nodes, uniform_points, uniform_rims);

  run(plan, points);
  return GpuRefinement{plan.vertex_count,
                       plan.quad_count,
                       plan.polygon_control_faces.size(),
                       plan.node_counts[0],
                       count_uniform(plan),
                       plan.piece_count,
                       plan.resting_quads.size() + plan.polygon_control_faces.size(),
                       plan.resting_points.size()};
}

}  // namespace limn::render
