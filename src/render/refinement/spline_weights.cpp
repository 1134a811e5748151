// The four control points' own weights are subdivided like any points, with one vertex beyond each
// end of the segment.
#include "render/refinement/spline_weights.h"

namespace limn::render {

std::vector<glm::vec4> spline_weights(std::uint32_t most) {
  std::vector<glm::dvec4> line{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  std::vector<glm::vec4> weights;
  for (std::uint32_t level = 0;; ++level) {
    weights.insert(weights.end(), line.begin() + 1, line.end() - 1);
    if (level == most) {
      return weights;
    }
    std::vector<glm::dvec4> finer;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      finer.push_back((line[i] + line[i + 1]) * 0.5);
      if (i + 2 < line.size()) {
        finer.push_back((line[i] + line[i + 2]) * 0.125 + line[i + 1] * 0.75);
      }
    }
    line = std::move(finer);
  }
}

}  // namespace limn::render
