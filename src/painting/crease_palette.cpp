#include "limn/painting/crease_palette.h"

#include <algorithm>
#include <cmath>

#include "limn/contract.h"

namespace limn {

std::size_t sharpness_band(float sharpness) noexcept {
  LIMN_EXPECTS(sharpness > 0.0f);
  if (sharpness >= kInfiniteSharpness) {
    return kSharpnessBands - 1;
  }
  return static_cast<std::size_t>(std::min(std::ceil(sharpness), 5.0f)) - 1;
}

const char* sharpness_band_name(std::size_t band) noexcept {
  constexpr std::array<const char*, kSharpnessBands> names{"up to 1", "up to 2", "up to 3",
                                                           "up to 4", "over 4",  "infinite"};
  LIMN_EXPECTS(band < names.size());
  return names[band];
}

const std::array<Rgb, kSharpnessBands>& crease_palette() noexcept {
  static constexpr std::array<Rgb, kSharpnessBands> palette{{{0x8e, 0x1b, 0x1b},
                                                             {0xc6, 0x28, 0x28},
                                                             {0xef, 0x53, 0x50},
                                                             {0xf4, 0x8f, 0x7f},
                                                             {0xfb, 0xc9, 0xb8},
                                                             {0xff, 0xff, 0xff}}};
  return palette;
}

CreaseCounts count_creases(const ControlMesh& mesh) {
  CreaseCounts counts{};
  for (const auto* sharpness : {&mesh.creases().edge_sharpness, &mesh.creases().vertex_sharpness}) {
    for (const float s : *sharpness) {
      if (s > 0.0f) {
        ++counts[sharpness_band(s)];
      }
    }
  }
  return counts;
}

}  // namespace limn
