#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/painting/auto_depth/screen_view.h"
#include "limn/progress.h"
#include "limn/subdivision/settings.h"

namespace limn {

/// What faces can be told apart by, a number each.
enum class FaceMeasure {
  kCurvature,  ///< By how much the limit surface turns within the face, in degrees (`face_bends`).
  kDihedral,   ///< The greatest angle to a neighbour of the control mesh, in degrees.
  kDistance,   ///< From the unrefined face to the limit surface, in diagonals of the mesh.
  kEdge,       ///< The longest side of the control mesh's face, in diagonals of the mesh.
  kScreen,     ///< The longest side on the screen, in pixels (`screen_sizes`).
};

struct FaceMeasureInfo {
  FaceMeasure measure = FaceMeasure::kCurvature;
  std::string_view word;   ///< In rules: "curvature".
  std::string_view title;  ///< For people: "Curvature".
  std::string_view unit;   ///< Behind numbers, in rules and for people: "deg", "d", "px".
  bool needs_view = false;
  std::string_view meaning;  ///< A sentence.
};

/// All of them, in the order of the enumeration.
[[nodiscard]] std::span<const FaceMeasureInfo> face_measures() noexcept;
[[nodiscard]] const FaceMeasureInfo& info(FaceMeasure measure) noexcept;

/// One number a face. `views` are asked by kScreen alone. Errors: kCancelled.
[[nodiscard]] Result<std::vector<double>> measure_faces(const ControlMesh& mesh,
                                                        const SubdivisionSettings& settings,
                                                        FaceMeasure measure,
                                                        std::span<const ScreenView> views,
                                                        Progress& progress);

}  // namespace limn
