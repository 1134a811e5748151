// Levels are made one of another with all their connectivity, but for the last: of that only its
// faces are needed, and its points are rounded as they come.
#include "limn/subdivision/schemes/uniform.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "limn/contract.h"
#include "limn/subdivision/label_subdivision.h"
#include "subdivision/schemes/level_mesh.h"
#include "subdivision/schemes/marked_corners.h"
#include "subdivision/schemes/scheme_rules.h"
#include "subdivision/schemes/sharp_stencils.h"
#include "subdivision/world_origin.h"

namespace limn {
namespace {

/// Half-edges are numbered by 32 bits, of which kNone is one.
constexpr std::uint64_t kMostHalfEdges = 0xFFFFFFFFu;

const SchemeRules& rules_of(Scheme scheme) {
  switch (scheme) {
    case Scheme::kLinear:
      return linear_rules();
    case Scheme::kLoop:
      return loop_rules();
    case Scheme::kButterfly:
      return butterfly_rules();
    case Scheme::kKobbelt:
      return kobbelt_rules();
    case Scheme::kSqrt3:
      return sqrt3_rules();
    case Scheme::kDooSabin:
      return doo_sabin_rules();
    case Scheme::kMidedge:
      return midedge_rules();
    case Scheme::kBiquartic:
      return biquartic_rules();
    case Scheme::kCatmullClark:
      break;
  }
  LIMN_EXPECTS(false && "Catmull-Clark has an engine of its own");
  return linear_rules();
}

Result<void> check_budget(const SchemeCounts& counts, std::uint64_t budget) {
  // Every face has a half-edge for each of its sides, so there are twice as many as edges or fewer.
  if (counts.faces <= budget && 2 * counts.edges < kMostHalfEdges) {
    return {};
  }
  return fail(
      ErrorKind::kOverBudget,
      counts.faces > budget
          ? fmt::format("The subdivided mesh would have {} faces, more than the allowed {}. Make "
                        "fewer levels, or raise the face budget.",
                        counts.faces, budget)
          : fmt::format("The subdivided mesh would have {} faces, more than can be numbered. Make "
                        "fewer levels.",
                        counts.faces));
}

tl::unexpected<Error> cancelled_scheme() {
  return fail(ErrorKind::kCancelled, "The subdivision was cancelled.");
}

/// Uniform Catmull-Clark is label-driven Catmull-Clark with the same label everywhere.
Result<RefinedMesh> refine_everywhere(const ControlMesh& mesh, const SchemeSettings& settings,
                                      int levels, std::uint64_t budget, Progress& progress) {
  SubdivisionSettings refinement;
  refinement.corners = settings.corners;
  RefineLimits limits;
  limits.face_budget = budget;
  return refine(mesh, VertexLabels(mesh.vertex_count(), static_cast<std::uint8_t>(levels)),
                refinement, limits, progress);
}

LevelMesh first_level(const ControlMesh& mesh, const SchemeSettings& settings) {
  LevelMesh level = level_of(mesh, origin_of(mesh.bounds()));
  if (!rules_of(settings.scheme).has_creases) {
    mark_corners(settings.corners, level);
  }
  return level;
}

/// The sharpness of the next level.
void pass_sharpness(const LevelMesh& from, const SchemeRules& rules, LevelMesh& to) {
  to.creasing = from.creasing;
  if (rules.has_creases) {
    wear_off(from, rules.vertex_count(from), 2 * from.edge_count + from.half_edge_count(), to);
  }
}

LevelMesh next_level(const LevelMesh& from, const SchemeSettings& settings) {
  const SchemeRules& rules = rules_of(settings.scheme);
  LevelMesh to;
  to.level = from.level + 1;
  to.faces = rules.split(from);
  rules.connect(from, to);
  pass_sharpness(from, rules, to);
  to.points.resize(to.vertex_starts.size());
  rules.place(from, settings, to, {to.points.data(), nullptr});
  return to;
}

/// Quads first, then the others, as a refined mesh has them.
void put_mixed_faces(const LevelFaces& faces, RefinedMesh& mesh) {
  const auto sides = [&faces](std::size_t f) { return faces.first(f + 1) - faces.first(f); };
  std::size_t quads = 0;
  for (std::size_t f = 0; f < faces.count(); ++f) {
    quads += sides(f) == 4 ? 1 : 0;
  }
  mesh.quads.resize(quads);
  mesh.polygon_offsets.reserve(faces.count() - quads + 1);
  mesh.polygon_vertices.reserve(faces.corners.size() - 4 * quads);
  std::size_t quad = 0;
  for (std::size_t f = 0; f < faces.count(); ++f) {
    const std::uint32_t* const corners = faces.corners.data() + faces.first(f);
    if (sides(f) == 4) {
      mesh.face_control_faces[quad] = faces.control_faces[f];
      std::copy_n(corners, 4, mesh.quads[quad++].begin());
    } else {
      mesh.face_control_faces[quads + mesh.polygon_count()] = faces.control_faces[f];
      mesh.polygon_vertices.insert(mesh.polygon_vertices.end(), corners, corners + sides(f));
      mesh.polygon_offsets.push_back(static_cast<std::uint32_t>(mesh.polygon_vertices.size()));
    }
  }
}

void put_faces(LevelFaces faces, int level, RefinedMesh& mesh) {
  mesh.face_levels.assign(faces.count(), static_cast<std::uint8_t>(level));
  if (faces.sides == 0) {
    mesh.face_control_faces.resize(faces.count());
    put_mixed_faces(faces, mesh);
    return;
  }
  mesh.face_control_faces = std::move(faces.control_faces);
  if (faces.sides == 4) {
    mesh.quads.resize(mesh.face_control_faces.size());
    std::memcpy(mesh.quads.data(), faces.corners.data(),
                faces.corners.size() * sizeof(std::uint32_t));
    return;
  }
  mesh.polygon_offsets.resize(mesh.face_control_faces.size() + 1);
  for (std::size_t f = 0; f < mesh.polygon_offsets.size(); ++f) {
    mesh.polygon_offsets[f] = static_cast<std::uint32_t>(f) * faces.sides;
  }
  mesh.polygon_vertices = std::move(faces.corners);
}

void add_crease(std::uint32_t a, std::uint32_t b, float sharpness, RefinedMesh& mesh) {
  if (sharpness > 0.0f) {
    mesh.creases.push_back({{std::min(a, b), std::max(a, b)}, sharpness});
  }
}

void put_corners(const LevelMesh& level, RefinedMesh& mesh) {
  for (std::uint32_t v = 0; v < level.vertex_sharpness.size(); ++v) {
    if (level.vertex_sharpness[v] > 0.0f) {
      mesh.corners.push_back({v, level.vertex_sharpness[v]});
    }
  }
}

void sort_creases(RefinedMesh& mesh) {
  std::ranges::sort(mesh.creases, {}, &RefinedCrease::vertices);
}

/// What is sharp at a level.
void put_creases(const LevelMesh& level, RefinedMesh& mesh) {
  for (std::uint32_t h = 0; h < level.half_edge_count() && !level.edge_sharpness.empty(); ++h) {
    if (level.is_first(h) && level.twins[h] != kNone) {
      add_crease(level.start(h), level.end(h), level.edge_sharpness[level.edges[h]], mesh);
    }
  }
  put_corners(level, mesh);
  sort_creases(mesh);
}

/// The same of the level after `from`, of which only the sharpness is there. Edge e has become 2 e
/// and 2 e + 1, with its middle behind the old vertices.
void put_creases_after(const LevelMesh& from, const LevelMesh& to, RefinedMesh& mesh) {
  const auto old = static_cast<std::uint32_t>(from.vertex_count());
  for (std::uint32_t h = 0; h < from.half_edge_count() && !to.edge_sharpness.empty(); ++h) {
    if (from.is_first(h) && from.twins[h] != kNone) {
      const std::uint32_t e = from.edges[h];
      add_crease(from.start(h), old + e, to.edge_sharpness[2 * std::size_t{e}], mesh);
      add_crease(old + e, from.end(h), to.edge_sharpness[2 * std::size_t{e} + 1], mesh);
    }
  }
  put_corners(to, mesh);
  sort_creases(mesh);
}

/// A result of `level` with everything but what is sharp and where points lie.
RefinedMesh result_of(const ControlMesh& control, const SchemeSettings& settings, LevelFaces faces,
                      int level, std::size_t vertices) {
  RefinedMesh mesh;
  mesh.origin = origin_of(control.bounds());
  put_faces(std::move(faces), level, mesh);
  mesh.creasing = control.creases().method;
  if (!control.is_closed()) {
    mesh.corner_rule = settings.corners;
  }
  mesh.positions.resize(vertices);
  mesh.vertex_levels.assign(vertices, static_cast<std::uint8_t>(level));
  return mesh;
}

/// A level as a result.
RefinedMesh mesh_of(const LevelMesh& level, const ControlMesh& control,
                    const SchemeSettings& settings) {
  RefinedMesh mesh = result_of(control, settings, level.faces, level.level, level.vertex_count());
  if (rules_of(settings.scheme).has_creases) {
    put_creases(level, mesh);
  }
  for (std::size_t v = 0; v < level.vertex_count(); ++v) {
    mesh.positions[v] = glm::vec3(to_vec3(level.points[v]));
  }
  return mesh;
}

/// The level after `from` as a result.
RefinedMesh last_level(const LevelMesh& from, const ControlMesh& control,
                       const SchemeSettings& settings) {
  const SchemeRules& rules = rules_of(settings.scheme);
  RefinedMesh mesh =
      result_of(control, settings, rules.split(from), from.level + 1, rules.vertex_count(from));
  LevelMesh sharpness;
  pass_sharpness(from, rules, sharpness);
  if (rules.has_creases) {
    put_creases_after(from, sharpness, mesh);
  }
  rules.place(from, settings, sharpness, {nullptr, mesh.positions.data()});
  return mesh;
}

bool report_level(Progress& progress, int level, int levels, const SchemeInfo& info) {
  // Every level costs about four times the one before.
  const double fraction = std::ldexp(1.0, 2 * (level - levels));
  return progress.report(fraction, fmt::format("{}, level {}", info.title, level + 1));
}

}  // namespace

Result<RefinedMesh> subdivide(const ControlMesh& mesh, const SchemeSettings& settings,
                              const UniformLimits& limits, Progress& progress) {
  if (Result<void> fits = check_fits(mesh, settings.scheme); !fits) {
    return tl::unexpected(fits.error());
  }
  const std::vector<SchemeCounts> counts = predict_scheme(mesh, settings, limits.levels);
  if (Result<void> affordable = check_budget(counts.back(), limits.face_budget); !affordable) {
    return tl::unexpected(affordable.error());
  }
  if (settings.scheme == Scheme::kCatmullClark || limits.levels == 0) {
    return refine_everywhere(mesh, settings, limits.levels, limits.face_budget, progress);
  }
  const SchemeInfo& info = scheme_info(settings.scheme);
  LevelMesh level = first_level(mesh, settings);
  while (level.level + 1 < limits.levels) {
    if (!report_level(progress, level.level, limits.levels, info)) {
      return cancelled_scheme();
    }
    level = next_level(level, settings);
  }
  if (!report_level(progress, level.level, limits.levels, info)) {
    return cancelled_scheme();
  }
  RefinedMesh result = last_level(level, mesh, settings);
  if (!progress.report(1.0, info.title)) {
    return cancelled_scheme();
  }
  return result;
}

struct SchemeLevels::State {
  ControlMesh control;
  SchemeSettings settings;
  int level = 0;
  LevelMesh mesh;       ///< From level 1 on; of Catmull-Clark
  RefinedMesh refined;  ///< this, at all levels.
};

SchemeLevels::SchemeLevels(const ControlMesh& mesh, const SchemeSettings& settings)
    : state_(std::make_unique<State>(State{mesh, settings, 0, {}, {}})) {
  LIMN_EXPECTS(check_fits(mesh, settings.scheme).has_value());
}
SchemeLevels::~SchemeLevels() = default;
SchemeLevels::SchemeLevels(SchemeLevels&&) noexcept = default;
SchemeLevels& SchemeLevels::operator=(SchemeLevels&&) noexcept = default;

int SchemeLevels::level() const noexcept {
  return state_->level;
}

SchemeCounts SchemeLevels::counts() const {
  return predict_scheme(state_->control, state_->settings, state_->level).back();
}

Result<void> SchemeLevels::advance(std::uint64_t face_budget, Progress& progress) {
  LIMN_EXPECTS(state_->level < kMostSchemeLevels);
  State& state = *state_;
  const SchemeCounts next = predict_scheme(state.control, state.settings, state.level + 1).back();
  if (Result<void> affordable = check_budget(next, face_budget); !affordable) {
    return affordable;
  }
  const SchemeInfo& info = scheme_info(state.settings.scheme);
  if (!progress.report(0.0, fmt::format("{}, level {}", info.title, state.level + 1))) {
    return cancelled_scheme();
  }
  if (state.settings.scheme == Scheme::kCatmullClark) {
    Result<RefinedMesh> refined =
        refine_everywhere(state.control, state.settings, state.level + 1, face_budget, progress);
    if (!refined) {
      return tl::unexpected(std::move(refined.error()));
    }
    state.refined = *std::move(refined);
  } else {
    state.mesh = next_level(
        state.level == 0 ? first_level(state.control, state.settings) : state.mesh, state.settings);
  }
  ++state.level;
  return {};
}

RefinedMesh SchemeLevels::mesh() const {
  const State& state = *state_;
  if (state.level == 0) {
    IgnoreProgress nobody;
    return *refine_everywhere(state.control, state.settings, 0,
                              std::numeric_limits<std::uint64_t>::max(), nobody);
  }
  return state.settings.scheme == Scheme::kCatmullClark
             ? state.refined
             : mesh_of(state.mesh, state.control, state.settings);
}

}  // namespace limn
