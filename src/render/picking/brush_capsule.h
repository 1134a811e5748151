#pragma once

#include "render/coordinates.h"

namespace limn::render {

/// What a round brush covers on its way from one mouse position to the next, in pixels. Equal ends
/// make a disc.
struct BrushCapsule {
  FramebufferPoint from;
  FramebufferPoint to;
  /// Taken as at least half a pixel's diagonal, so that the thinnest brush still covers every pixel
  /// its path runs through.
  double radius = 0.0;
};

/// Its radius, in pixels, with that taken into account.
[[nodiscard]] double effective_radius(const BrushCapsule& capsule) noexcept;

/// The pixels whose centres the capsule may cover, clipped to the image.
[[nodiscard]] PixelRect pixel_rect(const BrushCapsule& capsule, FramebufferSize size);

/// Columns [first, last) of one row of pixels whose centres lie in the capsule; not clipped, empty
/// where first >= last.
struct PixelSpan {
  int first = 0;
  int last = 0;
};
[[nodiscard]] PixelSpan covered_span(const BrushCapsule& capsule, int row);

}  // namespace limn::render
