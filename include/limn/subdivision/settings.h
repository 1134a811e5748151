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

/// What subdivides the painted faces.
enum class RefinementScheme {
  kCatmullClark,  ///< Label-driven, any mesh (subdivision/label_subdivision.h).
  kLoop,          ///< Triangle meshes (subdivision/schemes/adaptive_loop.h).
};

/// How much of itself old vertices keep under Loop's scheme: with n neighbours, 1 - n beta.
enum class LoopWeights {
  kOriginal,  ///< beta = (1/n) (5/8 - (3/8 + cos(2 pi / n) / 4)^2) (Loop 1987).
  kWarren,    ///< beta = 3 / (8 n), and 3/16 for n = 3 (Warren 1995).
};

/// The choices of an adaptive subdivision. Those of rules for non-quads, legalisation, positions
/// and texture are Catmull-Clark's, the weights are Loop's.
struct SubdivisionSettings {
  RefinementScheme scheme = RefinementScheme::kCatmullClark;
  LoopWeights weights = LoopWeights::kOriginal;
  NonQuadRule non_quads = NonQuadRule::kUniformFirstStep;
  LegalisationMethod legalisation = LegalisationMethod::kLookAhead;
  CornerRule corners = CornerRule::kSharp;
  SurfacePoints points = SurfacePoints::kLevel;
  TextureRule texture = TextureRule::kSmoothInside;

  [[nodiscard]] bool operator==(const SubdivisionSettings&) const = default;
};

}  // namespace limn
