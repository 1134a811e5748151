#pragma once

#include <cstdint>
#include <vector>

#include "faces/trials.h"

namespace limn::bench {

/// What OpenSubdiv's feature-adaptive refinement makes of a control mesh: bicubic patches, which a
/// GPU then cuts into triangles, and no faces. Regular ones are the limit surface itself; around
/// irregular vertices and creases it is approximated by Gregory patches, the more levels are
/// isolated the nearer.
struct Patches {
  int isolation = 0;  ///< Levels.
  std::uint64_t patches = 0;
  double greatest = 0.0;  ///< Distance to the limit at equal parameters, in diagonals: no less than
                          ///< the distance between the surfaces.
};

/// For levels from 1 on, until the distance is at most `target`.
[[nodiscard]] std::vector<Patches> isolate_patches(const Subject& subject, double target);

}  // namespace limn::bench
