// The cube's corners are numbered in binary: bit 0 is x, bit 1 is y, bit 2 is z. The
// rhombicosidodecahedron is the icosahedron blown apart: every triangle moves out along its normal
// until the gap that opens along each edge is a square; five triangles leave a pentagon behind at
// each vertex.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "families.h"

namespace limn::generator {
namespace {

using Index = std::uint32_t;

constexpr std::array<std::array<Index, 4>, 6> kCubeFaces = {{
    {0, 4, 6, 2},  // -x
    {1, 3, 7, 5},  // +x
    {0, 1, 5, 4},  // -y
    {2, 6, 7, 3},  // +y
    {0, 2, 3, 1},  // -z
    {4, 5, 7, 6},  // +z
}};

constexpr std::array<std::array<Index, 3>, 20> kIcosahedronFaces = {{
    {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1},
}};

/// Corners in pairs along x, y and z.
constexpr std::array<std::array<Index, 3>, 8> kOctahedronFaces = {{
    {0, 2, 4},
    {2, 1, 4},
    {1, 3, 4},
    {3, 0, 4},
    {2, 0, 5},
    {1, 2, 5},
    {3, 1, 5},
    {0, 3, 5},
}};

std::vector<glm::dvec3> cube_corners() {
  std::vector<glm::dvec3> corners;
  corners.reserve(8);
  for (int i = 0; i < 8; ++i) {
    corners.emplace_back((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0,
                         (i & 4) != 0 ? 1.0 : -1.0);
  }
  return corners;
}

std::vector<glm::dvec3> icosahedron_corners() {
  const double g = std::numbers::phi;
  std::vector<glm::dvec3> corners = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                     {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                     {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
  for (glm::dvec3& corner : corners) {
    corner = glm::normalize(corner);
  }
  return corners;
}

/// Which side of triangle f starts at vertex v; 3 where none does.
Index side_at(std::size_t f, Index v) {
  Index side = 0;
  while (side < 3 && kIcosahedronFaces[f][side] != v) {
    ++side;
  }
  return side;
}

/// The triangle that has the side from `from` to `to`.
std::size_t triangle_with_side(Index from, Index to) {
  for (std::size_t f = 0; f < kIcosahedronFaces.size(); ++f) {
    const Index side = side_at(f, from);
    if (side < 3 && kIcosahedronFaces[f][(side + 1) % 3] == to) {
      return f;
    }
  }
  return kIcosahedronFaces.size();
}

}  // namespace

PolygonSoup cube() {
  PolygonSoup soup;
  soup.positions = cube_corners();
  for (const auto& face : kCubeFaces) {
    soup.add_face(face);
  }
  return soup;
}

PolygonSoup cube_triangulated() {
  PolygonSoup soup;
  soup.positions = cube_corners();
  for (std::size_t f = 0; f < kCubeFaces.size(); ++f) {
    const auto& face = kCubeFaces[f];
    // From their first corners all squares would be cut around one space diagonal. With one of them
    // cut the other way, two of the cube's 48 symmetries are left.
    const std::size_t i = f == 0 ? 1 : 0;
    soup.add_face(std::array{face[i], face[i + 1], face[i + 2]});
    soup.add_face(std::array{face[i], face[i + 2], face[(i + 3) % 4]});
  }
  return soup;
}

PolygonSoup icosahedron() {
  PolygonSoup soup;
  soup.positions = icosahedron_corners();
  for (const auto& face : kIcosahedronFaces) {
    soup.add_face(face);
  }
  return soup;
}

PolygonSoup sphere() {
  PolygonSoup soup;
  soup.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::array<std::array<Index, 6>, 6> middles{};  // 0: not there yet.
  const auto middle = [&](Index a, Index b) {
    Index& known = middles[std::min(a, b)][std::max(a, b)];
    if (known == 0) {
      known = static_cast<Index>(soup.positions.size());
      soup.positions.push_back(glm::normalize(soup.positions[a] + soup.positions[b]));
    }
    return known;
  };
  for (const auto& [a, b, c] : kOctahedronFaces) {
    const Index ab = middle(a, b);
    const Index bc = middle(b, c);
    const Index ca = middle(c, a);
    soup.add_face(std::array{a, ab, ca});
    soup.add_face(std::array{b, bc, ab});
    soup.add_face(std::array{c, ca, bc});
    soup.add_face(std::array{ab, bc, ca});
  }
  return soup;
}

PolygonSoup rhombicosidodecahedron() {
  const std::vector<glm::dvec3> corners = icosahedron_corners();
  std::array<glm::dvec3, 20> normals;
  for (std::size_t f = 0; f < normals.size(); ++f) {
    const auto& face = kIcosahedronFaces[f];
    normals[f] = glm::normalize(corners[face[0]] + corners[face[1]] + corners[face[2]]);
  }
  const double edge = glm::distance(corners[0], corners[11]);
  const double gap = glm::distance(normals[0], normals[1]);

  // Corner i of triangle f becomes vertex 3 f + i.
  const auto vertex_at = [](std::size_t f, Index v) {
    return static_cast<Index>(3 * f) + side_at(f, v);
  };
  PolygonSoup soup;
  for (std::size_t f = 0; f < normals.size(); ++f) {
    for (const Index v : kIcosahedronFaces[f]) {
      soup.positions.push_back(glm::normalize(corners[v] + normals[f] * (edge / gap)));
    }
  }
  for (std::size_t f = 0; f < normals.size(); ++f) {
    const auto first = static_cast<Index>(3 * f);
    soup.add_face(std::array{first, first + 1, first + 2});
  }
  for (std::size_t f = 0; f < normals.size(); ++f) {
    for (std::size_t side = 0; side < 3; ++side) {
      const Index a = kIcosahedronFaces[f][side];
      const Index b = kIcosahedronFaces[f][(side + 1) % 3];
      if (a < b) {
        const std::size_t across = triangle_with_side(b, a);
        soup.add_face(std::array{vertex_at(f, b), vertex_at(f, a), vertex_at(across, a),
                                 vertex_at(across, b)});
      }
    }
  }
  for (Index v = 0; v < corners.size(); ++v) {
    // Around v counter-clockwise: each triangle's last side leads into the next triangle.
    std::size_t f = 0;
    while (side_at(f, v) == 3) {
      ++f;
    }
    std::vector<Index> pentagon;
    while (pentagon.size() < 5) {
      pentagon.push_back(vertex_at(f, v));
      const Index last = kIcosahedronFaces[f][(side_at(f, v) + 2) % 3];
      f = triangle_with_side(v, last);
    }
    soup.add_face(pentagon);
  }
  return soup;
}

}  // namespace limn::generator
