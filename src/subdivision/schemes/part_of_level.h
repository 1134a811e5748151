#pragma once

#include <cstdint>
#include <vector>

#include "subdivision/schemes/level_mesh.h"

// Internal to this folder.
namespace limn {

/// Some triangles of a level as a level of their own.
struct PartOfLevel {
  LevelMesh mesh;                    ///< Where the rest was cut off there is a boundary.
  std::vector<std::uint32_t> faces;  ///< Number in the part of every face of the whole, or kNone.
  std::vector<std::uint32_t> vertices;  ///< Number in the whole of every vertex of the part.
};

/// Those with `is_kept`, in their order. A vertex that some of its triangles are cut off from has
/// any of the fans that are left.
[[nodiscard]] PartOfLevel part_of(const LevelMesh& whole, const std::vector<bool>& is_kept);

}  // namespace limn
