#include "limn/painting/valence_palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/mesh/bundled.h"
#include "limn/subdivision/label_subdivision.h"
#include "limn/subdivision/legalisation.h"
#include "support/shapes.h"

namespace limn {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::shared_ptr<const ControlMesh> bundled_mesh(std::string_view name) {
  return load_bundled_mesh(name).value().mesh;
}

/// The same by counting edges and the faces beside each.
std::vector<IrregularVertex> by_edges(const ControlMesh& mesh, int inner, int boundary) {
  const FlatTopology& topology = mesh.topology();
  std::vector<int> valences(mesh.vertex_count(), 0);
  std::vector<bool> is_boundary(mesh.vertex_count(), false);
  for (std::size_t e = 0; e < mesh.edge_count(); ++e) {
    for (const std::uint32_t v : topology.edge_vertices[e]) {
      ++valences[v];
      is_boundary[v] = is_boundary[v] || topology.edge_corners[e][1] == kNone;
    }
  }
  std::vector<IrregularVertex> found;
  for (std::uint32_t v = 0; v < valences.size(); ++v) {
    const int off = valences[v] - (is_boundary[v] ? boundary : inner);
    if (off != 0) {
      const int band = off < 0 ? (off == -1 ? 1 : 0) : (off == 1 ? 2 : 3);
      found.push_back({v, static_cast<std::uint8_t>(valences[v]), static_cast<std::uint8_t>(band)});
    }
  }
  return found;
}

TEST(IrregularVertices, MeasureTrianglesBySixAndAllElseByFour) {
  const auto icosahedron = irregular_vertices(*bundled_mesh("icosahedron"));
  ASSERT_EQ(icosahedron.size(), 12U);
  EXPECT_EQ(icosahedron[3], (IrregularVertex{3, 5, 1}));
  EXPECT_THAT(count_valences(irregular_vertices(*bundled_mesh("sphere"))), ElementsAre(6, 0, 0, 0));
  EXPECT_THAT(count_valences(irregular_vertices(*test::cube())), ElementsAre(0, 8, 0, 0));
  EXPECT_THAT(irregular_vertices(*bundled_mesh("mixed")), IsEmpty())
      << "four edges at every vertex";
}

TEST(IrregularVertices, AgreeWithEdgesCountedOneByOne) {
  for (const char* name : {"creature", "teapot", "cube", "grid", "torus_open", "mixed"}) {
    const auto mesh = bundled_mesh(name);
    EXPECT_EQ(irregular_vertices(*mesh), by_edges(*mesh, 4, 3)) << name;
  }
  for (const char* name : {"icosahedron", "sphere", "cube_triangulated"}) {
    const auto mesh = bundled_mesh(name);
    EXPECT_EQ(irregular_vertices(*mesh), by_edges(*mesh, 6, 4)) << name;
  }
}

TEST(IrregularVertices, OfARefinedMeshAreThoseOfTheSameControlMesh) {
  const auto mesh = bundled_mesh("torus_open");
  std::vector<std::uint8_t> depths(mesh->face_count(), 0);
  for (std::size_t f = 0; f < depths.size(); ++f) {
    depths[f] = static_cast<std::uint8_t>(f % 3);
  }
  IgnoreProgress progress;
  const auto labels = legal_labels(*mesh, depths, {}, progress);
  const auto refined = refine(*mesh, labels->labels, {}, {}, progress);
  ASSERT_TRUE(refined);
  const auto found = irregular_vertices(*refined);
  EXPECT_EQ(found, by_edges(*to_control_mesh(*refined), 4, 3));
  EXPECT_FALSE(found.empty());
}

// Lightness by itself would not do: bands of one side differ by it, the sides by their hue. What
// is tested is that no two colours come close for any eye (CIE 1976 L*a*b* distance, Machado,
// Oliveira & Fernandes 2009).
using Triple = std::array<double, 3>;
using Eye = std::array<Triple, 3>;

Triple seen_by(const Eye& m, const Triple& v) {
  Triple result{};
  for (std::size_t row = 0; row < 3; ++row) {
    result[row] = m[row][0] * v[0] + m[row][1] * v[1] + m[row][2] * v[2];
  }
  return result;
}

Triple lab_of(Rgb colour, const Eye& eye) {
  const auto linear = [](std::uint8_t value) {
    const double v = value / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  Triple seen = seen_by(eye, {linear(colour.red), linear(colour.green), linear(colour.blue)});
  for (double& value : seen) {
    value = std::clamp(value, 0.0, 1.0);
  }
  constexpr Eye kXyz{
      {{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}};
  const Triple xyz = seen_by(kXyz, seen);
  const auto f = [](double t) {
    return t > 216.0 / 24389.0 ? std::cbrt(t) : (t * 24389.0 / 27.0 + 16.0) / 116.0;
  };
  const double x = f(xyz[0] / 0.9505);
  const double y = f(xyz[1]);
  const double z = f(xyz[2] / 1.089);
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

TEST(ValencePalette, BandsAreToldApartWithColourVisionDeficiencies) {
  constexpr std::array<Eye, 4> kEyes{{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                                      {{{0.152286, 1.052583, -0.204868},
                                        {0.114503, 0.786281, 0.099216},
                                        {-0.003882, -0.048116, 1.051998}}},
                                      {{{0.367322, 0.860646, -0.227968},
                                        {0.280085, 0.672501, 0.047413},
                                        {-0.011820, 0.042940, 0.968881}}},
                                      {{{1.255528, -0.076749, -0.178779},
                                        {-0.078411, 0.930809, 0.147602},
                                        {0.004733, 0.691367, 0.303900}}}}};
  for (std::size_t eye = 0; eye < kEyes.size(); ++eye) {
    for (std::size_t a = 0; a < kValenceBands; ++a) {
      for (std::size_t b = a + 1; b < kValenceBands; ++b) {
        const Triple p = lab_of(valence_palette()[a], kEyes[eye]);
        const Triple q = lab_of(valence_palette()[b], kEyes[eye]);
        EXPECT_GT(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]), 20.0)
            << "eye " << eye << ", bands " << a << " and " << b;
      }
    }
  }
}

}  // namespace
}  // namespace limn
