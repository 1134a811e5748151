#pragma once

#include <vector>

namespace limn {

/// Sharpness from here on never wears off: the edge is a crease, the vertex a corner, at every
/// level (DeRose, Kass & Truong 1998; OpenSubdiv's Sdc::Crease::SHARPNESS_INFINITE).
inline constexpr float kInfiniteSharpness = 10.0f;

/// How the sharpness of a crease passes to the two halves of an edge.
enum class CreasingMethod {
  kUniform,  ///< Each half: one less than the edge's.
  kChaikin,  ///< Each half: 3/4 of the edge's plus 1/4 of the mean of the other sharp edges' at
             ///< that end, less one.
};

/// What happens to a boundary vertex that belongs to one face only.
enum class CornerRule {
  kSharp,   ///< It stays where it is (OpenSubdiv's edge-and-corner).
  kSmooth,  ///< It follows the boundary's cubic B-spline like any other (edge-only).
};

/// Semi-sharp creases and corners of a control mesh: how many levels an edge or a vertex stays
/// sharp, 0 being smooth. Boundary edges are sharp whatever is said here.
struct Creases {
  std::vector<float> edge_sharpness;    ///< One per edge, or empty: no edge is sharp.
  std::vector<float> vertex_sharpness;  ///< One per vertex, or empty: no vertex is sharp.
  CreasingMethod method = CreasingMethod::kUniform;

  [[nodiscard]] bool operator==(const Creases&) const = default;
};

}  // namespace limn
