// A control face's quads come in the order of a walk through its quadtree (patch.cpp,
// fine_writer.cpp), so the walk is made again, only where faces are asked for.
#include "limn/subdivision/fine_places.h"

#include <algorithm>

#include "limn/contract.h"
#include "subdivision/cage.h"
#include "subdivision/fine/fine_counts.h"
#include "subdivision/fine/fine_path.h"
#include "subdivision/node_counts.h"

namespace limn {
namespace {

class Places {
 public:
  /// `has_grids`: nodes of more than one level whose labels are all equal have their quads row by
  /// row.
  Places(const FineWalk& walk, bool has_grids, std::span<const std::uint32_t> asked,
         std::vector<FineFace>& found)
      : walk_(&walk), has_grids_(has_grids), asked_(asked), found_(&found) {}

  /// Goes through what becomes of a node at some place.
  void visit(const WalkNode& node, const FineFace& place) {
    visit(node, place, [&](std::uint32_t i) { return walk_->child(node, i); });
  }
  template <class ChildOf>
  void visit(const WalkNode& node, const FineFace& place, const ChildOf& child_at) {
    const auto visit_child = [&](std::uint32_t i) { visit(child_at(i), child_of(place, i)); };
    if (asked_.empty()) {
      return;
    }
    if (walk_->follows(node) && node.level > 0) {
      const std::uint32_t quads = LabelCounts::table().face(node.labels).quads;
      if (asked_.front() >= next_ + quads) {
        next_ += quads;
        return;
      }
    }
    const std::uint8_t label = node.labels[0];
    if (has_grids_ && label > 1 && label <= kMostUniformLevels && node.is_uniform(label)) {
      visit_grid(place, label);
      return;
    }
    switch (node.pattern()) {
      case FacePattern::kStays:
        take(place);
        break;
      case FacePattern::kY: {
        const std::uint32_t positive = node.positive_corner();
        visit_child(positive);
        take(child_of(place, (positive + 1) % 4));
        take(child_of(place, (positive + 3) % 4));
        break;
      }
      case FacePattern::kSplit:
        for (std::uint32_t i = 0; i < 4; ++i) {
          visit_child(i);
        }
        break;
      case FacePattern::kIllegal:
        LIMN_EXPECTS(!"legal labels");
    }
  }

 private:
  void take(const FineFace& place) {
    while (!asked_.empty() && asked_.front() == next_) {
      found_->push_back(place);
      asked_ = asked_.subspan(1);
    }
    ++next_;
  }
  void visit_grid(const FineFace& place, std::uint8_t label) {
    const std::uint32_t along = 1U << label;
    for (; !asked_.empty() && asked_.front() < next_ + along * along; asked_ = asked_.subspan(1)) {
      const std::uint32_t at = asked_.front() - next_;
      found_->push_back({place.control_face, place.corner,
                         static_cast<std::uint8_t>(place.level + label),
                         static_cast<std::uint16_t>((place.column << label) + at % along),
                         static_cast<std::uint16_t>((place.row << label) + at / along)});
    }
    next_ += along * along;
  }

  const FineWalk* walk_;
  bool has_grids_;
  std::span<const std::uint32_t> asked_;
  std::vector<FineFace>* found_;
  std::uint32_t next_ = 0;
};

/// Of one control face that is not whole; `asked` are numbers among its quads.
void find_places(const Cage& cage, const RefinedFrom& from, std::span<const std::uint8_t> labels,
                 std::uint32_t f, std::span<const std::uint32_t> asked,
                 std::vector<FineFace>& found) {
  const FineWalk walk(from.fine, from.levels);
  const FaceLabels face(cage, labels, f);
  const bool is_fine = from.fine != nullptr && from.fine->first_node(f) != kNone;
  Places places(walk, !is_fine, asked, found);
  const auto child_at = [&](std::uint32_t i) { return walk.child_of_root(f, face, i); };
  if (face.size() == 4) {
    places.visit(walk.root(face), {f, 0, 0, 0, 0}, child_at);
    return;
  }
  for (std::uint32_t i = 0; i < face.size(); ++i) {
    places.visit(child_at(i), {f, i, 1, 0, 0});
  }
}

}  // namespace

std::vector<FineFace> places_of(const RefinedFrom& from, const RefinedMesh& refined,
                                std::span<const std::uint32_t> faces) {
  LIMN_EXPECTS(std::ranges::is_sorted(faces));
  LIMN_EXPECTS(faces.empty() || faces.back() < refined.face_count());
  Cage cage;
  cage.topology = &from.control->topology();
  cage.is_all_quads = from.control->is_all_quads();
  VertexLabels labels = *from.labels;
  for (std::uint8_t& label : labels) {
    label = static_cast<std::uint8_t>(std::min<int>(label, from.levels));
  }
  std::vector<FineFace> found;
  found.reserve(faces.size());
  std::vector<std::uint32_t> asked;
  const auto quads = std::span(refined.face_control_faces).first(refined.quads.size());
  std::size_t i = 0;
  while (i < faces.size() && faces[i] < quads.size()) {
    const std::uint32_t f = quads[faces[i]];
    const auto first =
        static_cast<std::uint32_t>(std::ranges::lower_bound(quads, f) - quads.begin());
    asked.clear();
    for (; i < faces.size() && faces[i] < quads.size() && quads[faces[i]] == f; ++i) {
      asked.push_back(faces[i] - first);
    }
    find_places(cage, from, labels, f, asked, found);
  }
  for (; i < faces.size(); ++i) {
    found.push_back({refined.face_control_faces[faces[i]], 0, 0, 0, 0});
  }
  LIMN_EXPECTS(found.size() == faces.size());
  return found;
}

}  // namespace limn
