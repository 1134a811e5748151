// A walk over all patches with rings of a few levels, which is as far as most need, and another
// with all levels for the faces that are not done by then.
#include "limn/subdivision/face_errors.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <glm/trigonometric.hpp>

#include "limn/contract.h"
#include "subdivision/cage.h"
#include "subdivision/patch_errors.h"
#include "subdivision/patch_gather.h"
#include "subdivision/patch_levels.h"
#include "subdivision/patch_limits.h"
#include "subdivision/ring_tables.h"
#include "subdivision/root_nodes.h"
#include "subdivision/sweep.h"
#include "subdivision/world_origin.h"

namespace limn {
namespace {

/// Levels of rings that nearly all faces are done with.
constexpr int kFirstRings = 4;
/// Patches of faces that are no quads start at level 1 and are looked at one level down.
constexpr int kLeastRings = 2;
constexpr std::size_t kFaceGrain = 64;
constexpr std::size_t kFaceSlab = std::size_t{1} << 14;

tl::unexpected<Error> cancelled() {
  return fail(ErrorKind::kCancelled, "Choosing depths was cancelled.");
}

Cage cage_of(const ControlMesh& mesh, CornerRule corners) {
  Cage cage;
  cage.topology = &mesh.topology();
  cage.positions = mesh.positions();
  cage.origin = origin_of(mesh.bounds());
  cage.creases = &mesh.creases();
  cage.corners = corners;
  cage.is_all_quads = mesh.is_all_quads();
  return cage;
}

/// A grid of one face: all of a patch, at its root's level.
PatchGrid root_grid(const Patch& patch, int level) {
  return {{patch.grid.data(), 4, 1}, level, 0, 0, 15, 15};
}

/// Calls `visit(patch, root_level)` for the patches of face f.
template <class Visit>
void for_each_patch(const Cage& cage, const RingTables& rings, std::uint32_t f, Patch& patch,
                    const Visit& visit) {
  if (cage.side_count(f) == 4) {
    gather_quad(cage, rings, f, patch);
    visit(patch, 0);
    return;
  }
  const std::uint32_t first = cage.first_corner(f);
  for (std::uint32_t i = 0; i < cage.side_count(f); ++i) {
    gather_polygon_corner(cage, rings, f, first + i, patch);
    visit(patch, 1);
  }
}

/// Room for what is seen of one face after the other.
struct Scratch {
  Patch patch;
  std::vector<Point> corners;
  std::vector<LimitPoint> limits;
  std::vector<LimitPoint> middles;
};

double error_of_polygon(const Cage& cage, const RingTables& rings, std::uint32_t f,
                        SurfacePoints points, Scratch& scratch) {
  scratch.corners.clear();
  scratch.limits.clear();
  scratch.middles.clear();
  const std::uint32_t first = cage.first_corner(f);
  LimitPoint centre;
  for_each_patch(cage, rings, f, scratch.patch, [&](const Patch& patch, int level) {
    const PatchGrid grid = root_grid(patch, level);
    const std::size_t i = scratch.corners.size();
    scratch.corners.push_back(cage.point(cage.topology->corner_vertices[first + i]));
    scratch.limits.push_back(limit_in_patch(patch, grid, kRootCorners[0]));
    scratch.middles.push_back(limit_in_patch(patch, grid, kRootCorners[1]));
    centre = limit_in_patch(patch, grid, kRootCorners[2]);
  });
  return polygon_error({scratch.corners, scratch.limits, scratch.middles, centre}, points);
}

/// A coarser level's error is never below a finer one's: where it is, it was missed.
void make_falling(LevelErrors& errors) {
  for (std::size_t level = errors.size() - 1; level-- > 0;) {
    errors[level] = std::max(errors[level], errors[level + 1]);
  }
}

/// Faces, and how far the rings around them reach.
class ErrorSweep {
 public:
  ErrorSweep(const ControlMesh& mesh, const FaceErrorOptions& options, Progress& progress)
      : cage_(cage_of(mesh, options.corners)),
        options_(options),
        sweep_(progress, sums_),
        errors_(mesh.face_count()),
        rings_of_faces_(mesh.face_count()),
        is_done_(mesh.face_count()) {}

  [[nodiscard]] Result<std::vector<LevelErrors>> run() {
    const int most = std::clamp(options_.deepest + 1, kLeastRings, static_cast<int>(kErrorLevels));
    sweep_.begin_stage("Measuring the limit surface", 0.0, 0.5, 2 * cage_.face_count());
    visit_all(std::min(kFirstRings, most));
    if (most > kFirstRings && std::ranges::find(is_done_, 0) != is_done_.end()) {
      sweep_.begin_stage("Measuring the limit surface", 0.5, 1.0, 2 * cage_.face_count());
      visit_all(most);
    }
    if (sweep_.is_cancelled()) {
      return cancelled();
    }
    return std::move(errors_);
  }

 private:
  /// Those that are not done, with rings of so many levels.
  void visit_all(int rings) {
    for (std::size_t f = 0; f < cage_.face_count(); ++f) {
      rings_of_faces_[f] = static_cast<std::uint8_t>(is_done_[f] != 0 ? 1 : rings);
    }
    rings_.build(sweep_, cage_, rings_of_faces_, true);
    const Creases& creases = *cage_.creases;
    const PatchErrorWish wish{options_.points, options_.enough, rings - 1,
                              !creases.edge_sharpness.empty() || !creases.vertex_sharpness.empty()};
    sweep_.ranges(
        cage_.face_count(), kFaceSlab, kFaceGrain, 1, [&](std::size_t begin, std::size_t end) {
          visit_range(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end), wish);
        });
  }

  void visit_range(std::uint32_t begin, std::uint32_t end, const PatchErrorWish& wish) {
    Scratch scratch;
    PatchErrors patches(wish);
    for (std::uint32_t f = begin; f < end; ++f) {
      if (is_done_[f] == 0) {
        is_done_[f] = visit(f, wish, patches, scratch) ? 1 : 0;
      }
    }
    patches.finish();
    std::for_each(errors_.begin() + begin, errors_.begin() + end, make_falling);
  }

  bool visit(std::uint32_t f, const PatchErrorWish& wish, PatchErrors& patches, Scratch& scratch) {
    LevelErrors& errors = errors_[f];
    errors.fill(0.0F);
    bool is_complete = true;
    if (cage_.side_count(f) != 4) {
      errors[0] = static_cast<float>(error_of_polygon(cage_, rings_, f, wish.points, scratch));
    }
    for_each_patch(cage_, rings_, f, scratch.patch, [&](const Patch& patch, int level) {
      is_complete = patches.add(patch, level, errors) && is_complete;
    });
    return is_complete;
  }

  Cage cage_;
  FaceErrorOptions options_;
  std::vector<std::uint64_t> sums_;
  Sweep sweep_;
  RingTables rings_;
  std::vector<LevelErrors> errors_;
  std::vector<std::uint8_t> rings_of_faces_;
  std::vector<std::uint8_t> is_done_;  ///< Bytes, since threads write neighbours.
};

/// Normals seen so far, and the greatest angle between two of them.
class Turn {
 public:
  void clear() noexcept { normals_.clear(); }
  /// A place without a tangent plane has none.
  void add(const glm::dvec3& normal) {
    if (normal != glm::dvec3(0.0)) {
      normals_.push_back(normal);
    }
  }
  [[nodiscard]] double degrees() const noexcept {
    double least_cosine = 1.0;
    double greatest_sine = 0.0;
    for (std::size_t i = 0; i < normals_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const double cosine = glm::dot(normals_[i], normals_[j]);
        if (cosine < least_cosine) {
          least_cosine = cosine;
          greatest_sine = glm::length(glm::cross(normals_[i], normals_[j]));
        }
      }
    }
    return glm::degrees(std::atan2(greatest_sine, least_cosine));
  }

 private:
  std::vector<glm::dvec3> normals_;
};

/// The normals of a face at level `face.level`: at its corners, the middles of its sides, and its
/// centre. A corner where the surface is creased has those of several sides, so there a place
/// within the face stands for it.
void add_normals(const Patch& patch, const PatchGrid& face, bool is_creased, Turn& turn) {
  std::array<Point, 25> points;
  step_down(patch, face, points.data());
  const PatchGrid next = one_level_down(face, points.data());
  for (std::size_t i = 0; i < 4; ++i) {
    if (is_creased && patch.corners[i].ring.exists()) {
      const PatchGrid beside = face_at_corner(next, i);
      std::array<Point, 25> around;
      step_down(patch, beside, around.data());
      turn.add(limit_in_patch(patch, one_level_down(beside, around.data()), {1, 1}).normal);
    } else {
      turn.add(limit_in_patch(patch, next, kCornersOfFour[i]).normal);
    }
    turn.add(limit_in_patch(patch, next, kMiddlesOfFour[i]).normal);
  }
  turn.add(limit_in_patch(patch, next, {1, 1}).normal);
}

}  // namespace

Result<std::vector<LevelErrors>> face_errors(const ControlMesh& mesh,
                                             const FaceErrorOptions& options, Progress& progress) {
  LIMN_EXPECTS(options.deepest >= 0 && options.deepest < static_cast<int>(kErrorLevels));
  return ErrorSweep(mesh, options, progress).run();
}

Result<std::vector<float>> face_bends(const ControlMesh& mesh, CornerRule corners,
                                      Progress& progress) {
  constexpr std::uint8_t kRings = 3;  // Two steps down from the quads of any face.
  const Cage cage = cage_of(mesh, corners);
  const bool is_creased = !cage.creases->edge_sharpness.empty();
  std::vector<std::uint64_t> sums;
  Sweep sweep(progress, sums);
  sweep.begin_stage("Measuring how the surface bends", 0.0, 1.0, 2 * mesh.face_count());
  RingTables rings;
  rings.build(sweep, cage, std::vector<std::uint8_t>(mesh.face_count(), kRings), true);
  std::vector<float> bends(mesh.face_count());
  sweep.ranges(mesh.face_count(), kFaceSlab, kFaceGrain, 1,
               [&](std::size_t begin, std::size_t end) {
                 Patch room;
                 Turn turn;
                 for (auto f = static_cast<std::uint32_t>(begin); f < end; ++f) {
                   turn.clear();
                   for_each_patch(cage, rings, f, room, [&](const Patch& patch, int level) {
                     add_normals(patch, root_grid(patch, level), is_creased, turn);
                   });
                   bends[f] = static_cast<float>(turn.degrees());
                 }
               });
  if (sweep.is_cancelled()) {
    return cancelled();
  }
  return bends;
}

}  // namespace limn
