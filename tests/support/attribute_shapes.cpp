#include "support/attribute_shapes.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <memory>
#include <utility>

#include "limn/contract.h"
#include "limn/mesh/build.h"

namespace limn::test {
namespace {

using Tags = std::vector<CreaseTag>;

MeshPointer without_complaint(const PolygonSoup& soup) {
  const Result<ImportedMesh> built = build_control_mesh(soup);
  LIMN_EXPECTS(built.has_value() && !built->report.is_mended());
  return built->mesh;
}

void add_path(Tags& tags, const std::vector<std::uint32_t>& vertices, float sharpness) {
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
    tags.push_back({{vertices[i], vertices[i + 1]}, sharpness});
  }
}

/// Vertex of grid_soup(n, n).
struct GridVertex {
  std::uint32_t n;
  std::uint32_t operator()(std::uint32_t x, std::uint32_t y) const { return y * (n + 1) + x; }
};

void add_creased_cubes(CreasingMethod method, std::vector<NamedShape>& shapes) {
  Tags loop;
  add_path(loop, {0, 1, 2, 3, 0}, 1.0f);
  shapes.push_back({"cube, loop of 1", with_tags(cube_soup(), loop, {}, method)});
  Tags loops;
  add_path(loops, {0, 1, 2, 3, 0}, 2.4f);
  add_path(loops, {4, 5, 6, 7, 4}, kInfiniteSharpness);
  shapes.push_back({"cube, loops of 2.4 and infinity",
                    with_tags(cube_soup(), loops, {{0, 0.5f}, {6, 1.7f}}, method)});
  Tags uneven;
  add_path(uneven, {0, 1}, 0.3f);
  add_path(uneven, {1, 2}, 1.0f);
  add_path(uneven, {2, 3}, 2.2f);
  add_path(uneven, {3, 0}, 3.9f);
  add_path(uneven, {0, 4}, 1.5f);
  shapes.push_back({"cube, uneven loop that meets another",  //
                    with_tags(cube_soup(), uneven, {}, method)});
  shapes.push_back({"cube, corners alone",
                    with_tags(cube_soup(), {}, {{0, 2.8f}, {1, 1.0f}, {6, 12.0f}}, method)});
}

void add_creased_grids(CreasingMethod method, std::vector<NamedShape>& shapes) {
  constexpr std::uint32_t n = 5;
  const GridVertex at{n};
  Tags dart;
  add_path(dart, {at(2, 0), at(2, 1), at(2, 2), at(2, 3)}, 2.5f);
  shapes.push_back({"grid, dart", with_tags(grid_soup(n, n), dart, {}, method)});
  Tags across;
  add_path(across, {at(0, 2), at(1, 2), at(2, 2), at(3, 2), at(4, 2), at(5, 2)}, 3.2f);
  add_path(across, {at(3, 0), at(3, 1), at(3, 2), at(3, 3), at(3, 4), at(3, 5)}, 1.6f);
  shapes.push_back(
      {"grid, creases that cross", with_tags(grid_soup(n, n), across, {{at(1, 4), 1.2f}}, method)});
  Tags fading;
  for (std::uint32_t x = 0; x < n; ++x) {
    add_path(fading, {at(x, 3), at(x + 1, 3)}, 0.4f + 0.8f * static_cast<float>(x));
  }
  shapes.push_back({"grid, fading crease", with_tags(grid_soup(n, n), fading, {}, method)});
  Tags along;
  add_path(along, {at(0, 0), at(1, 0), at(2, 0)}, 1.4f);  // On the boundary: sharp anyway.
  add_path(along, {at(5, 4), at(4, 4), at(4, 5)}, 0.8f);
  shapes.push_back(
      {"grid, boundary creases and corners",
       with_tags(grid_soup(n, n), along,
                 {{at(3, 0), 1.5f}, {at(0, 2), kInfiniteSharpness}, {at(5, 5), 2.0f}}, method)});
  Tags strip;
  add_path(strip, {1, 8}, 2.0f);
  add_path(strip, {3, 10}, 0.6f);
  shapes.push_back({"open strip", with_tags(grid_soup(6, 1), strip, {{5, 1.1f}}, method)});
}

void add_other_creased(CreasingMethod method, std::vector<NamedShape>& shapes) {
  Tags pole;
  add_path(pole, {0, 16, 6}, 2.3f);
  add_path(pole, {1, 17}, 1.3f);
  add_path(pole, {0, 1, 2, 3, 4}, 1.9f);
  shapes.push_back(
      {"poles of valence 8", with_tags(trapezohedron_soup(8), pole, {{17, 0.9f}}, method)});
  Tags prism;
  add_path(prism, {0, 1, 2, 3, 4, 0}, 1.7f);
  add_path(prism, {5, 6, 7}, kInfiniteSharpness);
  add_path(prism, {2, 7}, 0.5f);
  shapes.push_back({"pentagonal prism", with_tags(prism_soup(5), prism, {{9, 2.0f}}, method)});
  Tags torus;
  add_path(torus, {0, 5, 10, 15, 20, 25, 0}, 2.0f);
  add_path(torus, {2, 3, 8, 9}, kInfiniteSharpness);
  shapes.push_back({"torus", with_tags(torus_soup(6, 5), torus, {{13, 3.0f}}, method)});
}

std::vector<glm::dvec2> flat_points(const PolygonSoup& soup, double scale) {
  std::vector<glm::dvec2> points;
  for (const glm::dvec3& p : soup.positions) {
    points.emplace_back(scale * p.x, scale * p.y);
  }
  return points;
}

MeshPointer cross_cube() {
  // Squares of the cross, one per face of cube_soup(), as (column, row) of its lower left corner,
  // and for each corner of the face where in the square it lies.
  //
  //          +---+
  //          |+y |          The belt -x, +z, +x, -z runs along row 1.
  //      +---+---+---+---+
  //      |-x |+z |+x |-z |
  //      +---+---+---+---+
  //          |-y |
  //          +---+
  constexpr std::uint32_t columns = 5;  // Points of the lattice in a row.
  const auto at = [&](std::uint32_t x, std::uint32_t y) { return y * columns + x; };
  std::vector<glm::dvec2> lattice;
  for (std::uint32_t y = 0; y < 4; ++y) {
    for (std::uint32_t x = 0; x < columns; ++x) {
      lattice.emplace_back(0.25 * x, 0.25 * y);
    }
  }
  const std::vector<std::uint32_t> corners = {
      at(0, 1), at(1, 1), at(1, 2), at(0, 2),  // -x: 0 4 7 3
      at(3, 1), at(3, 2), at(2, 2), at(2, 1),  // +x: 1 2 6 5
      at(1, 0), at(2, 0), at(2, 1), at(1, 1),  // -y: 0 1 5 4
      at(1, 3), at(1, 2), at(2, 2), at(2, 3),  // +y: 3 7 6 2
      at(4, 1), at(4, 2), at(3, 2), at(3, 1),  // -z: 0 3 2 1
      at(1, 1), at(2, 1), at(2, 2), at(1, 2),  // +z: 4 5 6 7
  };
  std::vector<std::uint32_t> numbers(lattice.size(), kNone);
  std::vector<glm::dvec2> points;
  std::vector<std::uint32_t> used;
  for (const std::uint32_t corner : corners) {
    if (numbers[corner] == kNone) {
      numbers[corner] = static_cast<std::uint32_t>(points.size());
      points.push_back(lattice[corner]);
    }
    used.push_back(numbers[corner]);
  }
  return with_uvs(cube_soup(), points, used);
}

MeshPointer cut_torus() {
  constexpr std::uint32_t around = 6;
  constexpr std::uint32_t across = 5;
  std::vector<glm::dvec2> points;
  for (std::uint32_t i = 0; i <= around; ++i) {
    for (std::uint32_t j = 0; j <= across; ++j) {
      points.emplace_back(1.0 * i / around, 0.8 * j / across + 0.02 * i);
    }
  }
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return i * (across + 1) + j; };
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      corners.insert(corners.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return with_uvs(torus_soup(around, across), points, corners);
}

MeshPointer chart_per_face(const PolygonSoup& soup) {
  std::vector<glm::dvec2> points;
  std::vector<std::uint32_t> corners;
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    const double shift = static_cast<double>(f);
    for (const std::uint32_t v : soup.face(f)) {
      const glm::dvec3& p = soup.positions[v];
      corners.push_back(static_cast<std::uint32_t>(points.size()));
      points.emplace_back(p.x + 0.3 * p.z + 3.0 * shift, p.y - 0.2 * p.z);
    }
  }
  return with_uvs(soup, points, corners);
}

/// The grid's own plane, but cut along column `cut` between rows `from` and `to`: faces to the
/// right have points of their own there, `shift` away, and all of theirs are mirrored about the
/// cut.
MeshPointer cut_grid(std::uint32_t n, std::uint32_t cut, std::uint32_t from, std::uint32_t to,
                     double shift, bool is_flipped) {
  const PolygonSoup soup = grid_soup(n, n);
  const GridVertex at{n};
  std::vector<glm::dvec2> points = flat_points(soup, 0.2);
  std::map<std::uint32_t, std::uint32_t> copies;
  for (std::uint32_t y = from; y <= to; ++y) {
    copies[at(cut, y)] = static_cast<std::uint32_t>(points.size());
    points.push_back(points[at(cut, y)] + glm::dvec2(shift, 0.0));
  }
  std::vector<std::uint32_t> corners;
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    const bool is_right = f % n >= cut;
    for (const std::uint32_t v : soup.face(f)) {
      const auto copy = copies.find(v);
      corners.push_back(is_right && copy != copies.end() ? copy->second : v);
    }
  }
  if (is_flipped) {
    for (std::uint32_t y = 0; y <= n; ++y) {
      for (std::uint32_t x = cut + 1; x <= n; ++x) {
        points[at(x, y)].x = 0.4 * cut - points[at(x, y)].x;
      }
    }
  }
  return with_uvs(soup, points, corners);
}

/// Quads of one colour of a chequered board in a chart, the others each on their own: charts touch
/// in points.
MeshPointer chequered_grid(std::uint32_t n) {
  const PolygonSoup soup = grid_soup(n, n);
  std::vector<glm::dvec2> points = flat_points(soup, 0.25);
  std::vector<std::uint32_t> corners;
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    for (const std::uint32_t v : soup.face(f)) {
      if ((f / n + f % n) % 2 == 0) {
        corners.push_back(v);
      } else {
        corners.push_back(static_cast<std::uint32_t>(points.size()));
        points.push_back(points[v] + glm::dvec2(2.0, 0.1 * static_cast<double>(f)));
      }
    }
  }
  return with_uvs(soup, points, corners);
}

}  // namespace

MeshPointer with_tags(PolygonSoup soup, std::vector<CreaseTag> creases,
                      std::vector<CornerTag> corners, CreasingMethod method) {
  soup.creases = std::move(creases);
  soup.corners = std::move(corners);
  soup.creasing = method;
  return without_complaint(soup);
}

std::vector<NamedShape> creased_shapes() {
  std::vector<NamedShape> shapes;
  for (const CreasingMethod method : {CreasingMethod::kUniform, CreasingMethod::kChaikin}) {
    const std::size_t first = shapes.size();
    add_creased_cubes(method, shapes);
    add_creased_grids(method, shapes);
    add_other_creased(method, shapes);
    for (std::size_t i = first; i < shapes.size(); ++i) {
      shapes[i].name += method == CreasingMethod::kUniform ? " (uniform)" : " (Chaikin)";
    }
  }
  return shapes;
}

MeshPointer with_random_creases(const ControlMesh& mesh, double edge_probability,
                                double vertex_probability, Random& random) {
  std::uniform_real_distribution<float> sharpness(0.1f, 5.0f);
  const auto drawn = [&](std::size_t count, double probability) {
    std::bernoulli_distribution is_sharp(probability);
    std::bernoulli_distribution is_infinite(0.15);
    std::vector<float> values(count, 0.0f);
    for (float& value : values) {
      if (is_sharp(random)) {
        value = is_infinite(random) ? kInfiniteSharpness : sharpness(random);
      }
    }
    return values;
  };
  MeshAttributes attributes = mesh.attributes();
  attributes.creases.edge_sharpness = drawn(mesh.edge_count(), edge_probability);
  attributes.creases.vertex_sharpness = drawn(mesh.vertex_count(), vertex_probability);
  return std::make_shared<const ControlMesh>(mesh.with_attributes(std::move(attributes)));
}

MeshPointer with_uvs(PolygonSoup soup, std::vector<glm::dvec2> points,
                     std::vector<std::uint32_t> corners) {
  LIMN_EXPECTS(corners.size() == soup.face_vertices.size());
  soup.uvs = std::move(points);
  soup.face_uvs = std::move(corners);
  return without_complaint(soup);
}

std::vector<NamedShape> textured_shapes() {
  std::vector<NamedShape> shapes;
  const PolygonSoup grid = grid_soup(4, 4);
  shapes.push_back(
      {"grid, one chart", with_uvs(grid, flat_points(grid, 0.25), grid.face_vertices)});
  shapes.push_back({"cube, cross", cross_cube()});
  shapes.push_back({"cube, chart per face", chart_per_face(cube_soup())});
  shapes.push_back({"torus, cut open", cut_torus()});
  shapes.push_back({"grid, cut through", cut_grid(4, 2, 0, 4, 0.3, false)});
  shapes.push_back({"grid, flipped half", cut_grid(4, 2, 0, 4, 0.0, true)});
  shapes.push_back({"grid, seam that ends inside", cut_grid(4, 2, 0, 2, 0.05, false)});
  shapes.push_back({"grid, seam inside", cut_grid(5, 2, 1, 3, 0.05, false)});
  shapes.push_back({"grid, same points on both sides", cut_grid(4, 1, 0, 4, 0.0, false)});
  shapes.push_back({"grid, chequered", chequered_grid(4)});
  shapes.push_back({"prism, chart per face", chart_per_face(prism_soup(5))});
  const PolygonSoup ring = polygon_in_ring_soup(5);
  shapes.push_back(
      {"pentagon in a ring", with_uvs(ring, flat_points(ring, 0.2), ring.face_vertices)});
  const PolygonSoup poles = trapezohedron_soup(7);
  shapes.push_back({"poles of valence 7, one point per vertex",
                    with_uvs(poles, flat_points(poles, 0.5), poles.face_vertices)});

  MeshAttributes attributes = shapes[4].mesh->attributes();
  attributes.creases.edge_sharpness.assign(shapes[4].mesh->edge_count(), 0.0f);
  for (std::size_t e = 0; e < attributes.creases.edge_sharpness.size(); e += 3) {
    attributes.creases.edge_sharpness[e] = 0.7f + 0.2f * static_cast<float>(e % 9);
  }
  shapes.push_back(
      {"grid, cut through and creased",
       std::make_shared<const ControlMesh>(shapes[4].mesh->with_attributes(attributes))});
  return shapes;
}

MeshPointer with_random_charts(const ControlMesh& mesh, std::uint32_t charts, Random& random) {
  std::uniform_int_distribution<std::uint32_t> chart(0, charts - 1);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> numbers;  // (chart, vertex) -> point.
  MeshAttributes attributes = mesh.attributes();
  attributes.texture = {};
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const std::uint32_t drawn = chart(random);
    for (const std::uint32_t v : mesh.face(f)) {
      const auto [entry, is_new] = numbers.try_emplace(
          {drawn, v}, static_cast<std::uint32_t>(attributes.texture.values.size()));
      if (is_new) {
        const double x = place(random);
        const double y = place(random);
        attributes.texture.values.emplace_back(x, y);
      }
      attributes.texture.corner_values.push_back(entry->second);
    }
  }
  return std::make_shared<const ControlMesh>(mesh.with_attributes(std::move(attributes)));
}

}  // namespace limn::test
