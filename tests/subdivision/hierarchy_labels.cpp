#include "hierarchy_labels.h"

#include <algorithm>
#include <optional>
#include <random>

#include <fmt/format.h>

#include "subdivision/fine/fine_labels.h"

namespace limn::test {
namespace {

/// A face of the hierarchy, and which of its corners is corner 0 of the engine's.
struct TurnedFace {
  std::uint32_t face = 0;
  std::uint32_t turn = 0;
};

class Spreading {
 public:
  Spreading(const UniformHierarchy& hierarchy, const ControlMesh& mesh)
      : hierarchy_(hierarchy), mesh_(mesh) {}

  [[nodiscard]] std::uint32_t vertex(int level, const TurnedFace& at, std::uint32_t i) const {
    return hierarchy_.face_vertices(level, at.face)[(i + at.turn) % 4];
  }
  [[nodiscard]] TurnedFace child_of_control_face(std::uint32_t f, std::uint32_t i) const {
    return child(0, {f, 0}, i, mesh_.face(f).size() == 4 ? i : 0);
  }
  [[nodiscard]] TurnedFace child(int level, const TurnedFace& at, std::uint32_t i) const {
    return child(level, at, i, i);
  }
  [[nodiscard]] TurnedFace find(const FineFace& face) const {
    const bool is_quad = mesh_.face(face.control_face).size() == 4;
    TurnedFace at = is_quad ? TurnedFace{face.control_face, 0}
                            : child_of_control_face(face.control_face, face.corner);
    for (int level = is_quad ? 0 : 1; level < face.level; ++level) {
      const int below = face.level - level - 1;
      const bool right = (face.column >> below & 1) != 0;
      const bool up = (face.row >> below & 1) != 0;
      at = child(level, at, up ? (right ? 2 : 3) : (right ? 1 : 0));
    }
    return at;
  }

 private:
  [[nodiscard]] TurnedFace child(int level, const TurnedFace& at, std::uint32_t i,
                                 std::uint32_t corner_there) const {
    const auto vertices = hierarchy_.face_vertices(level, at.face);
    const std::uint32_t corner = (i + at.turn) % static_cast<std::uint32_t>(vertices.size());
    const std::uint32_t face = hierarchy_.child_faces(level, at.face)[corner];
    const std::uint32_t vertex = hierarchy_.child_of_vertex(level, vertices[corner]);
    const auto there = hierarchy_.face_vertices(level + 1, face);
    const auto place = static_cast<std::uint32_t>(std::ranges::find(there, vertex) - there.begin());
    return {face, (place + 4 - corner_there) % 4};
  }

  const UniformHierarchy& hierarchy_;
  const ControlMesh& mesh_;
};

/// Labels one level down, by the rules of one level.
std::vector<std::uint8_t> inherited(const UniformHierarchy& hierarchy, int level,
                                    const std::vector<std::uint8_t>& labels) {
  const auto lowered = [&](std::uint32_t v) { return std::max(0, labels[v] - 1); };
  std::vector<std::uint8_t> next(hierarchy.vertex_count(level + 1), 0);
  for (std::uint32_t v = 0; v < labels.size(); ++v) {
    next[hierarchy.child_of_vertex(level, v)] = static_cast<std::uint8_t>(lowered(v));
  }
  for (std::uint32_t e = 0; e < hierarchy.edge_count(level); ++e) {
    const auto [a, b] = hierarchy.edge_vertices(level, e);
    next[hierarchy.child_of_edge(level, e)] =
        static_cast<std::uint8_t>(std::min(lowered(a), lowered(b)));
  }
  for (std::uint32_t f = 0; f < hierarchy.face_count(level); ++f) {
    std::uint8_t least = 0;
    for (const std::uint32_t e : hierarchy.face_edges(level, f)) {
      const std::uint8_t label = next[hierarchy.child_of_edge(level, e)];
      least = label > 0 && (least == 0 || label < least) ? label : least;
    }
    next[hierarchy.child_of_face(level, f)] = least;
  }
  return next;
}

std::string breach_at(const UniformHierarchy& hierarchy, int level, const LevelLabels& labels) {
  const std::vector<std::uint8_t>& here = labels[static_cast<std::size_t>(level)];
  const auto is_split = [&](std::uint32_t f) {
    const auto v = hierarchy.face_vertices(level, f);
    const auto positive = std::ranges::count_if(v, [&](std::uint32_t w) { return here[w] > 0; });
    return v.size() != 4 ? positive == static_cast<std::ptrdiff_t>(v.size())
                         : positive > 2 || (positive == 2 && (here[v[0]] > 0) == (here[v[2]] > 0));
  };
  for (std::uint32_t f = 0; f < hierarchy.face_count(level); ++f) {
    const auto v = hierarchy.face_vertices(level, f);
    const auto positive = std::ranges::count_if(v, [&](std::uint32_t w) { return here[w] > 0; });
    if ((v.size() == 4 && positive == 2 && !is_split(f)) ||
        (v.size() != 4 && positive > 0 && !is_split(f))) {
      return fmt::format("level {}: face {} is illegal", level, f);
    }
  }
  if (level + 1 >= static_cast<int>(labels.size())) {
    return "";
  }
  const std::vector<std::uint8_t>& next = labels[static_cast<std::size_t>(level) + 1];
  for (std::uint32_t v = 0; v < here.size(); ++v) {
    if (next[hierarchy.child_of_vertex(level, v)] > 0 && here[v] == 0) {
      return fmt::format("level {}: vertex {} goes on as a zero", level, v);
    }
  }
  for (std::uint32_t e = 0; e < hierarchy.edge_count(level); ++e) {
    const auto [a, b] = hierarchy.edge_vertices(level, e);
    if (next[hierarchy.child_of_edge(level, e)] > 0 && (here[a] == 0 || here[b] == 0)) {
      return fmt::format("level {}: edge {} ends in a zero", level, e);
    }
  }
  for (std::uint32_t f = 0; f < hierarchy.face_count(level); ++f) {
    if (next[hierarchy.child_of_face(level, f)] > 0 && !is_split(f)) {
      return fmt::format("level {}: face {} is not split", level, f);
    }
  }
  return "";
}

}  // namespace

std::vector<FineDemand> random_demands(const ControlMesh& mesh, std::size_t count, int deepest,
                                       Random& random) {
  const auto up_to = [&](std::uint32_t most) {
    return std::uniform_int_distribution<std::uint32_t>(0, most)(random);
  };
  std::vector<FineDemand> demands;
  for (std::size_t i = 0; i < count; ++i) {
    FineDemand demand;
    FineFace& face = demand.face;
    face.control_face = up_to(static_cast<std::uint32_t>(mesh.face_count() - 1));
    const auto sides = static_cast<std::uint32_t>(mesh.face(face.control_face).size());
    face.level = static_cast<std::uint8_t>(1 + up_to(static_cast<std::uint32_t>(deepest - 2)));
    const std::uint32_t last = (1U << (sides == 4 ? face.level : face.level - 1)) - 1;
    face.corner = sides == 4 ? 0 : up_to(sides - 1);
    face.column = static_cast<std::uint16_t>(up_to(last));
    face.row = static_cast<std::uint16_t>(up_to(last));
    demand.depth = static_cast<std::uint8_t>(
        face.level + 1 + up_to(static_cast<std::uint32_t>(deepest - face.level - 1)));
    demands.push_back(demand);
  }
  return demands;
}

std::uint32_t find_face(const UniformHierarchy& hierarchy, const ControlMesh& mesh,
                        const FineFace& face) {
  return face.level == 0 ? face.control_face : Spreading(hierarchy, mesh).find(face).face;
}

FinePainting random_fine_painting(const UniformHierarchy& hierarchy, const ControlMesh& mesh,
                                  std::span<const std::uint8_t> depths, std::size_t demands,
                                  const SubdivisionSettings& settings, Random& random) {
  const FineDemands raised(random_demands(mesh, demands, hierarchy.levels(), random));
  IgnoreProgress progress;
  FinePainting painting;
  painting.labels = legal_labels(mesh, depths, raised, settings, progress).value();
  painting.given = hierarchy_labels(hierarchy, mesh, depths, raised, settings, painting.labels);
  return painting;
}

HierarchyLabels hierarchy_labels(const UniformHierarchy& hierarchy, const ControlMesh& mesh,
                                 std::span<const std::uint8_t> depths, const FineDemands& demands,
                                 const SubdivisionSettings& settings,
                                 const LabelsWithDemands& found) {
  HierarchyLabels result;
  result.labels.emplace_back(found.legal.labels);
  LevelLabels wanted{vertex_labels(mesh, depths)};
  const bool is_painted =
      !demands.empty() || std::ranges::any_of(depths, [](std::uint8_t d) { return d > 0; });
  const bool has_first_step =
      is_painted && !mesh.is_all_quads() && settings.non_quads == NonQuadRule::kUniformFirstStep;
  for (std::uint8_t& label : wanted[0]) {
    label = static_cast<std::uint8_t>(label + (has_first_step ? 1 : 0));
  }
  if (!has_first_step) {
    wanted[0] = apply_non_quad_rule(mesh, wanted[0], settings.non_quads);
  }
  const Spreading spreading(hierarchy, mesh);
  struct Given {
    TurnedFace face;
    std::uint32_t node;
  };
  std::vector<Given> given;
  for (int level = 0; level < hierarchy.levels(); ++level) {
    const auto at = static_cast<std::size_t>(level);
    wanted.push_back(inherited(hierarchy, level, wanted[at]));
    for (const FineDemand& demand : demands.all()) {
      if (demand.face.level == level + 1) {
        for (std::uint32_t i = 0; i < 4; ++i) {
          std::uint8_t& label =
              wanted[at + 1][spreading.vertex(level + 1, spreading.find(demand.face), i)];
          label = std::max(label, static_cast<std::uint8_t>(demand.depth - level - 1));
        }
      }
    }
    result.labels.push_back(inherited(hierarchy, level, result.labels[at]));
    std::vector<Given> next;
    if (level == 0 && found.fine != nullptr) {
      for (const std::uint32_t f : found.fine->faces) {
        for (std::uint32_t i = 0; i < mesh.face(f).size(); ++i) {
          next.push_back({spreading.child_of_control_face(f, i), found.fine->first_node(f) + i});
        }
      }
    }
    for (const Given& here : given) {
      const std::uint32_t first = found.fine->nodes[here.node].first_child;
      for (std::uint32_t i = 0; i < 4 && first != kNone; ++i) {
        next.push_back({spreading.child(level, here.face, i), first + i});
      }
    }
    given = std::move(next);
    std::vector<int> told(result.labels[at + 1].size(), -1);
    for (const Given& here : given) {
      for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t v = spreading.vertex(level + 1, here.face, i);
        const std::uint8_t label = found.fine->nodes[here.node].labels[i];
        if (told[v] >= 0 && told[v] != label) {
          result.breach = fmt::format("level {}: two labels for vertex {}", level + 1, v);
        }
        told[v] = label;
        result.labels[at + 1][v] = label;
      }
    }
  }
  for (int level = 0; level <= hierarchy.levels() && result.breach.empty(); ++level) {
    const auto at = static_cast<std::size_t>(level);
    for (std::size_t v = 0; v < wanted[at].size() && result.breach.empty(); ++v) {
      const int is = result.labels[at][v];
      if (wanted[at][v] > 0 ? is != wanted[at][v] : is > 1) {
        result.breach = fmt::format("level {}: vertex {} has label {} instead of {}", level, v, is,
                                    wanted[at][v]);
      }
    }
    if (result.breach.empty()) {
      result.breach = breach_at(hierarchy, level, result.labels);
    }
  }
  return result;
}

}  // namespace limn::test
