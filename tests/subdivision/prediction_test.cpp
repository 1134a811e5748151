// Counts without a refinement; that they are a refinement's is checked in exactness_test.cpp.
#include "limn/subdivision/prediction.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "limn/subdivision/label_subdivision.h"
#include "support/shapes.h"

namespace limn {
namespace {

TEST(Prediction, OfUnpaintedMeshIsTheMesh) {
  const auto mesh = test::control_mesh(test::prism_soup(5));
  const auto prediction = predict_refinement(*mesh, VertexLabels(10, 0));
  EXPECT_EQ(prediction.faces, 7u);
  EXPECT_EQ(prediction.vertices, 10u);
  EXPECT_EQ(prediction.edges, 15u);
  EXPECT_EQ(prediction.uniform_faces, 7u);
  EXPECT_EQ(prediction.levels, 0);
}

TEST(Prediction, OfEvenPaintIsUniformAndGoesDeep) {
  const auto mesh = test::control_mesh(test::prism_soup(5));
  for (int label = 1; label <= kMaxDepth + 1; ++label) {
    const auto prediction =
        predict_refinement(*mesh, VertexLabels(10, static_cast<std::uint8_t>(label)));
    const auto uniform = static_cast<std::uint64_t>(30 * std::pow(4, label - 1));
    EXPECT_EQ(prediction.faces, uniform);
    EXPECT_EQ(prediction.uniform_faces, uniform);
    EXPECT_EQ(prediction.edges, 2 * uniform);
    EXPECT_EQ(prediction.vertices, uniform + 2);
    EXPECT_EQ(prediction.levels, label);
  }
}

TEST(Prediction, OfOpenMeshCountsItsBoundary) {
  const auto mesh = test::control_mesh(test::grid_soup(3, 2));
  const auto prediction = predict_refinement(*mesh, VertexLabels(12, 4));
  EXPECT_EQ(prediction.vertices, (3 * 16 + 1) * (2 * 16 + 1));
  EXPECT_EQ(prediction.edges, 3 * 16 * 33 + 2 * 16 * 49);
}

TEST(Prediction, StopsAfterSomeLevels) {
  const auto mesh = test::cube();
  const VertexLabels labels(8, 5);
  EXPECT_EQ(predict_refinement(*mesh, labels, 0).faces, 6u);
  EXPECT_EQ(predict_refinement(*mesh, labels, 2).faces, 96u);
  EXPECT_EQ(predict_refinement(*mesh, labels, 2).uniform_faces, 96u);
  EXPECT_EQ(predict_refinement(*mesh, labels, 2).levels, 2);
  EXPECT_EQ(predict_refinement(*mesh, labels, 77).faces, 6u * 1024u);
}

/// Random faces painted to random depths.
std::vector<std::uint8_t> random_depths(const ControlMesh& mesh, test::Random& random) {
  std::vector<std::uint8_t> depths(mesh.face_count(), 0);
  for (std::uint8_t& depth : depths) {
    if (random() % 4 == 0) {
      depth = static_cast<std::uint8_t>(random() % 4);
    }
  }
  return depths;
}

TEST(PaintedCounts, AreThePredictionOnceLabelsAreLegal) {
  test::Random random(21);
  IgnoreProgress progress;
  for (const NonQuadRule rule : {NonQuadRule::kUniformFirstStep, NonQuadRule::kWherePainted}) {
    SubdivisionSettings settings;
    settings.non_quads = rule;
    for (int i = 0; i < 20; ++i) {
      const auto mesh = test::control_mesh(test::with_mixed_faces(test::torus_soup(9, 7), random));
      const VertexLabels legal =
          legal_labels(*mesh, random_depths(*mesh, random), settings, progress).value().labels;
      const PaintedCounts painted = count_painted(*mesh, legal);
      EXPECT_EQ(painted.faces, predict_refinement(*mesh, legal).faces);
      EXPECT_EQ(painted.illegal_quads, 0u);
    }
  }
}

TEST(PaintedCounts, TakeIllegalQuadsForSplitOnes) {
  test::Random random(22);
  const auto mesh = test::control_mesh(test::torus_soup(40, 30));
  for (int i = 0; i < 20; ++i) {
    const VertexLabels labels = vertex_labels(*mesh, random_depths(*mesh, random));
    const PaintedCounts painted = count_painted(*mesh, labels);
    const auto illegal = illegal_faces(*mesh, labels, LegalisationMethod::kLookAhead);
    EXPECT_GT(illegal.size(), 0u);
    EXPECT_EQ(painted.illegal_quads, illegal.size());
    // By themselves, each with a third corner of label 1.
    std::uint64_t faces = 0;
    for (std::size_t f = 0; f < mesh->face_count(); ++f) {
      std::vector<std::uint8_t> corners;
      for (const std::uint32_t v : mesh->face(f)) {
        corners.push_back(labels[v]);
      }
      if (std::ranges::count(illegal, f) > 0) {
        *std::ranges::find(corners, std::uint8_t{0}) = 1;
      }
      const auto quad = test::control_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                           std::vector<std::vector<std::uint32_t>>{{0, 1, 2, 3}});
      faces += predict_refinement(*quad, VertexLabels(corners.begin(), corners.end())).faces;
    }
    EXPECT_EQ(painted.faces, faces);
  }
}

}  // namespace
}  // namespace limn
