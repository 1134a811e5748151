// Boundaries are edges that stay sharp for ever; what is sharp around a vertex tells its rule, and
// where that changes in this step, the old and the new rule are mixed (DeRose, Kass & Truong 1998).
#include "editing/loop_step.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <glm/common.hpp>

#include "subdivision/sharpness.h"
#include "subdivision/vertex_rule.h"

namespace limn {
namespace {

class Stepping {
 public:
  Stepping(const ControlMesh& mesh, CornerRule corners)
      : mesh_(mesh), flat_(mesh.topology()), corners_(corners) {}

  [[nodiscard]] LoopStep run() {
    for (std::uint32_t e = 0; e < mesh_.edge_count(); ++e) {
      const auto [a, b] = flat_.edge_vertices[e];
      step_.half_sharpness.push_back({half_sharpness(e, a), half_sharpness(e, b)});
    }
    step_.positions.reserve(mesh_.vertex_count() + mesh_.edge_count());
    for (std::uint32_t v = 0; v < mesh_.vertex_count(); ++v) {
      step_.positions.push_back(vertex_point(v));
    }
    for (std::uint32_t e = 0; e < mesh_.edge_count(); ++e) {
      step_.positions.push_back(edge_point(e));
    }
    if (!mesh_.creases().vertex_sharpness.empty()) {
      for (const float sharpness : mesh_.creases().vertex_sharpness) {
        step_.vertex_sharpness.push_back(one_level_less(sharpness));
      }
      step_.vertex_sharpness.resize(step_.positions.size(), 0.0f);
    }
    return std::move(step_);
  }

 private:
  /// The sharp edges at a vertex.
  struct Star {
    SharpEdges edges;
    glm::dvec3 ends{0.0};  ///< Sum of their other ends.

    void add(float sharpness, const glm::dvec3& end) {
      edges.add(0, sharpness);
      ends += is_sharp(sharpness) ? end : glm::dvec3(0.0);
    }
    [[nodiscard]] glm::dvec3 point(VertexRule rule, const glm::dvec3& itself,
                                   const glm::dvec3& smooth) const {
      switch (rule) {
        case VertexRule::kCorner:
          return itself;
        case VertexRule::kCrease:
          return 0.75 * itself + 0.125 * ends;
        case VertexRule::kSmooth:
          break;
      }
      return smooth;
    }
  };

  [[nodiscard]] bool is_boundary(std::uint32_t edge) const {
    return flat_.edge_corners[edge][1] == kNone;
  }
  [[nodiscard]] float sharpness(std::uint32_t edge) const {
    if (is_boundary(edge)) {
      return kInfiniteSharpness;
    }
    const std::vector<float>& edges = mesh_.creases().edge_sharpness;
    return edges.empty() ? 0.0f : edges[edge];
  }

  static std::uint32_t previous(std::uint32_t corner) {
    return corner % 3 == 0 ? corner + 2 : corner - 1;
  }
  [[nodiscard]] std::uint32_t apex(std::uint32_t corner) const {
    return flat_.corner_vertices[previous(corner)];
  }

  /// Calls `visit(edge, neighbour)` for every edge at a vertex, counter-clockwise.
  template <class Visit>
  void for_each_edge(std::uint32_t v, const Visit& visit) const {
    for (std::uint32_t i = flat_.vertex_offsets[v]; i < flat_.vertex_offsets[v + 1]; ++i) {
      const std::uint32_t corner = flat_.vertex_corners[i];
      const std::uint32_t edge = flat_.corner_edges[corner];
      const auto [a, b] = flat_.edge_vertices[edge];
      visit(edge, a == v ? b : a);
      const std::uint32_t entering = previous(corner);
      if (flat_.corner_twins[entering] == kNone) {
        visit(flat_.corner_edges[entering], flat_.corner_vertices[entering]);
      }
    }
  }

  [[nodiscard]] float half_sharpness(std::uint32_t edge, std::uint32_t v) const {
    const float whole = sharpness(edge);
    if (mesh_.creases().method == CreasingMethod::kUniform || !is_semi_sharp(whole)) {
      return one_level_less(whole);
    }
    SharpnessSum sum;
    for_each_edge(v, [&](std::uint32_t e, std::uint32_t) { sum.add(sharpness(e)); });
    return chaikin_child(whole, sum.mean_besides(whole));
  }

  [[nodiscard]] float corner_sharpness(std::uint32_t v) const {
    const std::uint32_t first = flat_.vertex_corners[flat_.vertex_offsets[v]];
    if (corners_ == CornerRule::kSharp && flat_.corner_twins[first] == kNone &&
        flat_.vertex_offsets[v + 1] - flat_.vertex_offsets[v] == 1) {
      return kInfiniteSharpness;
    }
    const std::vector<float>& vertices = mesh_.creases().vertex_sharpness;
    return vertices.empty() ? 0.0f : vertices[v];
  }

  [[nodiscard]] glm::dvec3 vertex_point(std::uint32_t v) const {
    Star before;
    Star after;
    WornOff worn;
    glm::dvec3 sum(0.0);
    int n = 0;
    for_each_edge(v, [&](std::uint32_t e, std::uint32_t neighbour) {
      const glm::dvec3& end = mesh_.positions()[neighbour];
      const float whole = sharpness(e);
      const float half = step_.half_sharpness[e][flat_.edge_vertices[e][0] == v ? 0 : 1];
      before.add(whole, end);
      after.add(half, end);
      worn.add(whole, half);
      sum += end;
      ++n;
    });
    const float own = corner_sharpness(v);
    worn.add(own, one_level_less(own));
    const VertexRule rule = before.edges.rule(own);
    const VertexRule child_rule = after.edges.rule(one_level_less(own));

    const double around = 0.375 + 0.25 * std::cos(2.0 * std::numbers::pi / n);
    const double others = 0.625 - around * around;  // n beta.
    const glm::dvec3& itself = mesh_.positions()[v];
    const glm::dvec3 smooth = (1.0 - others) * itself + others / n * sum;
    return glm::mix(after.point(child_rule, itself, smooth), before.point(rule, itself, smooth),
                    weight_of_rule(rule, child_rule, worn));
  }

  [[nodiscard]] glm::dvec3 edge_point(std::uint32_t e) const {
    const auto [a, b] = flat_.edge_vertices[e];
    const glm::dvec3 ends = mesh_.positions()[a] + mesh_.positions()[b];
    if (is_boundary(e)) {
      return 0.5 * ends;
    }
    const auto [corner, twin] = flat_.edge_corners[e];
    const glm::dvec3 smooth =
        0.375 * ends + 0.125 * (mesh_.positions()[apex(corner)] + mesh_.positions()[apex(twin)]);
    const auto [one, other] = step_.half_sharpness[e];
    return glm::mix(smooth, 0.5 * ends, double{sharp_share_of_edge(sharpness(e), one, other)});
  }

  const ControlMesh& mesh_;
  const FlatTopology& flat_;
  CornerRule corners_;
  LoopStep step_;
};

}  // namespace

LoopStep loop_step(const ControlMesh& mesh, CornerRule corners) {
  return Stepping(mesh, corners).run();
}

}  // namespace limn
