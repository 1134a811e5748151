#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "render/coordinates.h"
#include "render/picking/brush_capsule.h"

namespace limn::render {

/// A part of the picture that is asked about, in pixels: what a brush covers on its way, or what a
/// polygon encloses (a rectangle, a lasso). A polygon is closed by itself; all that it winds around
/// at all is inside, so that a lasso which crosses itself leaves no holes. Of two points or fewer,
/// or without area, it is the lines between them alone.
class ScreenRegion {
 public:
  ScreenRegion(const BrushCapsule& capsule);  // NOLINT(google-explicit-constructor): is one.
  explicit ScreenRegion(std::vector<FramebufferPoint> polygon);
  /// The rectangle between two opposite corners.
  [[nodiscard]] static ScreenRegion rectangle(FramebufferPoint a, FramebufferPoint b);

  /// The brush, where it is one.
  [[nodiscard]] const std::optional<BrushCapsule>& capsule() const noexcept { return capsule_; }
  /// Corners of the polygon, where it is one.
  [[nodiscard]] std::span<const FramebufferPoint> polygon() const noexcept { return polygon_; }

  /// The pixels whose centres the region may cover, clipped to the image.
  [[nodiscard]] PixelRect pixel_rect(FramebufferSize size) const;
  /// Replaces `spans` by the columns of one row of pixels whose centres lie in the region:
  /// ascending, apart from each other, not clipped.
  void covered_spans(int row, std::vector<PixelSpan>& spans) const;

  /// Whether the region has any point in common with a polygon on the screen, borders included. A
  /// polygon without area is its outline.
  [[nodiscard]] bool meets(std::span<const glm::dvec2> face) const;

  /// What encloses the region.
  struct Box {
    glm::dvec2 low{0.0};
    glm::dvec2 high{0.0};
  };
  [[nodiscard]] const Box& box() const noexcept { return box_; }

 private:
  /// Sides of the polygon by the bands of rows they run through.
  void make_bands();
  [[nodiscard]] std::size_t band_of(double y) const;
  [[nodiscard]] glm::dvec2 corner(std::size_t i) const;
  [[nodiscard]] bool encloses(const glm::dvec2& point) const;
  [[nodiscard]] bool outline_meets(const glm::dvec2& from, const glm::dvec2& to) const;

  std::optional<BrushCapsule> capsule_;
  std::vector<FramebufferPoint> polygon_;
  Box box_;
  std::vector<std::uint32_t> band_offsets_;  ///< Prefix sums,
  std::vector<std::uint32_t> band_sides_;    ///< and the sides in each band.
};

}  // namespace limn::render
