#pragma once

#include <cstdint>
#include <vector>

#include "mesh/manifold/mend_log.h"
#include "mesh/manifold/working_faces.h"

namespace limn::detail {

/// The faces of a soup, each clean by itself.
struct CleanFaces {
  WorkingFaces faces;
  std::vector<std::uint32_t> pinched;  ///< Faces that meet a vertex twice, not in a row.
};

/// Merges corners that repeat the one before and drops faces that are left with fewer than three
/// distinct vertices. The soup's indices are in range.
[[nodiscard]] CleanFaces clean_faces(const PolygonSoup& soup, MendLog& log);

/// Drops every face that has the vertices of an earlier one in the same circle and direction;
/// `pinched` is renumbered. Returns whether there was one. Takes the time of sorting.
bool drop_duplicates(CleanFaces& clean, MendLog& log);

}  // namespace limn::detail
