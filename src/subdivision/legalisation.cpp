// Two lazy heaps hold the candidates: `near_leaf_` the illegal vertices beside one of valence 1,
// and `all_` every illegal vertex. An entry is (valence, cost, vertex) as they were when it was
// pushed; on top of a heap it counts only if they still are. A relabelled vertex v changes the
// faces around it; through them the state and the cost of their vertices; through a changed state
// the valence of that vertex's neighbours; and through a valence that becomes or stops being 1
// their neighbours' candidacy. Only what changed is pushed again, so the whole takes O(n log n) for
// bounded valence.
#include "limn/subdivision/legalisation.h"

#include <algorithm>
#include <optional>
#include <queue>
#include <tuple>

#include "limn/contract.h"
#include "subdivision/non_quads.h"
#include "subdivision/surroundings.h"

namespace limn {
namespace {

struct Candidate {
  std::uint32_t valence;
  std::uint32_t cost;
  std::uint32_t vertex;

  /// Highest valence first, then lowest cost, then lowest index.
  [[nodiscard]] bool is_worse_than(const Candidate& other) const {
    return std::tuple(other.valence, cost, vertex) > std::tuple(valence, other.cost, other.vertex);
  }
};

struct IsWorse {
  bool operator()(const Candidate& a, const Candidate& b) const { return a.is_worse_than(b); }
};

using Heap = std::priority_queue<Candidate, std::vector<Candidate>, IsWorse>;

class Greedy {
 public:
  Greedy(const ControlMesh& mesh, VertexLabels labels)
      : topology_(&mesh.topology()),
        mesh_(&mesh),
        labels_(std::move(labels)),
        zeros_(mesh.face_count(), 0),
        vertices_(mesh.vertex_count()) {
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
      if (sides_of(*topology_, f) == 4) {
        for (const std::uint32_t v : corners_of(*topology_, f)) {
          zeros_[f] = static_cast<std::uint8_t>(zeros_[f] + (labels_[v] == 0 ? 1 : 0));
        }
        count_face(f, +1);
      }
    }
    push_changed();
  }

  [[nodiscard]] std::size_t illegal_count() const { return illegal_count_; }
  [[nodiscard]] VertexLabels take_labels() { return std::move(labels_); }

  /// The vertex to relabel next, if any is illegal.
  [[nodiscard]] std::optional<LegalisationStep> best() {
    for (Heap* heap : {&near_leaf_, &all_}) {
      while (!heap->empty()) {
        const Candidate top = heap->top();
        if (is_current(top) && (heap == &all_ || vertices_[top.vertex].leaf_neighbours > 0)) {
          return LegalisationStep{top.vertex, top.valence, top.cost};
        }
        heap->pop();
      }
    }
    return std::nullopt;
  }

  void relabel(std::uint32_t v) {
    risen_.assign(1, v);
    labels_[v] = 1;
    raise_non_quads(*mesh_, labels_, risen_);
    for (const std::uint32_t w : risen_) {
      // Out of the faces' counts with the old number of zeros, in again with the new one.
      for (const std::uint32_t corner : corners_around(*topology_, w)) {
        const std::uint32_t f = topology_->corner_faces[corner];
        if (sides_of(*topology_, f) == 4) {
          count_face(f, -1);
          --zeros_[f];
          count_face(f, +1);
        }
      }
    }
    push_changed();
  }

 private:
  struct Vertex {
    std::uint32_t illegal_faces = 0;    ///< Quads around it with exactly two zeros.
    std::uint32_t cost = 0;             ///< Quads around it with exactly three zeros.
    std::uint32_t valence = 0;          ///< Illegal neighbours, one for each mesh edge.
    std::uint32_t leaf_neighbours = 0;  ///< Illegal neighbours of valence 1, likewise.
    bool is_illegal = false;
    bool is_leaf = false;  ///< Illegal and of valence 1.
    bool is_changed = false;
  };

  [[nodiscard]] bool is_current(const Candidate& candidate) const {
    const Vertex& vertex = vertices_[candidate.vertex];
    return vertex.is_illegal && vertex.valence == candidate.valence &&
           vertex.cost == candidate.cost;
  }

  void mark(std::uint32_t v) {
    if (!vertices_[v].is_changed) {
      vertices_[v].is_changed = true;
      changed_.push_back(v);
    }
  }

  /// Adds (+1) or takes back (-1) what a quad contributes to its vertices.
  void count_face(std::uint32_t f, int sign) {
    if (zeros_[f] != 2 && zeros_[f] != 3) {
      return;
    }
    for (const std::uint32_t v : corners_of(*topology_, f)) {
      Vertex& vertex = vertices_[v];
      std::uint32_t& counter = zeros_[f] == 2 ? vertex.illegal_faces : vertex.cost;
      counter = static_cast<std::uint32_t>(static_cast<int>(counter) + sign);
      mark(v);
    }
  }

  /// Brings valences and leaves up to date with the changed vertices, then offers them anew.
  void push_changed() {
    // Whatever changes on the way is appended to `changed_`, and offered in the end as well.
    const std::size_t counted = changed_.size();
    for (std::size_t i = 0; i < counted; ++i) {
      update_legality(changed_[i]);
    }
    for (std::size_t i = 0; i < changed_.size(); ++i) {
      update_leaf(changed_[i]);
    }
    for (const std::uint32_t v : changed_) {
      Vertex& vertex = vertices_[v];
      vertex.is_changed = false;
      if (vertex.is_illegal) {
        all_.push({vertex.valence, vertex.cost, v});
        if (vertex.leaf_neighbours > 0) {
          near_leaf_.push({vertex.valence, vertex.cost, v});
        }
      }
    }
    changed_.clear();
  }

  void update_legality(std::uint32_t v) {
    Vertex& vertex = vertices_[v];
    const bool is_illegal = labels_[v] == 0 && vertex.illegal_faces > 0;
    if (is_illegal == vertex.is_illegal) {
      return;
    }
    vertex.is_illegal = is_illegal;
    illegal_count_ = is_illegal ? illegal_count_ + 1 : illegal_count_ - 1;
    for_each_neighbour(*topology_, v, [&](std::uint32_t w) {
      vertices_[w].valence += is_illegal ? 1u : ~0u;
      mark(w);
    });
  }

  void update_leaf(std::uint32_t v) {
    Vertex& vertex = vertices_[v];
    const bool is_leaf = vertex.is_illegal && vertex.valence == 1;
    if (is_leaf == vertex.is_leaf) {
      return;
    }
    vertex.is_leaf = is_leaf;
    for_each_neighbour(*topology_, v, [&](std::uint32_t w) {
      vertices_[w].leaf_neighbours += is_leaf ? 1u : ~0u;
      mark(w);
    });
  }

  const FlatTopology* topology_;
  const ControlMesh* mesh_;
  VertexLabels labels_;
  std::vector<std::uint8_t> zeros_;  ///< Zero labels of each quad.
  std::vector<Vertex> vertices_;
  std::vector<std::uint32_t> changed_;
  std::vector<std::uint32_t> risen_;
  Heap near_leaf_;
  Heap all_;
  std::size_t illegal_count_ = 0;
};

}  // namespace

Result<Legalisation> legalise_greedy(const ControlMesh& mesh, VertexLabels labels, NonQuadRule,
                                     Progress& progress) {
  LIMN_EXPECTS(labels.size() == mesh.vertex_count());
  constexpr std::size_t kStepsBetweenReports = 1024;
  constexpr const char* kStage = "Removing illegal vertices";
  const auto cancelled = [] { return fail(ErrorKind::kCancelled, "Legalising was cancelled."); };
  if (!progress.report(0.0, kStage)) {
    return cancelled();
  }

  Legalisation result;
  Greedy greedy(mesh, std::move(labels));
  double reached = 0.0;
  while (const std::optional<LegalisationStep> step = greedy.best()) {
    greedy.relabel(step->vertex);
    result.steps.push_back(*step);
    if (result.steps.size() % kStepsBetweenReports == 0) {
      const auto made = static_cast<double>(result.steps.size());
      reached = std::max(reached, made / (made + static_cast<double>(greedy.illegal_count())));
      if (!progress.report(reached, kStage)) {
        return cancelled();
      }
    }
  }
  result.labels = greedy.take_labels();
  if (!progress.report(1.0, kStage)) {
    return cancelled();
  }
  return result;
}

}  // namespace limn
