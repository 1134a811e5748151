#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/mesh/refined_mesh.h"
#include "limn/progress.h"
#include "limn/subdivision/schemes/scheme.h"

namespace limn {

/// How far to go. Every level is made of the one before.
struct UniformLimits {
  int levels = 1;  ///< 0..kMostSchemeLevels.
  std::uint64_t face_budget = std::numeric_limits<std::uint64_t>::max();
};

inline constexpr int kMostSchemeLevels = 12;

/// What so many levels of a scheme give, known before any work.
struct SchemeCounts {
  std::uint64_t vertices = 0;
  std::uint64_t edges = 0;
  std::uint64_t faces = 0;

  [[nodiscard]] bool operator==(const SchemeCounts&) const = default;
};
/// For 0..levels, exact; a count that no 64 bits hold is the greatest they do. The mesh fits.
[[nodiscard]] std::vector<SchemeCounts> predict_scheme(const ControlMesh& mesh, Scheme scheme,
                                                       int levels);

/// Subdivides all of a mesh.
///
/// Takes what `check_fits` allows. Creases and corners hold for as many levels as they are sharp in
/// the schemes that have a rule for them (linear, Catmull-Clark, Loop); the others treat their
/// infinitely sharp edges like boundaries where their entry in `schemes()` says so. Face-split
/// schemes keep vertices 0..V-1 in their order; vertex-split schemes have other vertices. Every
/// face of the result names the control face it lies in, faces between several the first of them.
/// Computes in double precision from level to level; the same input gives the same bytes for any
/// number of threads. Texture coordinates are carried by Catmull-Clark alone.
/// Errors: kFailed (`check_fits`), kOverBudget (before any work), kCancelled.
[[nodiscard]] Result<RefinedMesh> subdivide(const ControlMesh& mesh, const SchemeSettings& settings,
                                            const UniformLimits& limits, Progress& progress);

/// What makes a mesh fit for a scheme.
enum class Fitting : std::uint8_t {
  kTriangulate,         ///< Every face becomes triangles, by its shortest diagonals; creases stay.
  kOneCatmullClarkStep  ///< Every face becomes quads.
};
/// The one that makes any mesh fit for a scheme that takes such faces. `kinds` is not kAny.
[[nodiscard]] Fitting fitting_for(FaceKinds kinds) noexcept;
/// Texture coordinates and creases are carried along. Faces that are triangles already stay, and
/// faces of a polygon follow each other in its place.
[[nodiscard]] std::shared_ptr<const ControlMesh> make_fit(const ControlMesh& mesh, Fitting fitting);

}  // namespace limn
