// Faces come sorted, so what is new is merged in.
#include "app/paint_tools/fine_stroke.h"

#include <algorithm>
#include <iterator>

namespace limn::app {

bool FineStroke::touch(const ShownFaces& shown) {
  if (!has_mesh_) {
    touched_.refined = shown.refined;
    has_mesh_ = true;
  }
  if (shown.refined != touched_.refined || std::ranges::includes(touched_.faces, shown.faces)) {
    return false;
  }
  std::vector<std::uint32_t> all;
  all.reserve(touched_.faces.size() + shown.faces.size());
  std::ranges::set_union(touched_.faces, shown.faces, std::back_inserter(all));
  touched_.faces = std::move(all);
  return true;
}

}  // namespace limn::app
