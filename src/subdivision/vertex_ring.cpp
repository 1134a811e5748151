// A step maps (v, e_i, c_i) linearly to the ring of the next level, in place: the vertex needs all
// old points; edge points need the old vertex and old centroids; centroids come last and need the
// new vertex and edge points.

#include "subdivision/vertex_ring.h"

#include <algorithm>

#include "limn/contract.h"
#include "subdivision/sharpness.h"

namespace limn {
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

void VertexRing::add_moved_centre(double weight, VertexRule rule, const SharpEdges& sharp,
                                  Point& sum) const noexcept {
  switch (rule) {
    case VertexRule::kCorner:
      sum += weight * centre_;
      return;
    case VertexRule::kCrease:
      sum += (0.125 * weight) * (edges_[sharp.first] + 6.0 * centre_ + edges_[sharp.last]);
      return;
    case VertexRule::kSmooth:
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
    child_sharpness_[i] = chaikin_child(sharpness, here.mean_besides(sharpness));
    far_sharpness_[i] = chaikin_child(sharpness, far_sharpness_[i]);
  }
}

WornOff VertexRing::worn_off(float child_vertex_sharpness) const noexcept {
  WornOff worn;
  worn.add(vertex_sharpness_, child_vertex_sharpness);
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    worn.add(edge_sharpness_[i], child_sharpness_[i]);
  }
  return worn;
}

void VertexRing::step_sharp(CreasingMethod method) {
  const std::size_t n = edges_.size();
  wear_off(method);
  const float child_vertex_sharpness = one_level_less(vertex_sharpness_);

  const SharpEdges sharp = SharpEdges::among(edge_sharpness_);
  const SharpEdges child_sharp = SharpEdges::among(child_sharpness_);
  const VertexRule rule = sharp.rule(vertex_sharpness_);
  const VertexRule child_rule = child_sharp.rule(child_vertex_sharpness);
  const double weight = weight_of_rule(rule, child_rule, worn_off(child_vertex_sharpness));
  Point moved{};
  add_moved_centre(weight, rule, sharp, moved);
  if (weight < 1.0) {
    add_moved_centre(1.0 - weight, child_rule, child_sharp, moved);
  }

  for (std::size_t i = 0; i < n; ++i) {
    const Point middle = 0.5 * (centre_ + edges_[i]);
    const float sharpness = edge_sharpness_[i];
    const float far_half =
        method == CreasingMethod::kUniform ? child_sharpness_[i] : far_sharpness_[i];
    const double held = sharp_share_of_edge(sharpness, child_sharpness_[i], far_half);
    if (held == 1.0) {
      edges_[i] = middle;
      continue;
    }
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

}  // namespace limn
