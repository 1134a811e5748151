#include "limn/mesh/face_names.h"

#include "limn/contract.h"

namespace limn {
namespace {

FaceNames pick(const FaceNames& layer, std::span<const std::uint32_t> sources) {
  FaceNames result;
  if (layer.empty()) {
    return result;
  }
  result.names = layer.names;
  result.of_faces.reserve(sources.size());
  for (const std::uint32_t source : sources) {
    LIMN_EXPECTS(source < layer.of_faces.size());
    result.of_faces.push_back(layer.of_faces[source]);
  }
  return result;
}

}  // namespace

FaceNaming names_by_source(const FaceNaming& names, std::span<const std::uint32_t> sources) {
  return {pick(names.objects, sources), pick(names.groups, sources), pick(names.materials, sources),
          names.material_libraries};
}

}  // namespace limn
