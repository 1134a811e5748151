// Someone who presses everything: whatever is done, in whatever order, while refinements run or
// not, every frame can be drawn, and what the session says of itself holds together.
#include <array>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "app/desk.h"
#include "support/effort.h"

namespace limn::app {
namespace {

using enum ui::ActionId;

class RandomHand {
 public:
  explicit RandomHand(std::uint32_t seed) : random_(seed) {}

  std::size_t below(std::size_t n) { return random_() % n; }

  ui::Action next() {
    static const std::vector<ui::ActionId> plain{kUndo,
                                                 kUndo,
                                                 kUndo,
                                                 kRedo,
                                                 kRevert,
                                                 kRaiseAll,
                                                 kLowerAll,
                                                 kZeroAll,
                                                 kRemoveIllegal,
                                                 kSubdivide,
                                                 kBackToControl,
                                                 kApply,
                                                 kShowControl,
                                                 kShowRefined,
                                                 kShowBoth,
                                                 kSchemeForward,
                                                 kSchemeForward,
                                                 kSchemeBack,
                                                 kLoopOriginal,
                                                 kLoopWarren,
                                                 kMakeFit,
                                                 kMakeFit,
                                                 kCompareSphere,
                                                 kTintDistance,
                                                 kTintDepth,
                                                 kMeasureDistance,
                                                 kSplitEdge,
                                                 kSplitEdge,
                                                 kFlipEdge,
                                                 kToggleValences,
                                                 kToggleFaces,
                                                 kToggleLabels,
                                                 kCreaseDihedral,
                                                 kClearCreases,
                                                 kCornersSmooth,
                                                 kCornersSharp,
                                                 kAdaptiveLoop,
                                                 kAdaptiveCatmullClark,
                                                 kToolSplitEdge,
                                                 kToolPaint,
                                                 kToolFill,
                                                 kToolSmartFill,
                                                 kGrowPainting,
                                                 kShrinkPainting,
                                                 kSmoothPainting,
                                                 kInvertPainting,
                                                 kMirrorPainting,
                                                 kToggleMirrorX,
                                                 kToggleMirrorZ,
                                                 kSubdivideOneLevel,
                                                 kChooseDepths,
                                                 kChooseDepths,
                                                 kToggleLiveDepths,
                                                 kCompareBudget,
                                                 kKeepView,
                                                 kForgetViews,
                                                 kCancel};
    static const std::vector<std::string> all_words = [] {
      std::vector<std::string> words{""};
      for (const SchemeInfo& info : schemes()) {
        words.emplace_back(info.name);
      }
      return words;
    }();
    const std::size_t choice = below(11);
    if (choice == 0) {
      static constexpr std::array kMeshes{"cube", "icosahedron", "mixed", "grid", "sphere"};
      return {kOpenBundled, std::string(kMeshes[below(kMeshes.size())])};
    }
    if (choice == 10) {
      return {kSetDepthSource, static_cast<int>(below(ui::kDepthSources))};
    }
    if (choice < 3) {
      return {choice == 1 ? kSetScheme : kSetSecondScheme, all_words[below(all_words.size())]};
    }
    return plain[below(plain.size())];
  }

 private:
  std::mt19937 random_;
};

/// The mouse comes to rest on a face and an edge of it, or on nothing.
void point_somewhere(Session& session, RandomHand& hand) {
  if (hand.below(4) == 0) {
    session.set_hover(std::nullopt);
    session.set_hover_edge(std::nullopt);
    return;
  }
  const FlatTopology& topology = session.document().control->topology();
  const auto corner = static_cast<std::uint32_t>(hand.below(topology.corner_faces.size()));
  session.set_hover(topology.corner_faces[corner]);
  session.set_hover_edge(topology.corner_edges[corner]);
}

/// Shows what a click would cost, and perhaps clicks, on the face under the mouse.
void paint_somewhere(Session& session, RandomHand& hand) {
  if (!session.hover()) {
    session.withdraw_proposal();
    return;
  }
  const std::vector<std::uint32_t> region = session.fill_region(*session.hover());
  const DepthChange change = hand.below(2) == 0 ? DepthChange::add(1) : DepthChange::set(2);
  session.propose(session.with_images(region), change);
  if (hand.below(3) == 0) {
    session.finish_forecast();
  }
  if (hand.below(2) == 0) {
    session.begin_stroke(change, "fill");
    session.touch(region);
    if (hand.below(4) > 0) {
      session.end_stroke();
    }
  }
}

void answer(Session& session) {
  if (std::holds_alternative<ui::UnsavedQuestion>(session.modal())) {
    session.perform(kDiscardChanges);
  } else if (!std::holds_alternative<std::monostate>(session.modal())) {
    EXPECT_FALSE(std::holds_alternative<ui::ErrorDialog>(session.modal()))
        << to_string(std::get<ui::ErrorDialog>(session.modal()).error);
    session.perform(kCancel);
  }
}

void expect_sound(const Session& session) {
  const Document& document = session.document();
  ASSERT_EQ(document.depths.size(), document.control->face_count());
  if (document.scheme) {
    ASSERT_LE(document.stage.levels, kMostSchemeLevels);
    ASSERT_TRUE(document.stage.levels == 0 ||
                check_fits(*document.control, document.scheme->scheme));
  }
  for (const LiveRefinement* live : {&session.refinement(), &session.second()}) {
    const JobResult* refined = live->refined();
    if (refined != nullptr && (live == &session.refinement() || session.is_split())) {
      ASSERT_EQ(&refined->control->topology(), &document.control->topology());
    }
  }
}

TEST(Session, WhateverIsPressedEveryFrameCanBeDrawn) {
  const int steps = static_cast<int>(400 * test::effort());
  RandomHand hand(9);
  Desk desk({560, 400});
  Session& session = desk.session();
  session.set_face_budget(4000);
  double now = 0.0;
  for (int step = 0; step < steps && !testing::Test::HasFailure(); ++step) {
    point_somewhere(session, hand);
    if (hand.below(3) == 0) {
      paint_somewhere(session, hand);
    }
    const ui::Action action = hand.next();
    SCOPED_TRACE(testing::Message()
                 << "step " << step << ": action " << static_cast<int>(action.id));
    session.perform(action);
    answer(session);
    expect_sound(session);
    desk.draw_frame();
    if (hand.below(2) == 0) {
      session.update(now += 0.05);
      answer(session);
      desk.draw_frame();
    }
    if (hand.below(8) == 0) {
      session.finish_refinement();
      answer(session);
      expect_sound(session);
      desk.draw_frame();
    }
  }
}

}  // namespace
}  // namespace limn::app
