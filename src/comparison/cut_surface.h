#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <glm/vec3.hpp>

#include "limn/mesh/control_mesh.h"
#include "limn/mesh/large_array.h"
#include "limn/mesh/refined_mesh.h"

// Internal to this folder.
namespace limn {

class Sweep;

/// A polygon surface as triangles, cut as in STL files: see mesh/triangulate.h. Scalar: float or
/// double.
template <class Scalar>
struct CutSurface {
  /// Those of the mesh, then the centroids of faces that no diagonals cut.
  LargeArray<glm::vec<3, Scalar>> points;
  LargeArray<std::array<std::uint32_t, 3>> triangles;  ///< Into `points`, face by face.
  LargeArray<std::uint32_t> faces;                     ///< For every triangle.
};

/// Coordinates as they are in the mesh. Empty where `sweep` is cancelled.
[[nodiscard]] CutSurface<double> cut_surface(const ControlMesh& mesh, Sweep& sweep);
/// Coordinates relative to RefinedMesh::origin.
[[nodiscard]] CutSurface<float> cut_surface(const RefinedMesh& mesh, Sweep& sweep);

}  // namespace limn
