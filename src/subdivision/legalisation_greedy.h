#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/progress.h"
#include "limn/subdivision/legalisation.h"

// Internal to this folder.
namespace limn {

inline constexpr std::uint64_t kAnyNumberOfFaces = std::numeric_limits<std::uint64_t>::max();

/// The greedy, but only while its relabels add fewer than `most_faces` faces; nothing once it has
/// added as many. Errors: kCancelled.
[[nodiscard]] Result<std::optional<Legalisation>> greedy_below(const ControlMesh& mesh,
                                                               VertexLabels labels,
                                                               std::uint64_t most_faces,
                                                               Progress& progress);

}  // namespace limn
