#pragma once

#include <cstdint>

#include "limn/mesh/control_mesh.h"
#include "limn/painting/face_depths.h"

namespace limn {

/// What can be done to a painting as a whole. The neighbours of a face are the faces that share a
/// vertex with it: those whose labels it has a say in, and the eight around a face of a quad grid.
enum class DepthFilter : std::uint8_t {
  /// Each face takes the greatest depth of itself and its neighbours: painted places widen by one
  /// ring of faces.
  kGrow,
  /// Each face takes the least depth of itself and its neighbours. What lies beyond a boundary does
  /// not count, so painted places do not shrink from there.
  kShrink,
  /// The deepest painted depth less each face's own. Twice is as before where some face had 0.
  kInvert,
  /// Each face takes the mean of itself and its neighbours, rounded; a half stays on the side of
  /// the face's own depth. A step of several levels becomes a flight of stairs, a lone face or hole
  /// goes. Evenly painted surroundings stay as they are, and no depth comes up that lies outside of
  /// what is around. Repeating comes to rest, or to two paintings in turn where stripes one face
  /// wide alternate.
  kSmooth,
  /// Every face gets 0.
  kClear,
};

/// The painting after the filter, every face seen as it was before. One entry per face of `mesh`.
[[nodiscard]] FaceDepths filter_depths(const ControlMesh& mesh, const FaceDepths& depths,
                                       DepthFilter filter);

}  // namespace limn
