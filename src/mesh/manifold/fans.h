#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/manifold/mend_log.h"
#include "mesh/manifold/working_faces.h"

namespace limn::detail {

/// Which vertex every corner has, once each fan of faces around a vertex has one of its own.
struct FanOwners {
  std::vector<std::uint32_t>
      of_corners;  ///< C: the vertex itself for the first fan that the
                   ///< corners meet, numbers from vertex_count on for others.
  std::vector<std::uint32_t> copy_sources;  ///< The vertex that each further number is a copy of.
};

/// `faces` are oriented, and twins run in opposite directions; corners without one have kNone.
[[nodiscard]] FanOwners find_fans(const FaceArrays& faces, std::span<const std::uint32_t> twins);

/// Gives every corner the vertex of its fan and renumbers the vertices: those in use keep their
/// order, copies come last. Returns for every new vertex the old one.
[[nodiscard]] std::vector<std::uint32_t> separate_fans(WorkingFaces& faces, const FanOwners& owners,
                                                       MendLog& log);

}  // namespace limn::detail
