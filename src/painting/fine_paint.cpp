// What lowers goes down the quadtree of its control face with what is asked for above it: where
// part of a face is to get less, what was asked of the whole is handed on to its four children, and
// so at last to those beside the faces that are lowered. These stay asked for at the level they are
// lowered to: as a split of the face around them, if that lies in the face which asked for more.
#include "limn/painting/fine_paint.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "limn/contract.h"
#include "subdivision/fine/fine_path.h"

namespace limn {
namespace {

/// Children in the order of places.
constexpr std::array<std::uint32_t, 4> kWalkOrder{0, 1, 3, 2};

bool comes_before(const FineDemand& a, const FineDemand& b) {
  const auto key = [](const FineFace& face) {
    return std::tuple(face.control_face, face.corner, face.level > 0 ? first_place(face) : 0,
                      face.level);
  };
  return key(a.face) < key(b.face);
}

/// Levels that the rule for non-quads adds to every depth.
int extra_levels(const Painting& painting) {
  const bool splits_all = painting.non_quads == NonQuadRule::kUniformFirstStep &&
                          !painting.mesh.is_all_quads() &&
                          (!painting.demands.empty() || painting.depths.deepest() > 0);
  return splits_all ? 1 : 0;
}

/// The face of that level which a face lies in, or the control face.
FineFace face_around(FineFace face, int level) {
  while (face.level > level) {
    face = parent_of(face);
  }
  if (face.level == 0) {
    face.corner = 0;
  }
  return face;
}

int asked_of(const Painting& painting, int extra, const FineFace& face) {
  const int whole = painting.depths[face.control_face] + extra;
  return face.level == 0 ? whole : std::max<int>(whole, painting.demands.depth_at(face));
}

/// That can be asked for: of a control face, by its depth, one more where the rule adds one.
int most_levels(const FineFace& face, int extra) {
  return face.level == 0 ? kMaxDepth + extra : kMaxDepth;
}

/// What is left of one control face's painting where places of it get at most so much.
class Lowering {
 public:
  /// Demands and mosts in order; the depths of the latter may be less than their level.
  using Some = std::span<const FineDemand>;

  Lowering(const ControlMesh& mesh, std::uint32_t face, std::vector<FineDemand>& left)
      : sides_(mesh.face(face).size()), face_(face), left_(&left) {}

  /// Returns the levels that the whole control face is still asked for.
  int carry_out(int whole, Some demands, Some most) {
    int cap = kMaxDepth + 1;
    for (; !most.empty() && most.front().face.level == 0; most = most.subspan(1)) {
      cap = std::min<int>(cap, most.front().depth);
    }
    whole = std::min(whole, cap);
    int rest = whole;
    for (const FineDemand& one : most) {
      rest = std::min<int>(rest, one.depth);
    }
    const int handed_on = rest < whole ? whole : 0;
    pins_.clear();
    const std::uint32_t corners = sides_ == 4 ? 1 : static_cast<std::uint32_t>(sides_);
    for (std::uint32_t corner = 0; corner < corners; ++corner) {
      for (const std::uint32_t i : kWalkOrder) {
        const FineFace root{face_, corner, 0, 0, 0};
        const FineFace child = sides_ == 4 ? child_of(root, i) : FineFace{face_, corner, 1, 0, 0};
        visit(child, {handed_on, 0, cap}, take(demands, child), take(most, child));
        if (sides_ != 4) {
          break;
        }
      }
    }
    for (const FineDemand& pin : pins_) {
      rest = pin.face.level == 0 ? std::max<int>(rest, pin.depth) : rest;
    }
    for (const FineDemand& pin : pins_) {
      if (pin.face.level > 0 && pin.depth > rest) {
        left_->push_back(pin);
      }
    }
    return rest;
  }

 private:
  struct Above {
    int asked = 0;        ///< Of the face by one around it, and not kept yet;
    int asked_level = 0;  ///< the level of that one.
    int cap = 0;          ///< What anything in it may ask for.
  };

  /// Takes what lies in a face off the front.
  static Some take(Some& some, const FineFace& face) {
    const auto end = std::ranges::find_if_not(
        some, [&](const FineDemand& one) { return lies_in(one.face, face); });
    const auto count = static_cast<std::size_t>(end - some.begin());
    const Some taken = some.first(count);
    some = some.subspan(count);
    return taken;
  }

  void keep(const FineFace& face, int depth) {
    if (depth > face.level) {
      left_->push_back({face, static_cast<std::uint8_t>(depth)});
    }
  }

  void visit(const FineFace& face, Above above, Some demands, Some most) {
    for (; !most.empty() && most.front().face == face; most = most.subspan(1)) {
      above.cap = std::min<int>(above.cap, most.front().depth);
    }
    for (; !demands.empty() && demands.front().face == face; demands = demands.subspan(1)) {
      if (demands.front().depth > above.asked) {
        above.asked = demands.front().depth;
        above.asked_level = face.level;
      }
    }
    if (above.asked > above.cap) {
      above.asked = above.cap;
      if (above.cap <= face.level && above.cap > above.asked_level) {
        pins_.push_back({face_around(face, above.cap - 1), static_cast<std::uint8_t>(above.cap)});
      }
    }
    const bool is_parted =
        std::ranges::any_of(most, [&](const FineDemand& one) { return one.depth < above.asked; });
    if (!is_parted) {
      keep(face, above.asked);
      above.asked = 0;
    }
    if (most.empty()) {
      for (const FineDemand& demand : demands) {
        keep(demand.face, std::min<int>(demand.depth, above.cap));
      }
      return;
    }
    for (const std::uint32_t i : kWalkOrder) {
      const FineFace child = child_of(face, i);
      visit(child, above, take(demands, child), take(most, child));
    }
  }

  std::size_t sides_;
  std::uint32_t face_;
  std::vector<FineDemand>* left_;
  std::vector<FineDemand>
      pins_;  ///< What lowered faces are still asked for, as splits around them.
};

/// Depths of control faces that are to change.
class DepthEdits {
 public:
  DepthEdits(const Painting& painting, int extra) : painting_(&painting), extra_(extra) {}

  void set(std::uint32_t face, int levels) {
    const int before = painting_->depths[face];
    const int after = std::clamp(levels - extra_, 0, kMaxDepth);
    edits_.push_back({face, static_cast<std::uint8_t>(before), static_cast<std::uint8_t>(after)});
  }
  /// What lowers has been set before what raises.
  std::vector<DepthEdit> take() {
    std::ranges::stable_sort(edits_, {}, &DepthEdit::face);
    std::vector<DepthEdit> merged;
    for (const DepthEdit& edit : edits_) {
      if (merged.empty() || merged.back().face != edit.face) {
        merged.push_back(edit);
      } else {
        merged.back().after = std::max(merged.back().after, edit.after);
      }
    }
    std::erase_if(merged, [](const DepthEdit& edit) { return edit.before == edit.after; });
    return merged;
  }

 private:
  const Painting* painting_;
  int extra_;
  std::vector<DepthEdit> edits_;
};

/// All demands, those in control faces where something gets less rewritten.
std::vector<FineDemand> lowered(const Painting& painting, int extra,
                                std::span<const FineDemand> most, DepthEdits& depths) {
  std::vector<FineDemand> left;
  std::span<const FineDemand> demands = painting.demands.all();
  while (!most.empty()) {
    const std::uint32_t face = most.front().face.control_face;
    const auto is_of_face = [face](const FineDemand& one) { return one.face.control_face == face; };
    const auto begin = std::ranges::lower_bound(
        demands, face, {}, [](const FineDemand& one) { return one.face.control_face; });
    left.insert(left.end(), demands.begin(), begin);
    const auto end = std::find_if_not(begin, demands.end(), is_of_face);
    const auto most_end = std::ranges::find_if_not(most, is_of_face);
    Lowering lowering(painting.mesh, face, left);
    const int whole = painting.depths[face] + extra;
    depths.set(face, lowering.carry_out(whole, {begin, end}, {most.begin(), most_end}));
    demands = {end, demands.end()};
    most = {most_end, most.end()};
  }
  left.insert(left.end(), demands.begin(), demands.end());
  return left;
}

}  // namespace

int depth_asked(const Painting& painting, const FineFace& face) {
  const int extra = extra_levels(painting);
  return std::max(asked_of(painting, extra, face_around(face, kMaxDepth)) - extra, 0);
}

std::vector<std::uint8_t> demanded_depths(const Painting& painting, const RefinedFrom& from,
                                          const RefinedMesh& refined) {
  std::vector<std::uint8_t> depths(refined.face_count(), 0);
  const auto quads = std::span(refined.face_control_faces).first(refined.quads.size());
  std::vector<std::uint32_t> concerned;
  std::uint32_t last = kNone;
  for (const FineDemand& demand : painting.demands.all()) {
    if (std::exchange(last, demand.face.control_face) == demand.face.control_face) {
      continue;
    }
    const auto [begin, end] = std::equal_range(quads.begin(), quads.end(), last);
    for (auto at = begin; at != end; ++at) {
      concerned.push_back(static_cast<std::uint32_t>(at - quads.begin()));
    }
  }
  const std::vector<FineFace> places = places_of(from, refined, concerned);
  const int extra = extra_levels(painting);
  for (std::size_t i = 0; i < concerned.size(); ++i) {
    const FineFace face = face_around(places[i], kMaxDepth);
    const int depth = face.level > 0 ? painting.demands.depth_at(face) - extra : 0;
    depths[concerned[i]] = static_cast<std::uint8_t>(std::max(depth, 0));
  }
  return depths;
}

FineEdits plan_fine_edits(const Painting& painting, std::span<const FineFace> faces,
                          DepthChange change) {
  LIMN_EXPECTS(painting.depths.size() == painting.mesh.face_count());
  const int extra = extra_levels(painting);
  const bool adds = change.kind == DepthChange::Kind::kAdd;
  FineEdits edits;
  DepthEdits depths(painting, extra);
  std::vector<FineDemand> most;
  std::vector<FineDemand> least;
  std::vector<std::pair<std::uint32_t, int>> whole;  // Control faces to raise, and their levels.
  bool is_one_depth = true;
  for (const FineFace& given : faces) {
    const FineFace face = face_around(given, kMaxDepth);
    LIMN_EXPECTS(face.level > 0 ? is_face_of(painting.mesh, face)
                                : face.control_face < painting.mesh.face_count());
    const int asked = asked_of(painting, extra, face);
    const int from = adds && change.amount > 0 ? std::max<int>(asked, face.level) : asked;
    const int wanted = std::min(change(from - extra) + extra, most_levels(face, extra));
    const bool is_finer_already = adds && (change.amount > 0 ? wanted <= from : asked < face.level);
    if (wanted == asked || is_finer_already) {
      continue;
    }
    is_one_depth = is_one_depth && (edits.faces == 0 || edits.depth == wanted - extra);
    edits.depth = wanted - extra;
    ++edits.faces;
    if (wanted < asked) {
      most.push_back({face, static_cast<std::uint8_t>(wanted)});
      continue;
    }
    // A face of the wanted level is there because the one around it is split.
    const FineFace split = face_around(face, std::min<int>(face.level, wanted - 1));
    if (split.level == 0) {
      whole.emplace_back(split.control_face, wanted);
    } else {
      least.push_back({split, static_cast<std::uint8_t>(wanted)});
    }
  }
  if (!is_one_depth) {
    edits.depth.reset();
  }
  std::ranges::sort(most, comes_before);
  FineDemands after =
      most.empty() ? painting.demands : FineDemands(lowered(painting, extra, most, depths));
  for (const auto& [face, levels] : whole) {
    depths.set(face, levels);
  }
  after.raise(least);
  edits.depths = depths.take();
  edits.demands = after.edits_from(painting.demands);
  return edits;
}

}  // namespace limn
