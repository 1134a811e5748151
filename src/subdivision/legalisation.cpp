// A relabelled vertex v changes the zeros of the quads around it; through them the state and the
// cost of their corners; through a changed state the valence of that vertex's neighbours; and
// through a valence that becomes or stops being 1 their neighbours' candidacy. Only what changed is
// queued anew, so a step costs a constant for bounded valence. At a million vertices the time goes
// into fetching them: what a step reads of a vertex is one run of spokes and one small record, its
// counters a byte each unless some vertex has too many edges for that.
#include "limn/subdivision/legalisation.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "limn/contract.h"
#include "limn/mesh/large_array.h"
#include "subdivision/legalisation_greedy.h"
#include "subdivision/legalisation_queue.h"
#include "subdivision/legalisation_rings.h"
#include "subdivision/legality_problem.h"
#include "subdivision/non_quads.h"
#include "subdivision/surroundings.h"

namespace limn {
namespace {

using Candidate = CandidateQueue::Candidate;

/// `Count` holds the number of edges of any vertex with spokes. Counters of the others are moved
/// along and mean nothing.
template <class Count>
class Greedy {
 public:
  Greedy(const ControlMesh& mesh, const SpokeRings& rings, VertexLabels labels)
      : mesh_(&mesh),
        rings_(&rings),
        labels_(std::move(labels)),
        vertices_(mesh.vertex_count()),
        queue_(mesh.vertex_count()) {
    for (std::uint32_t v = 0; v < labels_.size(); ++v) {
      if (labels_[v] == 0) {
        vertices_[v].is_zero = true;
        count_quads_around(v);
      }
    }
    push_changed();
  }

  [[nodiscard]] std::size_t illegal_count() const { return illegal_count_; }
  /// By which the relabels so far make the refined mesh larger.
  [[nodiscard]] std::uint64_t added() const { return added_; }
  [[nodiscard]] VertexLabels take_labels() { return std::move(labels_); }

  /// The vertex to relabel next, if any is illegal.
  [[nodiscard]] std::optional<Candidate> best() {
    return queue_.first([&](const Candidate& candidate) {
      const Vertex& vertex = vertices_[candidate.vertex];
      return vertex.place == CandidateQueue::kInHeap && rank_of(vertex) == candidate.rank;
    });
  }

  void relabel(std::uint32_t v) {
    labels_[v] = 1;
    risen_.assign(1, v);
    if (!mesh_->is_all_quads()) {
      raise_non_quads(*mesh_, labels_, risen_);
      for (const std::uint32_t w : risen_) {
        add_polygons_of(w);
      }
    }
    for (const std::uint32_t w : risen_) {
      raise(w);
    }
    push_changed();
  }

 private:
  struct Vertex {
    Count illegal_quads = 0;    ///< Quads around it with exactly two zeros.
    Count cost = 0;             ///< Quads around it with exactly three zeros.
    Count valence = 0;          ///< Illegal neighbours, one for each mesh edge.
    Count leaf_neighbours = 0;  ///< Illegal neighbours of valence 1, likewise.
    CandidateQueue::Place place = CandidateQueue::kNowhere;
    bool is_zero : 1 = false;
    bool is_illegal : 1 = false;
    bool is_leaf : 1 = false;  ///< Illegal and of valence 1.
    bool is_changed : 1 = false;
  };

  static void add(Count& count, int amount) { count = static_cast<Count>(count + amount); }

  [[nodiscard]] static CandidateRank rank_of(const Vertex& vertex) {
    return {vertex.leaf_neighbours > 0, vertex.valence, vertex.cost};
  }

  void mark(std::uint32_t v, Vertex& vertex) {
    if (!vertex.is_changed) {
      vertex.is_changed = true;
      changed_.push_back(v);
    }
  }

  void count_quads_around(std::uint32_t v) {
    Vertex& vertex = vertices_[v];
    for_each_quad(rings_->of(v), [&](std::uint32_t a, std::uint32_t diagonal, std::uint32_t b) {
      const int zeros = 1 + (labels_[a] == 0) + (labels_[diagonal] == 0) + (labels_[b] == 0);
      add(vertex.illegal_quads, zeros == 2);
      add(vertex.cost, zeros == 3);
    });
    if (vertex.illegal_quads > 0) {
      mark(v, vertex);
    }
  }

  /// Takes a zero away from the quads around v.
  void raise(std::uint32_t v) {
    Vertex& vertex = vertices_[v];
    vertex.is_zero = false;
    mark(v, vertex);
    for_each_quad(rings_->of(v), [&](std::uint32_t a, std::uint32_t diagonal, std::uint32_t b) {
      Vertex* const corners[] = {&vertex, &vertices_[a], &vertices_[diagonal], &vertices_[b]};
      const int zeros = corners[1]->is_zero + corners[2]->is_zero + corners[3]->is_zero;
      if (zeros == 0) {
        return;
      }
      added_ += added_faces(4 - zeros) - added_faces(3 - zeros);
      for (Vertex* const corner : corners) {
        add(corner->cost, (zeros == 3) - (zeros == 2));
        add(corner->illegal_quads, (zeros == 2) - (zeros == 1));
      }
      mark(a, *corners[1]);
      mark(diagonal, *corners[2]);
      mark(b, *corners[3]);
    });
  }

  /// Counts the faces other than quads that rise, each at its first corner.
  void add_polygons_of(std::uint32_t v) {
    const FlatTopology& topology = mesh_->topology();
    for (const std::uint32_t corner : corners_around(topology, v)) {
      const std::uint32_t f = topology.corner_faces[corner];
      if (sides_of(topology, f) != 4 && corners_of(topology, f)[0] == v) {
        added_ += sides_of(topology, f) - 1;
      }
    }
  }

  /// Brings valences and leaves up to date with the changed vertices, then queues them anew.
  void push_changed() {
    // Whatever changes on the way is appended to `changed_`, and queued in the end as well.
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
        vertex.place = queue_.move(v, vertex.place, rank_of(vertex));
      } else if (vertex.place != CandidateQueue::kNowhere) {
        queue_.leave(v, vertex.place);
        vertex.place = CandidateQueue::kNowhere;
      }
    }
    changed_.clear();
  }

  void update_legality(std::uint32_t v) {
    Vertex& vertex = vertices_[v];
    const bool is_illegal = vertex.is_zero && vertex.illegal_quads > 0;
    if (is_illegal == vertex.is_illegal) {
      return;
    }
    vertex.is_illegal = is_illegal;
    illegal_count_ += is_illegal ? 1 : ~std::size_t{0};
    for (const Spoke& spoke : rings_->of(v)) {
      Vertex& neighbour = vertices_[spoke.neighbour];
      add(neighbour.valence, is_illegal ? 1 : -1);
      mark(spoke.neighbour, neighbour);
    }
  }

  void update_leaf(std::uint32_t v) {
    Vertex& vertex = vertices_[v];
    const bool is_leaf = vertex.is_illegal && vertex.valence == 1;
    if (is_leaf == vertex.is_leaf) {
      return;
    }
    vertex.is_leaf = is_leaf;
    for (const Spoke& spoke : rings_->of(v)) {
      Vertex& neighbour = vertices_[spoke.neighbour];
      add(neighbour.leaf_neighbours, is_leaf ? 1 : -1);
      mark(spoke.neighbour, neighbour);
    }
  }

  const ControlMesh* mesh_;
  const SpokeRings* rings_;
  VertexLabels labels_;
  LargeArray<Vertex> vertices_;
  std::vector<std::uint32_t> changed_;
  std::vector<std::uint32_t> risen_;
  CandidateQueue queue_;
  std::size_t illegal_count_ = 0;
  std::uint64_t added_ = 0;
};

constexpr const char* kStage = "Removing illegal vertices";

tl::unexpected<Error> cancelled() {
  return fail(ErrorKind::kCancelled, "Legalising was cancelled.");
}

template <class Count>
Result<std::optional<Legalisation>> relabel_all(Greedy<Count> greedy, std::uint64_t most_faces,
                                                Progress& progress) {
  constexpr std::size_t kStepsBetweenReports = 4096;
  Legalisation result;
  double reached = 0.0;
  while (const std::optional<Candidate> best = greedy.best()) {
    if (greedy.added() >= most_faces) {
      return std::nullopt;
    }
    greedy.relabel(best->vertex);
    result.steps.push_back(
        {.vertex = best->vertex, .valence = best->rank.valence, .cost = best->rank.cost});
    if (result.steps.size() % kStepsBetweenReports == 0) {
      const auto made = static_cast<double>(result.steps.size());
      reached = std::max(reached, made / (made + static_cast<double>(greedy.illegal_count())));
      if (!progress.report(reached, kStage)) {
        return cancelled();
      }
    }
  }
  if (greedy.added() >= most_faces) {
    return std::nullopt;
  }
  result.labels = greedy.take_labels();
  if (!progress.report(1.0, kStage)) {
    return cancelled();
  }
  return result;
}

}  // namespace

Result<std::optional<Legalisation>> greedy_below(const ControlMesh& mesh, VertexLabels labels,
                                                 std::uint64_t most_faces, Progress& progress) {
  if (!progress.report(0.0, kStage)) {
    return cancelled();
  }
  const SpokeRings rings(mesh.topology(), labels);
  if (rings.most_spokes() <= std::numeric_limits<std::uint8_t>::max()) {
    return relabel_all(Greedy<std::uint8_t>(mesh, rings, std::move(labels)), most_faces, progress);
  }
  return relabel_all(Greedy<std::uint32_t>(mesh, rings, std::move(labels)), most_faces, progress);
}

Result<Legalisation> legalise_greedy(const ControlMesh& mesh, VertexLabels labels, NonQuadRule,
                                     Progress& progress) {
  LIMN_EXPECTS(labels.size() == mesh.vertex_count());
  return greedy_below(mesh, std::move(labels), kAnyNumberOfFaces, progress)
      .map([](std::optional<Legalisation> result) { return *std::move(result); });
}

}  // namespace limn
