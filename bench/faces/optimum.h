#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "faces/trials.h"

namespace limn::bench {

/// A mesh of so few faces that all of its paintings can be tried.
struct SmallMesh {
  std::string name;
  std::shared_ptr<const ControlMesh> mesh;
};

/// Meshes of 4 to 9 faces: even and uneven ones, closed and open.
[[nodiscard]] std::vector<SmallMesh> small_meshes();

/// The most faces of a mesh whose paintings are counted out, and how deep these go.
inline constexpr std::size_t kMostSmallFaces = 9;
inline constexpr int kSmallDepth = 3;

/// The painting with the fewest faces, of all with depths of 0..kSmallDepth, whose greatest
/// distance to the limit is at most `target` (in diagonals). All are legalised and counted; in the
/// order of their faces they are measured until one keeps to the target. How a control face and
/// those around it are refined depends on the labels at their corners alone, so where a face was
/// seen to be too far off, no painting with the same labels there is measured again. No faces where
/// none keeps to the target.
[[nodiscard]] Trial optimal_painting(const Subject& subject, double target);

}  // namespace limn::bench
