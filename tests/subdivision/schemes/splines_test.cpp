// On regular grids schemes are tensor products of curve subdivisions, and along boundaries they are
// these curves: told here once more as plain masks on rows of points.
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "limn/subdivision/schemes/uniform.h"
#include "scheme_shapes.h"
#include "subdivision/schemes/quad_split.h"
#include "support/surface_match.h"

namespace limn {
namespace {

using test::MeshPointer;
using test::subdivided;
using Row = std::vector<glm::dvec3>;

/// A closed row of points after a step: point k takes mask[k - factor i + centre] of point i.
Row stepped(const Row& row, const std::vector<double>& mask, int factor) {
  const auto n = static_cast<int>(row.size());
  const auto length = static_cast<int>(mask.size());
  Row result(row.size() * static_cast<std::size_t>(factor), glm::dvec3(0.0));
  for (int i = 0; i < n; ++i) {
    for (int m = 0; m < length; ++m) {
      const int k = ((factor * i + m - length / 2) % (factor * n) + factor * n) % (factor * n);
      result[static_cast<std::size_t>(k)] +=
          mask[static_cast<std::size_t>(m)] * row[static_cast<std::size_t>(i)];
    }
  }
  return result;
}

using Net = std::vector<Row>;

Net transposed(const Net& net) {
  Net result(net[0].size(), Row(net.size()));
  for (std::size_t i = 0; i < net.size(); ++i) {
    for (std::size_t j = 0; j < net[0].size(); ++j) {
      result[j][i] = net[i][j];
    }
  }
  return result;
}

Net stepped(Net net, const std::vector<double>& mask) {
  for (int direction = 0; direction < 2; ++direction) {
    for (Row& row : net) {
      row = stepped(row, mask, 2);
    }
    net = transposed(net);
  }
  return net;
}

Row points_of(const Net& net) {
  Row points;
  for (const Row& row : net) {
    points.insert(points.end(), row.begin(), row.end());
  }
  return points;
}

const std::vector<double> kQuadratic{0.25, 0.75, 0.75, 0.25};
const std::vector<double> kCubic{0.125, 0.5, 0.75, 0.5, 0.125};
const std::vector<double> kQuartic{1 / 16.0, 5 / 16.0, 10 / 16.0, 10 / 16.0, 5 / 16.0, 1 / 16.0};
const std::vector<double> kFourPoint{-1 / 16.0, 0, 9 / 16.0, 1, 9 / 16.0, 0, -1 / 16.0};
const std::vector<double> kCubicByThree{1 / 27.0,  4 / 27.0,  10 / 27.0, 16 / 27.0, 19 / 27.0,
                                        16 / 27.0, 10 / 27.0, 4 / 27.0,  1 / 27.0};

/// A closed grid of points anywhere, and the torus of quads over it.
struct ClosedNet {
  Net net;
  MeshPointer mesh;
};

ClosedNet closed_net(std::uint32_t rows, std::uint32_t columns, unsigned seed) {
  test::Random random(seed);
  std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
  ClosedNet closed;
  std::vector<glm::dvec3> positions;
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::uint32_t i = 0; i < rows; ++i) {
    closed.net.emplace_back();
    for (std::uint32_t j = 0; j < columns; ++j) {
      positions.emplace_back(anywhere(random), anywhere(random), anywhere(random));
      closed.net.back().push_back(positions.back());
      const auto at = [&](std::uint32_t a, std::uint32_t b) {
        return (a % rows) * columns + b % columns;
      };
      faces.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
    }
  }
  closed.mesh = test::control_mesh(positions, faces);
  return closed;
}

Row points_of(const RefinedMesh& mesh) {
  return test::plain(mesh).positions;
}

struct TensorCase {
  SchemeSettings settings;
  const std::vector<double>* mask;
};

TEST(TensorProducts, AreTheSchemesOnRegularGrids) {
  const std::vector<TensorCase> cases{
      {{.scheme = Scheme::kLinear, .averages = true}, &kCubic},
      {{.scheme = Scheme::kCatmullClark}, &kCubic},
      {{.scheme = Scheme::kKobbelt}, &kFourPoint},
      {{.scheme = Scheme::kDooSabin}, &kQuadratic},
      {{.scheme = Scheme::kBiquartic}, &kQuartic},
  };
  for (const TensorCase& c : cases) {
    ClosedNet closed = closed_net(5, 7, 41);
    for (int level = 1; level <= 3; ++level) {
      closed.net = stepped(closed.net, *c.mask);
      EXPECT_EQ(test::matching_vertices(points_of(subdivided(*closed.mesh, c.settings, level)),
                                        points_of(closed.net), 2e-6)
                    .size(),
                closed.net.size() * closed.net[0].size())
          << scheme_info(c.settings.scheme).name << ", level " << level;
    }
  }
}

// Two steps of midedge are one of the quadratic box spline in four directions (Zwart & Powell): in
// each corner of a quad half of the corner and a quarter of its neighbours there.
TEST(Midedge, IsTheFourDirectionBoxSplineOnRegularGrids) {
  const ClosedNet closed = closed_net(5, 6, 42);
  Row expected;
  for (std::size_t f = 0; f < closed.mesh->face_count(); ++f) {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto corner = [&](std::size_t j) {
        return closed.mesh->positions()[closed.mesh->face(f)[j % 4]];
      };
      expected.push_back(0.5 * corner(i) + 0.25 * (corner(i + 1) + corner(i + 3)));
    }
  }
  const Row actual = points_of(subdivided(*closed.mesh, {.scheme = Scheme::kMidedge}, 2));
  EXPECT_EQ(test::matching_vertices(actual, expected, 2e-6).size(), expected.size());
}

/// The boundary of a ring of quads, outer loop first in order; cut into triangles if need be.
struct Ring {
  MeshPointer mesh;
  std::vector<Row> loops;
};

Ring ring_for(Scheme scheme) {
  constexpr std::uint32_t kAround = 7;
  test::Random random(43);
  std::uniform_real_distribution<double> off(-0.2, 0.2);
  PolygonSoup soup;
  Ring ring;
  for (std::uint32_t loop = 0; loop < 4; ++loop) {
    Row row;
    for (std::uint32_t i = 0; i < kAround; ++i) {
      const double angle = 2.0 * 3.14159265358979 * i / kAround;
      const double radius = 4.0 - loop;
      soup.positions.emplace_back(radius * std::cos(angle) + off(random),
                                  radius * std::sin(angle) + off(random), off(random));
      row.push_back(soup.positions.back());
    }
    if (loop == 0 || loop == 3) {
      ring.loops.push_back(row);
    }
  }
  for (std::uint32_t loop = 0; loop < 3; ++loop) {
    for (std::uint32_t i = 0; i < kAround; ++i) {
      const std::uint32_t j = (i + 1) % kAround;
      const std::uint32_t at = loop * kAround;
      soup.add_face(std::array{at + i, at + j, at + kAround + j, at + kAround + i});
    }
  }
  ring.mesh = test::fitted(test::control_mesh(soup), scheme);
  return ring;
}

struct CurveCase {
  SchemeSettings settings;
  const std::vector<double>* mask;
  int factor = 2;
  int levels = 1;  ///< That make one step of the curve.
};

TEST(Boundaries, AreTheCurvesOfTheirSchemes) {
  const std::vector<CurveCase> cases{
      {{.scheme = Scheme::kLinear, .averages = true}, &kCubic},
      {{.scheme = Scheme::kCatmullClark}, &kCubic},
      {{.scheme = Scheme::kLoop}, &kCubic},
      {{.scheme = Scheme::kButterfly}, &kFourPoint},
      {{.scheme = Scheme::kKobbelt}, &kFourPoint},
      {{.scheme = Scheme::kSqrt3}, &kCubicByThree, 3, 2},
      {{.scheme = Scheme::kDooSabin}, &kQuadratic},
      {{.scheme = Scheme::kMidedge}, &kQuadratic, 2, 2},
      {{.scheme = Scheme::kBiquartic}, &kQuartic},
  };
  for (const CurveCase& c : cases) {
    Ring ring = ring_for(c.settings.scheme);
    for (int step = 1; step <= 2; ++step) {
      Row expected;
      for (Row& loop : ring.loops) {
        loop = stepped(loop, *c.mask, c.factor);
        expected.insert(expected.end(), loop.begin(), loop.end());
      }
      const Row actual =
          test::boundary_positions(subdivided(*ring.mesh, c.settings, step * c.levels));
      EXPECT_EQ(test::matching_vertices(actual, expected, 3e-6).size(), expected.size())
          << scheme_info(c.settings.scheme).name << ", step " << step;
    }
  }
}

// The point that stands in for a missing one beside an irregular vertex is chosen such that the
// four-point rule gives the middle of a face from both pairs of its sides (Kobbelt 1996).
TEST(Kobbelt, FindsTheMiddleOfAFaceFromBothSides) {
  for (const test::NamedShape& shape : test::closed_shapes_for(Scheme::kKobbelt)) {
    // After two steps no face has to do with more than one irregular vertex.
    const MeshPointer mesh =
        to_control_mesh(subdivided(*shape.mesh, {.scheme = Scheme::kCatmullClark}, 2));
    const RefinedMesh result = subdivided(*mesh, {.scheme = Scheme::kKobbelt}, 1);
    const FlatTopology& flat = mesh->topology();
    const auto edge_point = [&](std::uint32_t corner) {
      return result.position(mesh->vertex_count() + flat.corner_edges[corner]);
    };
    const auto opposite = [](std::uint32_t corner) { return corner ^ 2u; };
    double farthest = 0.0;
    std::size_t tried = 0;
    for (std::uint32_t f = 0; f < mesh->face_count(); ++f) {
      if (std::ranges::none_of(mesh->face(f), [&flat](std::uint32_t v) {
            return std::ranges::binary_search(flat.irregular_vertices, v);
          })) {
        continue;
      }
      ++tried;
      for (const std::uint32_t side : {4 * f, 4 * f + 1}) {
        const auto beyond = [&](std::uint32_t corner) {
          return edge_point(opposite(flat.corner_twins[corner]));
        };
        const glm::dvec3 middle = (9.0 * (edge_point(side) + edge_point(opposite(side))) -
                                   (beyond(side) + beyond(opposite(side)))) /
                                  16.0;
        farthest = std::max(
            farthest,
            glm::distance(middle, result.position(mesh->vertex_count() + mesh->edge_count() + f)));
      }
    }
    EXPECT_LT(farthest, 2e-6 * mesh->bounds().diagonal()) << shape.name;
    EXPECT_EQ(tried > 0, !mesh->topology().irregular_vertices.empty());
  }
}

}  // namespace
}  // namespace limn
