// The painting beside what uniform subdivision to the same depth would give.
#include <gtest/gtest.h>

#include <vector>

#include "app/session.h"

namespace limn::app {
namespace {

using enum ui::ActionId;

class CompareUniform : public testing::Test {
 protected:
  void open(const char* name) { session_.perform({kOpenBundled, std::string(name)}); }
  void paint(std::uint32_t face, int depth) {
    session_.begin_stroke(DepthChange::set(depth));
    session_.touch(std::vector<std::uint32_t>{face});
    session_.end_stroke();
    session_.perform(kSubdivide);
    session_.finish_refinement();
    session_.finish_refinement();
  }
  [[nodiscard]] std::size_t second_faces() const {
    return session_.model().second.faces.value_or(0);
  }

  Session session_{{[] {}, {}}};
};

TEST_F(CompareUniform, OnePressShowsUniformCatmullClarkAtTheSameDepth) {
  open("cube");
  paint(5, 3);
  session_.perform(kCompareUniform);
  session_.finish_refinement();
  ASSERT_TRUE(session_.is_split());
  EXPECT_EQ(session_.display().second->scheme, Scheme::kCatmullClark);
  EXPECT_EQ(second_faces(), 6U * 64U);
  EXPECT_EQ(second_faces(), session_.model().refinement.result->uniform_faces);
  session_.perform(kCompareUniform);
  EXPECT_FALSE(session_.is_split()) << "the second press closes it";
}

TEST_F(CompareUniform, ItFollowsTheGreatestDepth) {
  open("cube");
  paint(5, 2);
  session_.perform(kCompareUniform);
  session_.finish_refinement();
  EXPECT_EQ(second_faces(), 6U * 16U);
  paint(4, 4);
  EXPECT_EQ(second_faces(), 6U * 256U);
  session_.perform(kUndo);
  session_.perform(kUndo);
  session_.finish_refinement();
  session_.finish_refinement();
  EXPECT_EQ(second_faces(), 6U * 16U);
}

TEST_F(CompareUniform, AMeshOfTrianglesIsAsDeepAsItsRefinement) {
  open("icosahedron");
  paint(3, 2);
  session_.perform(kCompareUniform);
  session_.finish_refinement();
  EXPECT_EQ(second_faces(), session_.model().refinement.result->uniform_faces);
  EXPECT_EQ(session_.model().second.levels, session_.model().refinement.result->levels);
  session_.perform(kAdaptiveLoop);
  session_.finish_refinement();
  session_.finish_refinement();
  EXPECT_EQ(session_.display().second->scheme, Scheme::kLoop) << "it follows the scheme";
  EXPECT_EQ(second_faces(), session_.model().refinement.result->uniform_faces);
}

TEST_F(CompareUniform, ASchemeOfOnesOwnChoiceStays) {
  open("cube");
  paint(5, 2);
  session_.perform({kSetSecondScheme, std::string("linear")});
  EXPECT_FALSE(session_.display().is_second_uniform);
  session_.perform(kCompareUniform);
  EXPECT_TRUE(session_.display().is_second_uniform);
  session_.perform({kSetSecondScheme, std::string("linear")});
  EXPECT_EQ(session_.display().second->scheme, Scheme::kLinear);
  session_.perform({kCompareUniform, false});
  EXPECT_TRUE(session_.is_split()) << "that is not the one to close";
}

}  // namespace
}  // namespace limn::app
