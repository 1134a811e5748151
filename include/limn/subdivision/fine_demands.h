#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "limn/mesh/control_mesh.h"
#include "limn/subdivision/settings.h"

namespace limn {

/// A face of the mesh that `level` uniform Catmull-Clark steps make of the control mesh.
///
/// Control face f, a quad, becomes 2^level columns and rows: columns count from its first corner
/// towards its second, rows towards its last. At each corner of a face that is no quad lie
/// 2^(level - 1) columns and rows: columns count from the corner along the side that leaves it,
/// rows along the side that enters it.
struct FineFace {
  std::uint32_t control_face = 0;
  std::uint32_t corner = 0;  ///< The place of that corner in its face; 0 in quads.
  std::uint8_t level = 0;    ///< 1 or more: level 0 is a control face.
  std::uint16_t column = 0;
  std::uint16_t row = 0;

  [[nodiscard]] bool operator==(const FineFace&) const = default;
};

/// A face of some level that shall be subdivided further, to `depth` levels in all: more than its
/// own, and at most kMaxDepth.
struct FineDemand {
  FineFace face;
  std::uint8_t depth = 0;

  [[nodiscard]] bool operator==(const FineDemand&) const = default;
};

/// Whether the mesh has such a face, of a level from 1 to kMaxDepth.
[[nodiscard]] bool is_face_of(const ControlMesh& mesh, const FineFace& face);
/// Whether that is so and the depth is beyond the face's level, up to kMaxDepth.
[[nodiscard]] bool is_demand_on(const ControlMesh& mesh, const FineDemand& demand);

/// What tells two lots of demands apart, each in their order.
struct DemandEdits {
  std::vector<FineDemand> removed;
  std::vector<FineDemand> added;

  [[nodiscard]] bool empty() const noexcept { return removed.empty() && added.empty(); }
  [[nodiscard]] bool operator==(const DemandEdits&) const = default;
};

/// What is asked of faces finer than control faces. The depth asked of a place is the greatest of
/// the demands on faces that it lies in.
///
/// Kept are only those demands that no other covers, in an order of their own (control face, place,
/// level): whoever raised the same demands, one by one in any order or all at once, has the same.
class FineDemands {
 public:
  FineDemands() = default;
  explicit FineDemands(std::span<const FineDemand> demands) { raise(demands); }

  [[nodiscard]] bool empty() const noexcept { return demands_.empty(); }
  [[nodiscard]] std::size_t size() const noexcept { return demands_.size(); }
  [[nodiscard]] std::span<const FineDemand> all() const noexcept { return demands_; }
  [[nodiscard]] bool operator==(const FineDemands&) const = default;

  /// Asks for at least so much. Demands that are none, of a depth up to their face's level, are
  /// left out. In n log n of the new ones, linear in all.
  void raise(std::span<const FineDemand> demands);
  /// Asks for at most so much within a face: a demand on more than that stays for the rest, as
  /// demands on the faces beside. A depth up to the face's level leaves nothing asked for there.
  void lower(const FineDemand& most);
  /// What makes these of those before; `apply` to those before gives these, `revert` undoes it.
  [[nodiscard]] DemandEdits edits_from(const FineDemands& before) const;
  void apply(const DemandEdits& edits);
  void revert(const DemandEdits& edits);

  /// The depth asked of a face: the greatest demand on it or on one that it lies in; 0 for none.
  [[nodiscard]] std::uint8_t depth_at(const FineFace& face) const;

 private:
  void put_in_order();
  void drop_covered();
  void exchange(std::span<const FineDemand> removed, std::span<const FineDemand> added);

  std::vector<FineDemand> demands_;
};

}  // namespace limn
