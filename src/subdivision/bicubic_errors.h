#pragma once

#include "limn/subdivision/settings.h"
#include "subdivision/bicubic.h"

// How far the triangles that a regular piece of surface is cut into are from it. Internal to this
// folder.
namespace limn {

/// Of quads of side 1 in a bicubic.
struct BicubicErrors {
  double outwards = 0.0;  ///< The most that triangles are off in the direction of the normal,
  double within = 0.0;    ///< and at right angles to it.
  double turn = 0.0;  ///< The greatest sine of an angle between the middle's normal and another;
                      ///< 1 where it is a right one or more, or somewhere is no normal.
};

/// From the derivatives at nine places, for vertices on the limit surface or where subdivision puts
/// them; quads are cut along their shorter diagonal, which may be either where both are about as
/// long.
[[nodiscard]] BicubicErrors bicubic_errors(const BicubicSamples& samples,
                                           SurfacePoints points) noexcept;

}  // namespace limn
