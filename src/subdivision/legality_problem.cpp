// A face that is no quad rises as a whole, so its vertices are one variable, found by uniting sets.
// Quads may then have a variable at several corners; it counts once.
#include "subdivision/legality_problem.h"

#include <algorithm>
#include <numeric>

#include "subdivision/parallel_ranges.h"
#include "subdivision/surroundings.h"

namespace limn {
namespace {

/// Sets of vertices with the least of each as its name.
class UnitedVertices {
 public:
  explicit UnitedVertices(std::size_t count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), 0U);
  }
  [[nodiscard]] std::uint32_t least(std::uint32_t v) {
    while (parents_[v] != v) {
      parents_[v] = parents_[parents_[v]];
      v = parents_[v];
    }
    return v;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    a = least(a);
    b = least(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parents_;
};

QuadMask mask_of(std::span<const std::uint32_t> quad, const VertexLabels& labels) {
  unsigned mask = 0;
  for (unsigned i = 0; i < 4; ++i) {
    mask |= static_cast<unsigned>(labels[quad[i]] > 0) << i;
  }
  return static_cast<QuadMask>(mask);
}

/// Turns counts in [1, n] into prefix sums.
void sum_up(std::vector<std::uint32_t>& counts) {
  std::partial_sum(counts.begin(), counts.end(), counts.begin());
}

}  // namespace

LegalityProblem::LegalityProblem(const ControlMesh& mesh) : mesh_(&mesh) {
  const FlatTopology& topology = mesh.topology();
  if (mesh.is_all_quads()) {
    corner_variables_ = topology.corner_vertices;
    first_corners_ = topology.vertex_offsets;
    corners_ = topology.vertex_corners;
    return;
  }

  UnitedVertices sets(mesh.vertex_count());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const std::span<const std::uint32_t> face = corners_of(topology, f);
    for (std::size_t i = 1; face.size() != 4 && i < face.size(); ++i) {
      sets.unite(face[0], face[i]);
    }
  }
  std::uint32_t count = 0;
  variables_.resize(mesh.vertex_count());
  for (std::uint32_t v = 0; v < variables_.size(); ++v) {
    const std::uint32_t least = sets.least(v);
    variables_[v] = least == v ? count++ : variables_[least];
  }

  first_members_.assign(count + 1, 0);
  for (const std::uint32_t variable : variables_) {
    ++first_members_[variable + 1];
  }
  sum_up(first_members_);
  members_.resize(variables_.size());
  std::vector<std::uint32_t> next(first_members_.begin(), first_members_.end() - 1);
  for (std::uint32_t v = 0; v < variables_.size(); ++v) {
    members_[next[variables_[v]]++] = v;
  }

  polygon_faces_.assign(count, 0);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const std::span<const std::uint32_t> face = corners_of(topology, f);
    if (face.size() == 4) {
      for (const std::uint32_t v : face) {
        own_corner_variables_.push_back(variables_[v]);
      }
    } else {
      polygon_faces_[variables_[face[0]]] += static_cast<std::uint32_t>(face.size() - 1);
    }
  }
  corner_variables_ = own_corner_variables_;

  own_first_corners_.assign(count + 1, 0);
  const auto quads = static_cast<std::uint32_t>(quad_count());
  for (std::uint32_t q = 0; q < quads; ++q) {
    for_each_variable(
        q, [&](std::uint32_t variable, unsigned) { ++own_first_corners_[variable + 1]; });
  }
  sum_up(own_first_corners_);
  own_corners_.resize(own_first_corners_.back());
  next.assign(own_first_corners_.begin(), own_first_corners_.end() - 1);
  for (std::uint32_t q = 0; q < quads; ++q) {
    for_each_variable(q, [&](std::uint32_t variable, unsigned bits) {
      own_corners_[next[variable]++] = 4 * q + static_cast<std::uint32_t>(std::countr_zero(bits));
    });
  }
  first_corners_ = own_first_corners_;
  corners_ = own_corners_;
}

LargeArray<QuadMask> LegalityProblem::masks(const VertexLabels& labels) const {
  LargeArray<QuadMask> masks;
  if (mesh_->is_all_quads()) {
    constexpr std::size_t kGrain = std::size_t{1} << 13;
    masks.resize(quad_count());
    parallel_ranges(0, masks.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t q = begin; q < end; ++q) {
        masks[q] = mask_of(corner_variables_.subspan(4 * q, 4), labels);
      }
    });
    return masks;
  }
  masks.reserve(quad_count());
  for (std::size_t f = 0; f < mesh_->face_count(); ++f) {
    const std::span<const std::uint32_t> face = corners_of(mesh_->topology(), f);
    if (face.size() == 4) {
      masks.push_back(mask_of(face, labels));
    }
  }
  return masks;
}

}  // namespace limn
