#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/painting/auto_depth/face_measure.h"
#include "limn/painting/face_depths.h"
#include "limn/painting/paint_context.h"

namespace limn {

/// Every face.
struct SelectAll {
  [[nodiscard]] bool operator==(const SelectAll&) const = default;
};
/// Faces of which at least one pixel shows in the camera in force.
struct SelectVisible {
  [[nodiscard]] bool operator==(const SelectVisible&) const = default;
};
/// Angles, in degrees, that differ by less than this count as equal: what rounding leaves of the
/// coordinates must not decide whether "over 90 degrees" takes the faces of a cube.
inline constexpr double kDihedralTolerance = 1e-6;

/// Faces with an edge whose dihedral angle (between the normals of its two faces, 0 where flat) is
/// greater than `degrees`, 0..180, by more than kDihedralTolerance. Boundary edges have none.
struct SelectDihedral {
  double degrees = 30.0;
  [[nodiscard]] bool operator==(const SelectDihedral&) const = default;
};
/// The faces in `ranges`, both ends included.
struct SelectFaces {
  struct Range {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    [[nodiscard]] bool operator==(const Range&) const = default;
  };
  std::vector<Range> ranges;
  [[nodiscard]] bool operator==(const SelectFaces&) const = default;
};

/// The faces of the depth that `seed` has when the rule's turn comes, as far as they hang together
/// with it (`flood_region`).
struct SelectFlood {
  std::uint32_t seed = 0;

  [[nodiscard]] bool operator==(const SelectFlood&) const = default;
};

/// The faces that can be reached from `seed` over dihedral angles that add up to at most `degrees`,
/// 0..kMostFillAngle (`smart_region`).
struct SelectSmart {
  std::uint32_t seed = 0;
  double degrees = 40.0;

  [[nodiscard]] bool operator==(const SelectSmart&) const = default;
};

/// The connected component of `seed`.
struct SelectConnected {
  std::uint32_t seed = 0;

  [[nodiscard]] bool operator==(const SelectConnected&) const = default;
};

/// Faces for which a measure is greater than a value, or less. For dihedral angles
/// `SelectDihedral`.
struct SelectMeasured {
  FaceMeasure measure = FaceMeasure::kCurvature;
  bool is_above = true;
  double value = 0.0;  ///< In the measure's unit.

  [[nodiscard]] bool operator==(const SelectMeasured&) const = default;
};

/// Faces whose depth is not 0 when the rule's turn comes, or those where it is.
struct SelectPainted {
  bool is_painted = true;

  [[nodiscard]] bool operator==(const SelectPainted&) const = default;
};

/// Which faces a paint rule changes.
using Selection = std::variant<SelectAll, SelectVisible, SelectDihedral, SelectFaces, SelectFlood,
                               SelectSmart, SelectConnected, SelectMeasured, SelectPainted>;

/// The dihedral angle of every edge, in degrees; 0 for boundary edges. Face normals are Newell's,
/// so non-planar polygons have one too; a face without area has none, and no angle with its
/// neighbours.
[[nodiscard]] std::vector<double> edge_dihedral_angles(const ControlMesh& mesh);

/// The largest dihedral angle over each face's edges, in degrees, one entry per face; 0 for a face
/// with boundary edges only.
[[nodiscard]] std::vector<double> face_dihedral_angles(const ControlMesh& mesh);

/// The selected faces, ascending, of a painting with one depth per face. Errors: kUsage where a
/// face number is out of range or the context lacks what is asked for, and whatever it returns;
/// kCancelled.
[[nodiscard]] Result<std::vector<std::uint32_t>> select_faces(const ControlMesh& mesh,
                                                              const FaceDepths& depths,
                                                              const Selection& selection,
                                                              const PaintContext& context);

}  // namespace limn
