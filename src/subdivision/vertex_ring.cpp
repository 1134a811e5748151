// A step maps (v, e_i, c_i) linearly to the ring of the next level, in place: the vertex needs all
// old points; edge points need the old vertex and old centroids; centroids come last and need the
// new vertex and edge points. Whether the faces are quads does not matter to that map, so limit
// masks, its left eigenvectors, hold for any face sizes once they are written in centroids: with
// quads the fourth corner is f_i = 4 c_i - v - e_i - e_(i+1), which is how published masks were
// brought to this form.
//
// Sharpness is reckoned in single precision and in the order of the edges, like OpenSubdiv's, so
// that a sharpness that wears off to just 0 does so in both.

#include "subdivision/vertex_ring.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "limn/contract.h"

namespace limn {
namespace {

constexpr bool is_sharp(float sharpness) noexcept {
  return sharpness > 0.0f;
}

constexpr bool is_infinite(float sharpness) noexcept {
  return sharpness >= kInfiniteSharpness;
}

constexpr bool is_semi_sharp(float sharpness) noexcept {
  return is_sharp(sharpness) && !is_infinite(sharpness);
}

constexpr float one_level_less(float sharpness) noexcept {
  return is_infinite(sharpness) ? kInfiniteSharpness : std::max(sharpness - 1.0f, 0.0f);
}

/// Of semi-sharp edges that meet at a vertex.
struct SharpnessSum {
  float sum = 0.0f;
  int count = 0;

  void add(float sharpness) noexcept {
    if (is_semi_sharp(sharpness)) {
      sum += sharpness;
      ++count;
    }
  }
  /// Chaikin's rule for one of them.
  [[nodiscard]] float child_of(float sharpness) const noexcept {
    return count < 2 ? one_level_less(sharpness)
                     : chaikin(sharpness, (sum - sharpness) / static_cast<float>(count - 1));
  }
  [[nodiscard]] static float chaikin(float sharpness, float mean_of_others) noexcept {
    return one_level_less(0.75f * sharpness + 0.25f * mean_of_others);
  }
};

/// The greater eigenvalue of the step on the waves sin and cos of an angle a face.
double wave_eigenvalue(double cosine) noexcept {
  return (5.0 + cosine + std::sqrt((1.0 + cosine) * (9.0 + cosine))) / 16.0;
}

/// Turns by the same angle again and again.
struct Wave {
  double cosine = 1.0;
  double sine = 0.0;

  void turn(const Wave& by) noexcept {
    const double turned = cosine * by.cosine - sine * by.sine;
    sine = sine * by.cosine + cosine * by.sine;
    cosine = turned;
  }
};

glm::dvec3 unit_normal(const Point& tangent, const Point& other) noexcept {
  const glm::dvec3 a = to_vec3(tangent);
  const glm::dvec3 b = to_vec3(other);
  const glm::dvec3 normal = glm::cross(a, b);
  const double length = glm::length(normal);
  constexpr double kLeastSine = 1e-12;
  // Written so that a length that is no number fails too.
  return length > kLeastSine * glm::length(a) * glm::length(b) ? normal / length : glm::dvec3(0.0);
}

}  // namespace

VertexRing::SharpEdges VertexRing::SharpEdges::among(std::span<const float> sharpness) noexcept {
  SharpEdges sharp;
  for (std::size_t i = 0; i < sharpness.size(); ++i) {
    if (is_sharp(sharpness[i])) {
      sharp.first = sharp.count == 0 ? i : sharp.first;
      sharp.last = i;
      ++sharp.count;
    }
  }
  return sharp;
}

VertexRing::Rule VertexRing::SharpEdges::rule(float vertex_sharpness) const noexcept {
  if (is_sharp(vertex_sharpness) || count > 2) {
    return Rule::kCorner;
  }
  return count == 2 ? Rule::kCrease : Rule::kSmooth;
}

void VertexRing::reset(std::size_t faces, bool is_boundary) {
  LIMN_EXPECTS(faces >= (is_boundary ? 1u : 2u));
  const std::size_t edges = faces + (is_boundary ? 1 : 0);
  centroids_.resize(faces);
  edges_.resize(edges);
  edge_sharpness_.assign(edges, 0.0f);
  far_sharpness_.assign(edges, 0.0f);
  child_sharpness_.resize(edges);
  vertex_sharpness_ = 0.0f;
  if (is_boundary) {
    edge_sharpness_.front() = edge_sharpness_.back() = kInfiniteSharpness;
  }
}

bool VertexRing::is_smooth() const noexcept {
  return !is_boundary() && !is_sharp(vertex_sharpness_) &&
         std::ranges::none_of(edge_sharpness_, is_sharp);
}

void VertexRing::sharpen_boundary(CornerRule corners) noexcept {
  if (is_boundary()) {
    edge_sharpness_.front() = edge_sharpness_.back() = kInfiniteSharpness;
    if (face_count() == 1 && corners == CornerRule::kSharp) {
      vertex_sharpness_ = kInfiniteSharpness;
    }
  }
}

void VertexRing::step(CreasingMethod method, CornerRule corners) {
  if (is_smooth()) {
    step_smooth();
  } else {
    sharpen_boundary(corners);
    step_sharp(method);
  }
}

Point VertexRing::smooth_centre() const noexcept {
  const auto n = static_cast<double>(face_count());
  Point sum{};
  for (std::size_t i = 0; i < face_count(); ++i) {
    sum += edges_[i] + centroids_[i];
  }
  return centre_ * ((n - 2.0) / n) + sum / (n * n);
}

void VertexRing::add_moved_centre(double weight, Rule rule, const SharpEdges& sharp,
                                  Point& sum) const noexcept {
  switch (rule) {
    case Rule::kCorner:
      sum += weight * centre_;
      return;
    case Rule::kCrease:
      sum += (0.125 * weight) * (edges_[sharp.first] + 6.0 * centre_ + edges_[sharp.last]);
      return;
    case Rule::kSmooth:
      sum += weight * smooth_centre();
      return;
  }
}

void VertexRing::step_smooth() {
  const Point moved = smooth_centre();
  Point before = centroids_.back();
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    edges_[i] = 0.25 * (centre_ + edges_[i] + before + centroids_[i]);
    before = centroids_[i];
  }
  centre_ = moved;
  step_centroids();
}

void VertexRing::step_centroids() {
  const std::size_t n = face_count();
  for (std::size_t i = 0; i + 1 < n; ++i) {
    centroids_[i] = 0.25 * (centre_ + edges_[i] + centroids_[i] + edges_[i + 1]);
  }
  const Point& end = is_boundary() ? edges_.back() : edges_.front();
  centroids_[n - 1] = 0.25 * (centre_ + edges_[n - 1] + centroids_[n - 1] + end);
}

// Sets child_sharpness_, and moves on far_sharpness_: from level 1 on, the far end of edge i is the
// middle of the edge it was, whose other half is the one edge that can be sharp there besides.
void VertexRing::wear_off(CreasingMethod method) {
  const std::size_t n = edges_.size();
  if (method == CreasingMethod::kUniform) {
    std::ranges::transform(edge_sharpness_, child_sharpness_.begin(), one_level_less);
    return;
  }
  SharpnessSum here;
  for (const float sharpness : edge_sharpness_) {
    here.add(sharpness);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const float sharpness = edge_sharpness_[i];
    if (!is_semi_sharp(sharpness)) {
      child_sharpness_[i] = one_level_less(sharpness);
      continue;
    }
    child_sharpness_[i] = here.child_of(sharpness);
    far_sharpness_[i] = is_sharp(far_sharpness_[i])
                            ? SharpnessSum::chaikin(sharpness, far_sharpness_[i])
                            : one_level_less(sharpness);
  }
}

double VertexRing::worn_off_sharpness(float child_vertex_sharpness) const noexcept {
  float sum = 0.0f;
  int count = 0;
  const auto add = [&](float sharpness, float child_sharpness) {
    if (is_sharp(sharpness) && !is_sharp(child_sharpness)) {
      sum += sharpness;
      ++count;
    }
  };
  add(vertex_sharpness_, child_vertex_sharpness);
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    add(edge_sharpness_[i], child_sharpness_[i]);
  }
  return count == 0 ? 0.0 : std::min(sum / static_cast<float>(count), 1.0f);
}

void VertexRing::step_sharp(CreasingMethod method) {
  const std::size_t n = edges_.size();
  wear_off(method);
  const float child_vertex_sharpness = one_level_less(vertex_sharpness_);

  const SharpEdges sharp = SharpEdges::among(edge_sharpness_);
  const SharpEdges child_sharp = SharpEdges::among(child_sharpness_);
  const Rule rule = sharp.rule(vertex_sharpness_);
  const Rule child_rule = child_sharp.rule(child_vertex_sharpness);
  double weight = 1.0;
  if (child_rule != rule && rule != Rule::kSmooth) {
    weight = worn_off_sharpness(child_vertex_sharpness);
  }
  Point moved{};
  add_moved_centre(weight, rule, sharp, moved);
  if (weight < 1.0) {
    add_moved_centre(1.0 - weight, child_rule, child_sharp, moved);
  }

  for (std::size_t i = 0; i < n; ++i) {
    const Point middle = 0.5 * (centre_ + edges_[i]);
    const float sharpness = edge_sharpness_[i];
    // Both halves sharp: a crease goes on here. Under Chaikin's rule one may stay sharp alone.
    const bool is_crease = is_infinite(sharpness) ||
                           (is_sharp(child_sharpness_[i]) &&
                            (method == CreasingMethod::kUniform || is_sharp(far_sharpness_[i])));
    if (is_crease) {
      edges_[i] = middle;
      continue;
    }
    // Not held to 1, like OpenSubdiv's: Chaikin's rule can wear off more than 1 at a time.
    const double held = is_sharp(sharpness) ? sharpness : 0.0f;
    const Point beside = centroids_[i == 0 ? n - 1 : i - 1] + centroids_[i];
    edges_[i] = held * middle + (1.0 - held) * (0.5 * middle + 0.25 * beside);
  }
  centre_ = moved;
  vertex_sharpness_ = child_vertex_sharpness;
  if (method == CreasingMethod::kChaikin) {
    for (std::size_t i = 0; i < n; ++i) {
      // The far half is the only other edge at the far end; its mean, in the order of a sum.
      const float far = far_sharpness_[i];
      far_sharpness_[i] = is_sharp(far) ? (child_sharpness_[i] + far) - child_sharpness_[i] : 0.0f;
    }
  }
  edge_sharpness_.swap(child_sharpness_);
  step_centroids();
}

LimitPoint VertexRing::limit(CreasingMethod method, CornerRule corners) const {
  const auto wears_off = [](const VertexRing& ring) {
    return is_semi_sharp(ring.vertex_sharpness_) ||
           std::ranges::any_of(ring.edge_sharpness_, is_semi_sharp);
  };
  const bool is_sharpened =
      !is_boundary() ||
      (is_infinite(edge_sharpness_.front()) && is_infinite(edge_sharpness_.back()) &&
       (face_count() > 1 || corners == CornerRule::kSmooth || is_infinite(vertex_sharpness_)));
  if (is_sharpened && !wears_off(*this)) {
    return limit_without_wear();
  }
  VertexRing worn = *this;
  worn.sharpen_boundary(corners);
  while (wears_off(worn)) {
    worn.step_sharp(method);
  }
  return worn.limit_without_wear();
}

LimitPoint VertexRing::limit_without_wear() const {
  const SharpEdges sharp = SharpEdges::among(edge_sharpness_);
  switch (sharp.rule(vertex_sharpness_)) {
    case Rule::kSmooth:
      return sharp.count == 0 ? LimitPoint{to_vec3(smooth_limit()), smooth_normal()} : dart_limit();
    case Rule::kCrease:
      return {to_vec3((edges_[sharp.first] + 4.0 * centre_ + edges_[sharp.last]) / 6.0),
              crease_normal(sharp.first, sharp.last)};
    case Rule::kCorner:
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
    wave.turn(turn);
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
    wave.turn(turn);
    across += wave.sine * centroid;
  }
  return unit_normal(from - to, across);
}

// No closed form: the sharp edge breaks the symmetry of the smooth rule. The ring shrinks by 0.66
// a level or faster, so after this many the mask of the smooth rule is exact. Moved to the origin
// and magnified at every step, its shape keeps all its digits.
LimitPoint VertexRing::dart_limit() const {
  constexpr int kSteps = 96;
  VertexRing ring = *this;
  Point origin{};
  double scale = 1.0;
  for (int i = 0; i < kSteps; ++i) {
    origin += scale * ring.centre_;
    for (Point& edge : ring.edges_) {
      edge = 2.0 * (edge - ring.centre_);
    }
    for (Point& centroid : ring.centroids_) {
      centroid = 2.0 * (centroid - ring.centre_);
    }
    ring.centre_ = Point{};
    scale *= 0.5;
    ring.step_sharp(CreasingMethod::kUniform);
  }
  return {to_vec3(origin + scale * ring.smooth_limit()), ring.smooth_normal()};
}

}  // namespace limn
