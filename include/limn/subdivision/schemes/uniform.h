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
  /// Most bytes that the result may have, as `scheme_bytes` (document/scheme_refinement.h) tells.
  std::uint64_t memory_budget = std::numeric_limits<std::uint64_t>::max();
};

inline constexpr int kMostSchemeLevels = 12;

/// What so many levels of a scheme give, known before any work.
struct SchemeCounts {
  std::uint64_t vertices = 0;
  std::uint64_t edges = 0;
  std::uint64_t faces = 0;

  [[nodiscard]] bool operator==(const SchemeCounts&) const = default;
};
/// For 0..levels (up to kMostSchemeLevels), exact. The mesh fits.
[[nodiscard]] std::vector<SchemeCounts> predict_scheme(const ControlMesh& mesh,
                                                       const SchemeSettings& settings, int levels);

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

/// A scheme level by level, for those who look at each of them.
class SchemeLevels {
 public:
  /// At level 0. Keeps what it needs of the mesh. The mesh fits (`check_fits`).
  SchemeLevels(const ControlMesh& mesh, const SchemeSettings& settings);
  ~SchemeLevels();
  SchemeLevels(SchemeLevels&&) noexcept;
  SchemeLevels& operator=(SchemeLevels&&) noexcept;

  [[nodiscard]] int level() const noexcept;
  /// One level on; after an error the level is still the old one. Errors: kOverBudget, kCancelled.
  [[nodiscard]] Result<void> advance(std::uint64_t face_budget, Progress& progress);
  /// The level as `subdivide` gives it.
  [[nodiscard]] RefinedMesh mesh() const;
  [[nodiscard]] SchemeCounts counts() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// What makes a mesh fit for a scheme.
enum class Fitting : std::uint8_t {
  kTriangulate,          ///< `triangulated` (mesh/triangulate.h).
  kOneCatmullClarkStep,  ///< Every face becomes quads; the boundary by the mesh's own rule.
};
/// The one that makes any mesh fit for a scheme that takes such faces. `kinds` is not kAny.
[[nodiscard]] Fitting fitting_for(FaceKinds kinds) noexcept;
/// Texture coordinates and creases are carried along.
[[nodiscard]] std::shared_ptr<const ControlMesh> make_fit(const ControlMesh& mesh, Fitting fitting);

}  // namespace limn
