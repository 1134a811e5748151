// The engine that refines a mesh knows the limit surface: with all labels raised by some levels and
// its vertices put on the limit it gives points and normals of it where the mesh is, and as much
// finer. Either surface is then sampled against the other: twice everywhere, and from then on
// a level finer each time in the control faces alone that the figures still depend on.
#include "limn/comparison/limit_distance.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "comparison/directed_sampling.h"
#include "comparison/limit_surface.h"
#include "limn/contract.h"
#include "limn/part_of_progress.h"
#include "limn/subdivision/label_subdivision.h"
#include "subdivision/sweep.h"

namespace limn {
namespace {

/// Labels cannot be higher: a face painted as deep as can be, on a mesh with non-quads.
constexpr int kHighestLabel = kMaxDepth + 1;
/// Of the diagonal: what is left of positions in single precision.
constexpr double kNothing = 2e-7;
/// Small meshes are looked at no less closely than this.
constexpr std::uint64_t kFewestFaces = 1'000;
/// Samples that take no time to speak of.
constexpr std::size_t kFewSamples = std::size_t{1} << 22;

/// Distances of faces, raised by several threads.
void raise(float& value, double to) {
  std::atomic_ref<float> shared(value);
  const auto candidate = static_cast<float>(to);
  float before = shared.load(std::memory_order_relaxed);
  while (before < candidate &&
         !shared.compare_exchange_weak(before, candidate, std::memory_order_relaxed)) {
  }
}

/// The figures of both directions.
struct Figures {
  DirectedDistance to_limit;
  DirectedDistance from_limit;
};

std::size_t samples_in(const Figures& figures) {
  return figures.to_limit.samples + figures.from_limit.samples;
}

/// What is known of the control faces, and how it came about.
class Measurement {
 public:
  Measurement(const ControlMesh& mesh, const VertexLabels& labels,
              const SubdivisionSettings& settings, const RefinedMesh& refined, Progress& progress,
              Sweep& sweep)
      : mesh_(&mesh),
        labels_(&labels),
        settings_(settings),
        progress_(&progress),
        sweep_(&sweep),
        measured_(refined, sweep),
        of_faces_(refined.face_count(), 0.0f),
        to_limit_(mesh.face_count()),
        from_limit_(mesh.face_count()) {
    settings_.points = SurfacePoints::kLimit;
  }

  /// Looks at the control faces that have `levels` above 0, that many less one above their labels;
  /// at the others it takes the limit surface at `rest` levels. The progress runs between the
  /// fractions.
  [[nodiscard]] Result<void> look(std::span<const std::uint8_t> levels, int rest, double from,
                                  double to);

  [[nodiscard]] Figures figures() const {
    return {directed_distance(to_limit_), directed_distance(from_limit_)};
  }
  [[nodiscard]] std::span<const GroupDistance> to_limit() const noexcept { return to_limit_; }
  [[nodiscard]] std::span<const GroupDistance> from_limit() const noexcept { return from_limit_; }
  [[nodiscard]] LargeArray<float>& of_faces() noexcept { return of_faces_; }

 private:
  [[nodiscard]] Result<VertexLabels> raised(std::span<const std::uint8_t> levels, int rest) const;

  const ControlMesh* mesh_;
  const VertexLabels* labels_;
  SubdivisionSettings settings_;
  Progress* progress_;
  Sweep* sweep_;
  MeasuredMesh measured_;
  LargeArray<float> of_faces_;
  std::vector<GroupDistance> to_limit_;
  std::vector<GroupDistance> from_limit_;
};

Result<VertexLabels> Measurement::raised(std::span<const std::uint8_t> levels, int rest) const {
  const FlatTopology& topology = mesh_->topology();
  VertexLabels result(labels_->size());
  for (std::size_t v = 0; v < result.size(); ++v) {
    int more = rest;
    for (std::uint32_t i = topology.vertex_offsets[v]; i < topology.vertex_offsets[v + 1]; ++i) {
      more = std::max(more, levels[topology.corner_faces[topology.vertex_corners[i]]] - 1);
    }
    result[v] = static_cast<std::uint8_t>(std::min((*labels_)[v] + more, kHighestLabel));
  }
  if (rest > 0) {
    return result;  // No label is 0, and so none is illegal.
  }
  IgnoreProgress nobody;
  return legalise_look_ahead(
             *mesh_, apply_non_quad_rule(*mesh_, std::move(result), NonQuadRule::kWherePainted),
             NonQuadRule::kWherePainted, nobody)
      .map([](Legalisation&& legal) { return std::move(legal.labels); });
}

Result<void> Measurement::look(std::span<const std::uint8_t> levels, int rest, double from,
                               double to) {
  const Result<VertexLabels> labels = raised(levels, rest);
  if (!labels) {
    return tl::unexpected(labels.error());
  }
  const double refined = from + 0.1 * (to - from);
  PartOfProgress part(*progress_, from, refined);
  Result<RefinedMesh> points = refine(*mesh_, *labels, settings_, {.normals = true}, part);
  if (!points) {
    return tl::unexpected(std::move(points.error()));
  }
  std::vector<std::uint32_t> parts(levels.size());
  std::vector<bool> is_looked_at(levels.size());
  for (std::size_t f = 0; f < levels.size(); ++f) {
    parts[f] = levels[f] > 0 ? 1u << (levels[f] - 1) : 0;
    is_looked_at[f] = levels[f] > 0;
    if (is_looked_at[f]) {
      to_limit_[f] = {};
      from_limit_[f] = {};
    }
  }
  sweep_->begin_stage("Measuring", refined, to, 40 * points->face_count());
  const LimitSurface limit(std::move(*points), std::move(is_looked_at), *sweep_);
  measured_.set_parts(std::move(parts));
  if (!sweep_->is_cancelled()) {
    measure_directed(
        measured_, limit,
        [this](std::uint32_t t, double distance, std::uint32_t) {
          raise(of_faces_[measured_.face(t)], distance);
        },
        to_limit_, *sweep_);
    measure_directed(
        limit, measured_,
        [this](std::uint32_t, double distance, std::uint32_t nearest) {
          raise(of_faces_[measured_.face(nearest)], distance);
        },
        from_limit_, *sweep_);
  }
  if (sweep_->is_cancelled()) {
    return fail(ErrorKind::kCancelled, "Measuring was cancelled.");
  }
  return {};
}

double greatest_in(std::span<const GroupDistance> groups) {
  double greatest = 0.0;
  for (const GroupDistance& group : groups) {
    greatest = std::max(greatest, group.greatest);
  }
  return greatest;
}

/// Marks the control faces that have much of the greatest distance, if that changed.
void mark_peaks(std::span<const GroupDistance> before, std::span<const GroupDistance> now,
                double change, std::vector<bool>& is_marked) {
  constexpr double kNear = 0.85;
  const double greatest = greatest_in(now);
  if (std::abs(greatest - greatest_in(before)) <= change * greatest) {
    return;
  }
  for (std::size_t f = 0; f < now.size(); ++f) {
    is_marked[f] = is_marked[f] || now[f].greatest >= kNear * greatest;
  }
}

/// Marks the control faces whose squares changed most, until those of all others together changed
/// by no more than a quarter of what is allowed.
void mark_changes(std::span<const GroupDistance> before, std::span<const GroupDistance> now,
                  double change, std::vector<bool>& is_marked) {
  std::vector<std::pair<double, std::uint32_t>> changes;
  double sum = 0.0;
  double squares_before = 0.0;
  double squares = 0.0;
  for (std::uint32_t f = 0; f < now.size(); ++f) {
    changes.emplace_back(std::abs(now[f].squares - before[f].squares), f);
    sum += changes.back().first;
    squares_before += before[f].squares;
    squares += now[f].squares;
  }
  // Squares change by twice as much as their root. What was not looked at again did not change.
  if (std::abs(squares_before - squares) <= 2.0 * change * squares) {
    return;
  }
  std::ranges::sort(changes, std::greater<>());
  for (const auto& [of_face, f] : changes) {
    if (sum <= 0.25 * 2.0 * change * squares) {
      return;
    }
    sum -= of_face;
    is_marked[f] = true;
  }
}

/// Which control faces are looked at next, and how closely.
class Rounds {
 public:
  /// At first all, at `rest` levels.
  Rounds(Measurement& measurement, int rest)
      : measurement_(&measurement),
        rest_(rest),
        levels_(measurement.to_limit().size(), static_cast<std::uint8_t>(rest + 1)),
        is_next_(levels_.size(), true) {}

  /// Looks at the next ones, one level more closely than any before, in pieces that take no more
  /// memory than the mesh itself or a few hundred megabytes.
  [[nodiscard]] Result<void> look(double from, double to);
  /// After all have been looked at twice: those that figures depend on which have not settled.
  void choose(double change);
  [[nodiscard]] bool can_go_on() const { return rest_ + round_ < kHighestLabel; }
  /// As far as can be told from the last.
  [[nodiscard]] std::size_t next_samples() const {
    std::size_t samples = 0;
    for (std::size_t f = 0; f < levels_.size(); ++f) {
      samples += is_next_[f] ? samples_of(f) : 0;
    }
    return samples;
  }

 private:
  [[nodiscard]] std::size_t samples_of(std::size_t f) const {
    const int further = rest_ + round_ + 1 - levels_[f];
    return (measurement_->to_limit()[f].samples + measurement_->from_limit()[f].samples)
           << (2 * further);
  }

  Measurement* measurement_;
  int rest_;
  std::vector<std::uint8_t> levels_;  ///< One more than those last looked at, by control face.
  std::vector<bool> is_next_;
  std::vector<GroupDistance> to_before_;
  std::vector<GroupDistance> from_before_;
  int round_ = 0;
};

Result<void> Rounds::look(double from, double to) {
  constexpr std::size_t kSamplesInPiece = std::size_t{1} << 25;
  to_before_.assign(measurement_->to_limit().begin(), measurement_->to_limit().end());
  from_before_.assign(measurement_->from_limit().begin(), measurement_->from_limit().end());
  if (round_ == 1) {
    std::ranges::fill(measurement_->of_faces(), 0.0f);
  }
  const std::size_t all = next_samples();
  const auto level = static_cast<std::uint8_t>(rest_ + round_ + 1);
  const std::size_t pieces = all / kSamplesInPiece + 1;
  std::size_t f = 0;
  for (std::size_t piece = 0; piece < pieces; ++piece) {
    std::vector<std::uint8_t> looked(levels_.size(), 0);
    std::size_t samples = 0;
    bool has_any = false;
    for (; f < levels_.size() && (samples <= all / pieces || piece + 1 == pieces); ++f) {
      if (is_next_[f]) {
        samples += samples_of(f);
        looked[f] = levels_[f] = level;
        has_any = true;
      }
    }
    if (!has_any) {
      continue;
    }
    const double part = (to - from) / static_cast<double>(pieces);
    const double begin = from + part * static_cast<double>(piece);
    if (auto seen = measurement_->look(looked, rest_, begin, begin + part); !seen) {
      return seen;
    }
  }
  ++round_;
  return {};
}

void Rounds::choose(double change) {
  is_next_.assign(is_next_.size(), false);
  mark_peaks(to_before_, measurement_->to_limit(), change, is_next_);
  mark_peaks(from_before_, measurement_->from_limit(), change, is_next_);
  mark_changes(to_before_, measurement_->to_limit(), change, is_next_);
  mark_changes(from_before_, measurement_->from_limit(), change, is_next_);
}

}  // namespace

Result<LimitDistance> measure_limit_distance(const ControlMesh& mesh, const VertexLabels& labels,
                                             const SubdivisionSettings& settings,
                                             const RefinedMesh& refined, Progress& progress,
                                             const LimitDistanceLimits& limits) {
  LIMN_EXPECTS(labels.size() == mesh.vertex_count());
  if (settings.scheme != RefinementScheme::kCatmullClark) {
    return fail(ErrorKind::kUsage,
                "Only the distance to the limit surface of Catmull-Clark can be measured.");
  }
  std::vector<std::uint64_t> scratch;
  Sweep sweep(progress, scratch);
  sweep.begin_stage("Sorting triangles", 0.0, 0.05, 30 * refined.face_count());
  Measurement measurement(mesh, labels, settings, refined, progress, sweep);

  const double nothing = kNothing * mesh.bounds().diagonal();
  int rest = refined.polygon_count() > 0 ? 1 : 0;
  while ((refined.face_count() << (2 * rest)) < kFewestFaces) {
    ++rest;
  }
  Rounds rounds(measurement, rest);
  LimitDistance result;
  std::size_t most = limits.samples;
  double done = 0.05;
  for (int round = 0;; ++round) {
    const double until = done + (round < 2 ? 0.4 : 0.5 * (1.0 - done));
    if (const Result<void> seen = rounds.look(done, until); !seen) {
      return tl::unexpected(seen.error());
    }
    done = until;
    const Figures now = measurement.figures();
    const bool is_to_settled = has_settled(result.to_limit, now.to_limit, limits.change, nothing);
    const bool is_from_settled =
        has_settled(result.from_limit, now.from_limit, limits.change, nothing);
    result.to_limit = now.to_limit;
    result.from_limit = now.from_limit;
    result.is_settled = round > 0 && is_to_settled && is_from_settled;
    if (result.is_settled) {
      break;
    }
    if (round > 0) {
      rounds.choose(limits.change);
    }
    // Looking closely at some of it takes no longer than four times what looking at all of it did.
    most = round == 1 ? std::min(limits.samples, std::max(kFewSamples, 4 * samples_in(now))) : most;
    if (!rounds.can_go_on() || (round > 0 && rounds.next_samples() > most)) {
      break;
    }
  }
  result.of_faces = std::move(measurement.of_faces());
  const auto greatest = static_cast<float>(result.greatest());
  for (float& of_face : result.of_faces) {
    of_face =
        std::min(of_face, greatest);  // What a face that was looked at more closely had before.
  }
  for (DirectedDistance* directed : {&result.to_limit, &result.from_limit}) {
    directed->from += refined.origin;
    directed->to += refined.origin;
  }
  return result;
}

}  // namespace limn
