// Whether the faces are quads does not matter to a step of the ring, so limit masks, which are left
// eigenvectors of it, hold for any face sizes once they are written in centroids: with quads the
// fourth corner is f_i = 4 c_i - v - e_i - e_(i+1), which is how published masks come to this form.
// Points are taken relative to the vertex, lest digits be lost far from the origin.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "subdivision/sharpness.h"
#include "subdivision/vertex_ring.h"

namespace limn {
namespace {

/// The greater eigenvalue of the step on the waves sin and cos of an angle a face.
double wave_eigenvalue(double cosine) noexcept {
  return (5.0 + cosine + std::sqrt((1.0 + cosine) * (9.0 + cosine))) / 16.0;
}

/// Turns by the same angle again and again.
struct Wave {
  double cosine = 1.0;
  double sine = 0.0;

  [[nodiscard]] Wave turned(const Wave& by) const noexcept {
    return {cosine * by.cosine - sine * by.sine, sine * by.cosine + cosine * by.sine};
  }
};

/// Weights of the points of a ring with one sharp edge, edge 0.
struct DartMask {
  double centre = 0.0;
  std::vector<double> edges;
  std::vector<double> centroids;

  explicit DartMask(std::size_t n) : edges(n), centroids(n) {}

  [[nodiscard]] double sum() const noexcept {
    return std::accumulate(centroids.begin(), centroids.end(),
                           std::accumulate(edges.begin(), edges.end(), centre));
  }
  /// The mask that gives on a ring what this one gives on the ring one level down.
  [[nodiscard]] DartMask pulled_back() const;
  /// Takes out of the mask of an even tangent what rounding put in: parts of the masks of the
  /// position and of the odd tangent, whose eigenvalues may be the greater.
  void make_even_tangent();
  /// Makes the greatest weight 1.
  void normalise();
  [[nodiscard]] double distance(const DartMask& other) const noexcept;
};

DartMask DartMask::pulled_back() const {
  const std::size_t n = edges.size();
  const auto count = static_cast<double>(n);
  double on_centre = centre;             // On the new vertex, by itself and in new centroids,
  std::vector<double> on_edges = edges;  // and likewise on new edge points.
  for (std::size_t i = 0; i < n; ++i) {
    const double quarter = 0.25 * centroids[i];
    on_centre += quarter;
    on_edges[i] += quarter;
    on_edges[(i + 1) % n] += quarter;
  }
  const double everywhere = on_centre / (count * count);
  const auto smooth = [&](std::size_t i) { return i == 0 ? 0.0 : 0.25 * on_edges[i]; };
  DartMask above(n);
  above.centre = on_centre * (count - 2.0) / count + 0.5 * on_edges[0];
  for (std::size_t i = 0; i < n; ++i) {
    above.centre += smooth(i);
    above.edges[i] = everywhere + (i == 0 ? 0.5 * on_edges[0] : smooth(i));
    above.centroids[i] = everywhere + 0.25 * centroids[i] + smooth(i) + smooth((i + 1) % n);
  }
  return above;
}

void DartMask::make_even_tangent() {
  const std::size_t n = edges.size();
  for (std::size_t i = 0; i < n; ++i) {
    edges[(n - i) % n] = edges[i];
    centroids[n - 1 - i] = centroids[i];
  }
  centre -= sum();
}

void DartMask::normalise() {
  double greatest = std::abs(centre);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    greatest = std::max({greatest, std::abs(edges[i]), std::abs(centroids[i])});
  }
  centre /= greatest;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    edges[i] /= greatest;
    centroids[i] /= greatest;
  }
}

double DartMask::distance(const DartMask& other) const noexcept {
  double greatest = std::abs(centre - other.centre);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    greatest = std::max({greatest, std::abs(edges[i] - other.edges[i]),
                         std::abs(centroids[i] - other.centroids[i])});
  }
  return greatest;
}

enum class MaskKind { kPosition, kEvenTangent };

/// Pulls a mask back until it stays the same: it is a left eigenvector.
void settle(DartMask& mask, MaskKind kind) {
  constexpr int kMostSteps = 10'000;  // A hundredth of it, unless the valence is in the dozens.
  constexpr double kSettled = 1e-14;
  mask.normalise();
  for (int i = 0; i < kMostSteps; ++i) {
    DartMask above = mask.pulled_back();
    if (kind == MaskKind::kEvenTangent) {
      above.make_even_tangent();
    }
    above.normalise();
    const double change = above.distance(mask);
    mask = std::move(above);
    if (change < kSettled) {
      return;
    }
  }
}

}  // namespace

bool VertexRing::wears_off() const noexcept {
  return is_semi_sharp(vertex_sharpness_) || std::ranges::any_of(edge_sharpness_, is_semi_sharp);
}

void VertexRing::step_until_worn(CreasingMethod method, CornerRule corners) {
  sharpen_boundary(corners);
  while (wears_off()) {
    step_sharp(method);
  }
}

LimitPoint VertexRing::limit(CreasingMethod method, CornerRule corners) const {
  const bool is_sharpened =
      !is_boundary() ||
      (is_infinite(edge_sharpness_.front()) && is_infinite(edge_sharpness_.back()) &&
       (face_count() > 1 || corners == CornerRule::kSmooth || is_infinite(vertex_sharpness_)));
  if (is_sharpened && !wears_off()) {
    return limit_without_wear();
  }
  VertexRing worn = *this;
  worn.step_until_worn(method, corners);
  return worn.limit_without_wear();
}

LimitPoint VertexRing::limit_without_wear() const {
  const SharpEdges sharp = SharpEdges::among(edge_sharpness_);
  switch (sharp.rule(vertex_sharpness_)) {
    case VertexRule::kSmooth:
      return sharp.count == 0 ? LimitPoint{to_vec3(smooth_limit()), smooth_normal()}
                              : dart_limit(sharp.first);
    case VertexRule::kCrease:
      return {to_vec3((edges_[sharp.first] + 4.0 * centre_ + edges_[sharp.last]) / 6.0),
              crease_normal(sharp.first, sharp.last)};
    case VertexRule::kCorner:
      break;
  }
  if (sharp.count < 2) {
    return {to_vec3(centre_), smooth_normal()};
  }
  const std::size_t next = sharp.first + 1 < edges_.size() ? sharp.first + 1 : 0;
  return {to_vec3(centre_), unit_normal(edges_[sharp.first] - centre_, edges_[next] - centre_)};
}

Point VertexRing::smooth_limit() const noexcept {
  const auto n = static_cast<double>(face_count());
  Point sum{};
  for (std::size_t i = 0; i < face_count(); ++i) {
    sum += edges_[i] + 2.0 * centroids_[i];
  }
  return (n * (n - 1.0) * centre_ + 2.0 * sum) / (n * (n + 5.0));
}

glm::dvec3 VertexRing::smooth_normal() const noexcept {
  const std::size_t n = face_count();
  if (n == 2) {
    // Both differences shrink by 1/4 a level; what lies along the axis does too, and swaps sides.
    return unit_normal(edges_[0] - edges_[1], centroids_[0] - centroids_[1]);
  }
  if (n == 4) {
    return unit_normal(edges_[0] - edges_[2] +
                           2.0 * (centroids_[0] - centroids_[1] - centroids_[2] + centroids_[3]),
                       edges_[1] - edges_[3] +
                           2.0 * (centroids_[0] + centroids_[1] - centroids_[2] - centroids_[3]));
  }
  const double angle = 2.0 * std::numbers::pi / static_cast<double>(n);
  const Wave turn{std::cos(angle), std::sin(angle)};
  const double lambda = wave_eigenvalue(turn.cosine);
  const double centroid_weight = lambda / (lambda - 0.25);
  Wave wave;
  Point tangent{};
  Point other{};
  for (std::size_t i = 0; i < n; ++i) {
    const Point edge = edges_[i] - centre_;
    const Point centroid = centroid_weight * (centroids_[i] - centre_);
    tangent += wave.cosine * (edge + centroid);
    other += wave.sine * (edge + centroid);
    wave = wave.turned(turn);
    tangent += wave.cosine * centroid;
    other += wave.sine * centroid;
  }
  return unit_normal(tangent, other);
}

// Along the crease: the cubic B-spline's tangent. Across it: sine waves over the angle pi / k a
// face, with the weight of the two crease edges that makes this a left eigenvector of the step.
// The published weights (Biermann, Levin & Zorin 2000) are this for k = 2; for others they belong
// to that paper's changed edge rule.
glm::dvec3 VertexRing::crease_normal(std::size_t first, std::size_t last) const noexcept {
  const Point from = edges_[first] - centre_;
  const Point to = edges_[last] - centre_;
  const std::size_t faces = last - first;
  if (faces == 1) {
    const glm::dvec3 normal = unit_normal(from - to, from + to);
    // A straight crease: the face itself decides.
    return normal != glm::dvec3(0.0) ? normal : unit_normal(from - to, centroids_[first] - centre_);
  }
  const double angle = std::numbers::pi / static_cast<double>(faces);
  const Wave turn{std::cos(angle), std::sin(angle)};
  const double lambda = wave_eigenvalue(turn.cosine);
  const double centroid_weight = lambda / (lambda - 0.25);
  const double sum = (1.0 + turn.cosine) / turn.sine;  // Of the sines inside.
  const double crease_weight =
      (centroid_weight * (2.0 * turn.sine - 3.0 * sum) - 2.0 * sum) / (16.0 * (lambda - 0.25));
  Point across = crease_weight * (from + to);
  Wave wave;
  for (std::size_t i = first; i < last; ++i) {
    const Point centroid = centroid_weight * (centroids_[i] - centre_);
    across += wave.sine * (edges_[i] - centre_ + centroid);
    wave = wave.turned(turn);
    across += wave.sine * centroid;
  }
  return unit_normal(from - to, across);
}

// The sharp edge breaks the symmetry of the smooth rule. Waves that are odd about it do not notice;
// the masks of the position and of the even wave are those to which the smooth rule's tend when
// they are pulled back from level to level.
LimitPoint VertexRing::dart_limit(std::size_t dart) const {
  const std::size_t n = face_count();
  const double angle = 2.0 * std::numbers::pi / static_cast<double>(n);
  const Wave turn{std::cos(angle), std::sin(angle)};
  DartMask position(n);
  DartMask even(n);
  position.centre = 0.5 * static_cast<double>(n * (n - 1));
  std::ranges::fill(position.edges, 1.0);
  std::ranges::fill(position.centroids, 2.0);
  Wave wave;
  for (std::size_t i = 0; i < n; ++i) {
    const Wave next = wave.turned(turn);
    even.edges[i] = wave.cosine;
    even.centroids[i] = 2.0 * (wave.cosine + next.cosine);
    wave = next;
  }
  settle(position, MaskKind::kPosition);
  settle(even, MaskKind::kEvenTangent);

  const Wave half_turn{std::cos(0.5 * angle), std::sin(0.5 * angle)};
  // With two faces, edges take no part in the odd wave.
  const double lambda = wave_eigenvalue(turn.cosine);
  const double edge_weight = n == 2 ? 0.0 : 1.0;
  const double centroid_weight = n == 2 ? 1.0 : 2.0 * half_turn.cosine * lambda / (lambda - 0.25);
  Point offset{};
  Point even_tangent{};
  Point odd_tangent{};
  wave = Wave{};
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t at = (dart + i) % n;
    const Point edge = edges_[at] - centre_;
    const Point centroid = centroids_[at] - centre_;
    offset += position.edges[i] * edge + position.centroids[i] * centroid;
    even_tangent += even.edges[i] * edge + even.centroids[i] * centroid;
    odd_tangent +=
        edge_weight * wave.sine * edge + centroid_weight * wave.turned(half_turn).sine * centroid;
    wave = wave.turned(turn);
  }
  return {to_vec3(centre_ + offset / position.sum()), unit_normal(even_tangent, odd_tangent)};
}

}  // namespace limn
