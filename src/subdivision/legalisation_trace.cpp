// Positions are reached by replaying steps; what a move is weighed by is counted over the whole
// mesh each time it is asked for, which is once for each picture of it.
#include "limn/subdivision/legalisation_trace.h"

#include <algorithm>
#include <utility>

#include "limn/contract.h"
#include "subdivision/look_ahead_score.h"
#include "subdivision/surroundings.h"

namespace limn {
namespace {

/// Quads around each vertex that have exactly three zero labels.
std::vector<std::uint32_t> costs_of(const ControlMesh& mesh, const VertexLabels& labels) {
  std::vector<std::uint32_t> costs(labels.size(), 0);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const std::span<const std::uint32_t> face = mesh.face(f);
    if (face.size() == 4 &&
        std::ranges::count_if(face, [&](std::uint32_t v) { return labels[v] == 0; }) == 3) {
      for (const std::uint32_t v : face) {
        ++costs[v];
      }
    }
  }
  return costs;
}

/// What relabels would mend, by definition.
class Scores {
 public:
  Scores(const LegalityProblem& problem, const VertexLabels& labels)
      : problem_(problem),
        masks_(problem.masks(labels)),
        is_zero_(problem.variable_count(), 0),
        gains_(problem.variable_count(), 0) {
    for (std::uint32_t v = 0; v < labels.size(); ++v) {
      is_zero_[problem.variable_of(v)] = labels[v] == 0 ? 1 : 0;
    }
  }

  [[nodiscard]] bool is_candidate(std::uint32_t u) const {
    bool has_illegal_quad = false;
    problem_.for_each_quad(u, [&](std::uint32_t q, unsigned) {
      has_illegal_quad = has_illegal_quad || is_illegal_mask(masks_[q]);
    });
    return is_zero_[u] != 0 && has_illegal_quad;
  }

  /// In fifths.
  [[nodiscard]] std::int32_t score(std::uint32_t u) {
    std::int32_t faces = static_cast<std::int32_t>(problem_.polygon_faces(u));
    problem_.for_each_quad(u, [&](std::uint32_t q, unsigned bits) {
      faces += faces_of(masks_[q] | bits) - faces_of(masks_[q]);
    });
    return kOneMended * mended_by(u) + kOneFaceAdded * faces + kOneMendedNext * most_next(u);
  }

 private:
  [[nodiscard]] bool is_small(std::uint32_t u) const {
    return problem_.quads_around(u) <= kMostQuadsLookedAhead;
  }
  [[nodiscard]] std::int32_t mended_by(std::uint32_t u) const {
    std::int32_t sum = 0;
    problem_.for_each_quad(u,
                           [&](std::uint32_t q, unsigned bits) { sum += mended(masks_[q], bits); });
    return sum;
  }
  /// What the best further relabel in a quad around u would mend once u has risen; not below 0.
  [[nodiscard]] std::int32_t most_next(std::uint32_t u) {
    if (!is_small(u)) {
      return 0;
    }
    const auto each_other = [&](const auto& visit) {
      problem_.for_each_quad(u, [&](std::uint32_t q, unsigned bits) {
        problem_.for_each_variable(q, [&](std::uint32_t w, unsigned others) {
          if (w != u && is_zero_[w] != 0 && is_small(w)) {
            visit(q, bits, w, others);
          }
        });
      });
    };
    each_other(
        [&](std::uint32_t, unsigned, std::uint32_t w, unsigned) { gains_[w] = mended_by(w); });
    each_other([&](std::uint32_t q, unsigned bits, std::uint32_t w, unsigned others) {
      gains_[w] += mended(masks_[q] | bits, others) - mended(masks_[q], others);
    });
    std::int32_t most = 0;
    each_other([&](std::uint32_t, unsigned, std::uint32_t w, unsigned) {
      most = std::max(most, gains_[w]);
    });
    return most;
  }

  const LegalityProblem& problem_;
  LargeArray<QuadMask> masks_;
  std::vector<std::uint8_t> is_zero_;
  std::vector<std::int32_t> gains_;  ///< Of the variables around one, while it is scored.
};

/// The steps at which moves begin, and one past the last.
std::vector<std::size_t> first_steps_of(std::span<const LegalisationStep> steps) {
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (i == 0 || !steps[i - 1].is_joint) {
      first.push_back(i);
    }
  }
  first.push_back(steps.size());
  return first;
}

}  // namespace

LegalisationTrace::LegalisationTrace(std::shared_ptr<const ControlMesh> mesh, VertexLabels painted,
                                     Legalisation legal, NonQuadRule rule,
                                     LegalisationMethod method)
    : mesh_(std::move(mesh)),
      painted_(std::move(painted)),
      legal_(std::move(legal)),
      rule_(rule),
      method_(method),
      first_steps_(first_steps_of(legal_.steps)),
      labels_(painted_) {
  LIMN_EXPECTS(mesh_ != nullptr);
  LIMN_EXPECTS(painted_.size() == mesh_->vertex_count());
}

void LegalisationTrace::seek(std::size_t position) {
  position = std::min(position, size());
  if (position < position_) {
    labels_ = painted_;
    position_ = 0;
  }
  for (; position_ < position; ++position_) {
    make(move(position_));
  }
}

std::span<const LegalisationStep> LegalisationTrace::move(std::size_t index) const {
  LIMN_EXPECTS(index < size());
  return std::span(legal_.steps)
      .subspan(first_steps_[index], first_steps_[index + 1] - first_steps_[index]);
}

void LegalisationTrace::make(std::span<const LegalisationStep> steps) {
  for (const LegalisationStep& step : steps) {
    if (step.label > 0) {
      raise(step.vertex);
    } else {
      labels_[step.vertex] = 0;
    }
  }
}

void LegalisationTrace::raise(std::uint32_t vertex) {
  labels_[vertex] = 1;
  if (rule_ != NonQuadRule::kWherePainted || mesh_->is_all_quads()) {
    return;
  }
  const FlatTopology& topology = mesh_->topology();
  std::vector<std::uint32_t> risen{vertex};
  while (!risen.empty()) {
    const std::uint32_t v = risen.back();
    risen.pop_back();
    for (const std::uint32_t corner : corners_around(topology, v)) {
      const std::span<const std::uint32_t> face =
          corners_of(topology, topology.corner_faces[corner]);
      for (const std::uint32_t w : face) {
        if (face.size() != 4 && labels_[w] == 0) {
          labels_[w] = 1;
          risen.push_back(w);
        }
      }
    }
  }
}

LegalisationMethod LegalisationTrace::method_now() const {
  const bool is_raising = position_ < size() && !is_reset(position_);
  return is_raising ? legal_.order : method_;
}

std::vector<std::uint32_t> LegalisationTrace::illegal_faces() const {
  return limn::illegal_faces(*mesh_, labels_, method_now());
}

std::vector<std::uint32_t> LegalisationTrace::illegal_vertices() const {
  return limn::illegal_vertices(*mesh_, labels_, method_now());
}

std::vector<std::uint32_t> LegalisationTrace::raised_vertices() const {
  std::vector<std::uint32_t> raised;
  for (std::uint32_t v = 0; v < labels_.size(); ++v) {
    if (labels_[v] > 0 && painted_[v] == 0) {
      raised.push_back(v);
    }
  }
  return raised;
}

std::vector<LegalisationCandidate> LegalisationTrace::candidates() const {
  if (position_ == size() || is_reset(position_)) {
    return {};
  }
  return legal_.order == LegalisationMethod::kGreedy ? greedy_candidates()
                                                     : look_ahead_candidates();
}

std::vector<LegalisationCandidate> LegalisationTrace::greedy_candidates() const {
  const FlatTopology& topology = mesh_->topology();
  const std::vector<std::uint32_t> illegal = illegal_vertices();
  const std::vector<std::uint32_t> costs = costs_of(*mesh_, labels_);
  std::vector<std::uint32_t> valences(labels_.size(), 0);
  for (const std::uint32_t v : illegal) {
    for_each_neighbour(topology, v, [&](std::uint32_t w) { ++valences[w]; });
  }
  std::vector<std::uint8_t> is_beside_leaf(labels_.size(), 0);
  for (const std::uint32_t v : illegal) {
    if (valences[v] == 1) {
      for_each_neighbour(topology, v, [&](std::uint32_t w) { is_beside_leaf[w] = 1; });
    }
  }
  std::vector<LegalisationCandidate> all;
  all.reserve(illegal.size());
  for (const std::uint32_t v : illegal) {
    all.push_back({v, is_beside_leaf[v] != 0, valences[v], costs[v], 0.0F});
  }
  std::ranges::stable_sort(all, [](const LegalisationCandidate& a, const LegalisationCandidate& b) {
    if (a.is_beside_leaf != b.is_beside_leaf) {
      return a.is_beside_leaf;
    }
    return a.valence != b.valence ? a.valence > b.valence : a.cost < b.cost;
  });
  // The others have to wait while there is one beside a leaf.
  const auto waiting = std::ranges::find(
      all, false, [](const LegalisationCandidate& c) { return c.is_beside_leaf; });
  if (waiting != all.begin()) {
    all.erase(waiting, all.end());
  }
  return all;
}

std::vector<LegalisationCandidate> LegalisationTrace::look_ahead_candidates() const {
  const LegalityProblem problem(*mesh_);
  Scores scores(problem, labels_);
  std::vector<LegalisationCandidate> all;
  for (std::uint32_t u = 0; u < problem.variable_count(); ++u) {
    if (!scores.is_candidate(u)) {
      continue;
    }
    LegalisationCandidate candidate;
    problem.for_each_vertex(
        u, [&](std::uint32_t v) { candidate.vertex = std::min(candidate.vertex, v); });
    candidate.score = static_cast<float>(scores.score(u)) / kScoreUnit;
    all.push_back(candidate);
  }
  const std::uint32_t chosen = move(position_).front().vertex;
  std::ranges::stable_sort(
      all, [chosen](const LegalisationCandidate& a, const LegalisationCandidate& b) {
        return a.score != b.score ? a.score > b.score : a.vertex == chosen && b.vertex != chosen;
      });
  return all;
}

}  // namespace limn
