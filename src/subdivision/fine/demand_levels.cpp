// Down the levels go the labels that follow from the control mesh's and those that are demanded; up
// them goes what each level needs of the one before. What is raised on the way up was 0 and becomes
// 1, which is 0 again one level down, so the levels below keep the labels that they were closed
// with.
#include "subdivision/fine/demand_levels.h"

#include <algorithm>

#include "limn/contract.h"
#include "subdivision/fine/fine_path.h"
#include "subdivision/fine/level_legalisation.h"
#include "subdivision/label_counts.h"
#include "subdivision/numbering.h"
#include "subdivision/surroundings.h"

namespace limn {
namespace {

Cage cage_of(const ControlMesh& mesh) {
  Cage cage;
  cage.topology = &mesh.topology();
  cage.is_all_quads = mesh.is_all_quads();
  return cage;
}

/// The face of so low a level that a demand's face lies in.
FineFace at_level(FineFace face, int level) {
  const int levels = face.level - level;
  face.level = static_cast<std::uint8_t>(level);
  face.column = static_cast<std::uint16_t>(face.column >> levels);
  face.row = static_cast<std::uint16_t>(face.row >> levels);
  return face;
}

/// The control faces with demands and those around, ascending.
std::vector<std::uint32_t> faces_around(const FlatTopology& topology,
                                        std::span<const FineDemand> demands, int rings) {
  std::vector<std::uint32_t> faces;
  std::vector<std::uint8_t> is_listed(topology.face_offsets.size() - 1, 0);
  const auto list = [&](std::uint32_t f) {
    if (is_listed[f] == 0) {
      is_listed[f] = 1;
      faces.push_back(f);
    }
  };
  for (const FineDemand& demand : demands) {
    list(demand.face.control_face);
  }
  std::size_t inner = 0;
  for (int ring = 0; ring < rings; ++ring) {
    const std::size_t end = faces.size();
    for (; inner < end; ++inner) {
      for (const std::uint32_t v : corners_of(topology, faces[inner])) {
        for (const std::uint32_t corner : corners_around(topology, v)) {
          list(topology.corner_faces[corner]);
        }
      }
    }
  }
  std::ranges::sort(faces);
  return faces;
}

void raise(std::uint8_t& label) {
  label = std::max<std::uint8_t>(label, 1);
}

}  // namespace

DemandLevels::DemandLevels(const ControlMesh& mesh, const FineDemands& demands,
                           const VertexLabels& labels, int rings) {
  const Cage cage = cage_of(mesh);
  forest_.plant(cage, faces_around(mesh.topology(), demands.all(), rings));
  std::vector<std::uint8_t>& first = labels_.emplace_back();
  for (const std::uint32_t v : forest_.control_vertices()) {
    first.push_back(labels[v]);
  }
  forest_.divide_roots(cage, [](std::uint32_t) { return kAllChildren; });
  std::vector<std::uint8_t>& second = labels_.emplace_back(forest_.vertex_count(), std::uint8_t{0});
  for (const ForestRoot& root : forest_.roots()) {
    const FaceLabels face(cage, labels, root.face);
    const std::uint8_t centre = face_point_label(face);
    for (std::uint32_t i = 0; i < face.size(); ++i) {
      const QuadLabels child = child_labels(face, i, centre);
      for (std::uint32_t k = 0; k < 4; ++k) {
        second[forest_.node(root.child(i)).vertices[(root.turn(i) + k) % 4]] = child[k];
      }
    }
  }
  inherited_ = labels_;
  for (const FineDemand& demand : demands.all()) {
    const ForestRoot& root = forest_.root(forest_.root_of(demand.face.control_face));
    demand_nodes_.push_back(root.child(root.is_quad() ? corner_in_parent(at_level(demand.face, 1))
                                                      : demand.face.corner));
  }
  const int deepest = std::ranges::max_element(demands.all(), {}, [](const FineDemand& d) {
                        return d.face.level;
                      })->face.level;
  for (int level = 1; level <= deepest; ++level) {
    apply(demands.all(), level);
    if (level < deepest) {
      descend(demands.all(), level, rings);
    }
  }
}

void DemandLevels::apply(std::span<const FineDemand> demands, int level) {
  for (std::size_t i = 0; i < demands.size(); ++i) {
    if (demands[i].face.level == level) {
      for (const std::uint32_t v : forest_.node(demand_nodes_[i]).vertices) {
        std::uint8_t& label = labels_[static_cast<std::size_t>(level)][v];
        label = std::max(label, static_cast<std::uint8_t>(demands[i].depth - level));
      }
    }
  }
}

/// From a level to the next, where that has demands or what lies in it has.
void DemandLevels::descend(std::span<const FineDemand> demands, int level, int rings) {
  const std::uint32_t begin = forest_.first_node(level);
  const std::uint32_t end = forest_.first_node(level + 1);
  std::vector<std::uint8_t> is_wanted(end - begin, 0);
  for (std::size_t i = 0; i < demands.size(); ++i) {
    if (demands[i].face.level > level) {
      is_wanted[demand_nodes_[i] - begin] = 1;
    }
  }
  std::vector<std::uint8_t> is_near(forest_.vertex_count(), 0);
  for (int ring = 0; ring < rings; ++ring) {
    for (std::uint32_t i = begin; i < end; ++i) {
      for (const std::uint32_t v : forest_.node(i).vertices) {
        is_near[v] |= is_wanted[i - begin];
      }
    }
    for (std::uint32_t i = begin; i < end; ++i) {
      for (const std::uint32_t v : forest_.node(i).vertices) {
        is_wanted[i - begin] |= is_near[v];
      }
    }
  }
  forest_.divide(
      [&](std::uint32_t i) { return is_wanted[i - begin] != 0 ? kAllChildren : kNoChildren; });

  const std::vector<std::uint8_t>& labels = labels_.back();
  std::vector<std::uint8_t> next(forest_.vertex_count(), 0);
  for (std::uint32_t i = begin; i < end; ++i) {
    const ForestNode& node = forest_.node(i);
    if (node.children == kNoChildren) {
      continue;
    }
    QuadLabels here;
    std::ranges::transform(node.vertices, here.begin(), [&](std::uint32_t v) { return labels[v]; });
    const std::uint8_t centre = face_point_label(here);
    for (std::uint32_t c = 0; c < 4; ++c) {
      const QuadLabels child = child_labels(here, c, centre);
      for (std::uint32_t k = 0; k < 4; ++k) {
        next[forest_.node(node.child(c)).vertices[(c + k) % 4]] = child[k];
      }
    }
  }
  inherited_.push_back(next);
  labels_.push_back(std::move(next));
  for (std::size_t i = 0; i < demands.size(); ++i) {
    if (demands[i].face.level > level) {
      demand_nodes_[i] = forest_.node(demand_nodes_[i])
                             .child(corner_in_parent(at_level(demands[i].face, level + 1)));
    }
  }
}

bool DemandLevels::close() {
  for (int level = forest_.level_count() - 1; level > 0; --level) {
    need(level);
    const std::uint32_t begin = forest_.first_node(level);
    legalise_level(forest_.nodes().subspan(begin, forest_.first_node(level + 1) - begin),
                   labels_[static_cast<std::size_t>(level)]);
    if (!is_settled(level)) {
      return false;
    }
  }
  return true;
}

/// What the next level needs of this one. A positive face point needs its face split; it has a
/// positive edge point beside it, whose ends two neighbouring corners are, and these make the face
/// split once the level is legal.
void DemandLevels::need(int level) {
  std::vector<std::uint8_t>& labels = labels_[static_cast<std::size_t>(level)];
  for (std::uint32_t i = forest_.first_node(level); i < forest_.first_node(level + 1); ++i) {
    const ForestNode& node = forest_.node(i);
    for (std::uint32_t c = 0; c < 4 && node.children != kNoChildren; ++c) {
      const std::array<std::uint32_t, 4>& child = forest_.node(node.child(c)).vertices;
      if (label(level + 1, child[c]) > 0) {
        raise(labels[node.vertices[c]]);
      }
      if (label(level + 1, child[(c + 1) % 4]) > 0) {
        raise(labels[node.vertices[c]]);
        raise(labels[node.vertices[(c + 1) % 4]]);
      }
    }
  }
}

std::vector<std::uint32_t> DemandLevels::needed_vertices() const {
  const std::vector<std::uint8_t>& labels = labels_[1];
  std::vector<std::uint32_t> needed;
  const auto need_corner = [&](const ForestRoot& root, std::uint32_t i) {
    needed.push_back(
        forest_.control_vertices()[forest_.node(root.child(i)).vertices[root.turn(i)]]);
  };
  for (const ForestRoot& root : forest_.roots()) {
    const std::uint32_t n = root.sides;
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::array<std::uint32_t, 4>& child = forest_.node(root.child(i)).vertices;
      const std::uint32_t turn = root.turn(i);
      const bool has_middle = labels[child[(turn + 1) % 4]] > 0;
      if (labels[child[turn]] > 0 || has_middle) {
        need_corner(root, i);
      }
      if (has_middle) {
        need_corner(root, (i + 1) % n);
      }
    }
  }
  return needed;
}

/// Whether no label has been raised on the rim of what there is, nor next to it.
bool DemandLevels::is_settled(int level) const {
  const std::vector<std::uint8_t>& labels = labels_[static_cast<std::size_t>(level)];
  const std::vector<std::uint8_t>& inherited = inherited_[static_cast<std::size_t>(level)];
  const std::uint32_t begin = forest_.first_node(level);
  const std::span<const ForestNode> nodes =
      forest_.nodes().subspan(begin, forest_.first_node(level + 1) - begin);
  std::vector<std::uint8_t> is_rim(labels.size(), 0);
  for (const ForestNode& node : nodes) {
    for (std::size_t side = 0; side < 4; ++side) {
      if (node.neighbours[side] == kNobody) {
        is_rim[node.vertices[side]] = 1;
        is_rim[node.vertices[(side + 1) % 4]] = 1;
      }
    }
  }
  return std::ranges::none_of(nodes, [&](const ForestNode& node) {
    const auto at_rim = [&](std::uint32_t v) { return is_rim[v] != 0; };
    const auto is_raised = [&](std::uint32_t v) { return labels[v] != inherited[v]; };
    return std::ranges::any_of(node.vertices, at_rim) &&
           std::ranges::any_of(node.vertices, is_raised);
  });
}

}  // namespace limn
