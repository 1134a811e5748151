#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "limn/mesh/control_mesh.h"
#include "limn/mesh/refined_mesh.h"
#include "subdivision/side_matching.h"

// Tells the boundary that a refined mesh has from its control mesh from any other. Internal to this
// folder.
namespace limn {

class BoundaryPaths {
 public:
  /// `singles`: the sides that have their edge to themselves, in ascending order. Memory of an
  /// earlier call is used again.
  void find(const ControlMesh& control, const RefinedMesh& refined, std::span<const Side> singles);

  /// One entry per single side: 1 where it lies on an edge of the control mesh's boundary.
  [[nodiscard]] std::span<const std::uint8_t> is_on_path() const noexcept { return is_on_path_; }

 private:
  struct ControlEdge {
    std::uint32_t from;
    std::uint32_t to;
    std::uint32_t face;
    std::uint32_t pieces;  ///< As the refined mesh has it; 0 where the levels of the ends tell.
  };
  struct Meshes {
    const ControlMesh* control;
    const RefinedMesh* refined;
    std::span<const Side> singles;
  };

  void follow(const Meshes& meshes, const ControlEdge& edge);
  [[nodiscard]] std::size_t side_from(const Meshes& meshes, std::uint32_t v,
                                      std::uint32_t control_face) const;
  [[nodiscard]] bool has_one_face(const RefinedMesh& refined, std::uint32_t v);

  std::vector<std::uint8_t> is_on_path_;
  std::vector<std::size_t> path_;
  std::vector<std::uint32_t> faces_around_;  ///< Empty until it is needed.
};

}  // namespace limn
