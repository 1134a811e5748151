// Demands stand in the order of a walk through the quadtrees that meets a face before what lies in
// it (Morton order), so what lies in a face follows it without a gap, and one pass with a stack of
// the faces around drops what is covered.
#include "limn/subdivision/fine_demands.h"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include "limn/contract.h"
#include "subdivision/fine/fine_path.h"

namespace limn {
namespace {

constexpr auto kOrder = [](const FineDemand& a, const FineDemand& b) {
  const auto key = [](const FineFace& face) {
    return std::tuple(face.control_face, face.corner, first_place(face), face.level);
  };
  return key(a.face) < key(b.face);
};

/// The greater depth first.
constexpr auto kWholeOrder = [](const FineDemand& a, const FineDemand& b) {
  return kOrder(a, b) || (!kOrder(b, a) && a.depth > b.depth);
};

bool is_some(const FineDemand& demand) {
  return demand.face.level > 0 && demand.depth > demand.face.level;
}

}  // namespace

bool is_face_of(const ControlMesh& mesh, const FineFace& face) {
  if (face.control_face >= mesh.face_count() || face.level < 1 || face.level > kMaxDepth) {
    return false;
  }
  const std::size_t sides = mesh.face(face.control_face).size();
  const std::uint32_t along = 1U << (sides == 4 ? face.level : face.level - 1);
  return face.corner < (sides == 4 ? 1 : sides) && face.column < along && face.row < along;
}

bool is_demand_on(const ControlMesh& mesh, const FineDemand& demand) {
  return is_face_of(mesh, demand.face) && is_some(demand) && demand.depth <= kMaxDepth;
}

void FineDemands::raise(std::span<const FineDemand> demands) {
  const auto before = static_cast<std::ptrdiff_t>(demands_.size());
  demands_.insert(demands_.end(), demands.begin(), demands.end());
  std::sort(demands_.begin() + before, demands_.end(), kWholeOrder);
  std::inplace_merge(demands_.begin(), demands_.begin() + before, demands_.end(), kWholeOrder);
  drop_covered();
}

void FineDemands::put_in_order() {
  std::ranges::sort(demands_, kWholeOrder);
  drop_covered();
}

void FineDemands::drop_covered() {
  std::vector<FineDemand> around;  // Those that the last one lies in, and itself.
  std::size_t kept = 0;
  for (const FineDemand& demand : demands_) {
    if (!is_some(demand)) {
      continue;
    }
    while (!around.empty() && !lies_in(demand.face, around.back().face)) {
      around.pop_back();
    }
    if (around.empty() || around.back().depth < demand.depth) {
      around.push_back(demand);
      demands_[kept++] = demand;
    }
  }
  demands_.resize(kept);
}

void FineDemands::lower(const FineDemand& most) {
  LIMN_EXPECTS(most.face.level > 0);
  std::vector<FineDemand> beside;
  for (FineDemand& demand : demands_) {
    if (demand.depth <= most.depth) {
      continue;
    }
    if (lies_in(demand.face, most.face)) {
      demand.depth = most.depth;
    } else if (lies_in(most.face, demand.face)) {
      FineFace face = most.face;
      for (; face.level > demand.face.level; face = parent_of(face)) {
        for (std::uint16_t child = 0; child < 4; ++child) {
          if (const FineFace sibling = child_of(parent_of(face), child); sibling != face) {
            beside.push_back({sibling, demand.depth});
          }
        }
      }
      demand = {most.face, most.depth};
    }
  }
  demands_.insert(demands_.end(), beside.begin(), beside.end());
  put_in_order();
}

DemandEdits FineDemands::edits_from(const FineDemands& before) const {
  DemandEdits edits;
  std::ranges::set_difference(before.demands_, demands_, std::back_inserter(edits.removed),
                              kWholeOrder);
  std::ranges::set_difference(demands_, before.demands_, std::back_inserter(edits.added),
                              kWholeOrder);
  return edits;
}

void FineDemands::apply(const DemandEdits& edits) {
  exchange(edits.removed, edits.added);
}

void FineDemands::revert(const DemandEdits& edits) {
  exchange(edits.added, edits.removed);
}

void FineDemands::exchange(std::span<const FineDemand> removed, std::span<const FineDemand> added) {
  std::vector<FineDemand> kept;
  kept.reserve(demands_.size());
  std::ranges::set_difference(demands_, removed, std::back_inserter(kept), kWholeOrder);
  LIMN_EXPECTS(kept.size() + removed.size() == demands_.size());
  std::vector<FineDemand> all;
  all.reserve(kept.size() + added.size());
  std::ranges::merge(kept, added, std::back_inserter(all), kWholeOrder);
  demands_ = std::move(all);
}

std::uint8_t FineDemands::depth_at(const FineFace& face) const {
  std::uint8_t depth = 0;
  for (FineFace at = face; at.level > 0; at = parent_of(at)) {
    const auto found =
        std::lower_bound(demands_.begin(), demands_.end(), FineDemand{at, 0}, kOrder);
    if (found != demands_.end() && found->face == at) {
      depth = std::max(depth, found->depth);
    }
  }
  return depth;
}

}  // namespace limn
