#include "limn/mesh/mesh_format.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace limn {

std::string_view name_of(MeshFormat format) noexcept {
  switch (format) {
    case MeshFormat::kObj:
      return "OBJ";
    case MeshFormat::kPly:
      return "PLY";
    case MeshFormat::kOff:
      return "OFF";
    case MeshFormat::kStl:
      return "STL";
  }
  return {};
}

std::string_view ending_of(MeshFormat format) noexcept {
  switch (format) {
    case MeshFormat::kObj:
      return ".obj";
    case MeshFormat::kPly:
      return ".ply";
    case MeshFormat::kOff:
      return ".off";
    case MeshFormat::kStl:
      return ".stl";
  }
  return {};
}

std::optional<MeshFormat> format_by_ending(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const MeshFormat format : MeshFormats) {
    if (ending == ending_of(format)) {
      return format;
    }
  }
  return std::nullopt;
}

}  // namespace limn
