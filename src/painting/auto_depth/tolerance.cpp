#include "limn/painting/auto_depth/tolerance.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "limn/contract.h"
#include "limn/subdivision/face_errors.h"
#include "painting/auto_depth/first_step.h"

namespace limn {

Result<ChosenDepths> depths_for_tolerance(const ControlMesh& mesh,
                                          const SubdivisionSettings& settings,
                                          std::span<const double> distances, Progress& progress) {
  LIMN_EXPECTS(distances.size() == 1 || distances.size() == mesh.face_count());
  if (Result<void> has_limit = check_has_limit(settings); !has_limit) {
    return tl::unexpected(std::move(has_limit.error()));
  }
  FaceErrorOptions options;
  options.corners = settings.corners;
  options.points = settings.points;
  options.enough = *std::ranges::min_element(distances);
  const Result<std::vector<LevelErrors>> errors = face_errors(mesh, options, progress);
  if (!errors) {
    return tl::unexpected(errors.error());
  }
  const int first_step = first_step_levels(mesh, settings);
  const int most = kMaxDepth + first_step;
  ChosenDepths chosen{FaceDepths(mesh.face_count()), 0.0, 0};
  std::vector<std::uint8_t> levels(mesh.face_count());
  int deepest = 0;
  for (std::size_t f = 0; f < levels.size(); ++f) {
    const double distance = distances[distances.size() == 1 ? 0 : f];
    int level = 0;
    while (level < most && at_level((*errors)[f], level) > distance) {
      ++level;
    }
    levels[f] = static_cast<std::uint8_t>(level);
    chosen.short_faces += at_level((*errors)[f], level) > distance ? 1 : 0;
    deepest = std::max(deepest, level);
    chosen.depths.set(f, std::max(0, level - first_step));
  }
  // The uniform step alone is not to be had: something has to be painted for it.
  if (deepest == 1 && first_step == 1) {
    const auto one = std::ranges::find(levels, 1) - levels.begin();
    chosen.depths.set(static_cast<std::size_t>(one), 1);
  }
  for (std::size_t f = 0; f < levels.size(); ++f) {
    const int reached = deepest == 0 ? 0 : std::max<int>(levels[f], first_step);
    chosen.expected_error =
        std::max<double>(chosen.expected_error, at_level((*errors)[f], reached));
  }
  return chosen;
}

}  // namespace limn
