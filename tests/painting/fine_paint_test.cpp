#include "limn/painting/fine_paint.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/subdivision/fine_labels.h"
#include "limn/subdivision/fine_places.h"
#include "limn/subdivision/label_subdivision.h"
#include "support/shapes.h"

namespace limn {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A painting that is painted on.
class Canvas {
 public:
  explicit Canvas(std::shared_ptr<const ControlMesh> mesh)
      : mesh_(std::move(mesh)), depths_(mesh_->face_count()) {}

  [[nodiscard]] Painting painting() const { return {*mesh_, depths_, demands_, rule_}; }
  FineEdits paint(std::vector<FineFace> faces, DepthChange change) {
    FineEdits edits = plan_fine_edits(painting(), faces, change);
    apply_edits(depths_, edits.depths);
    demands_.apply(edits.demands);
    return edits;
  }
  void set_depth(std::uint32_t face, int depth) { depths_.set(face, depth); }
  [[nodiscard]] int depth(std::uint32_t face) const { return depths_[face]; }
  [[nodiscard]] const FineDemands& demands() const { return demands_; }
  [[nodiscard]] const ControlMesh& mesh() const { return *mesh_; }
  [[nodiscard]] int asked(const FineFace& face) const { return depth_asked(painting(), face); }

  /// The faces of the refined mesh.
  [[nodiscard]] std::vector<FineFace> refined() const {
    IgnoreProgress progress;
    SubdivisionSettings settings;
    settings.non_quads = rule_;
    const auto labels =
        legal_labels(*mesh_, depths_.values(), demands_, settings, progress).value();
    const RefineLimits limits{.fine = labels.fine.get()};
    const RefinedMesh mesh =
        refine(*mesh_, labels.legal.labels, settings, limits, progress).value();
    std::vector<std::uint32_t> all(mesh.face_count());
    for (std::uint32_t f = 0; f < all.size(); ++f) {
      all[f] = f;
    }
    return places_of({mesh_.get(), &labels.legal.labels, labels.fine.get(), kAllLevels}, mesh, all);
  }
  void set_rule(NonQuadRule rule) { rule_ = rule; }

 private:
  std::shared_ptr<const ControlMesh> mesh_;
  FaceDepths depths_;
  FineDemands demands_;
  NonQuadRule rule_ = NonQuadRule::kUniformFirstStep;
};

constexpr FineFace at(std::uint32_t face, std::uint8_t level, std::uint16_t column,
                      std::uint16_t row) {
  return {face, 0, level, column, row};
}

TEST(FinePaint, RaisesTheFaceAloneByOneLevelMoreThanItHas) {
  Canvas canvas(test::cube());
  canvas.set_depth(0, 2);
  const FineEdits edits = canvas.paint({at(0, 2, 1, 3)}, DepthChange::add(1));
  EXPECT_EQ(edits.faces, 1U);
  EXPECT_EQ(edits.depth, 3);
  EXPECT_THAT(edits.depths, IsEmpty());
  EXPECT_THAT(canvas.demands().all(), ElementsAre(FineDemand{at(0, 2, 1, 3), 3}));
  EXPECT_EQ(canvas.asked(at(0, 3, 2, 7)), 3);
  EXPECT_EQ(canvas.asked(at(0, 3, 4, 7)), 2);
}

TEST(FinePaint, RaisesAFaceThatIsFineForItsNeighboursFromTheLevelItHas) {
  Canvas canvas(test::cube());
  canvas.set_depth(0, 2);
  canvas.paint({at(3, 2, 0, 0)}, DepthChange::add(1));
  EXPECT_THAT(canvas.demands().all(), ElementsAre(FineDemand{at(3, 2, 0, 0), 3}));
  EXPECT_EQ(canvas.depth(3), 0);
}

TEST(FinePaint, PaintsWholeControlFacesByTheirDepth) {
  Canvas canvas(test::cube());
  EXPECT_EQ(canvas.paint({at(1, 0, 0, 0), at(4, 0, 0, 0)}, DepthChange::add(1)).faces, 2U);
  EXPECT_EQ(canvas.depth(1), 1);
  EXPECT_EQ(canvas.depth(4), 1);
  EXPECT_TRUE(canvas.demands().empty());
  canvas.paint({at(1, 0, 0, 0)}, DepthChange::set(3));
  EXPECT_EQ(canvas.depth(1), 3);
  canvas.paint({at(1, 0, 0, 0)}, DepthChange::add(-1));
  EXPECT_EQ(canvas.depth(1), 2);
}

TEST(FinePaint, LoweringTakesBackWhatRaisingAsked) {
  Canvas canvas(test::cube());
  canvas.set_depth(2, 1);
  const FineFace face = at(2, 1, 1, 0);
  canvas.paint({face}, DepthChange::add(1));
  canvas.paint({face}, DepthChange::add(1));
  EXPECT_EQ(canvas.asked(face), 3);
  // Now it is four times four faces; one of them is lowered, and the three beside it go with it.
  canvas.paint({at(2, 3, 5, 1)}, DepthChange::add(-1));
  EXPECT_EQ(canvas.asked(at(2, 3, 5, 1)), 2);
  EXPECT_EQ(canvas.asked(at(2, 3, 4, 0)), 2) << "is of the same four";
  EXPECT_EQ(canvas.asked(at(2, 3, 4, 2)), 3) << "is not";
  EXPECT_EQ(canvas.depth(2), 1);
  for (const std::uint16_t column : std::array<std::uint16_t, 2>{4, 6}) {
    for (const std::uint16_t row : std::array<std::uint16_t, 2>{0, 2}) {
      canvas.paint({at(2, 3, column, row)}, DepthChange::add(-1));
    }
  }
  EXPECT_EQ(canvas.asked(face), 2);
  EXPECT_THAT(canvas.demands().all(), ElementsAre(FineDemand{face, 2}));
  canvas.paint({at(2, 2, 3, 1)}, DepthChange::add(-1));
  EXPECT_TRUE(canvas.demands().empty());
  EXPECT_EQ(canvas.depth(2), 1);
}

TEST(FinePaint, LoweringAfterRaisingLeavesNoTrace) {
  Canvas canvas(test::cube());
  canvas.set_depth(0, 2);
  const FineFace beside = at(1, 2, 3, 3);  // Fine for its neighbours.
  canvas.paint({beside}, DepthChange::add(1));
  canvas.paint({at(1, 3, 6, 6)}, DepthChange::add(-1));
  EXPECT_TRUE(canvas.demands().empty());
  EXPECT_EQ(canvas.depth(1), 0);
}

TEST(FinePaint, LoweringPartOfAPaintedFaceKeepsTheRest) {
  Canvas canvas(test::cube());
  canvas.set_depth(5, 3);
  const FineEdits edits = canvas.paint({at(5, 3, 7, 7)}, DepthChange::add(-1));
  EXPECT_THAT(edits.depths, ElementsAre(DepthEdit{5, 3, 2}));
  std::size_t coarser = 0;
  for (std::uint16_t row = 0; row < 8; ++row) {
    for (std::uint16_t column = 0; column < 8; ++column) {
      const int asked = canvas.asked(at(5, 2, column / 2, row / 2));
      EXPECT_EQ(asked, column >= 6 && row >= 6 ? 2 : 3);
      coarser += asked == 2 ? 1 : 0;
    }
  }
  EXPECT_EQ(coarser, 4U);
}

TEST(FinePaint, LoweringAllOfAFaceIsLoweringItsDepth) {
  Canvas canvas(test::cube());
  canvas.set_depth(5, 3);
  std::vector<FineFace> all;
  for (std::uint16_t row = 0; row < 8; ++row) {
    for (std::uint16_t column = 0; column < 8; ++column) {
      all.push_back(at(5, 3, column, row));
    }
  }
  EXPECT_EQ(canvas.paint(all, DepthChange::add(-1)).faces, 64U);
  EXPECT_TRUE(canvas.demands().empty());
  EXPECT_EQ(canvas.depth(5), 2);
}

TEST(FinePaint, DoesNotLowerWhatIsFineForItsNeighboursAlone) {
  Canvas canvas(test::cube());
  canvas.set_depth(0, 3);
  const FineEdits edits = canvas.paint({at(1, 2, 0, 0)}, DepthChange::add(-1));
  EXPECT_TRUE(edits.empty());
  EXPECT_EQ(edits.faces, 0U);
}

TEST(FinePaint, SettingHoldsAFaceAtTheLevelItHas) {
  Canvas canvas(test::cube());
  canvas.set_depth(0, 1);
  canvas.paint({at(0, 3, 2, 2)}, DepthChange::set(3));  // Is there for some neighbour's sake.
  EXPECT_THAT(canvas.demands().all(), ElementsAre(FineDemand{at(0, 2, 1, 1), 3}));
  EXPECT_TRUE(canvas.paint({at(0, 3, 2, 2)}, DepthChange::set(3)).empty()) << "once is enough";
  canvas.paint({at(0, 3, 2, 2)}, DepthChange::set(5));
  EXPECT_EQ(canvas.asked(at(0, 3, 2, 2)), 5);
  EXPECT_EQ(canvas.asked(at(0, 3, 3, 3)), 3);
  canvas.paint({at(0, 5, 8, 8), at(0, 5, 9, 9)}, DepthChange::set(1));
  EXPECT_EQ(canvas.asked(at(0, 5, 8, 8)), 1);
}

TEST(FinePaint, GoesNoDeeperThanThereAreLevels) {
  Canvas canvas(test::cube());
  canvas.set_depth(0, kMaxDepth);
  EXPECT_TRUE(canvas.paint({at(0, kMaxDepth, 1000, 3)}, DepthChange::add(1)).empty());
  Canvas prism(test::mixed_prism());
  prism.set_depth(0, kMaxDepth);
  // The rule for non-quads makes one level more than depths go.
  const FineFace deepest{0, 0, kMaxDepth + 1, 0, 0};
  EXPECT_TRUE(prism.paint({deepest}, DepthChange::add(1)).empty());
  EXPECT_EQ(prism.asked(deepest), kMaxDepth);
  prism.paint({deepest}, DepthChange::add(-1));
  EXPECT_EQ(prism.depth(0), kMaxDepth - 1);
}

TEST(FinePaint, CountsDepthsWithoutTheLevelThatAllFacesGet) {
  Canvas canvas(test::mixed_prism());
  canvas.set_depth(0, 1);
  for (const FineFace& face : canvas.refined()) {
    if (face.control_face == 0) {
      ASSERT_EQ(face.level, 2);
      EXPECT_EQ(canvas.asked(face), 1);
    }
  }
  const FineFace face{0, 0, 2, 1, 1};
  const FineEdits edits = canvas.paint({face}, DepthChange::add(1));
  EXPECT_EQ(edits.depth, 2);
  EXPECT_THAT(canvas.demands().all(), ElementsAre(FineDemand{face, 3}));
  EXPECT_EQ(canvas.asked(face), 2);
  canvas.paint({face}, DepthChange::set(0));
  EXPECT_EQ(canvas.asked(face), 0);
}

/// What is asked of all faces of one level.
std::vector<int> all_asked(const Canvas& canvas, std::uint8_t level) {
  std::vector<int> depths;
  for (std::uint32_t f = 0; f < canvas.mesh().face_count(); ++f) {
    const auto sides = static_cast<std::uint32_t>(canvas.mesh().face(f).size());
    const auto along = static_cast<std::uint16_t>(1U << (sides == 4 ? level : level - 1));
    for (std::uint32_t corner = 0; corner < (sides == 4 ? 1 : sides); ++corner) {
      for (std::uint16_t row = 0; row < along; ++row) {
        for (std::uint16_t column = 0; column < along; ++column) {
          depths.push_back(canvas.asked({f, corner, level, column, row}));
        }
      }
    }
  }
  return depths;
}

TEST(FinePaint, LowersManyAtOnceAsOneByOne) {
  test::Random random(11);
  for (const NonQuadRule rule : {NonQuadRule::kUniformFirstStep, NonQuadRule::kWherePainted}) {
    Canvas start(test::mixed_prism());
    start.set_rule(rule);
    for (std::uint32_t f = 0; f < start.mesh().face_count(); ++f) {
      start.set_depth(f, static_cast<int>(f % 3));
    }
    for (int stroke = 0; stroke < 12; ++stroke) {
      std::vector<FineFace> faces;
      std::ranges::sample(start.refined(), std::back_inserter(faces), 9, random);
      const int target = static_cast<int>(random() % 5);
      Canvas at_once = start;
      at_once.paint(faces, DepthChange::at_most(target));
      Canvas one_by_one = start;
      std::ranges::shuffle(faces, random);
      for (const FineFace& face : faces) {
        one_by_one.paint({face}, DepthChange::at_most(target));
      }
      EXPECT_EQ(all_asked(at_once, 5), all_asked(one_by_one, 5));
      EXPECT_EQ(at_once.demands(), one_by_one.demands());
      for (const FineFace& face : faces) {
        EXPECT_LE(at_once.asked(face), std::max(target, 0));
      }
      start.paint(faces, DepthChange::add(1));
      start.paint({faces.front()}, DepthChange::set(target));
    }
  }
}

TEST(FinePaint, ChangesNothingBesideTheFacesPaintedOn) {
  test::Random random(5);
  Canvas canvas(test::cube());
  canvas.set_depth(0, 3);
  canvas.set_depth(4, 1);
  for (int stroke = 0; stroke < 30; ++stroke) {
    const std::vector<FineFace> refined = canvas.refined();
    std::vector<FineFace> faces;
    std::ranges::sample(refined, std::back_inserter(faces), 5, random);
    const Canvas before = canvas;
    const bool lowers = stroke % 2 == 1;
    canvas.paint(faces, DepthChange::add(lowers ? -1 : 1));
    for (const FineFace& face : refined) {
      if (std::ranges::find(faces, face) != faces.end()) {
        continue;
      }
      const bool goes_together = lowers && std::ranges::any_of(faces, [&](const FineFace& painted) {
                                   const int up = painted.level - 1;
                                   return painted.control_face == face.control_face &&
                                          painted.level <= face.level && painted.level > 0 &&
                                          painted.column / 2 == face.column >> (face.level - up) &&
                                          painted.row / 2 == face.row >> (face.level - up);
                                 });
      if (!goes_together) {
        EXPECT_EQ(canvas.asked(face), before.asked(face)) << stroke;
      }
    }
  }
}

}  // namespace
}  // namespace limn
