#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "limn/mesh/control_mesh.h"

namespace limn::test {

/// What is compared besides positions, down to the sign of 0, and faces.
struct Compared {
  bool sharpness = true;  ///< Creases, corners and their rules.
  bool uvs = true;        ///< The point of every corner, and where the seams are.
  bool names = true;
  bool loose_vertices = true;
};

/// The first difference between two meshes, for people; empty where there is none.
[[nodiscard]] std::string difference(const ControlMesh& one, const ControlMesh& other,
                                     const Compared& compared = {});

}  // namespace limn::test
