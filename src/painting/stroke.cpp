#include "limn/painting/stroke.h"

namespace limn {

Stroke::Stroke(const FaceDepths& before, DepthChange change)
    : change_(change), touched_(before.size(), false) {}

bool Stroke::touch(FaceDepths& depths, std::span<const std::uint32_t> faces) {
  LIMN_EXPECTS(depths.size() == touched_.size());
  const std::size_t edits_before = edits_.size();
  for (const std::uint32_t face : faces) {
    LIMN_EXPECTS(face < touched_.size());
    if (touched_[face]) {
      continue;
    }
    const int before = depths[face];
    const int after = change_(before);
    if (after != before) {
      // In this order, since remembering it may fail.
      edits_.push_back({face, static_cast<std::uint8_t>(before), static_cast<std::uint8_t>(after)});
      depths.set(face, after);
    }
    touched_[face] = true;
  }
  return edits_.size() > edits_before;
}

}  // namespace limn
