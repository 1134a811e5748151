#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "limn/subdivision/fine_demands.h"

namespace limn::app {

struct JobResult;

/// Faces of the mesh that the viewport shows: those of a refined mesh by their number in it.
struct ShownFaces {
  std::shared_ptr<const JobResult> refined;  ///< Whose mesh they are of; null: the control mesh.
  std::vector<std::uint32_t> faces;          ///< Ascending.

  [[nodiscard]] bool operator==(const ShownFaces&) const = default;
};

/// Whether a result is a refinement of what was painted by Catmull-Clark, whose faces have names.
[[nodiscard]] bool has_fine_faces(const JobResult& result) noexcept;

/// What the faces are called, one name for each. `refined` has fine faces, where there is one.
[[nodiscard]] std::vector<FineFace> names_of(const ShownFaces& shown);

/// The faces of a refined mesh, with fine faces, that lie in any of the faces named, or around one.
/// Ascending. Time is linear in all the refined faces of those control faces.
[[nodiscard]] std::vector<std::uint32_t> faces_named(const JobResult& refined,
                                                     std::span<const FineFace> names);

}  // namespace limn::app
