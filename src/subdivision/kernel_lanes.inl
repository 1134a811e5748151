// The same number of several things, side by side in vector registers, for the kernels. What
// tensor_kernels.inl says about other headers holds here.
#pragma once

#ifdef __SSE__
#include <immintrin.h>
#endif

#include "subdivision/tensor_kernels.h"

namespace limn {
namespace {

/// The same coordinate of some places.
template <std::size_t kCount>
struct LanesOf;
template <>
struct LanesOf<4> {
  using Floats [[gnu::vector_size(16)]] = float;
  using Ints [[gnu::vector_size(16)]] = int;
};
template <>
struct LanesOf<8> {
  using Floats [[gnu::vector_size(32)]] = float;
  using Ints [[gnu::vector_size(32)]] = int;
};
using Four = LanesOf<4>::Floats;
using Eight = LanesOf<8>::Floats;

template <class Lanes>
inline Lanes load(const float* from) {
  Lanes lanes;
  __builtin_memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

template <class Lanes>
inline void store(const Lanes& lanes, float* to) {
  __builtin_memcpy(to, &lanes, sizeof lanes);
}

/// Picks from two vectors four by four, as the instructions do: 0..3 are the first's.
template <int k0, int k1, int k2, int k3>
inline Four shuffled(const Four& a, const Four& b) {
  return __builtin_shufflevector(a, b, k0, k1, k2, k3);
}
template <int k0, int k1, int k2, int k3>
inline Eight shuffled(const Eight& a, const Eight& b) {
  constexpr auto at = [](int k, int half) { return k % 4 + (k < 4 ? 0 : 8) + 4 * half; };
  return __builtin_shufflevector(a, b, at(k0, 0), at(k1, 0), at(k2, 0), at(k3, 0), at(k0, 1),
                                 at(k1, 1), at(k2, 1), at(k3, 1));
}

/// Four points into their coordinates.
inline void transpose(const Four& a, const Four& b, const Four& c, const Four& d, Four& x, Four& y,
                      Four& z) {
  const Four first = shuffled<0, 4, 1, 5>(a, b);
  const Four second = shuffled<0, 4, 1, 5>(c, d);
  x = shuffled<0, 1, 4, 5>(first, second);
  y = shuffled<2, 3, 6, 7>(first, second);
  z = shuffled<0, 1, 4, 5>(shuffled<2, 6, 3, 7>(a, b), shuffled<2, 6, 3, 7>(c, d));
}

/// Fours into eights, and the halves of these.
inline Eight joined(const Four& low, const Four& high) {
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}
inline Four low_half(const Eight& x) {
  return __builtin_shufflevector(x, x, 0, 1, 2, 3);
}
inline Four high_half(const Eight& x) {
  return __builtin_shufflevector(x, x, 4, 5, 6, 7);
}

#ifdef __SSE__
inline Four root(const Four& x) {
  return __builtin_bit_cast(Four, _mm_sqrt_ps(__builtin_bit_cast(__m128, x)));
}
inline Four greater(const Four& a, const Four& b) {
  return __builtin_bit_cast(
      Four, _mm_max_ps(__builtin_bit_cast(__m128, a), __builtin_bit_cast(__m128, b)));
}
inline Four lesser(const Four& a, const Four& b) {
  return __builtin_bit_cast(
      Four, _mm_min_ps(__builtin_bit_cast(__m128, a), __builtin_bit_cast(__m128, b)));
}
#else
inline Four root(const Four& x) {
  return Four{__builtin_sqrtf(x[0]), __builtin_sqrtf(x[1]), __builtin_sqrtf(x[2]),
              __builtin_sqrtf(x[3])};
}
inline Four greater(const Four& a, const Four& b) {
  return a > b ? a : b;
}
inline Four lesser(const Four& a, const Four& b) {
  return a < b ? a : b;
}
#endif

#ifdef __AVX__
inline Eight root(const Eight& x) {
  return __builtin_bit_cast(Eight, _mm256_sqrt_ps(__builtin_bit_cast(__m256, x)));
}
inline Eight greater(const Eight& a, const Eight& b) {
  return __builtin_bit_cast(
      Eight, _mm256_max_ps(__builtin_bit_cast(__m256, a), __builtin_bit_cast(__m256, b)));
}
inline Eight lesser(const Eight& a, const Eight& b) {
  return __builtin_bit_cast(
      Eight, _mm256_min_ps(__builtin_bit_cast(__m256, a), __builtin_bit_cast(__m256, b)));
}
#else
inline Eight root(const Eight& x) {
  return joined(root(low_half(x)), root(high_half(x)));
}
inline Eight greater(const Eight& a, const Eight& b) {
  return joined(greater(low_half(a), low_half(b)), greater(high_half(a), high_half(b)));
}
inline Eight lesser(const Eight& a, const Eight& b) {
  return joined(lesser(low_half(a), low_half(b)), lesser(high_half(a), high_half(b)));
}
#endif

/// Three coordinates of vectors.
template <class Lanes>
struct Vectors {
  Lanes x;
  Lanes y;
  Lanes z;
};

template <class Lanes>
inline Lanes square_of(const Vectors<Lanes>& v) {
  return v.x * v.x + v.y * v.y + v.z * v.z;
}

}  // namespace
}  // namespace limn
