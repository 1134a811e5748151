#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "app/paint_tools/shown_faces.h"
#include "limn/mesh/control_mesh.h"
#include "limn/painting/depth_change.h"
#include "render/coordinates.h"
#include "ui/model.h"

namespace limn::render {
class ScreenRegion;
}

namespace limn::app {

struct ViewportFrame;
class Session;

/// The brush under the cursor, in pixels of the viewport.
struct BrushRing {
  render::FramebufferPoint centre;
  double radius = 0.0;

  [[nodiscard]] bool operator==(const BrushRing&) const = default;
};

/// A line over the picture, in pixels of the viewport: what a rectangle or lasso encloses so far,
/// or the way of a straight stroke to come.
struct Outline {
  std::vector<render::FramebufferPoint> points;
  bool is_closed = false;

  [[nodiscard]] bool operator==(const Outline&) const = default;
};

/// What the left button does with the tools that paint, and what lights up before it does.
///
/// The brush paints as it goes, the whole way between two places of the cursor, so that it leaves
/// no gaps; a fill paints when the button goes down; rectangle and lasso paint when it comes up.
/// Each is one stroke of the session: one command, and Esc gives it up.
class PaintTools {
 public:
  void press(const ViewportFrame& frame, render::FramebufferPoint at);
  void move(const ViewportFrame& frame, render::FramebufferPoint from, render::FramebufferPoint to);
  /// `at` is where the button came up; where the window lost it instead, a rectangle or lasso is
  /// given up.
  void release(const ViewportFrame& frame, render::FramebufferPoint at);
  /// Whether what was begun has been given up by Esc; forgets about it then.
  [[nodiscard]] bool take_given_up(const Session& session);

  /// Shows what a click here would reach, and asks what it would cost.
  void hover(const ViewportFrame& frame, render::FramebufferPoint at);
  void leave(Session& session);

  [[nodiscard]] const std::optional<BrushRing>& ring() const noexcept { return ring_; }
  [[nodiscard]] const Outline& outline() const noexcept { return outline_; }
  [[nodiscard]] std::span<const std::uint32_t> highlighted() const noexcept { return highlighted_; }
  /// What lights up instead where one paints on faces of the refined mesh; null otherwise.
  [[nodiscard]] const ShownFaces* lit() const noexcept { return lit_ ? &*lit_ : nullptr; }

 private:
  enum class Gesture : std::uint8_t { kNone, kStroke, kFill, kArea, kPick };

  void add_to_area(const ViewportFrame& frame, render::FramebufferPoint at);
  [[nodiscard]] render::ScreenRegion area(const ViewportFrame& frame) const;
  [[nodiscard]] std::vector<std::uint32_t> faces_in(const ViewportFrame& frame,
                                                    const render::ScreenRegion& region) const;
  /// Begins the session's stroke, on control faces or on those of the refined mesh.
  void begin_stroke(const ViewportFrame& frame, const char* name);
  void touch(const ViewportFrame& frame, const render::ScreenRegion& region) const;
  /// Lights up faces of the refined mesh in a region, and asks what it would cost to paint them.
  void light(const ViewportFrame& frame, const render::ScreenRegion& region,
             std::optional<DepthChange> proposed);
  /// Where a straight line to the cursor would begin.
  [[nodiscard]] std::optional<render::FramebufferPoint> line_start(
      const ViewportFrame& frame) const;
  void remember_end(const ViewportFrame& frame, render::FramebufferPoint at);
  /// What a fill would take of the face under the cursor.
  [[nodiscard]] const std::vector<std::uint32_t>& fill_region(const ViewportFrame& frame,
                                                              std::uint32_t seed);

  Gesture gesture_ = Gesture::kNone;
  DepthChange change_;                          ///< Of the gesture.
  bool is_fine_ = false;                        ///< Likewise.
  ui::Tool area_tool_ = ui::Tool::kRectangle;   ///< Likewise.
  std::vector<render::FramebufferPoint> area_;  ///< Opposite corners, or the lasso's way.
  std::optional<BrushRing> ring_;
  Outline outline_;
  std::vector<std::uint32_t> highlighted_;
  std::optional<ShownFaces> lit_;

  /// Where the last stroke ended, on a mesh that is still open.
  struct StrokeEnd {
    std::weak_ptr<const ControlMesh> mesh;
    glm::dvec3 position{0.0};
  };
  std::optional<StrokeEnd> last_end_;

  /// A region is grown again only where one of these differs.
  struct Fill {
    std::weak_ptr<const ControlMesh> mesh;
    std::uint64_t depths_revision = 0;
    std::uint32_t seed = 0;
    ui::Tool tool = ui::Tool::kFill;
    double angle = 0.0;
    std::vector<std::uint32_t> region;
  };
  std::optional<Fill> fill_;
};

}  // namespace limn::app
