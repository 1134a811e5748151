// Level by level, as uniform Loop, but only of what is needed: the triangles of faces that go on,
// and two rings around them. A stencil reaches one ring of the level before; two rings of a level,
// all of whose points are right, give two of the next:
//
//     vertex at most 2 away from those that go on, in edges of the new level
//       = an old vertex at most 1 away, whose ring is at most 2 away in the old level, or
//         the middle of an old edge whose two triangles lie within the old two rings.
//
// What lies beyond is cut off, and points at the cut are wrong and not used. Every vertex has a
// number in the result from the level on at which a face that goes so far first has it, and its
// position is written anew at each level that has such a face.
#include "limn/subdivision/schemes/adaptive_loop.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "limn/contract.h"
#include "subdivision/schemes/part_of_level.h"
#include "subdivision/schemes/scheme_rules.h"
#include "subdivision/schemes/sharp_stencils.h"
#include "subdivision/schemes/triangle_split.h"
#include "subdivision/world_origin.h"

namespace limn {
namespace {

/// Vertices of a level as numbers in the result, kNone where they have none.
using Numbers = std::vector<std::uint32_t>;

class AdaptiveLoop {
 public:
  AdaptiveLoop(const ControlMesh& mesh, std::span<const std::uint8_t> depths,
               const AdaptiveLoopSettings& settings);

  /// Writes the faces that end at the level at hand and makes the next level. Whether there is one.
  [[nodiscard]] bool advance();
  [[nodiscard]] RefinedMesh take();

 private:
  [[nodiscard]] std::uint8_t depth_of(std::uint32_t face) const noexcept {
    return depths_[level_.faces.control_faces[face]];
  }
  [[nodiscard]] bool ends_here(std::uint32_t face) const noexcept {
    return depth_of(face) == level_.level;
  }
  [[nodiscard]] bool goes_on(std::uint32_t face) const noexcept {
    return depth_of(face) > level_.level;
  }
  [[nodiscard]] std::vector<bool> faces_to_split() const;
  void split(const PartOfLevel& part);
  void number_vertices();
  void put_faces(const LevelMesh& before, const PartOfLevel& part, const Numbers& numbers_before);
  void put_face(const std::array<std::uint32_t, 3>& corners,
                const std::array<std::uint32_t, 3>& middles, std::uint32_t control_face);
  void put_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t control_face);
  void put_creases();

  std::span<const std::uint8_t> depths_;
  SchemeSettings settings_;
  LevelMesh level_;
  Numbers numbers_;
  RefinedMesh result_;
  LargeArray<float> vertex_sharpness_;  ///< By number, empty where nothing is sharp.
  std::uint32_t vertices_ = 0;          ///< Numbered so far.
  std::size_t faces_ = 0;               ///< Written so far.
};

AdaptiveLoop::AdaptiveLoop(const ControlMesh& mesh, std::span<const std::uint8_t> depths,
                           const AdaptiveLoopSettings& settings)
    : depths_(depths), level_(level_of(mesh, origin_of(mesh.bounds()))) {
  settings_.scheme = Scheme::kLoop;
  settings_.weights = settings.weights;
  settings_.corners = settings.corners;
  const SchemeCounts counts = predict_adaptive_loop(mesh, depths);
  result_.origin = origin_of(mesh.bounds());
  result_.positions.resize(counts.vertices);
  result_.vertex_levels.resize(counts.vertices);
  result_.polygon_offsets.resize(counts.faces + 1);
  result_.polygon_vertices.resize(3 * counts.faces);
  result_.face_control_faces.resize(counts.faces);
  result_.face_levels.resize(counts.faces);
  for (std::size_t f = 0; f <= counts.faces; ++f) {
    result_.polygon_offsets[f] = static_cast<std::uint32_t>(3 * f);
  }
  result_.creasing = level_.creasing;
  if (!mesh.is_closed()) {
    result_.corner_rule = settings.corners;
  }
  if (!level_.vertex_sharpness.empty()) {
    vertex_sharpness_.assign(counts.vertices, 0.0f);
  }
  // Control vertices keep their numbers.
  numbers_.resize(mesh.vertex_count());
  for (std::uint32_t v = 0; v < numbers_.size(); ++v) {
    numbers_[v] = v;
  }
  vertices_ = static_cast<std::uint32_t>(numbers_.size());
  number_vertices();
}

/// Numbers the vertices of faces that come as far as this level, and writes their points.
void AdaptiveLoop::number_vertices() {
  for (std::uint32_t f = 0; f < level_.faces.count(); ++f) {
    if (!ends_here(f) && !goes_on(f)) {
      continue;
    }
    for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
      const std::uint32_t v = level_.start(h);
      if (numbers_[v] == kNone) {
        numbers_[v] = vertices_++;
      }
      const std::uint32_t number = numbers_[v];
      result_.positions[number] = glm::vec3(to_vec3(level_.points[v]));
      result_.vertex_levels[number] = static_cast<std::uint8_t>(level_.level);
      if (!vertex_sharpness_.empty()) {
        vertex_sharpness_[number] =
            level_.vertex_sharpness.empty() ? 0.0f : level_.vertex_sharpness[v];
      }
    }
  }
}

/// Those that go on and two rings around them.
std::vector<bool> AdaptiveLoop::faces_to_split() const {
  const std::size_t count = level_.faces.count();
  std::vector<bool> is_kept(count, false);
  for (std::uint32_t f = 0; f < count; ++f) {
    is_kept[f] = goes_on(f);
  }
  std::vector<bool> is_touched(level_.vertex_count(), false);
  for (int ring = 0; ring < 2; ++ring) {
    for (std::uint32_t h = 0; h < level_.half_edge_count(); ++h) {
      if (is_kept[h / 3]) {
        is_touched[level_.start(h)] = true;
      }
    }
    for (std::uint32_t h = 0; h < level_.half_edge_count(); ++h) {
      if (is_touched[level_.start(h)]) {
        is_kept[h / 3] = true;
      }
    }
  }
  return is_kept;
}

void AdaptiveLoop::split(const PartOfLevel& part) {
  const SchemeRules& rules = loop_rules();
  LevelMesh next;
  next.level = level_.level + 1;
  next.faces = rules.split(part.mesh);
  rules.connect(part.mesh, next);
  wear_off(part.mesh, next.vertex_starts.size(), next.edge_count, next);
  next.points.resize(next.vertex_starts.size());
  rules.place(part.mesh, settings_, next, {next.points.data(), nullptr});
  Numbers numbers(next.vertex_count(), kNone);
  for (std::size_t v = 0; v < part.vertices.size(); ++v) {
    numbers[v] = numbers_[part.vertices[v]];
  }
  level_ = std::move(next);
  numbers_ = std::move(numbers);
}

bool AdaptiveLoop::advance() {
  put_creases();
  const std::vector<bool> is_split = faces_to_split();
  const bool goes_further = std::ranges::find(is_split, true) != is_split.end();
  PartOfLevel part;
  const LevelMesh before = std::move(level_);
  const Numbers numbers_before = numbers_;
  level_ = LevelMesh();
  level_.level = before.level;
  if (goes_further) {
    part = part_of(before, is_split);
    split(part);
    number_vertices();
  }
  put_faces(before, part, numbers_before);
  return goes_further;
}

/// Those of `before` that ended there; the middles of their edges, where the faces beyond went on,
/// are vertices of the level at hand.
void AdaptiveLoop::put_faces(const LevelMesh& before, const PartOfLevel& part,
                             const Numbers& numbers_before) {
  const auto depth = [&](std::uint32_t f) { return depths_[before.faces.control_faces[f]]; };
  const std::size_t old = part.vertices.size();
  const std::size_t first = faces_;
  for (std::uint32_t f = 0; f < before.faces.count(); ++f) {
    if (depth(f) != before.level) {
      continue;
    }
    std::array<std::uint32_t, 3> corners{};
    std::array<std::uint32_t, 3> middles{kNone, kNone, kNone};
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t h = 3 * f + i;
      corners[i] = numbers_before[before.start(h)];
      const std::uint32_t twin = before.twins[h];
      if (twin != kNone && depth(twin / 3) > before.level) {
        const std::uint32_t edge = part.mesh.edges[3 * part.faces[f] + i];
        middles[i] = numbers_[old + edge];
      }
    }
    put_face(corners, middles, before.faces.control_faces[f]);
  }
  std::fill(result_.face_levels.begin() + static_cast<std::ptrdiff_t>(first),
            result_.face_levels.begin() + static_cast<std::ptrdiff_t>(faces_),
            static_cast<std::uint8_t>(before.level));
}

/// A triangle, or a fan where the middles of some edges are vertices, from one of these.
void AdaptiveLoop::put_face(const std::array<std::uint32_t, 3>& corners,
                            const std::array<std::uint32_t, 3>& middles,
                            std::uint32_t control_face) {
  const auto count = std::ranges::count_if(middles, [](std::uint32_t m) { return m != kNone; });
  if (count == 0) {
    put_triangle(corners[0], corners[1], corners[2], control_face);
    return;
  }
  // Turned so that edge 0 has a middle, and the edge before it has none unless all have.
  std::size_t first = 0;
  while (middles[first] == kNone || (count < 3 && middles[(first + 2) % 3] != kNone)) {
    ++first;
  }
  const std::uint32_t a = corners[first];
  const std::uint32_t b = corners[(first + 1) % 3];
  const std::uint32_t c = corners[(first + 2) % 3];
  const std::uint32_t ab = middles[first];
  const std::uint32_t bc = middles[(first + 1) % 3];
  const std::uint32_t ca = middles[(first + 2) % 3];
  if (bc == kNone) {
    put_triangle(ab, b, c, control_face);
  } else {
    put_triangle(ab, b, bc, control_face);
    put_triangle(ab, bc, c, control_face);
  }
  if (ca == kNone) {
    put_triangle(ab, c, a, control_face);
  } else {
    put_triangle(ab, c, ca, control_face);
    put_triangle(ab, ca, a, control_face);
  }
}

void AdaptiveLoop::put_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                std::uint32_t control_face) {
  std::uint32_t* const corners = result_.polygon_vertices.data() + 3 * faces_;
  corners[0] = a;
  corners[1] = b;
  corners[2] = c;
  result_.face_control_faces[faces_++] = control_face;
}

/// Sharp edges between faces that end here, or here and one level up.
void AdaptiveLoop::put_creases() {
  if (level_.edge_sharpness.empty()) {
    return;
  }
  for (std::uint32_t h = 0; h < level_.half_edge_count(); ++h) {
    const std::uint32_t twin = level_.twins[h];
    if (twin == kNone || !ends_here(h / 3)) {
      continue;
    }
    const std::uint8_t beyond = depth_of(twin / 3);
    const bool is_whole = beyond == level_.level ? level_.is_first(h) : beyond < level_.level;
    const float sharpness = level_.edge_sharpness[level_.edges[h]];
    if (is_whole && sharpness > 0.0f) {
      result_.creases.push_back({{numbers_[level_.start(h)], numbers_[level_.end(h)]}, sharpness});
    }
  }
}

RefinedMesh AdaptiveLoop::take() {
  LIMN_EXPECTS(faces_ == result_.polygon_count() && vertices_ == result_.vertex_count());
  for (std::uint32_t v = 0; v < vertex_sharpness_.size(); ++v) {
    if (vertex_sharpness_[v] > 0.0f) {
      result_.corners.push_back({v, vertex_sharpness_[v]});
    }
  }
  return std::move(result_);
}

}  // namespace

Result<RefinedMesh> refine_by_loop(const ControlMesh& mesh, std::span<const std::uint8_t> depths,
                                   const AdaptiveLoopSettings& settings, Progress& progress) {
  LIMN_EXPECTS(depths.size() == mesh.face_count());
  LIMN_ASSERT(std::ranges::equal(balanced_depths(mesh, depths), depths));
  if (Result<void> fits = check_fits(mesh, Scheme::kLoop); !fits) {
    return tl::unexpected(fits.error());
  }
  const SchemeCounts counts = predict_adaptive_loop(mesh, depths);
  constexpr std::uint64_t kMostFaces = 0xFFFFFFFFu / 3;
  if (const std::uint64_t most = std::min(settings.face_budget, kMostFaces); counts.faces > most) {
    return fail(ErrorKind::kOverBudget,
                fmt::format("The refinement would have {} faces, more than the allowed {}. Lower "
                            "the depths, refine fewer levels, or raise the face budget.",
                            counts.faces, most));
  }
  const int levels = depths.empty() ? 0 : *std::ranges::max_element(depths);
  AdaptiveLoop refinement(mesh, depths, settings);
  for (int level = 0;; ++level) {
    if (!progress.report(level / (levels + 1.0), fmt::format("Loop, level {}", level + 1))) {
      return fail(ErrorKind::kCancelled, "The refinement was cancelled.");
    }
    if (!refinement.advance()) {
      return refinement.take();
    }
  }
}

}  // namespace limn
