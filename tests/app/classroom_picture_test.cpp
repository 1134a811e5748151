// Pictures of what a course sees: the panel of schemes, two schemes side by side, irregular
// vertices. Drawn with ImGui's own font, so that they are the same bytes on every machine.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/desk.h"
#include "support/image_compare.h"

namespace limn::app {
namespace {

using enum ui::ActionId;

/// What the panels show of a machine that never was: every figure is fixed.
struct FixedFigures {
  std::vector<SchemeStep> steps;
  std::vector<ui::SphereSeries> series;

  FixedFigures() {
    for (int level = 0; level <= 3; ++level) {
      const std::uint64_t faces = std::uint64_t{32} << (2 * level);
      steps.push_back({level, {faces / 2 + 2, faces * 3 / 2, faces}, 21e-6 * std::pow(4.2, level)});
    }
    for (const LoopWeights weights : {LoopWeights::kOriginal, LoopWeights::kWarren}) {
      ui::SphereSeries one{{.scheme = Scheme::kLoop, .weights = weights}, {}};
      for (int level = 0; level <= 5; ++level) {
        const double error =
            (weights == LoopWeights::kWarren ? 0.021 : 0.012) * (0.1 + std::pow(0.3, level));
        SphereComparison row;
        row.level = level;
        row.vertices = (std::size_t{16} << (2 * level)) + 2;
        row.fit.radius = 0.8 - 0.01 * level;
        row.fit.least = -2.5 * error;
        row.fit.greatest = 1.5 * error;
        row.fit.root_mean_square = error;
        one.rows.push_back(row);
      }
      series.push_back(std::move(one));
    }
  }
};

class ClassroomPicture : public testing::Test {
 protected:
  explicit ClassroomPicture(ui::WindowSize size = {1100, 760}) : desk_(size) {
    ui::PanelLayout layout;
    layout.paint_open = layout.subdivide_open = layout.display_open = layout.numbers_open = false;
    layout.schemes_open = true;
    desk_.gui().set_layout(layout);
    perform({{kOpenBundled, std::string("sphere")}});
  }

  void perform(const std::vector<ui::Action>& actions) {
    for (const ui::Action& action : actions) {
      desk_.session().perform(action);
    }
  }
  void fix_figures() {
    desk_.adjust_model([this](ui::Model& model) {
      model.scheme.steps = figures_.steps;
      model.sphere.running.reset();
      model.sphere.series = figures_.series;
    });
  }

  FixedFigures figures_;
  Desk desk_;
};

class TallClassroomPicture : public ClassroomPicture {
 protected:
  TallClassroomPicture() : ClassroomPicture({900, 1060}) {}
};

TEST_F(TallClassroomPicture, PanelOfSchemes) {
  fix_figures();
  perform({{kSetScheme, std::string("loop")}, {kSetSchemeLevel, 3}});
  EXPECT_TRUE(test::matches_golden(desk_.panel_of(desk_.picture()), "schemes_panel_dark"));
  perform({kThemeLight, kLoopWarren});
  EXPECT_TRUE(test::matches_golden(desk_.panel_of(desk_.picture()), "schemes_panel_light"));
}

TEST_F(ClassroomPicture, PanelOfAMeshThatDoesNotFit) {
  perform({{kOpenBundled, std::string("cube")}, {kSetScheme, std::string("loop")}});
  EXPECT_TRUE(test::matches_golden(desk_.panel_of(desk_.picture()), "schemes_panel_misfit"));
}

TEST_F(ClassroomPicture, TwoSchemesSideBySide) {
  perform({{kSetScheme, std::string("loop")},
           {kSetSchemeLevel, 2},
           {kSetSecondScheme, std::string("linear")},
           kShowBoth});
  EXPECT_TRUE(test::matches_golden(desk_.viewport_of(desk_.picture()), "side_by_side_dark"));
  perform({kThemeLight, kShowRefined, kToggleValences});
  EXPECT_TRUE(test::matches_golden(desk_.viewport_of(desk_.picture()), "side_by_side_light"));
}

TEST_F(ClassroomPicture, IrregularVerticesOfTheControlMesh) {
  perform({{kOpenBundled, std::string("creature")}, kToggleValences});
  EXPECT_TRUE(test::matches_golden(desk_.viewport_of(desk_.picture()), "valences_control"));
}

TEST_F(ClassroomPicture, TheEdgeUnderTheCursor) {
  perform({{kSetScheme, std::string("loop")}, {kSetSchemeLevel, 1}, kToolFlipEdge});
  static_cast<void>(desk_.picture());  // The camera has come to rest.
  desk_.point_at(ui::WindowPoint{380.0, 360.0});
  EXPECT_TRUE(test::matches_golden(desk_.viewport_of(desk_.picture()), "edge_highlighted"));
}

TEST_F(ClassroomPicture, EdgesAlone) {
  perform({{kToggleFaces, false}});
  EXPECT_TRUE(test::matches_golden(desk_.viewport_of(desk_.picture()), "edges_alone"));
}

}  // namespace
}  // namespace limn::app
