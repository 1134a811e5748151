// The sides are gathered lane by lane, put into groups by a hash of their edge, and every group is
// matched in a small hash table. Where most vertices are unsettled, this is done for a share of the
// edges at a time, also by their hash, so that memory stays small beside the mesh.
#include "subdivision/side_matching.h"

#include <algorithm>
#include <array>
#include <bit>

namespace limn {
namespace {

/// Sides in a group, about: its table stays in the cache.
constexpr std::size_t kGroupSides = 4096;
/// Tables of more are not worth their memory.
constexpr std::size_t kMostEdges = 2 * kGroupSides;
/// One side is kept at a time for so many faces.
constexpr std::size_t kFacesPerSide = 2;

/// The same for both directions.
std::uint64_t edge_hash(std::uint32_t a, std::uint32_t b) noexcept {
  const auto vertex_hash = [](std::uint32_t v) {
    const std::uint64_t h = v * 0x9E3779B97F4A7C15u;
    return (h ^ h >> 32) * 0xD1B54A32D192ED03u;
  };
  return vertex_hash(a) + vertex_hash(b);
}

/// The `count` bits after the first `skipped`.
std::uint64_t hash_bits(std::uint64_t hash, unsigned skipped, unsigned count) noexcept {
  return count == 0 ? 0 : hash << skipped >> (64 - count);
}

/// Calls `visit(side)` for every side of some faces for which `may_matter(from, to)`.
template <class Filter, class Visit>
void for_each_side(const RefinedMesh& mesh, std::size_t first_face, std::size_t last_face,
                   const Filter& may_matter, const Visit& visit) {
  for (std::size_t f = first_face; f < last_face; ++f) {
    const std::span<const std::uint32_t> face = mesh.face(f);
    std::uint32_t from = face.back();
    for (const std::uint32_t to : face) {
      if (may_matter(from, to)) {
        visit(Side{from, to, static_cast<std::uint32_t>(f)});
      }
      from = to;
    }
  }
}

/// Calls `visit(side)` for the sides of some faces that have no settled end. Fast where few have
/// none.
template <class Visit>
void for_each_unsettled_side(const RefinedMesh& mesh, const SettledVertices& settled,
                             std::size_t first_face, std::size_t last_face, const Visit& visit) {
  const auto is_unsettled = [&](std::uint32_t from, std::uint32_t to) {
    return (settled[from] | settled[to]) == 0;
  };
  const std::size_t last_quad = std::min(last_face, mesh.quads.size());
  for (std::size_t f = first_face; f < last_quad; ++f) {
    const std::array<std::uint32_t, 4>& quad = mesh.quads[f];
    if (settled[quad[0]] + settled[quad[1]] + settled[quad[2]] + settled[quad[3]] < 3) {
      for_each_side(mesh, f, f + 1, is_unsettled, visit);
    }
  }
  for_each_side(mesh, std::max(first_face, mesh.quads.size()), last_face, is_unsettled, visit);
}

std::size_t side_count(const RefinedMesh& mesh) noexcept {
  return 4 * mesh.quads.size() + mesh.polygon_vertices.size();
}

}  // namespace

void SideMatching::match(const RefinedMesh& mesh, const SettledVertices& settled) {
  singles_.clear();
  nonmanifold_ = 0;
  const Lanes lanes(mesh.face_count());
  lanes_.resize(std::max(lanes_.size(), lanes.count()));

  const std::size_t room = std::max(kGroupSides, mesh.face_count() / kFacesPerSide);
  Gathering wish{{}, room / lanes.count()};
  Gathered gathered = gather(mesh, settled, wish);
  if (gathered.is_complete) {
    match_gathered(lanes, gathered.found, wish.share);
  } else {
    // Vertices far apart in memory are dearer to ask than a few sides more are to match.
    wish = {};
    wish.settled_too = gathered.found > mesh.face_count();
    const std::size_t sides = wish.settled_too ? side_count(mesh) : gathered.found;
    wish.share.bits = static_cast<unsigned>(std::bit_width((sides - 1) / room));
    for (; wish.share.number < std::uint64_t{1} << wish.share.bits; ++wish.share.number) {
      gathered = gather(mesh, settled, wish);
      match_gathered(lanes, gathered.found, wish.share);
    }
  }
  std::ranges::sort(singles_);
}

SideMatching::Gathered SideMatching::gather(const RefinedMesh& mesh, const SettledVertices& settled,
                                            const Gathering& wish) {
  const Lanes lanes(mesh.face_count());
  lanes.each([&](std::size_t i) {
    Lane& lane = lanes_[i];
    lane.sides.clear();
    lane.found = 0;
    const auto keep = [&](const Side& side) {
      if (lane.found++ < wish.lane_room) {
        lane.sides.push_back(side);
      }
    };
    const std::size_t first = lanes.begin(i);
    const std::size_t last = lanes.end(i);
    if (wish.share.bits == 0) {
      for_each_unsettled_side(mesh, settled, first, last, keep);
      return;
    }
    const Share share = wish.share;
    const auto may_matter = [&](std::uint32_t from, std::uint32_t to) {
      return hash_bits(edge_hash(from, to), 0, share.bits) == share.number &&
             (wish.settled_too || (settled[from] | settled[to]) == 0);
    };
    for_each_side(mesh, first, last, may_matter, keep);
  });
  Gathered gathered;
  for (std::size_t i = 0; i < lanes.count(); ++i) {
    gathered.found += lanes_[i].found;
    gathered.is_complete = gathered.is_complete && lanes_[i].found == lanes_[i].sides.size();
  }
  return gathered;
}

void SideMatching::match_gathered(const Lanes& lanes, std::size_t count, const Share& share) {
  const std::size_t groups = std::bit_ceil(count / kGroupSides + 1);
  const auto group_bits = static_cast<unsigned>(std::bit_width(groups) - 1);
  const auto group_of = [&](const Side& side) {
    return hash_bits(edge_hash(side.from, side.to), share.bits, group_bits);
  };
  lanes.each([&](std::size_t i) {
    Lane& lane = lanes_[i];
    lane.ends.assign(groups, 0);
    for (const Side& side : lane.sides) {
      ++lane.ends[group_of(side)];
    }
  });
  group_ends_.resize(groups);
  std::uint32_t next = 0;
  for (std::size_t group = 0; group < groups; ++group) {
    for (std::size_t i = 0; i < lanes.count(); ++i) {
      const std::uint32_t size = lanes_[i].ends[group];
      lanes_[i].ends[group] = next;
      next += size;
    }
    group_ends_[group] = next;
  }
  grouped_.resize(count);
  lanes.each([&](std::size_t i) {
    Lane& lane = lanes_[i];
    for (const Side& side : lane.sides) {
      grouped_[lane.ends[group_of(side)]++] = side;
    }
  });

  const Lanes group_lanes(groups, lanes.count());
  group_lanes.each([&](std::size_t i) {
    Lane& lane = lanes_[i];
    lane.singles.clear();
    lane.nonmanifold = 0;
    for (std::size_t group = group_lanes.begin(i); group < group_lanes.end(i); ++group) {
      const std::size_t first = group == 0 ? 0 : group_ends_[group - 1];
      match_group(std::span(grouped_).subspan(first, group_ends_[group] - first),
                  share.bits + group_bits, lane);
    }
  });
  for (std::size_t i = 0; i < lanes.count(); ++i) {
    singles_.insert(singles_.end(), lanes_[i].singles.begin(), lanes_[i].singles.end());
    nonmanifold_ += lanes_[i].nonmanifold;
  }
}

void SideMatching::match_group(std::span<Side> sides, unsigned common_bits, Lane& lane) {
  if (sides.size() > kMostEdges) {
    match_by_sorting(sides, lane);
    return;
  }
  // Places stay free even if no two sides share an edge.
  const std::size_t places = std::bit_ceil(sides.size() + sides.size() / 2 + 1);
  const auto place_bits = static_cast<unsigned>(std::bit_width(places) - 1);
  lane.table.assign(places, Edge{});
  for (const Side& side : sides) {
    const auto [low, high] = std::minmax(side.from, side.to);
    std::size_t place = hash_bits(edge_hash(low, high), common_bits, place_bits);
    while (lane.table[place].upwards + lane.table[place].downwards > 0 &&
           (lane.table[place].low != low || lane.table[place].high != high)) {
      place = (place + 1) & (places - 1);
    }
    Edge& edge = lane.table[place];
    edge.low = low;
    edge.high = high;
    edge.face = side.face;
    std::uint16_t& count = side.from < side.to ? edge.upwards : edge.downwards;
    count = std::min<std::uint16_t>(static_cast<std::uint16_t>(count + 1), 2);
  }
  for (const Edge& edge : lane.table) {
    if (edge.upwards + edge.downwards == 1) {
      lane.singles.push_back(edge.upwards == 1 ? Side{edge.low, edge.high, edge.face}
                                               : Side{edge.high, edge.low, edge.face});
    } else if (edge.upwards != edge.downwards || edge.upwards > 1) {
      ++lane.nonmanifold;
    }
  }
}

/// The same for a group of any size.
void SideMatching::match_by_sorting(std::span<Side> sides, Lane& lane) {
  const auto edge_of = [](const Side& side) { return std::minmax({side.from, side.to}); };
  std::ranges::sort(sides, {}, edge_of);
  for (auto first = sides.begin(); first != sides.end();) {
    const auto last = std::find_if(
        first, sides.end(), [&](const Side& side) { return edge_of(side) != edge_of(*first); });
    if (last - first == 1) {
      lane.singles.push_back(*first);
    } else if (last - first > 2 || (first->from < first->to) == (first[1].from < first[1].to)) {
      ++lane.nonmanifold;
    }
    first = last;
  }
}

}  // namespace limn
