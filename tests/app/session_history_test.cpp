// A long session of mixed work, undone to its start and redone to its end: the document is the same
// at every step, both ways, and wherever one jumps.
#include <map>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/recording/recording.h"
#include "app/session.h"

namespace limn::app {
namespace {

using enum ui::ActionId;

constexpr std::size_t kActions = 200;

/// Someone who uses everything that can be undone.
class Worker {
 public:
  explicit Worker(Session& session) : session_(session) {}

  void act() {
    switch (below(14)) {
      case 0:
      case 1:
      case 2:
        stroke();
        break;
      case 3:
        session_.perform(one_of({kRaiseAll, kLowerAll, kZeroAll, kRaiseDihedral, kGrowPainting,
                                 kShrinkPainting, kSmoothPainting, kInvertPainting}));
        break;
      case 4:
        session_.perform(one_of({kCreaseDihedral, kClearCreases}));
        break;
      case 5:
        session_.perform(one_of({kRemoveIllegal, kSubdivide, kSubdivideOneLevel, kBackToControl}));
        break;
      case 6:
        session_.perform(
            one_of({kCornersSharp, kCornersSmooth, kPointsLevel, kPointsLimit, kLegaliseGreedy,
                    kLegaliseLookAhead, kNonQuadsWherePainted, kNonQuadsUniformFirstStep}));
        break;
      case 7:
        session_.finish_refinement();
        session_.perform(session_.document().control->face_count() < 800 ? kApply : kRevert);
        break;
      case 8:
      case 9:
        edit_edge();
        break;
      case 10:
        session_.perform({kSetScheme, std::string(below(2) == 0 ? "loop" : "")});
        break;
      case 11:
        session_.perform(one_of({kSchemeForward, kSchemeBack}));
        break;
      case 12:
        session_.perform(kMakeFit);
        break;
      default:
        session_.perform(below(6) == 0 ? kRevert : kRaiseDihedral);
        break;
    }
  }

 private:
  std::size_t below(std::size_t n) { return random_() % n; }
  ui::ActionId one_of(const std::vector<ui::ActionId>& ids) { return ids[below(ids.size())]; }

  void stroke() {
    const std::size_t faces = session_.document().control->face_count();
    session_.begin_stroke(below(3) == 0 ? DepthChange::set(static_cast<int>(below(4)))
                                        : DepthChange::add(below(3) == 0 ? -1 : 1));
    for (int dab = 0; dab < 4; ++dab) {
      const auto face = static_cast<std::uint32_t>(below(faces));
      session_.touch({&face, 1});
    }
    session_.end_stroke();
  }
  void edit_edge() {
    const FlatTopology& topology = session_.document().control->topology();
    const std::size_t corner = below(topology.corner_faces.size());
    session_.set_hover(topology.corner_faces[corner]);
    session_.set_hover_edge(topology.corner_edges[corner]);
    session_.perform(one_of({kSplitEdge, kFlipEdge}));
  }

  Session& session_;
  std::mt19937 random_{20};
};

TEST(SessionHistory, TwoHundredActionsAreUndoneToTheStartAndRedoneToTheEnd) {
  Session session({[] {}, {}});
  session.set_face_budget(20'000);
  session.perform({kOpenBundled, std::string("cube_triangulated")});
  Worker worker(session);
  std::vector<std::string> states{checksum_of(session.document())};
  std::map<std::string, int> kinds;
  for (std::size_t tried = 0; states.size() <= kActions; ++tried) {
    ASSERT_LT(tried, 20 * kActions) << "hardly anything can be done";
    const std::size_t before = session.history().position();
    worker.act();
    if (!std::holds_alternative<std::monostate>(session.modal())) {
      session.perform(kCancel);
    }
    if (session.history().position() > before) {
      ASSERT_EQ(session.history().position(), before + 1) << "an action is one step";
      ++kinds[session.history().undo_name().substr(0, 8)];
      states.push_back(checksum_of(session.document()));
    } else {
      ASSERT_EQ(checksum_of(session.document()), states.back())
          << "what is no step changes nothing";
    }
  }
  ASSERT_EQ(session.history().size(), kActions);
  EXPECT_GE(kinds.size(), 12u) << "the work is mixed";

  for (std::size_t step = kActions; step > 0; --step) {
    session.perform(kUndo);
    ASSERT_EQ(checksum_of(session.document()), states[step - 1]) << "undone to step " << step - 1;
  }
  EXPECT_FALSE(session.history().can_undo());
  EXPECT_FALSE(session.history().is_modified());
  for (std::size_t step = 1; step <= kActions; ++step) {
    session.perform(kRedo);
    ASSERT_EQ(checksum_of(session.document()), states[step]) << "redone to step " << step;
  }
  EXPECT_FALSE(session.history().can_redo());

  std::mt19937 random(7);
  for (int jump = 0; jump < 30; ++jump) {
    const auto step = static_cast<std::size_t>(random() % (kActions + 1));
    session.perform({kGoToStep, static_cast<int>(step)});
    ASSERT_EQ(checksum_of(session.document()), states[step]) << "gone to step " << step;
  }
}

}  // namespace
}  // namespace limn::app
