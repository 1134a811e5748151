#pragma once

#include <array>
#include <cstdint>

#include "subdivision/control_faces.h"
#include "subdivision/flat_plan.h"
#include "subdivision/flat_shape.h"
#include "subdivision/root_nodes.h"

// Internal to this folder.
namespace limn {

/// What control faces add to.
enum PlanKind : std::size_t {
  kPlanRoots,
  kPlanSpecials,
  kPlanRingPoints,
  kPlanShares,
  kPlanSharpSides,
  kPlanPieces,
  kPlanQuads,
  kPlanPoints,
  kPlanNodes,  ///< And kNodeKinds - 1 more.
};
constexpr std::size_t kPlanKinds = kPlanNodes + kNodeKinds;
using PlanSizes = std::array<std::uint64_t, kPlanKinds>;

/// Counts what control faces add to the arrays of a plan, and adds it.
class FlatFiller {
 public:
  /// `plan` knows its subtrees, and whether it has limits.
  FlatFiller(const RefinementPlan& from, FlatPlan& plan);

  /// What face f adds.
  [[nodiscard]] PlanSizes sizes(std::uint32_t f) const;
  /// Adds it from `next` on, which then is where the next face's begin. There is room.
  void fill(std::uint32_t f, PlanSizes& next) const;

 private:
  void add_sizes(const RootNode& root, PlanSizes& sizes) const;
  void add_sizes(const PatchShape& shape, PlanSizes& sizes) const;
  void fill_root(std::uint32_t f, const RootNode& root, PlanSizes& next) const;
  void fill_points(const Patch& patch, const RootNode& root, std::uint64_t at) const;
  void fill_special(const Patch& patch, const PatchShape& shape, std::uint32_t root,
                    const PlanSizes& at) const;
  void fill_rings(const Patch& patch, const PatchShape& shape, const Point& base,
                  glm::vec3* out) const;
  void fill_polygon(std::uint32_t f) const;

  const RefinementPlan* from_;
  FlatPlan* plan_;
  bool is_even_;  ///< A side's shares are the same all along.
};

}  // namespace limn
