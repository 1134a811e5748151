#include "limn/painting/depth_change.h"

#include <algorithm>
#include <functional>

namespace limn {

int DepthChange::operator()(int depth) const noexcept {
  // Wide enough that no amount, however wild, can overflow.
  std::int64_t wanted = amount;
  switch (kind) {
    case Kind::kAdd:
      wanted += depth;
      break;
    case Kind::kSet:
      break;
    case Kind::kAtLeast:
      wanted = std::max<std::int64_t>(depth, wanted);
      break;
    case Kind::kAtMost:
      wanted = std::min<std::int64_t>(depth, wanted);
      break;
  }
  return static_cast<int>(std::clamp<std::int64_t>(wanted, 0, kMaxDepth));
}

std::vector<DepthEdit> plan_edits(const FaceDepths& depths, std::span<const std::uint32_t> faces,
                                  DepthChange change) {
  // Selections come strictly ascending; only other lists can name a face twice.
  const bool may_repeat =
      std::adjacent_find(faces.begin(), faces.end(), std::greater_equal<>{}) != faces.end();
  std::vector<bool> is_seen(may_repeat ? depths.size() : 0);

  std::vector<DepthEdit> edits;
  for (const std::uint32_t face : faces) {
    LIMN_EXPECTS(face < depths.size());
    if (may_repeat) {
      if (is_seen[face]) {
        continue;
      }
      is_seen[face] = true;
    }
    const int before = depths[face];
    const int after = change(before);
    if (after != before) {
      edits.push_back({face, static_cast<std::uint8_t>(before), static_cast<std::uint8_t>(after)});
    }
  }
  return edits;
}

void apply_edits(FaceDepths& depths, std::span<const DepthEdit> edits) {
  for (const DepthEdit& edit : edits) {
    LIMN_EXPECTS(edit.face < depths.size() && depths[edit.face] == edit.before);
    depths.set(edit.face, edit.after);
  }
}

void revert_edits(FaceDepths& depths, std::span<const DepthEdit> edits) {
  for (std::size_t i = edits.size(); i-- > 0;) {
    const DepthEdit& edit = edits[i];
    LIMN_EXPECTS(edit.face < depths.size() && depths[edit.face] == edit.after);
    depths.set(edit.face, edit.before);
  }
}

}  // namespace limn
