#include "support/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "limn/contract.h"
#include "limn/mesh/build.h"

namespace limn::test {
namespace {

using Polygon = std::vector<std::uint32_t>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

double turn(std::uint32_t i, std::uint32_t n) {
  return 2.0 * std::numbers::pi * i / n;
}

std::uint32_t below(Random& random, std::size_t n) {
  return std::uniform_int_distribution<std::uint32_t>(0, static_cast<std::uint32_t>(n - 1))(random);
}

std::vector<Polygon> polygons_of(const PolygonSoup& soup) {
  std::vector<Polygon> polygons;
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    polygons.emplace_back(soup.face(f).begin(), soup.face(f).end());
  }
  return polygons;
}

PolygonSoup soup_of(std::vector<glm::dvec3> positions, const std::vector<Polygon>& polygons) {
  PolygonSoup soup;
  soup.positions = std::move(positions);
  for (const Polygon& polygon : polygons) {
    soup.add_face(polygon);
  }
  return soup;
}

/// Both polygons around their one common edge (a, b), which the first one runs along from a to b;
/// nothing if they have not exactly one.
std::optional<Polygon> joined(const Polygon& first, const Polygon& second) {
  std::optional<std::size_t> at;
  std::size_t common = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    common += static_cast<std::size_t>(std::ranges::count(second, first[i]));
    for (std::size_t j = 0; j < second.size(); ++j) {
      if (first[i] == second[(j + 1) % second.size()] &&
          first[(i + 1) % first.size()] == second[j]) {
        at = i;
      }
    }
  }
  if (!at || common != 2) {
    return std::nullopt;
  }
  const std::uint32_t a = first[*at];
  Polygon polygon;
  for (std::size_t i = 1; i <= first.size(); ++i) {
    polygon.push_back(first[(*at + i) % first.size()]);  // From b around to a.
  }
  const auto start = static_cast<std::size_t>(std::ranges::find(second, a) - second.begin());
  for (std::size_t j = 1; j + 1 < second.size(); ++j) {
    polygon.push_back(second[(start + j) % second.size()]);
  }
  return polygon;
}

class Triangulation {
 public:
  explicit Triangulation(const std::vector<Polygon>& polygons) {
    for (const Polygon& polygon : polygons) {
      for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        add({polygon[0], polygon[i], polygon[i + 1]});
      }
    }
  }

  [[nodiscard]] const std::vector<std::array<std::uint32_t, 3>>& triangles() const {
    return triangles_;
  }

  void flip_random_edge(Random& random) {
    const std::uint32_t t = below(random, triangles_.size());
    const std::uint32_t side = below(random, 3);
    const auto [a, b, c] = rotated(t, side);
    const auto other = sides_.find({b, a});
    if (other == sides_.end()) {
      return;
    }
    const std::uint32_t u = other->second;
    const std::uint32_t d = opposite(u, b, a);
    if (c == d || sides_.contains({c, d}) || sides_.contains({d, c}) || degree_[a] <= 3 ||
        degree_[b] <= 3) {
      return;
    }
    remove(t);
    remove(u);
    set(t, {a, d, c});
    set(u, {d, b, c});
    --degree_[a];
    --degree_[b];
    ++degree_[c];
    ++degree_[d];
  }

 private:
  void add(const std::array<std::uint32_t, 3>& triangle) {
    triangles_.emplace_back();
    set(static_cast<std::uint32_t>(triangles_.size() - 1), triangle);
    for (const std::uint32_t v : triangle) {
      ++degree_[v];
    }
  }
  void set(std::uint32_t t, const std::array<std::uint32_t, 3>& triangle) {
    triangles_[t] = triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      sides_[{triangle[i], triangle[(i + 1) % 3]}] = t;
    }
  }
  void remove(std::uint32_t t) {
    for (std::size_t i = 0; i < 3; ++i) {
      sides_.erase({triangles_[t][i], triangles_[t][(i + 1) % 3]});
    }
  }
  [[nodiscard]] std::array<std::uint32_t, 3> rotated(std::uint32_t t, std::uint32_t side) const {
    const auto& triangle = triangles_[t];
    return {triangle[side], triangle[(side + 1) % 3], triangle[(side + 2) % 3]};
  }
  [[nodiscard]] std::uint32_t opposite(std::uint32_t t, std::uint32_t a, std::uint32_t b) const {
    for (const std::uint32_t v : triangles_[t]) {
      if (v != a && v != b) {
        return v;
      }
    }
    return kNone;
  }

  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::map<Edge, std::uint32_t> sides_;
  std::map<std::uint32_t, int> degree_;
};

}  // namespace

MeshPointer control_mesh(const PolygonSoup& soup) {
  const Result<ImportedMesh> built = build_control_mesh(soup);
  LIMN_EXPECTS(built.has_value());
  return built->mesh;
}

MeshPointer control_mesh(const std::vector<glm::dvec3>& positions,
                         const std::vector<std::vector<std::uint32_t>>& faces) {
  return control_mesh(soup_of(positions, faces));
}

PolygonSoup cube_soup() {
  return soup_of(
      {{-1, -1, -1},
       {1, -1, -1},
       {1, 1, -1},
       {-1, 1, -1},
       {-1, -1, 1},
       {1, -1, 1},
       {1, 1, 1},
       {-1, 1, 1}},
      {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}});
}

PolygonSoup grid_soup(std::uint32_t columns, std::uint32_t rows) {
  PolygonSoup soup;
  for (std::uint32_t y = 0; y <= rows; ++y) {
    for (std::uint32_t x = 0; x <= columns; ++x) {
      soup.positions.emplace_back(x, y, 0.3 * std::sin(1.3 * x) * std::cos(0.7 * y));
    }
  }
  const auto at = [&](std::uint32_t x, std::uint32_t y) { return y * (columns + 1) + x; };
  for (std::uint32_t y = 0; y < rows; ++y) {
    for (std::uint32_t x = 0; x < columns; ++x) {
      soup.add_face(Polygon{at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  }
  return soup;
}

PolygonSoup torus_soup(std::uint32_t around, std::uint32_t across) {
  PolygonSoup soup;
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      const double radius = 3.0 + std::cos(turn(j, across));
      soup.positions.emplace_back(radius * std::cos(turn(i, around)),
                                  radius * std::sin(turn(i, around)), std::sin(turn(j, across)));
    }
  }
  const auto at = [&](std::uint32_t i, std::uint32_t j) {
    return (i % around) * across + j % across;
  };
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      soup.add_face(Polygon{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return soup;
}

PolygonSoup trapezohedron_soup(std::uint32_t n) {
  PolygonSoup soup;
  for (std::uint32_t i = 0; i < 2 * n; ++i) {
    soup.positions.emplace_back(std::cos(turn(i, 2 * n)), std::sin(turn(i, 2 * n)),
                                i % 2 == 0 ? 0.1 : -0.1);
  }
  const std::uint32_t top = 2 * n;
  const std::uint32_t bottom = top + 1;
  soup.positions.emplace_back(0.0, 0.0, 1.0);
  soup.positions.emplace_back(0.0, 0.0, -1.0);
  for (std::uint32_t i = 0; i < 2 * n; i += 2) {
    const auto ring = [&](std::uint32_t j) { return (i + j) % (2 * n); };
    soup.add_face(Polygon{top, ring(0), ring(1), ring(2)});
    soup.add_face(Polygon{bottom, ring(3), ring(2), ring(1)});
  }
  return soup;
}

PolygonSoup polygon_in_ring_soup(std::uint32_t n) {
  PolygonSoup soup;
  for (const double radius : {1.0, 2.0}) {
    for (std::uint32_t i = 0; i < n; ++i) {
      soup.positions.emplace_back(radius * std::cos(turn(i, n)), radius * std::sin(turn(i, n)),
                                  0.5 * radius);
    }
  }
  Polygon inner(n);
  std::iota(inner.begin(), inner.end(), 0u);
  soup.add_face(inner);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    soup.add_face(Polygon{j, i, n + i, n + j});
  }
  return soup;
}

PolygonSoup prism_soup(std::uint32_t n) {
  PolygonSoup soup = polygon_in_ring_soup(n);
  Polygon outer(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    outer[i] = 2 * n - 1 - i;
  }
  soup.add_face(outer);
  return soup;
}

PolygonSoup with_mixed_faces(const PolygonSoup& soup, Random& random) {
  std::vector<Polygon> polygons;
  for (const Polygon& polygon : polygons_of(soup)) {
    if (polygon.size() == 4 && below(random, 4) == 0) {
      polygons.push_back({polygon[0], polygon[1], polygon[2]});
      polygons.push_back({polygon[2], polygon[3], polygon[0]});
    } else {
      polygons.push_back(polygon);
    }
  }
  // Joined pairs have exactly two common vertices, which both keep two other faces or more.
  std::vector<int> faces_around(soup.positions.size(), 0);
  for (const Polygon& polygon : polygons) {
    for (const std::uint32_t v : polygon) {
      ++faces_around[v];
    }
  }
  const std::size_t tries = polygons.size() / 2;
  for (std::size_t i = 0; i < tries; ++i) {
    const std::uint32_t first = below(random, polygons.size());
    const std::uint32_t second = below(random, std::min<std::size_t>(polygons.size(), 400));
    if (first == second || polygons[first].size() + polygons[second].size() > 9) {
      continue;
    }
    if (const auto polygon = joined(polygons[first], polygons[second])) {
      const std::uint32_t a = polygon->front();
      const std::uint32_t b = (*polygon)[polygons[first].size() - 1];
      if (faces_around[a] > 3 && faces_around[b] > 3) {
        --faces_around[a];
        --faces_around[b];
        polygons[first] = *polygon;
        polygons.erase(polygons.begin() + second);
      }
    }
  }
  return soup_of(soup.positions, polygons);
}

PolygonSoup random_quads(const PolygonSoup& soup, Random& random) {
  Triangulation triangulation(polygons_of(soup));
  for (std::size_t i = 0; i < 4 * triangulation.triangles().size(); ++i) {
    triangulation.flip_random_edge(random);
  }
  std::vector<glm::dvec3> positions = soup.positions;
  std::map<Edge, std::uint32_t> edge_points;
  const auto edge_point = [&](std::uint32_t a, std::uint32_t b) {
    const auto [entry, is_new] =
        edge_points.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(positions.size()));
    if (is_new) {
      positions.push_back(0.5 * (positions[a] + positions[b]));
    }
    return entry->second;
  };
  std::vector<Polygon> polygons;
  for (const auto& [a, b, c] : triangulation.triangles()) {
    const std::uint32_t ab = edge_point(a, b);
    const std::uint32_t bc = edge_point(b, c);
    const std::uint32_t ca = edge_point(c, a);
    const auto centre = static_cast<std::uint32_t>(positions.size());
    positions.push_back((positions[a] + positions[b] + positions[c]) / 3.0);
    polygons.push_back({a, ab, centre, ca});
    polygons.push_back({b, bc, centre, ab});
    polygons.push_back({c, ca, centre, bc});
  }
  return soup_of(std::move(positions), polygons);
}

PolygonSoup with_holes(const PolygonSoup& soup, std::uint32_t count, Random& random) {
  std::vector<Polygon> polygons = polygons_of(soup);
  for (std::uint32_t i = 0; i < count && polygons.size() > 1; ++i) {
    polygons.erase(polygons.begin() + below(random, polygons.size()));
  }
  return soup_of(soup.positions, polygons);
}

PolygonSoup jittered(PolygonSoup soup, double amount, Random& random) {
  std::uniform_real_distribution<double> shift(-amount, amount);
  for (glm::dvec3& position : soup.positions) {
    const double x = shift(random);
    const double y = shift(random);
    const double z = shift(random);
    position += glm::dvec3(x, y, z);
  }
  return soup;
}

MeshPointer cube() {
  return control_mesh(cube_soup());
}

MeshPointer grid(std::uint32_t n) {
  return control_mesh(grid_soup(n, n));
}

MeshPointer mixed_prism() {
  std::vector<glm::dvec3> positions;
  for (const double y : {-1.0, 1.0}) {
    for (int i = 0; i < 5; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / 5.0;
      positions.emplace_back(std::cos(angle), y, -std::sin(angle));
    }
  }
  return control_mesh(positions, {{0, 1, 6, 5},
                                  {5, 6, 7, 8, 9},
                                  {1, 2, 7},
                                  {1, 7, 6},
                                  {2, 3, 8, 7},
                                  {4, 3, 2, 1, 0},
                                  {3, 4, 9, 8},
                                  {4, 0, 5, 9}});
}

std::vector<std::uint8_t> random_depths(const ControlMesh& mesh, double probability, int deepest,
                                        Random& random) {
  std::bernoulli_distribution is_painted(probability);
  std::uniform_int_distribution<int> depth(1, deepest);
  std::vector<std::uint8_t> depths(mesh.face_count(), 0);
  for (std::uint8_t& d : depths) {
    if (is_painted(random)) {
      d = static_cast<std::uint8_t>(depth(random));
    }
  }
  return depths;
}

}  // namespace limn::test
