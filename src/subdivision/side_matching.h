#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "limn/mesh/large_array.h"
#include "limn/mesh/refined_mesh.h"
#include "subdivision/closed_stars.h"
#include "subdivision/lanes.h"

// Brings the sides of faces together that lie on one edge. Internal to this folder.
namespace limn {

/// A side of a face, in the face's direction.
struct Side {
  std::uint32_t from;
  std::uint32_t to;
  std::uint32_t face;

  // NOLINTNEXTLINE(modernize-use-nullptr): a slip of the check's.
  [[nodiscard]] auto operator<=>(const Side&) const = default;
};

/// Matches the sides that have no settled end.
class SideMatching {
 public:
  /// Memory of an earlier match is used again.
  void match(const RefinedMesh& mesh, const SettledVertices& settled);

  /// Sides that have their edge to themselves, in ascending order.
  [[nodiscard]] std::span<const Side> single_sides() const noexcept { return singles_; }
  /// Edges with three sides or more, or with two in one direction.
  [[nodiscard]] std::size_t nonmanifold_edges() const noexcept { return nonmanifold_; }

 private:
  /// An edge and how often it was met, for which 0, 1 and 2 are enough.
  struct Edge {
    std::uint32_t low;
    std::uint32_t high;
    std::uint32_t face;
    std::uint16_t upwards;
    std::uint16_t downwards;
  };
  /// Some of the edges by their hash: one part of 2^bits.
  struct Share {
    unsigned bits = 0;
    std::uint64_t number = 0;
  };
  struct Lane {
    std::vector<Side> sides;
    std::size_t found = 0;
    std::vector<std::uint32_t> ends;  ///< Of its sides in each group.
    std::vector<Edge> table;
    std::vector<Side> singles;
    std::size_t nonmanifold = 0;
  };
  /// Which sides are gathered, and how many of them each lane keeps at most.
  struct Gathering {
    Share share;
    std::size_t lane_room = static_cast<std::size_t>(-1);
    bool settled_too = false;  ///< Sides that have a settled end, where a share is asked for.
  };
  struct Gathered {
    std::size_t found = 0;
    bool is_complete = true;
  };

  Gathered gather(const RefinedMesh& mesh, const SettledVertices& settled, const Gathering& wish);
  void match_gathered(const Lanes& lanes, std::size_t count, const Share& share);
  static void match_group(std::span<Side> sides, unsigned common_bits, Lane& lane);
  static void match_by_sorting(std::span<Side> sides, Lane& lane);

  std::vector<Lane> lanes_;
  std::vector<std::uint32_t> group_ends_;
  LargeArray<Side> grouped_;
  std::vector<Side> singles_;
  std::size_t nonmanifold_ = 0;
};

}  // namespace limn
