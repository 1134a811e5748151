#include "render/surface/markers.h"

#include <gmock/gmock.h>

#include <glm/vec2.hpp>

#include "render/digit_strokes.h"
#include "support/shapes.h"

namespace limn::render {
namespace {

TEST(Markers, AStepShowsWhoMattersAndThePickedOneLast) {
  const auto mesh = test::cube();
  const VertexLabels labels{0, 0, 0, 1, 0, 2, 0, 0};
  const std::vector<std::uint32_t> illegal{0, 1, 2};
  const std::vector<std::uint32_t> raised{3};
  std::vector<LegalisationCandidate> candidates{{.vertex = 1, .valence = 3, .cost = 120},
                                                {.vertex = 0, .valence = 2, .cost = 0}};
  StepMarkers step{illegal, raised, candidates, {}};
  std::vector<Marker> markers = step_markers(*mesh, labels, step);
  ASSERT_EQ(markers.size(), 4U) << "an illegal one, a raised one, two candidates";
  EXPECT_EQ(markers[0].style, MarkerStyle::kIllegal);
  EXPECT_EQ(markers[1].style, MarkerStyle::kRelabelled);
  EXPECT_EQ(markers[2].style, MarkerStyle::kCandidate);
  EXPECT_EQ(markers[3].style, MarkerStyle::kPicked);
  EXPECT_EQ(markers[3].position, glm::vec3(mesh->positions()[1]));
  EXPECT_EQ(markers[3].number, 3);
  EXPECT_EQ(markers[3].second, 99) << "as many as there is room for";
  step.shows_labels = true;
  EXPECT_EQ(step_markers(*mesh, labels, step).size(), 8U);

  candidates = {{.vertex = 1, .score = 1.6F}, {.vertex = 0, .score = -2.4F}};
  step.order = LegalisationMethod::kLookAhead;
  markers = step_markers(*mesh, labels, step);
  EXPECT_EQ(markers.back().text, MarkerText::kDecimal);
  EXPECT_EQ(markers.back().number, 1);
  EXPECT_EQ(markers.back().second, 6);
  const Marker& other = markers[markers.size() - 2];
  EXPECT_EQ(other.text, MarkerText::kNegative);
  EXPECT_EQ(other.number, 2);
  EXPECT_EQ(other.second, 4);

  const std::vector<std::uint32_t> falling{3};
  markers = step_markers(*mesh, labels, {{}, raised, {}, falling});
  ASSERT_EQ(markers.size(), 1U);
  EXPECT_EQ(markers[0].text, MarkerText::kBecomes);
}

TEST(Markers, LabelsStandAtTheirVertices) {
  const auto mesh = test::cube();
  const VertexLabels labels{0, 1, 2, 3, 4, 5, 6, 7};
  const std::vector<std::uint32_t> illegal{0, 5};
  const std::vector<std::uint32_t> raised{2};
  const std::vector<Marker> markers = label_markers(*mesh, labels, illegal, raised);
  ASSERT_EQ(markers.size(), 8U);
  for (std::size_t v = 0; v < 8; ++v) {
    EXPECT_EQ(markers[v].number, labels[v]);
    EXPECT_EQ(markers[v].position, glm::vec3(mesh->positions()[v]));
  }
  EXPECT_EQ(markers[0].style, MarkerStyle::kIllegal);
  EXPECT_EQ(markers[1].style, MarkerStyle::kLabel);
  EXPECT_EQ(markers[2].style, MarkerStyle::kRelabelled);
  EXPECT_EQ(markers[5].style, MarkerStyle::kIllegal);
}

TEST(Markers, DepthsStandAtTheCentroidsOfPaintedFaces) {
  const auto mesh = test::cube();
  const std::vector<std::uint8_t> depths{0, 3, 0, 0, 0, 10};
  const std::vector<Marker> markers = depth_markers(*mesh, depths);
  ASSERT_EQ(markers.size(), 2U);
  EXPECT_EQ(markers[0].number, 3);
  EXPECT_EQ(markers[0].position, glm::vec3(1, 0, 0));
  EXPECT_EQ(markers[1].number, 10);
  EXPECT_EQ(markers[1].position, glm::vec3(0, 0, 1));
}

TEST(Markers, ValencesStandAtIrregularVerticesInTheColourOfTheirBand) {
  const auto mesh = test::cube();
  const glm::dvec3 origin(0.25, 0.5, -1.0);
  const std::vector<Marker> markers =
      valence_markers(*mesh, std::vector<IrregularVertex>{{2, 3, 1}, {7, 200, 3}}, origin);
  ASSERT_EQ(markers.size(), 2U);
  EXPECT_EQ(markers[0].position, glm::vec3(mesh->positions()[2] - origin));
  EXPECT_EQ(markers[0].number, 3);
  EXPECT_EQ(static_cast<int>(markers[0].style), static_cast<int>(MarkerStyle::kValence) + 1);
  EXPECT_EQ(markers[1].number, 99) << "two digits are all a dot has room for";
  EXPECT_EQ(static_cast<int>(markers[1].style), static_cast<int>(MarkerStyle::kValence) + 3);
}

TEST(DigitStrokes, StayWithinTheirBoxAndReachTopAndBottom) {
  const DigitStrokes font = make_digit_strokes();
  EXPECT_EQ(font.first[10], font.strokes.size());
  for (std::size_t digit = 0; digit < 10; ++digit) {
    float low = 2.0F;
    float high = -1.0F;
    for (std::uint32_t i = font.first[digit]; i < font.first[digit + 1]; ++i) {
      const glm::vec4& stroke = font.strokes[i];
      for (const glm::vec2 end : {glm::vec2(stroke.x, stroke.y), glm::vec2(stroke.z, stroke.w)}) {
        EXPECT_GE(end.x, -0.03F) << digit;
        EXPECT_LE(end.x, 0.63F) << digit;
        low = std::min(low, end.y);
        high = std::max(high, end.y);
      }
    }
    EXPECT_NEAR(low, 0.0F, 0.03F) << digit;
    EXPECT_NEAR(high, 1.0F, 0.03F) << digit;
  }
}

}  // namespace
}  // namespace limn::render
