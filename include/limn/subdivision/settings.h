#pragma once

namespace limn {

/// The greatest depth a face can be painted with: 4^10 quads from one.
inline constexpr int kMaxDepth = 10;

/// What to do with faces that are not quads (Yong & Cheng 2005; algorithm described in
/// subdivision/labels.h).
enum class NonQuadRule {
  kUniformFirstStep,  ///< Every label + 1: the first step is uniform and leaves only quads.
  kWherePainted,      ///< A non-quad face with a positive label is split as a whole, others stay.
};

/// How illegal vertices are removed.
enum class LegalisationMethod {
  kGreedy,  ///< The paper's order: highest valence, then lowest cost, then lowest index.
};

/// What happens to a boundary vertex that belongs to one face only.
enum class CornerRule {
  kSharp,   ///< It stays where it is (OpenSubdiv's edge-and-corner).
  kSmooth,  ///< It follows the boundary's cubic B-spline like any other (edge-only).
};

/// The choices of a label-driven subdivision.
struct SubdivisionSettings {
  NonQuadRule non_quads = NonQuadRule::kUniformFirstStep;
  LegalisationMethod legalisation = LegalisationMethod::kGreedy;
  CornerRule corners = CornerRule::kSharp;

  [[nodiscard]] bool operator==(const SubdivisionSettings&) const = default;
};

}  // namespace limn
