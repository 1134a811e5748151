#pragma once

#include <array>
#include <cstdint>

#include "subdivision/control_faces.h"
#include "subdivision/patch.h"
#include "subdivision/patch_limits.h"

// From control faces to the roots of their patches, without the patches' points. Internal to this
// folder.
namespace limn {

/// The root of a patch with its numbers, as `refine_patch` takes it.
struct RootNode {
  Node node;
  std::uint32_t polygon_corner = kNone;  ///< The corner that the patch lies at, where its control
                                         ///< face is no quad.
  std::uint8_t resting_corners = 0;      ///< Bits: corners of the root that never move again and
                                         ///< are its to place. None where the control face is a
                                         ///< quad.
};

/// Sets `node`, which is new, to the root of quad f. One that stays has no numbers but its corners
/// and its own.
void set_quad_root(const RefinementPlan& plan, std::uint32_t f, Node& node);

/// Whether the face of a corner writes the vertices on the side that leaves the corner, where one
/// of its ends has a positive label and no labels of finer levels are given near it.
[[nodiscard]] bool writes_side(const RefinementPlan& plan, std::uint32_t corner);

/// What is wanted of roots.
enum class RootDetail {
  kAll,
  kOutline,  ///< Labels and resting corners: enough to count with.
};

/// The roots of control face f, which is no resting polygon, one after the other: one, or one for
/// each corner where the face is no quad.
class RootCursor {
 public:
  RootCursor(const RefinementPlan& plan, std::uint32_t f, RootDetail detail = RootDetail::kAll);
  /// Null behind the last; else good until the next call.
  [[nodiscard]] const RootNode* next();

 private:
  [[nodiscard]] RootNode start(std::uint32_t i) const;
  std::uint32_t join(std::uint32_t i, RootNode& here, RootNode& after,
                     std::uint32_t first_inner) const;

  const RefinementPlan* plan_;
  std::uint32_t f_;
  std::uint32_t first_;
  FaceLabels labels_;
  RootDetail detail_;  ///< Quads alone are cheaper with less.
  std::uint32_t next_ = 0;
  std::uint32_t next_quad_;
  std::uint32_t next_vertex_ = 0;  ///< Inside the quads, behind those on the inner edges.
  std::uint32_t next_inner_ = 0;
  std::uint32_t centre_ = 0;
  std::uint8_t centre_label_ = 0;
  RootNode root_;
  RootNode following_;  ///< With what the edges before it gave it.
};

/// Where the corners of a root stand in its patch's grid.
inline constexpr std::array<GridPlace, 4> kRootCorners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

/// The points around a root of face f, and what is special about it. `patch` may be one that was
/// used before.
void gather_patch(const RefinementPlan& plan, std::uint32_t f, const RootNode& root, Patch& patch);

}  // namespace limn
