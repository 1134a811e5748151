#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "limn/subdivision/face_errors.h"
#include "subdivision/bicubic_errors.h"
#include "subdivision/limit_point.h"
#include "subdivision/patch.h"

// How far the quads that a patch is refined to are from its limit. Internal to this folder.
namespace limn {

/// What is asked of a patch.
struct PatchErrorWish {
  SurfacePoints points = SurfacePoints::kLimit;
  double enough = 0.0;      ///< Parts with an error up to this are not looked at more closely,
  int last_level = 0;       ///< nor are those of this level. Rings reach one level further.
  bool is_creased = false;  ///< Creases or corners are about, beside which nine places miss more.
};

/// Raises the errors of faces, patch by patch. Bicubics are looked at some at a time, so errors are
/// complete only after `finish`.
class PatchErrors {
 public:
  explicit PatchErrors(const PatchErrorWish& wish) : wish_(wish) {}

  /// Raises the errors of the levels from `root_level` (that of the patch's root) on to the patch's
  /// own; `errors` stay where they are until `finish`. False where the last level was reached with
  /// more than enough error left.
  bool add(const Patch& patch, int root_level, LevelErrors& errors);
  void finish();

 private:
  class Walk;
  /// Where the errors of a bicubic go, whose quad is one of this level.
  struct Target {
    LevelErrors* errors = nullptr;
    int level = 0;
  };

  void add_bicubic(const StoredPoint* points, std::size_t stride, std::uint8_t curves,
                   const Target& target);
  void visit_batch();

  PatchErrorWish wish_;
  BicubicBatch batch_{};
  std::array<Target, BicubicBatch::kMost> targets_;
  std::size_t count_ = 0;
};

/// Raises the error of level 0 to that of a face with any number of sides that stays as it is.
struct PolygonSamples {
  std::span<const Point> corners;       ///< Where the face's corners stand.
  std::span<const LimitPoint> limits;   ///< Where they tend to,
  std::span<const LimitPoint> middles;  ///< where the middle of the side from each tends to,
  LimitPoint centre;                    ///< and the centre.
};
[[nodiscard]] double polygon_error(const PolygonSamples& samples, SurfacePoints points);

}  // namespace limn
