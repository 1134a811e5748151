#pragma once

#include <span>
#include <vector>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/painting/auto_depth/screen_view.h"
#include "limn/painting/face_depths.h"
#include "limn/progress.h"
#include "limn/subdivision/settings.h"

namespace limn {

/// What is held to a size on the screen.
struct ScreenSize {
  enum class Of { kEdge, kArea };
  Of of = Of::kEdge;
  double pixels = 4.0;  ///< The longest edge a refined face may have, or the most pixels it covers.
  int silhouettes = 1;  ///< Levels more where the surface turns away from the eye.

  [[nodiscard]] bool operator==(const ScreenSize&) const = default;
};

/// How large each face of the limit surface shows at the most in any of the views: its longest side
/// in pixels or its area in square pixels, 0 where it does not show. One entry a face.
///
/// A face does not show where it is outside of the picture, or where a closed surface turns its
/// back on the eye. What hides it does not matter. Sides are those of the limit surface's corners;
/// parts before the near plane are cut off.
[[nodiscard]] Result<std::vector<double>> screen_sizes(const ControlMesh& mesh, CornerRule corners,
                                                       ScreenSize::Of of,
                                                       std::span<const ScreenView> views,
                                                       Progress& progress);

/// The depths at which no refined face shows larger than asked, in any of the views. What does not
/// show gets 0.
[[nodiscard]] Result<FaceDepths> depths_for_screen(const ControlMesh& mesh,
                                                   const SubdivisionSettings& settings,
                                                   const ScreenSize& size,
                                                   std::span<const ScreenView> views,
                                                   Progress& progress);

/// The length that a pixel covers at each face, in mesh units: at the part of it that is nearest to
/// any eye that sees it; infinite where it does not show.
[[nodiscard]] Result<std::vector<double>> pixel_lengths(const ControlMesh& mesh, CornerRule corners,
                                                        std::span<const ScreenView> views,
                                                        Progress& progress);

}  // namespace limn
