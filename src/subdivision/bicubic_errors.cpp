// All places at once, in lanes of single precision: derivatives are sampled in double precision and
// brought to a size of about 1 before. No branches, so that compilers turn the loops into vector
// instructions.
#include "subdivision/bicubic_errors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace limn {
namespace {

/// Nine places; the last of them thrice more.
constexpr std::size_t kLanes = 12;
constexpr std::size_t kPlaces = std::tuple_size_v<BicubicSamples>;
constexpr std::size_t kMiddle = 4;

using Lanes = std::array<float, kLanes>;

/// A vector a place.
struct Vectors {
  alignas(16) Lanes x;
  alignas(16) Lanes y;
  alignas(16) Lanes z;

  void set(std::size_t lane, const Point& p, double factor) noexcept {
    x[lane] = static_cast<float>(p[0] * factor);
    y[lane] = static_cast<float>(p[1] * factor);
    z[lane] = static_cast<float>(p[2] * factor);
  }
};

/// Derivatives, brought to a size of about 1.
struct Derivatives {
  Vectors u;
  Vectors v;
  Vectors uu;
  Vectors uv;
  Vectors vv;
};

double sum_of(const Point& p) noexcept {
  return std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]);
}

double sum_of(const BicubicSample& at) noexcept {
  return sum_of(at.u) + sum_of(at.v) + sum_of(at.uu) + sum_of(at.uv) + sum_of(at.vv);
}

/// About how large derivatives are; 0 where all are. Most often two places tell.
double size_of(const BicubicSamples& samples) noexcept {
  double size = sum_of(samples.front()) + sum_of(samples.back());
  for (std::size_t i = 1; size == 0.0 && i + 1 < samples.size(); ++i) {
    size = sum_of(samples[i]);
  }
  return size;
}

void fill(const BicubicSamples& samples, double factor, Derivatives& lanes) noexcept {
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const BicubicSample& at = samples[std::min(lane, kPlaces - 1)];
    lanes.u.set(lane, at.u, factor);
    lanes.v.set(lane, at.v, factor);
    lanes.uu.set(lane, at.uu, factor);
    lanes.uv.set(lane, at.uv, factor);
    lanes.vv.set(lane, at.vv, factor);
  }
}

float select(bool condition, float yes, float no) noexcept {
  return condition ? yes : no;
}

/// The greatest error of the plane through three points of a quadratic, between directions x and y
/// and their sum: eighths of what the quadratic bends along the sides or, where the triangle is
/// acute as the quadratic measures it, half the square of its circumradius.
inline float triangle_error(float along_x, float along_y, float along_sum) noexcept {
  const float a = std::abs(along_x);
  const float c = std::abs(along_y);
  const float s = std::abs(along_sum);
  const float longest = std::max(a, std::max(c, s));
  const float mixed = (along_sum - along_x - along_y) * 0.5F;
  const float determinant = along_x * along_y - mixed * mixed;
  const bool is_acute = (along_x * along_y > 0.0F) & (along_x * along_sum > 0.0F) &
                        (determinant > 0.0F) & (2.0F * longest < a + c + s);
  const float by_radius = a * c * s / (8.0F * select(is_acute, determinant, 1.0F));
  return select(is_acute, by_radius, longest * 0.125F);
}

/// The greatest error of the two triangles that a unit quad is cut into, with second derivatives a,
/// c and the mixed one, b; `up` is the product of its first derivatives, `size` the sum of their
/// squares.
template <SurfacePoints kPoints>
inline float quad_error(float a, float b, float c, float up, float size) noexcept {
  constexpr float kAboutEqual = 0.1F;  // Then either diagonal may be the shorter one.
  const bool is_either = std::abs(up) < kAboutEqual * size;
  const bool takes_up = is_either | (up < 0.0F);
  const bool takes_down = is_either | (up >= 0.0F);
  if constexpr (kPoints == SurfacePoints::kLimit) {
    const float along_up = triangle_error(a, c, a + c + 2.0F * b);
    const float along_down = triangle_error(a, c, a + c - 2.0F * b);
    return std::max(select(takes_up, along_up, 0.0F), select(takes_down, along_down, 0.0F));
  } else {
    // Corners stand off the limit by a sixth of what the surface bends both ways; chords come back
    // from there, or go further where it bends the other way.
    const float corner = (a + c) * (1.0F / 6.0F);
    const float along_up = std::abs(corner - (a + c + 2.0F * b) * 0.125F);
    const float along_down = std::abs(corner - (a + c - 2.0F * b) * 0.125F);
    const float sides = std::max(std::abs(corner - a * 0.125F), std::abs(corner - c * 0.125F));
    return std::max(
        std::max(std::abs(corner), sides),
        std::max(select(takes_up, along_up, 0.0F), select(takes_down, along_down, 0.0F)));
  }
}

/// What is left of a vector's square without its part along the normal.
inline float rest(float square, float along) noexcept {
  return std::sqrt(std::max(0.0F, square - along * along));
}

template <SurfacePoints kPoints>
BicubicErrors errors_of(const Derivatives& d) noexcept {
  Vectors normals;
  Lanes outwards;
  Lanes within;
  Lanes lengths;
  const auto* __restrict ux = d.u.x.data();
  const auto* __restrict uy = d.u.y.data();
  const auto* __restrict uz = d.u.z.data();
  const auto* __restrict vx = d.v.x.data();
  const auto* __restrict vy = d.v.y.data();
  const auto* __restrict vz = d.v.z.data();
  float* __restrict nx = normals.x.data();
  float* __restrict ny = normals.y.data();
  float* __restrict nz = normals.z.data();
  float* __restrict length = lengths.data();
  for (std::size_t i = 0; i < kLanes; ++i) {
    const float x = uy[i] * vz[i] - uz[i] * vy[i];
    const float y = uz[i] * vx[i] - ux[i] * vz[i];
    const float z = ux[i] * vy[i] - uy[i] * vx[i];
    length[i] = std::sqrt(x * x + y * y + z * z);
    const float by = 1.0F / select(length[i] > 0.0F, length[i], 1.0F);
    nx[i] = x * by;
    ny[i] = y * by;
    nz[i] = z * by;
  }
  const auto* __restrict uux = d.uu.x.data();
  const auto* __restrict uuy = d.uu.y.data();
  const auto* __restrict uuz = d.uu.z.data();
  const auto* __restrict uvx = d.uv.x.data();
  const auto* __restrict uvy = d.uv.y.data();
  const auto* __restrict uvz = d.uv.z.data();
  const auto* __restrict vvx = d.vv.x.data();
  const auto* __restrict vvy = d.vv.y.data();
  const auto* __restrict vvz = d.vv.z.data();
  float* __restrict out = outwards.data();
  float* __restrict in = within.data();
  for (std::size_t i = 0; i < kLanes; ++i) {
    const float a = uux[i] * nx[i] + uuy[i] * ny[i] + uuz[i] * nz[i];
    const float b = uvx[i] * nx[i] + uvy[i] * ny[i] + uvz[i] * nz[i];
    const float c = vvx[i] * nx[i] + vvy[i] * ny[i] + vvz[i] * nz[i];
    const float up = ux[i] * vx[i] + uy[i] * vy[i] + uz[i] * vz[i];
    const float size = ux[i] * ux[i] + uy[i] * uy[i] + uz[i] * uz[i] + vx[i] * vx[i] +
                       vy[i] * vy[i] + vz[i] * vz[i];
    out[i] = quad_error<kPoints>(a, b, c, up, size);
    const float along = rest(uux[i] * uux[i] + uuy[i] * uuy[i] + uuz[i] * uuz[i], a);
    const float mixed = rest(uvx[i] * uvx[i] + uvy[i] * uvy[i] + uvz[i] * uvz[i], b);
    const float across = rest(vvx[i] * vvx[i] + vvy[i] * vvy[i] + vvz[i] * vvz[i], c);
    in[i] = (along + across) * (1.0F / 6.0F) + mixed * 0.25F;
  }
  BicubicErrors errors;
  const float mx = nx[kMiddle];
  const float my = ny[kMiddle];
  const float mz = nz[kMiddle];
  float sine = 0.0F;  // Squared; of a small angle it is more exact than the cosine.
  float cosine = 1.0F;
  for (std::size_t i = 0; i < kLanes; ++i) {
    const float x = ny[i] * mz - nz[i] * my;
    const float y = nz[i] * mx - nx[i] * mz;
    const float z = nx[i] * my - ny[i] * mx;
    sine = std::max(sine, x * x + y * y + z * z);
    cosine = std::min(cosine, nx[i] * mx + ny[i] * my + nz[i] * mz);
  }
  errors.turn = cosine > 0.0F ? std::min(1.0, static_cast<double>(std::sqrt(sine))) : 1.0;
  errors.outwards = *std::max_element(outwards.begin(), outwards.end());
  errors.within = *std::max_element(within.begin(), within.end());
  return errors;
}

}  // namespace

BicubicErrors bicubic_errors(const BicubicSamples& samples, SurfacePoints points) noexcept {
  const double size = size_of(samples);
  if (!(size > 0.0)) {
    return {0.0, 0.0, 1.0};
  }
  Derivatives derivatives;
  fill(samples, 1.0 / size, derivatives);
  BicubicErrors errors = points == SurfacePoints::kLimit
                             ? errors_of<SurfacePoints::kLimit>(derivatives)
                             : errors_of<SurfacePoints::kLevel>(derivatives);
  errors.outwards *= size;
  errors.within *= size;
  return errors;
}

}  // namespace limn
