// Counts without a refinement; that they are a refinement's is checked in exactness_test.cpp.
#include "limn/subdivision/prediction.h"

#include <cmath>

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

}  // namespace
}  // namespace limn
