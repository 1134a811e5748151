// From one flaw of a surface to the next.
#include "app/flaws.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <fstream>

#include "app/session.h"
#include "limn/subdivision/label_subdivision.h"
#include "support/scratch_folder.h"
#include "support/shapes.h"

namespace limn::app {
namespace {

using enum ui::ActionId;

/// Two small quads beside a large one: vertex 5 (of the file) lies on its edge.
constexpr const char* kSplitBesideWhole =
    "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 2 1 0\nv 3 1 0\nv 3 2 0\nv 2 2 0\nv 2 0 0\nv 3 0 0\n"
    "f 1 2 3 4\nf 5 6 7 8\nf 9 10 6 5\n";

TEST(Flaws, EveryCrackIsAPlaceAtItsFace) {
  const test::MeshPointer control = test::cube();
  IgnoreProgress progress;
  auto refined = refine(*control, VertexLabels(8, 2), {}, {}, progress);
  ASSERT_TRUE(refined);
  EXPECT_FALSE(flaw_place(ui::FlawKind::kCrack, 0, {*control}));
  const CrackCheck sound = check_cracks(*control, *refined);
  EXPECT_FALSE(flaw_place(ui::FlawKind::kCrack, 0, {*control, &*refined, &sound}));

  // Torn along one edge: a face gets a corner of its own.
  RefinedMesh torn = *refined;
  torn.quads[17][2] =
      torn.quads[18][0] == torn.quads[17][2] ? torn.quads[40][1] : torn.quads[18][0];
  const CrackCheck cracked = check_cracks(*control, torn);
  ASSERT_FALSE(cracked.is_watertight());
  ASSERT_FALSE(cracked.crack_faces.empty());
  const std::size_t count = cracked.crack_faces.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto place = flaw_place(ui::FlawKind::kCrack, i, {*control, &torn, &cracked});
    ASSERT_TRUE(place);
    EXPECT_EQ(place->element, i);
    EXPECT_EQ(place->count, count);
    glm::dvec3 middle(0.0);
    for (const std::uint32_t v : torn.quads[cracked.crack_faces[i]]) {
      middle += 0.25 * torn.position(v);
    }
    EXPECT_LT(glm::length(place->position - middle), 1e-12);
  }
  EXPECT_EQ(flaw_place(ui::FlawKind::kCrack, count, {*control, &torn, &cracked})->element, 0U);
}

TEST(Flaws, BoundariesAreLedToOneByOne) {
  const test::MeshPointer mesh = test::control_mesh(test::polygon_in_ring_soup(5));
  const auto place = flaw_place(ui::FlawKind::kBoundary, 0, {*mesh});
  ASSERT_TRUE(place);
  EXPECT_EQ(place->count, 1U);
  EXPECT_LT(glm::length(place->position - mesh->bounds().centre()),
            0.3 * mesh->bounds().diagonal());
  EXPECT_FALSE(flaw_place(ui::FlawKind::kBoundary, 0, {*test::cube()}));
}

class FlawsOfAMesh : public testing::Test {
 protected:
  FlawsOfAMesh() {
    std::ofstream(folder_ / "beside.obj") << kSplitBesideWhole;
    session_.perform({kOpen, (folder_ / "beside.obj").string()});
    session_.finish_refinement();
  }

  test::ScratchFolder folder_;
  Session session_{{[] {}, {}}};
};

TEST_F(FlawsOfAMesh, TheWayLeadsToTheTJunctionAndMarksIt) {
  ASSERT_EQ(session_.document().control->face_count(), 3U);
  EXPECT_EQ(session_.model().t_junctions, 1U);
  EXPECT_FALSE(session_.model().flaw_focus);
  session_.update(1.0);
  session_.perform({kNextFlaw, static_cast<int>(ui::FlawKind::kTJunction)});
  session_.update(2.0);
  const auto focus = session_.model().flaw_focus;
  ASSERT_TRUE(focus);
  EXPECT_EQ(focus->kind, ui::FlawKind::kTJunction);
  EXPECT_EQ(focus->count, 1U);
  EXPECT_LT(glm::length(focus->position - glm::dvec3(2.0, 1.0, 0.0)), 1e-9);
  EXPECT_LT(glm::length(session_.view().target - focus->position), 0.2) << "the camera goes there";
  session_.perform(kCancel);
  EXPECT_FALSE(session_.model().flaw_focus) << "Esc takes the mark away";
}

TEST_F(FlawsOfAMesh, BoundaryLoopsGoRoundBothWays) {
  const auto at = [&] { return session_.model().flaw_focus->element; };
  const int kind = static_cast<int>(ui::FlawKind::kBoundary);
  session_.perform({kNextFlaw, kind});
  EXPECT_EQ(at(), 0U);
  EXPECT_EQ(session_.model().flaw_focus->count, 2U);
  session_.perform({kNextFlaw, kind});
  EXPECT_EQ(at(), 1U);
  session_.perform({kNextFlaw, kind});
  EXPECT_EQ(at(), 0U);
  session_.perform({kPreviousFlaw, kind});
  EXPECT_EQ(at(), 1U);
  session_.perform({kNextFlaw, static_cast<int>(ui::FlawKind::kTJunction)});
  EXPECT_EQ(at(), 0U) << "another kind begins at its first";
}

TEST_F(FlawsOfAMesh, AnotherMeshHasNoMark) {
  session_.perform({kNextFlaw, static_cast<int>(ui::FlawKind::kBoundary)});
  session_.perform({kOpenBundled, std::string("cube")});
  EXPECT_FALSE(session_.model().flaw_focus);
  EXPECT_EQ(session_.model().t_junctions, 0U);
  session_.perform({kNextFlaw, static_cast<int>(ui::FlawKind::kBoundary)});
  EXPECT_FALSE(session_.model().flaw_focus) << "there is none to lead to";
}

}  // namespace
}  // namespace limn::app
