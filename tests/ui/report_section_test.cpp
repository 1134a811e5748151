// What was mended on opening, as someone looks at it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ui/screen.h"

namespace limn::ui {
namespace {

using testing::ElementsAre;

TEST(ReportSection, MendedPlacesCanBeVisitedOneByOne) {
  Screen screen({1280, 1500});
  EXPECT_FALSE(screen.has("next of crowded_edges"));
  ImportReport& report = screen.document.import_report;
  report.has_places = true;
  report.add(MendKind::kFilledUv, 3);
  report.add(MendKind::kCrowdedEdge, MendedElement{0, {0, 1}, 41, glm::dvec3(0.0)});
  report.add(MendKind::kCrowdedEdge, MendedElement{1, {1, 2}, 47, glm::dvec3(1.0)});
  report.unused_data = {"12 normals"};
  screen.settle();
  EXPECT_FALSE(screen.has("next of filled_uvs"));  // They are not told one by one.
  EXPECT_FALSE(screen.has("previous of crowded_edges"));
  EXPECT_TRUE(screen.has("Not used: 12 normals."));
  screen.click("next of crowded_edges");
  const auto kind = static_cast<int>(MendKind::kCrowdedEdge);
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kNextMend, kind)));
  screen.model.mend_focus = MendFocus{MendKind::kCrowdedEdge, 0, glm::dvec3(0.0)};
  screen.settle();
  screen.click("previous of crowded_edges");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kPreviousMend, kind)));
}

}  // namespace
}  // namespace limn::ui
