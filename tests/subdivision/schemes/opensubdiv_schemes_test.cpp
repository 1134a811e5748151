// Linear, Catmull-Clark and Loop against OpenSubdiv: positions and faces, also beside creases,
// corners and boundaries.
#include <memory>
#include <set>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "limn/mesh/import.h"
#include "limn/subdivision/schemes/uniform.h"
#include "scheme_shapes.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/opensubdiv_reference.h"
#include "support/surface_match.h"

namespace limn {
namespace {

using test::MeshPointer;

test::ReferenceScheme reference_scheme(Scheme scheme) {
  switch (scheme) {
    case Scheme::kLinear:
      return test::ReferenceScheme::kBilinear;
    case Scheme::kLoop:
      return test::ReferenceScheme::kLoop;
    default:
      return test::ReferenceScheme::kCatmullClark;
  }
}

/// How far they may lie apart, in diagonals.
constexpr double kTolerance = 1e-6;

std::string difference(const ControlMesh& mesh, Scheme scheme, int level, CornerRule corners,
                       const test::UniformHierarchy& hierarchy) {
  IgnoreProgress progress;
  SchemeSettings settings;
  settings.scheme = scheme;
  settings.corners = corners;
  UniformLimits limits;
  limits.levels = level;
  const Result<RefinedMesh> result = subdivide(mesh, settings, limits, progress);
  if (!result) {
    return result.error().message;
  }
  test::PlainMesh expected;
  expected.positions = hierarchy.positions(mesh.positions())[static_cast<std::size_t>(level)];
  for (std::uint32_t f = 0; f < hierarchy.face_count(level); ++f) {
    expected.faces.push_back(hierarchy.face_vertices(level, f));
  }
  return test::surface_difference(test::plain(*result), expected,
                                  kTolerance * mesh.bounds().diagonal());
}

void expect_same(const test::NamedShape& shape, Scheme scheme, int levels) {
  for (const CornerRule corners : {CornerRule::kSharp, CornerRule::kSmooth}) {
    const test::UniformHierarchy hierarchy(*shape.mesh, levels, corners, TextureRule::kSmoothInside,
                                           reference_scheme(scheme));
    for (int level = 1; level <= levels; ++level) {
      SCOPED_TRACE(fmt::format("{} of {}, level {}", scheme_info(scheme).name, shape.name, level));
      ASSERT_EQ(difference(*shape.mesh, scheme, level, corners, hierarchy), "");
    }
  }
}

/// Two faces that share all their edges.
bool has_pair_back_to_back(const ControlMesh& mesh) {
  const FlatTopology& flat = mesh.topology();
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    std::set<std::uint32_t> beyond;
    for (std::uint32_t c = flat.face_offsets[f]; c < flat.face_offsets[f + 1]; ++c) {
      const std::uint32_t twin = flat.corner_twins[c];
      beyond.insert(twin == kNone ? kNone : flat.corner_faces[twin]);
    }
    if (beyond.size() == 1 && !beyond.contains(kNone)) {
      return true;
    }
  }
  return false;
}

class OpenSubdivSchemes : public testing::TestWithParam<Scheme> {};

TEST_P(OpenSubdivSchemes, AgreeOnShapesOfEveryKind) {
  for (const test::NamedShape& shape : test::shapes_for(GetParam())) {
    expect_same(shape, GetParam(), 3);
  }
}

TEST_P(OpenSubdivSchemes, AgreeBesideCreases) {
  test::Random random(33);
  std::vector<test::NamedShape> shapes = test::creased_shapes();
  for (int i = 0; i < 4; ++i) {
    const MeshPointer torus =
        test::control_mesh(test::jittered(test::torus_soup(7, 5), 0.1, random));
    shapes.push_back({"random creases", test::with_random_creases(*torus, 0.3, 0.05, random)});
    // Tags on boundary edges, which are sharp whatever these say, and count for no other edge.
    const MeshPointer grid = test::with_random_creases(
        *test::control_mesh(test::jittered(test::grid_soup(6, 5), 0.1, random)), 0.4, 0.05, random);
    MeshAttributes attributes = grid->attributes();
    attributes.creases.method = CreasingMethod::kChaikin;
    shapes.push_back({"random creases, open, Chaikin",
                      std::make_shared<const ControlMesh>(grid->with_attributes(attributes))});
  }
  const int levels = test::effort() < 1.0 ? 2 : 4;
  for (test::NamedShape& shape : shapes) {
    shape.mesh = test::fitted(shape.mesh, GetParam());
    expect_same(shape, GetParam(), levels);
  }
}

TEST_P(OpenSubdivSchemes, AgreeOnTheCorpus) {
  if (!test::corpus_folder()) {
    GTEST_SKIP() << "no corpus of meshes: set LIMN_CORPUS or put one at ../shared/corpus";
  }
  test::Random random(34);
  std::size_t compared = 0;
  for (const auto& path : test::corpus_files(".obj")) {
    const Result<ImportedMesh> imported = import_mesh(path);
    if (!imported || !check_fits(*imported->mesh, GetParam())) {
      continue;
    }
    if (has_pair_back_to_back(*imported->mesh)) {
      continue;  // What is made on either side lies in one place.
    }
    const std::size_t corners = imported->mesh->topology().corner_vertices.size();
    if (static_cast<double>(corners) > 12000 * test::effort()) {
      continue;
    }
    expect_same({path.filename().string(), test::set_apart(*imported->mesh, 1e-3, random)},
                GetParam(), static_cast<double>(corners) < 2000 * test::effort() ? 3 : 2);
    ++compared;
  }
  EXPECT_GT(compared, 5u);
}

INSTANTIATE_TEST_SUITE_P(Uniform, OpenSubdivSchemes,
                         testing::Values(Scheme::kLinear, Scheme::kCatmullClark, Scheme::kLoop),
                         [](const auto& with) {
                           std::string name(scheme_info(with.param).name);
                           std::erase(name, '-');
                           return name;
                         });

TEST(LoopCreases, KeepTheSharpnessThatRemains) {
  for (const test::NamedShape& shape : test::creased_shapes()) {
    const MeshPointer mesh = test::fitted(shape.mesh, Scheme::kLoop);
    const test::UniformHierarchy hierarchy(*mesh, 2, CornerRule::kSharp, TextureRule::kSmoothInside,
                                           test::ReferenceScheme::kLoop);
    IgnoreProgress progress;
    const RefinedMesh result =
        subdivide(*mesh, {.scheme = Scheme::kLoop}, {.levels = 2}, progress).value();
    double expected = 0.0;
    std::size_t count = 0;
    std::vector<int> faces(hierarchy.edge_count(2), 0);
    for (std::uint32_t f = 0; f < hierarchy.face_count(2); ++f) {
      for (const std::uint32_t e : hierarchy.face_edges(2, f)) {
        ++faces[e];
      }
    }
    for (std::uint32_t e = 0; e < hierarchy.edge_count(2); ++e) {
      if (faces[e] == 2 && hierarchy.edge_sharpness(2, e) > 0.0f) {
        expected += hierarchy.edge_sharpness(2, e);
        ++count;
      }
    }
    double sum = 0.0;
    for (const RefinedCrease& crease : result.creases) {
      sum += crease.sharpness;
    }
    EXPECT_EQ(result.creases.size(), count) << shape.name;
    EXPECT_NEAR(sum, expected, 1e-4) << shape.name;
  }
}

}  // namespace
}  // namespace limn
