// A bicubic's errors are known for all levels at once: its second derivatives, times the quads'
// area. So a quadtree walk goes down only where the patch is no bicubic: to irregular corners, and
// along creases that wear off.
#include "subdivision/patch_errors.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "subdivision/patch_levels.h"
#include "subdivision/patch_limits.h"

namespace limn {
namespace {

/// By how much the error beside an irregular vertex falls a level, at the slowest, for valences
/// that occur: extrapolation where nobody looks any more.
constexpr double kSlowestFall = 0.4;

/// What nine places of a coarse quad miss of its greatest error where creases wear off around it:
/// up to a fifth in all meshes that were tried.
constexpr double kMissedBesideCreases = 1.2;

/// How much of what lies within the surface counts, times the sine of how far it turns. A shift by
/// t within a surface that turns by an angle lifts a point by t times its sine at the most, yet
/// where a quad is furthest off it is parallel to the surface, and there a shift lifts nothing. All
/// of it made estimates twice what is measured, none of it a fifth too small here and there. At
/// positions of the level it is corners that are furthest off, and nothing is parallel there.
constexpr double part_within(SurfacePoints points) noexcept {
  return points == SurfacePoints::kLimit ? 0.25 : 1.0;
}

double dot(const Point& a, const Point& b) noexcept {
  const Point product = a * b;
  return product[0] + product[1] + product[2];
}

double length(const Point& a) noexcept {
  return std::sqrt(dot(a, a));
}

/// What a vector has at right angles to another; all of it where that is none.
double length_across(const Point& a, const Point& along) noexcept {
  const double square = dot(along, along);
  return square > 0.0 ? length(a - along * (dot(a, along) / square)) : length(a);
}

/// The error of quads of one level, in parts that fall at different speeds.
struct ErrorParts {
  double outwards = 0.0;  ///< What stands out of the surface: a quarter a level.
  double within = 0.0;    ///< What lies in it counts by as much as it turns within a quad:
  double turn = 0.0;      ///< the sine of that angle, a half a level.
  double part_within = 1.0;

  void add_outwards(double error) noexcept { outwards = std::max(outwards, error); }
  void add_within(double error) noexcept { within = std::max(within, error); }
  [[nodiscard]] double error() const noexcept {
    const double sine = std::min(1.0, turn);
    return outwards + std::min(1.0, part_within + sine) * sine * within;
  }
  /// To those of the quads that these become.
  void go_deeper() noexcept {
    outwards *= 0.25;
    within *= 0.25;
    turn *= 0.5;
  }
};

/// The normals of nine places, and how far they are apart.
class Normals {
 public:
  explicit Normals(const std::array<Point, 9>& normals) : normals_(&normals) {}

  /// The greatest sine of an angle to the middle one; 1 where some place has no normal.
  [[nodiscard]] double turn() const noexcept {
    const Point& middle = (*normals_)[4];
    double least = 1.0;
    for (const Point& normal : *normals_) {
      least = std::min(least, dot(normal, middle));
    }
    return least > 0.0 ? std::sqrt(std::max(0.0, 1.0 - least * least)) : 1.0;
  }

 private:
  const std::array<Point, 9>* normals_;
};

/// Where a unit quad is cut.
enum class Diagonal { kUp, kDown, kEither };  ///< From the first corner, or to it.

/// The shorter one, with these first derivatives; either, where both are about as long.
Diagonal shorter_diagonal(const Point& u, const Point& v) noexcept {
  constexpr double kAboutEqual = 0.1;
  const double up = dot(u, v);
  const double size = dot(u, u) + dot(v, v);
  return std::abs(up) < kAboutEqual * size ? Diagonal::kEither
         : up < 0.0                        ? Diagonal::kUp
                                           : Diagonal::kDown;
}

/// Which of the nine places lie on side i.
constexpr std::array<std::array<std::size_t, 3>, 4> kSidePlaces{
    {{0, 1, 2}, {2, 5, 8}, {8, 7, 6}, {6, 3, 0}}};

void raise_to(LevelErrors& errors, int level, double error) noexcept {
  float& kept = errors[static_cast<std::size_t>(level)];
  kept = std::max(kept, static_cast<float>(error));
}

}  // namespace

/// Down a patch.
class PatchErrors::Walk {
 public:
  Walk(PatchErrors& sums, const Patch& patch, LevelErrors& errors)
      : sums_(&sums), patch_(&patch), wish_(&sums.wish_), errors_(&errors) {}

  void visit(const PatchGrid& face);
  [[nodiscard]] bool is_complete() const noexcept { return is_complete_; }

 private:
  [[nodiscard]] std::optional<std::uint8_t> bicubic_curves(const PatchGrid& face) const;
  void add_bicubic(const PatchGrid& face, std::uint8_t curves);
  [[nodiscard]] ErrorParts measure(const PatchGrid& face, const PatchGrid& next) const;
  [[nodiscard]] bool is_amid_smooth_surface(const PatchGrid& face, std::size_t i) const noexcept;
  void raise(int level, double error) noexcept { raise_to(*errors_, level, error); }

  PatchErrors* sums_;
  const Patch* patch_;
  const PatchErrorWish* wish_;
  LevelErrors* errors_;
  bool is_complete_ = true;
};

/// Which sides are curves of their own (bits), where it is one bicubic.
std::optional<std::uint8_t> PatchErrors::Walk::bicubic_curves(const PatchGrid& face) const {
  std::uint8_t curves = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (has(face.patch_corners, i) && patch_->corners[i].ring.exists()) {
      return std::nullopt;
    }
    const SideLimits side = side_limits(*patch_, face, i);
    if (side == SideLimits::kWearing) {
      return std::nullopt;
    }
    curves |= bit(i, side == SideLimits::kMirrored);
  }
  return curves;
}

void PatchErrors::Walk::add_bicubic(const PatchGrid& face, std::uint8_t curves) {
  const Target target{errors_, face.level};
  if (curves == 0) {
    sums_->add_bicubic(face.grid.points, face.grid.stride, 0, target);
    return;
  }
  std::array<Point, 16> points;
  for (std::size_t y = 0; y < 4; ++y) {
    std::copy_n(face.grid.points + y * face.grid.stride, 4, points.data() + 4 * y);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    if (has(curves, i)) {
      mirror_ring({points.data(), 4, 1}, i, points.data());
    }
  }
  sums_->add_bicubic(points.data(), 4, curves, target);
}

/// Whether the surface has one tangent plane around corner i and goes on on all sides.
bool PatchErrors::Walk::is_amid_smooth_surface(const PatchGrid& face,
                                               std::size_t i) const noexcept {
  const auto is_open = [&](std::size_t side) {
    return !has(face.patch_sides, side) || patch_->sides[side].kind == SideKind::kOpen;
  };
  return !wish_->is_creased && is_open(i) && is_open((i + 3) % 4) &&
         !(has(face.patch_corners, i) && patch_->corners[i].is_on_boundary);
}

/// The error of the face as a quad of its own level, from its limits one level down.
ErrorParts PatchErrors::Walk::measure(const PatchGrid& face, const PatchGrid& next) const {
  std::array<Point, 9> limits;
  std::array<Point, 9> normals;
  for (std::size_t i = 0; i < 9; ++i) {
    const LimitPoint limit = limit_in_patch(*patch_, next, {i % 3, i / 3});
    limits[i] = to_point(limit.position);
    normals[i] = to_point(limit.normal);
  }
  constexpr std::array<std::size_t, 4> kCorners{0, 2, 8, 6};
  const GridView& grid = face.grid;
  const std::array<const Point*, 4> stored{
      grid.points + grid.stride + 1, grid.points + grid.stride + 2,
      grid.points + 2 * grid.stride + 2, grid.points + 2 * grid.stride + 1};
  ErrorParts parts;
  parts.part_within = part_within(wish_->points);
  const auto add = [&](const Point& off, std::size_t place) {
    const double out = dot(off, normals[place]);
    parts.add_outwards(std::abs(out));
    parts.add_within(length(off - normals[place] * out));
  };
  std::array<Point, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    corners[i] = wish_->points == SurfacePoints::kLimit ? limits[kCorners[i]] : *stored[i];
    const Point off = corners[i] - limits[kCorners[i]];
    if (is_amid_smooth_surface(face, i)) {
      add(off, kCorners[i]);
    } else {
      parts.add_outwards(length(off));  // The normal may be another side's.
    }
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t middle = kSidePlaces[i][1];
    const Point& from = corners[i];
    const Point& to = corners[(i + 1) % 4];
    const Point off = limits[middle] - (from + to) * 0.5;
    add(off, middle);
    if (has(face.patch_sides, i) && patch_->sides[i].kind != SideKind::kOpen) {
      parts.add_outwards(length_across(off, to - from));
    }
  }
  const Diagonal diagonal = shorter_diagonal(corners[1] + corners[2] - corners[0] - corners[3],
                                             corners[2] + corners[3] - corners[0] - corners[1]);
  if (diagonal != Diagonal::kDown) {
    add(limits[4] - (corners[0] + corners[2]) * 0.5, 4);
  }
  if (diagonal != Diagonal::kUp) {
    add(limits[4] - (corners[1] + corners[3]) * 0.5, 4);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    if (wish_->is_creased && has(face.patch_corners, i) && patch_->corners[i].ring.exists()) {
      normals[kCorners[i]] = normals[4];  // That of another side would make much of a flat one.
    }
  }
  parts.turn = Normals(normals).turn();
  return parts;
}

void PatchErrors::Walk::visit(const PatchGrid& face) {
  if (const std::optional<std::uint8_t> curves = bicubic_curves(face)) {
    add_bicubic(face, *curves);
    return;
  }
  std::array<Point, 25> points;
  step_down(*patch_, face, points.data());
  const PatchGrid next = one_level_down(face, points.data());
  const double error =
      measure(face, next).error() * (wish_->is_creased ? kMissedBesideCreases : 1.0);
  raise(face.level, error);
  if (error <= wish_->enough || face.level >= wish_->last_level) {
    is_complete_ = is_complete_ && error <= wish_->enough;
    double deeper = error;
    for (int level = face.level + 1; level < static_cast<int>(kErrorLevels); ++level) {
      deeper *= kSlowestFall;
      raise(level, deeper);
    }
    return;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    visit(face_at_corner(next, i));
  }
}

bool PatchErrors::add(const Patch& patch, int root_level, LevelErrors& errors) {
  if (patch.is_plain) {
    add_bicubic(patch.grid.data(), 4, 0, {&errors, root_level});
    return true;
  }
  Walk walk(*this, patch, errors);
  walk.visit({{patch.grid.data(), 4, 1}, root_level, 0, 0, 15, 15});
  return walk.is_complete();
}

void PatchErrors::add_bicubic(const StoredPoint* points, std::size_t stride, std::uint8_t curves,
                              const Target& target) {
  for (std::size_t y = 0; y < 4; ++y) {
    std::copy_n(points + y * stride, 4, batch_.points[count_] + 4 * y);
  }
  batch_.curves[count_] = curves;
  targets_[count_] = target;
  if (++count_ == BicubicBatch::kMost) {
    visit_batch();
  }
}

void PatchErrors::finish() {
  if (count_ > 0) {
    visit_batch();  // What is left in the other places is known already.
  }
}

void PatchErrors::visit_batch() {
  BicubicErrors found;
  bicubic_errors(batch_, wish_.points == SurfacePoints::kLevel, found);
  for (std::size_t i = 0; i < count_; ++i) {
    ErrorParts parts{found.outwards[i], found.within[i], found.turn[i], part_within(wish_.points)};
    for (int level = targets_[i].level; level < static_cast<int>(kErrorLevels); ++level) {
      raise_to(*targets_[i].errors, level, parts.error());
      parts.go_deeper();
    }
  }
  count_ = 0;
}

double polygon_error(const PolygonSamples& samples, SurfacePoints points) {
  const std::size_t n = samples.corners.size();
  const auto corner = [&](std::size_t i) {
    return points == SurfacePoints::kLimit ? to_point(samples.limits[i].position)
                                           : samples.corners[i];
  };
  Point mean{};
  for (std::size_t i = 0; i < n; ++i) {
    mean += corner(i);
  }
  mean /= static_cast<double>(n);
  const Point normal = to_point(samples.centre.normal);
  const Point off = to_point(samples.centre.position) - mean;
  ErrorParts parts;
  parts.part_within = part_within(points);
  parts.add_outwards(std::abs(dot(off, normal)));
  parts.add_within(length(off - normal * dot(off, normal)));
  double least_cosine = 1.0;
  for (std::size_t i = 0; i < n; ++i) {
    const Point here = corner(i);
    const Point next = corner((i + 1) % n);
    least_cosine = std::min(least_cosine, dot(to_point(samples.middles[i].normal), normal));
    parts.add_outwards(length(here - to_point(samples.limits[i].position)));
    parts.add_outwards(
        length_across(to_point(samples.middles[i].position) - (here + next) * 0.5, next - here));
    if (n > 3) {  // Cut into triangles it may leave its mean plane by as much.
      parts.add_outwards(std::abs(dot(here - mean, normal)));
    }
  }
  parts.turn =
      least_cosine > 0.0 ? std::sqrt(std::max(0.0, 1.0 - least_cosine * least_cosine)) : 1.0;
  return parts.error();
}

}  // namespace limn
