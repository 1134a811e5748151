#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "limn/mesh/control_mesh.h"
#include "limn/subdivision/labels.h"
#include "limn/subdivision/legalisation.h"

namespace limn {

/// A vertex that the next move of a legalisation might raise, and what it is weighed by.
struct LegalisationCandidate {
  std::uint32_t vertex = kNone;
  // The greedy's order, in the order of their weight:
  bool is_beside_leaf = false;  ///< Has an illegal neighbour of valence 1.
  std::uint32_t valence = 0;    ///< Illegal neighbours along mesh edges: the highest first.
  std::uint32_t cost = 0;       ///< Quads around it with exactly three zero labels: lowest first.
  /// Look-ahead's order: quads mended less quads made illegal, plus 0.6 of what the best further
  /// relabel would mend, less 1 for every face it adds. The highest first.
  float score = 0.0F;

  [[nodiscard]] bool operator==(const LegalisationCandidate&) const = default;
};

/// A legalisation, move by move: for those who want to see which vertex is picked and why.
///
/// A move is a vertex that is raised, or those that go back to 0 together (steps that are joint).
/// What the moves are weighed by is counted anew from the labels of the moment, by definition and
/// not by the algorithm's own bookkeeping.
class LegalisationTrace {
 public:
  /// What went into a legalisation (labels from `apply_non_quad_rule` with `rule`), and what came
  /// out. `method` is the one that was asked for.
  LegalisationTrace(std::shared_ptr<const ControlMesh> mesh, VertexLabels painted,
                    Legalisation legal, NonQuadRule rule, LegalisationMethod method);

  /// Moves in all.
  [[nodiscard]] std::size_t size() const noexcept { return first_steps_.size() - 1; }
  /// Moves made: 0 is before, `size()` after everything.
  [[nodiscard]] std::size_t position() const noexcept { return position_; }
  /// Goes to a position, `size()` at the most. Forwards it takes time linear in the steps between,
  /// backwards in all steps up to there.
  void seek(std::size_t position);

  [[nodiscard]] const ControlMesh& mesh() const noexcept { return *mesh_; }
  /// Whose order the raises follow: look-ahead takes the greedy's where they give fewer faces.
  [[nodiscard]] LegalisationMethod order() const noexcept { return legal_.order; }
  /// The labels now.
  [[nodiscard]] const VertexLabels& labels() const noexcept { return labels_; }
  /// The steps of a move, 0..size() - 1; one, unless vertices go back together.
  [[nodiscard]] std::span<const LegalisationStep> move(std::size_t index) const;
  /// Whether a move takes vertices back to 0.
  [[nodiscard]] bool is_reset(std::size_t index) const { return move(index).front().label == 0; }

  /// What is illegal now in the sense of the method that is at work.
  [[nodiscard]] std::vector<std::uint32_t> illegal_faces() const;
  [[nodiscard]] std::vector<std::uint32_t> illegal_vertices() const;
  /// Vertices positive now that were 0 as painted, ascending.
  [[nodiscard]] std::vector<std::uint32_t> raised_vertices() const;
  /// What the next move chooses from, best first; of equal scores the chosen one. Empty at the end
  /// and where the next move takes back. Under kWherePainted vertices that rise together are named
  /// by the least of them, as steps are.
  [[nodiscard]] std::vector<LegalisationCandidate> candidates() const;

 private:
  [[nodiscard]] LegalisationMethod method_now() const;
  [[nodiscard]] std::vector<LegalisationCandidate> greedy_candidates() const;
  [[nodiscard]] std::vector<LegalisationCandidate> look_ahead_candidates() const;
  void make(std::span<const LegalisationStep> steps);
  void raise(std::uint32_t vertex);

  std::shared_ptr<const ControlMesh> mesh_;
  VertexLabels painted_;
  Legalisation legal_;
  NonQuadRule rule_;
  LegalisationMethod method_;
  std::vector<std::size_t> first_steps_;  ///< Of each move, and how many steps there are.
  std::size_t position_ = 0;
  VertexLabels labels_;
};

}  // namespace limn
