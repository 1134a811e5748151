#pragma once

#include <cstdint>
#include <vector>

#include "subdivision/control_faces.h"
#include "subdivision/patch.h"

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

/// Replaces `roots` by those of control face f, which is no resting polygon: one, or one for each
/// corner where the face is no quad. A quad that stays has no numbers but its corners and its own.
void list_roots(const RefinementPlan& plan, std::uint32_t f, std::vector<RootNode>& roots);

/// The same with labels and corners that rest alone, for who only counts.
void outline_roots(const RefinementPlan& plan, std::uint32_t f, std::vector<RootNode>& roots);

/// The points around a root of face f, and what is special about it.
[[nodiscard]] Patch gather_patch(const RefinementPlan& plan, std::uint32_t f, const RootNode& root);

}  // namespace limn
