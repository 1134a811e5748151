#include "cli/level_text.h"

#include <fmt/format.h>

namespace limn::cli {

std::string level_text(const SchemeLevel& level) {
  const SchemeCounts& counts = level.counts;
  return fmt::format("level {}: {} vertices, {} edges, {} faces, {:.3f} ms", level.level,
                     counts.vertices, counts.edges, counts.faces, 1e3 * level.seconds);
}

}  // namespace limn::cli
