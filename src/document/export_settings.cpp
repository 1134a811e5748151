#include "limn/document/export_settings.h"

#include <algorithm>
#include <array>

#include "limn/painting/depth_palette.h"

namespace limn {

ExportSettings export_settings(const Document& document) {
  static const std::array<glm::u8vec3, kDepthColours> colours = [] {
    std::array<glm::u8vec3, kDepthColours> result;
    std::transform(depth_palette().begin(), depth_palette().end(), result.begin(),
                   [](const Rgb& c) { return glm::u8vec3(c.red, c.green, c.blue); });
    return result;
  }();
  return {document.depths.values(), document.control.get(), colours};
}

}  // namespace limn
