#pragma once

#include "limn/mesh/creases.h"

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
  kGreedy,     ///< The paper's order: highest valence, then lowest cost, then lowest index.
  kLookAhead,  ///< Fewer relabels and faces: a score that looks one relabel further, then resets.
};

/// Where the vertices of a refined mesh lie.
enum class SurfacePoints {
  kLevel,  ///< At P_k of uniform Catmull-Clark, k being the level they were last moved at.
  kLimit,  ///< On the limit surface.
};

/// How texture coordinates are subdivided, by the names of OpenSubdiv's face-varying options.
enum class TextureRule {
  kLinear,        ///< Bilinear in every face (linear all).
  kSmoothInside,  ///< Smooth, but linear along seams and boundaries (linear boundaries).
};

/// The choices of a label-driven subdivision.
struct SubdivisionSettings {
  NonQuadRule non_quads = NonQuadRule::kUniformFirstStep;
  LegalisationMethod legalisation = LegalisationMethod::kLookAhead;
  CornerRule corners = CornerRule::kSharp;
  SurfacePoints points = SurfacePoints::kLevel;
  TextureRule texture = TextureRule::kSmoothInside;

  [[nodiscard]] bool operator==(const SubdivisionSettings&) const = default;
};

}  // namespace limn
