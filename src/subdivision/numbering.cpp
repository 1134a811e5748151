// One pass over the faces counts, one assigns; a face's counts follow from its labels alone, or
// have been counted already where labels of finer levels are given.
#include "subdivision/numbering.h"

#include <algorithm>

#include "limn/contract.h"
#include "subdivision/fine/fine_counts.h"
#include "subdivision/label_counts.h"

namespace limn {
namespace {

enum Kind : std::size_t { kQuads, kVertices, kPolygons, kPolygonSides };
using Sizes = std::array<std::uint64_t, 4>;

/// Calls `visit(edge, side)` for the sides whose edges are numbered with this face.
template <class Visit>
void for_each_own_edge(const Cage& cage, std::size_t f, const Visit& visit) {
  const std::uint32_t first = cage.first_corner(f);
  const std::uint32_t n = cage.side_count(f);
  for (std::uint32_t side = 0; side < n; ++side) {
    if (cage.is_first(first + side)) {
      visit(cage.topology->corner_edges[first + side], side);
    }
  }
}

FaceCounts counts_of(const LabelCounts& table, const FaceLabels& labels) {
  if (labels.size() != 4) {
    return table.split(labels);
  }
  const FaceCounts& counts = table.face({labels[0], labels[1], labels[2], labels[3]});
  LIMN_EXPECTS(counts.quads > 0);  // Else the labels are illegal.
  return counts;
}

std::uint8_t greatest_of(const FaceLabels& labels) {
  std::uint8_t greatest = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    greatest = std::max(greatest, labels[i]);
  }
  return greatest;
}

/// What becomes of a face with a positive label, and of its sides.
class FaceSizes {
 public:
  FaceSizes(const LabelCounts& table, const FineCounts* fine, const FaceLabels& labels,
            std::size_t f)
      : table_(table),
        fine_(fine != nullptr && fine->has(f) ? fine : nullptr),
        labels_(labels),
        f_(f) {}

  [[nodiscard]] FaceCounts face() const {
    return fine_ != nullptr ? FaceCounts(fine_->face(f_)) : counts_of(table_, labels_);
  }
  [[nodiscard]] std::uint32_t on_edge(std::size_t side) const {
    if (fine_ != nullptr) {
      return fine_->side(f_, side);
    }
    const std::size_t after = side + 1 == labels_.size() ? 0 : side + 1;
    return table_.edge(labels_[side], labels_[after]);
  }

 private:
  const LabelCounts& table_;
  const FineCounts* fine_;
  const FaceLabels& labels_;
  std::size_t f_;
};

Sizes sizes_of(const FaceSizes& face, const Cage& cage, std::size_t f) {
  const FaceCounts counts = face.face();
  Sizes sizes{counts.quads, counts.inside, 0, 0};
  for_each_own_edge(
      cage, f, [&](std::uint32_t, std::uint32_t side) { sizes[kVertices] += face.on_edge(side); });
  return sizes;
}

}  // namespace

RefinedCounts Numbering::build(Sweep& sweep, const Cage& cage, std::span<const std::uint8_t> labels,
                               const FineCounts* fine) {
  const LabelCounts& table = LabelCounts::table();
  const std::size_t faces = cage.face_count();
  faces_.resize(faces);
  greatest_.resize(faces);
  insides_.resize(faces);
  edges_.resize(cage.topology->edge_corners.size());
  polygon_sides_.resize(cage.is_all_quads ? 0 : faces);

  const Sizes start{0, cage.vertex_count(), 0, 0};
  const auto resting = [&](std::size_t f) {
    const std::uint32_t n = cage.side_count(f);
    return n == 4 ? Sizes{1, 0, 0, 0} : Sizes{0, 0, 1, n};
  };
  const auto sizes = [&](std::size_t f) {
    const FaceLabels face(cage, labels, f);
    greatest_[f] = greatest_of(face);
    if (greatest_[f] == 0) {
      return resting(f);
    }
    if (fine != nullptr && fine->has(f)) {
      greatest_[f] = fine->face(f).deepest;
    }
    return sizes_of({table, fine, face, f}, cage, f);
  };
  const Sizes ends = sweep.number(faces, start, sizes, [&](std::size_t f, const Sizes& first) {
    if (greatest_[f] == 0) {
      const Sizes size = resting(f);
      faces_[f] = static_cast<std::uint32_t>(first[size[kQuads] > 0 ? kQuads : kPolygons]);
      if (size[kPolygons] > 0) {
        polygon_sides_[f] = static_cast<std::uint32_t>(first[kPolygonSides]);
      }
      return size;
    }
    const FaceLabels face(cage, labels, f);
    const FaceSizes face_sizes(table, fine, face, f);
    const FaceCounts counts = face_sizes.face();
    faces_[f] = static_cast<std::uint32_t>(first[kQuads]);
    std::uint64_t vertex = first[kVertices];
    for_each_own_edge(cage, f, [&](std::uint32_t edge, std::uint32_t side) {
      edges_[edge] = static_cast<std::uint32_t>(vertex);
      vertex += face_sizes.on_edge(side);
    });
    insides_[f] = static_cast<std::uint32_t>(vertex);
    return Sizes{counts.quads, vertex + counts.inside - first[kVertices], 0, 0};
  });
  return {ends[kQuads], ends[kVertices], ends[kPolygons], ends[kPolygonSides]};
}

}  // namespace limn
