#include <chrono>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "limn/comparison/sphere_fit.h"
#include "limn/subdivision/schemes/uniform.h"

namespace limn {
namespace {

using Clock = std::chrono::steady_clock;

Result<SphereComparison> compare_level(int level, const SchemeCounts& counts, double seconds,
                                       std::span<const glm::dvec3> positions) {
  const std::optional<SphereFit> fit = fit_sphere(positions);
  if (!fit) {
    return fail(ErrorKind::kFailed,
                fmt::format("No sphere fits the {} vertices of level {}: they lie in a plane, or "
                            "are nearer to one than to any sphere.",
                            positions.size(), level));
  }
  return SphereComparison{level, counts.vertices, counts.edges, counts.faces, seconds, *fit};
}

}  // namespace

Result<std::vector<SphereComparison>> compare_with_sphere(const ControlMesh& mesh,
                                                          const SchemeSettings& settings,
                                                          int levels, Progress& progress) {
  if (Result<void> fits = check_fits(mesh, settings.scheme); !fits) {
    return tl::unexpected(std::move(fits.error()));
  }
  SchemeLevels scheme(mesh, settings);
  std::vector<glm::dvec3> positions(mesh.positions().begin(), mesh.positions().end());
  double seconds = 0.0;
  std::vector<SphereComparison> rows;
  while (true) {
    const Result<SphereComparison> row =
        compare_level(scheme.level(), scheme.counts(), seconds, positions);
    if (!row) {
      return tl::unexpected(row.error());
    }
    rows.push_back(*row);
    if (scheme.level() == levels) {
      return rows;
    }
    const Clock::time_point start = Clock::now();
    if (Result<void> made = scheme.advance(std::numeric_limits<std::uint64_t>::max(), progress);
        !made) {
      return tl::unexpected(std::move(made.error()));
    }
    const RefinedMesh refined = scheme.mesh();
    seconds = std::chrono::duration<double>(Clock::now() - start).count();
    positions.resize(refined.vertex_count());
    for (std::size_t v = 0; v < positions.size(); ++v) {
      positions[v] = refined.position(v);
    }
  }
}

}  // namespace limn
