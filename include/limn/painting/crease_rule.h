#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/mesh/creases.h"

namespace limn {

/// Every edge between two faces.
struct SelectAllEdges {
  [[nodiscard]] bool operator==(const SelectAllEdges&) const = default;
};
/// Edges whose dihedral angle (between the normals of its two faces, 0 where flat) is greater than
/// `degrees`, 0..180, by more than kDihedralTolerance. Boundary edges have none.
struct SelectEdgesOverAngle {
  double degrees = 30.0;
  [[nodiscard]] bool operator==(const SelectEdgesOverAngle&) const = default;
};
/// Edges between two faces that are sharp already.
struct SelectCreases {
  [[nodiscard]] bool operator==(const SelectCreases&) const = default;
};

/// Which edges a crease rule changes.
using EdgeSelection = std::variant<SelectAllEdges, SelectEdgesOverAngle, SelectCreases>;

/// Adds to the sharpness of selected edges, or sets it. What comes out is held within 0 and
/// kInfiniteSharpness.
struct SharpenEdges {
  enum class Kind { kAdd, kSet };
  EdgeSelection selection;
  Kind kind = Kind::kSet;
  float amount = 0.0f;  ///< -kInfiniteSharpness..kInfiniteSharpness; from 0 on where it is set.

  [[nodiscard]] bool operator==(const SharpenEdges&) const = default;
};
/// Makes every edge and every vertex smooth.
struct ClearCreases {
  [[nodiscard]] bool operator==(const ClearCreases&) const = default;
};

/// A change of creases.
using CreaseRule = std::variant<SharpenEdges, ClearCreases>;

/// Reads `angle>30:=2`, `all:+0.5`, `creased:-1`, `angle>80:=inf` and `clear`. Blanks around the
/// parts are allowed.
/// Errors: kUsage, naming the part that was not understood and what may stand there.
[[nodiscard]] Result<CreaseRule> parse_crease_rule(std::string_view text);

/// The rule as `parse_crease_rule` reads it.
[[nodiscard]] std::string to_string(const CreaseRule& rule);

/// The mesh's creases after the rule. Corners stay, unless everything is cleared; boundary edges
/// are never touched.
[[nodiscard]] Creases apply_crease_rule(const ControlMesh& mesh, const CreaseRule& rule);

}  // namespace limn
