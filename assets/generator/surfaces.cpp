// Both sheets are written row by row; the torus leaves out the faces of a window and the vertices
// that only those faces had.
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "families.h"

namespace limn::generator {
namespace {

using Index = std::uint32_t;

constexpr Index kGridSide = 12;

constexpr Index kTorusAround = 20;  // quads along the ring
constexpr Index kTorusAcross = 10;  // quads around the tube
constexpr Index kWindowAround = 4;  // quads missing along the ring
constexpr Index kWindowAcross = 3;  // and around the tube
constexpr double kTorusRadius = 0.72;
constexpr double kTubeRadius = 0.3;

bool in_window(Index i, Index j) {
  return i >= 3 && i < 3 + kWindowAround && j >= 1 && j < 1 + kWindowAcross;
}

}  // namespace

PolygonSoup wavy_grid() {
  PolygonSoup soup;
  for (Index row = 0; row <= kGridSide; ++row) {
    for (Index column = 0; column <= kGridSide; ++column) {
      const double x = 2.0 * column / kGridSide - 1.0;
      const double z = 2.0 * row / kGridSide - 1.0;
      const double y = 0.16 * std::sin(2.6 * x + 0.7) * std::cos(2.1 * z - 0.4);
      soup.positions.emplace_back(x, y, z);
    }
  }
  for (Index row = 0; row < kGridSide; ++row) {
    for (Index column = 0; column < kGridSide; ++column) {
      const Index near_left = row * (kGridSide + 1) + column;
      const Index far_left = near_left + kGridSide + 1;
      soup.add_face(std::array{near_left, far_left, far_left + 1, near_left + 1});
    }
  }
  return soup;
}

PolygonSoup torus_with_window() {
  constexpr Index kUnused = 0xFFFFFFFFu;
  std::vector<Index> numbers(std::size_t{kTorusAround} * kTorusAcross, kUnused);
  PolygonSoup soup;
  const auto vertex = [&](Index i, Index j) {
    i %= kTorusAround;
    j %= kTorusAcross;
    Index& number = numbers[std::size_t{i} * kTorusAcross + j];
    if (number == kUnused) {
      number = static_cast<Index>(soup.positions.size());
      const double u = 2.0 * std::numbers::pi * i / kTorusAround;
      const double v = 2.0 * std::numbers::pi * j / kTorusAcross;
      const double r = kTorusRadius + kTubeRadius * std::cos(v);
      soup.positions.emplace_back(r * std::cos(u), kTubeRadius * std::sin(v), r * std::sin(u));
    }
    return number;
  };
  for (Index i = 0; i < kTorusAround; ++i) {
    for (Index j = 0; j < kTorusAcross; ++j) {
      if (!in_window(i, j)) {
        // Numbered one by one: the order of evaluation shall not depend on the compiler.
        const Index a = vertex(i, j);
        const Index b = vertex(i, j + 1);
        const Index c = vertex(i + 1, j + 1);
        const Index d = vertex(i + 1, j);
        soup.add_face(std::array{a, b, c, d});
      }
    }
  }
  return soup;
}

}  // namespace limn::generator
