#include "support/shape_lists.h"

namespace limn::test {

std::vector<PolygonSoup> regular_soups() {
  return {cube_soup(),     grid_soup(1, 1),  grid_soup(2, 9),
          grid_soup(9, 8), torus_soup(3, 3), torus_soup(8, 8)};
}

PolygonSoup random_quad_soup(int i, Random& random) {
  PolygonSoup soup = random_quads(i % 2 == 0 ? torus_soup(4, 4) : grid_soup(5, 3), random);
  if (i % 3 == 0) {
    soup = with_holes(soup, 8, random);
  }
  return soup;
}

PolygonSoup random_mixed_soup(int i, Random& random) {
  PolygonSoup soup = i % 2 == 0 ? torus_soup(6, 5) : grid_soup(6, 6);
  if (i % 4 == 3) {
    soup = random_quads(grid_soup(3, 3), random);
  }
  soup = with_mixed_faces(soup, random);
  if (i % 3 == 0) {
    soup = with_holes(soup, 5, random);
  }
  return soup;
}

}  // namespace limn::test
