// One pass over the edges; see also crack_check.cpp, which shares how edges are found: a counting
// sort by the lower end, then a sort of each short group.
#include "subdivision/invariants.h"

#include <algorithm>
#include <tuple>

#include "subdivision/face_edges.h"

namespace limn {

FaceSides gather_face_sides(const RefinedMesh& mesh) {
  FaceSides all;
  all.offsets.assign(mesh.vertex_count() + 1, 0);
  const auto for_each_side = [&](const auto& visit) {
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      const auto corners = mesh.face(f);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        visit(f, corners[i], corners[i + 1 == corners.size() ? 0 : i + 1]);
      }
    }
  };
  for_each_side(
      [&](std::size_t, std::uint32_t a, std::uint32_t b) { ++all.offsets[std::min(a, b) + 1]; });
  for (std::size_t v = 1; v < all.offsets.size(); ++v) {
    all.offsets[v] += all.offsets[v - 1];
  }
  all.sides.resize(all.offsets.back());
  std::vector<std::uint64_t> places = all.offsets;
  for_each_side([&](std::size_t f, std::uint32_t a, std::uint32_t b) {
    all.sides[places[std::min(a, b)]++] = {std::max(a, b), static_cast<std::uint32_t>(f), a < b};
  });
  const auto order = [](const FaceSide& side) {
    return std::tuple(side.high, side.face, side.is_from_low);
  };
  for (std::size_t v = 0; v + 1 < all.offsets.size(); ++v) {
    const auto begin = all.sides.begin();
    std::sort(begin + static_cast<std::ptrdiff_t>(all.offsets[v]),
              begin + static_cast<std::ptrdiff_t>(all.offsets[v + 1]),
              [&](const FaceSide& a, const FaceSide& b) { return order(a) < order(b); });
  }
  return all;
}

int greatest_level_difference(const RefinedMesh& mesh) {
  int greatest = 0;
  for_each_edge(gather_face_sides(mesh), [&](std::uint32_t, std::span<const FaceSide> sides) {
    for (const FaceSide& side : sides) {
      greatest = std::max(greatest, std::abs(int{mesh.face_levels[side.face]} -
                                             int{mesh.face_levels[sides.front().face]}));
    }
  });
  return greatest;
}

}  // namespace limn
