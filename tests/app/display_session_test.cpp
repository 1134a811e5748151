// What colours the faces and what they seem to be made of.
#include <numeric>

#include <gtest/gtest.h>

#include "app/session.h"
#include "limn/mesh/refined_mesh.h"

namespace limn::app {
namespace {

using enum ui::ActionId;

class DisplaySession : public testing::Test {
 protected:
  DisplaySession() { session_.perform({kOpenBundled, std::string("cube")}); }

  Session session_{{[] {}, {}}};
};

TEST_F(DisplaySession, LevelsAreCountedOfWhatIsShown) {
  session_.begin_stroke(DepthChange::set(3));
  session_.touch(std::vector<std::uint32_t>{5});
  session_.end_stroke();
  session_.perform(kTintLevel);
  EXPECT_EQ(session_.model().level_counts[0], 6U) << "the control mesh is of level 0";
  session_.perform(kSubdivide);
  session_.finish_refinement();
  session_.perform(kTintLevel);
  const ui::DepthCounts counts = session_.model().level_counts;
  const RefinedMesh& mesh = *session_.refinement().refined()->mesh;
  EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::size_t{0}), mesh.face_count());
  EXPECT_EQ(counts[3],
            static_cast<std::size_t>(std::ranges::count(mesh.face_levels, std::uint8_t{3})));
  EXPECT_GT(counts[3], 60U);
  EXPECT_GT(counts[1], 0U);
  session_.perform(kShowControl);
  EXPECT_EQ(session_.model().level_counts[0], 6U);
}

TEST_F(DisplaySession, AMaterialTurnsTheLightOn) {
  session_.perform({kToggleLight, false});
  session_.perform(kMaterialClay);
  EXPECT_TRUE(session_.display().light);
  EXPECT_EQ(session_.display().material, ui::Material::kClay);
  session_.perform(kMaterialStudio);
  EXPECT_EQ(session_.display().material, ui::Material::kStudio);
}

TEST_F(DisplaySession, ColoursAndNumbersChangeNoDocument) {
  for (const ui::ActionId id : {kTintLevel, kTintNone, kTintDepth, kToggleNumbers}) {
    session_.perform(id);
  }
  EXPECT_TRUE(session_.display().numbers);
  EXPECT_EQ(session_.display().tint, ui::Tint::kDepth);
  EXPECT_FALSE(session_.history().is_modified());
}

}  // namespace
}  // namespace limn::app
