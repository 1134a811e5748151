// The illustrated guide: each picture is drawn by doing with the mouse what its section tells, and
// the keys in the text are those of the keymap, so that neither can go stale.
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/desk.h"
#include "app/fonts.h"
#include "app/steady_figures.h"
#include "support/image_compare.h"
#include "ui/action_table.h"
#include "ui/keymap.h"

namespace limn::app {
namespace {

using enum ui::ActionId;

struct Scene {
  const char* name;
  std::function<void(Desk&)> play;
};

void PrintTo(const Scene& scene, std::ostream* out) {
  *out << scene.name;
}

void fold_all(Desk& desk, bool ui::PanelLayout::*unfolded) {
  ui::PanelLayout layout;
  layout.paint_open = layout.subdivide_open = layout.display_open = layout.numbers_open = false;
  layout.*unfolded = true;
  desk.gui().set_layout(layout);
}

/// The dragon with a smoother head.
void paint_head(Desk& desk) {
  desk.session().perform(kRaiseAll);
  desk.drag({250.0, 330.0}, {390.0, 360.0});
  desk.drag({190.0, 400.0}, {330.0, 430.0});
}

const std::vector<Scene>& scenes() {
  static const std::vector<Scene> all{
      {"start", [](Desk&) {}},
      {"brush",
       [](Desk& desk) {
         desk.session().perform(kRaiseAll);
         desk.session().perform({kSetBrushRadius, 34.0});
         desk.press({230.0, 330.0});
         desk.point_at(ui::WindowPoint{300.0, 350.0});
         desk.point_at(ui::WindowPoint{370.0, 350.0});
       }},
      {"smart_fill",
       [](Desk& desk) {
         paint_head(desk);
         desk.session().perform(kToolSmartFill);
         desk.session().perform({kSetFillAngle, 60.0});
         desk.point_at(ui::WindowPoint{470.0, 360.0});
       }},
      {"rules",
       [](Desk& desk) {
         desk.session().perform(kRaiseVisible);
         desk.session().perform({kSetDihedralThreshold, 40.0});
         desk.session().perform(kRaiseDihedral);
         desk.session().perform(kGrowPainting);
       }},
      {"fine",
       [](Desk& desk) {
         desk.session().perform(kRaiseAll);
         desk.session().perform({kToggleFine, true});
         desk.session().perform({kSetBrushRadius, 20.0});
         desk.session().finish_refinement();
         for (int stroke = 0; stroke < 2; ++stroke) {
           desk.drag({250.0, 330.0}, {330.0, 345.0});
           desk.session().finish_refinement();
           desk.draw_frame();
         }
         desk.press({240.0, 400.0});
         desk.point_at(ui::WindowPoint{300.0, 400.0});
         desk.point_at(ui::WindowPoint{350.0, 390.0});
       }},
      {"auto_depth",
       [](Desk& desk) {
         fold_all(desk, &ui::PanelLayout::auto_depth_open);
         desk.session().perform({kSetDepthRules, std::string("tolerance=0.002d")});
         desk.session().perform(kChooseDepths);
       }},
      {"curve",
       [](Desk& desk) {
         fold_all(desk, &ui::PanelLayout::auto_depth_open);
         desk.session().perform({kSetDepthRules, std::string("curve=curvature,20/0,60/2,120/3")});
         desk.session().perform({kToggleLiveDepths, true});
       }},
      {"distance",
       [](Desk& desk) {
         fold_all(desk, &ui::PanelLayout::numbers_open);
         paint_head(desk);
         desk.session().perform(kTintDistance);
       }},
      {"cage",
       [](Desk& desk) {
         fold_all(desk, &ui::PanelLayout::display_open);
         desk.session().perform({kOpenBundled, std::string("mixed")});
         desk.session().perform(kRaiseAll);
         desk.session().perform(kRaiseVisible);
         desk.session().perform(kShowBoth);
       }},
      {"uniform",
       [](Desk& desk) {
         fold_all(desk, &ui::PanelLayout::numbers_open);
         desk.drag({250.0, 330.0}, {390.0, 360.0});
         desk.drag({190.0, 400.0}, {330.0, 430.0});
         desk.drag({250.0, 330.0}, {390.0, 360.0});
         desk.session().perform(kCompareUniform);
       }},
      {"steps",
       [](Desk& desk) {
         fold_all(desk, &ui::PanelLayout::steps_open);
         desk.session().perform({kOpenBundled, std::string("teapot")});
         desk.session().perform(kLegaliseGreedy);
         desk.drag({260.0, 300.0}, {420.0, 330.0});
         desk.session().perform({kToggleSteps, true});
         desk.session().finish_refinement();
         desk.session().perform(kStepNext);
         desk.session().perform(kStepNext);
       }},
      {"history",
       [](Desk& desk) {
         fold_all(desk, &ui::PanelLayout::history_open);
         paint_head(desk);
         desk.session().perform(kRaiseDihedral);
         desk.session().perform(kRaiseVisible);
         desk.session().perform(kUndo);
       }},
      {"schemes",
       [](Desk& desk) {
         fold_all(desk, &ui::PanelLayout::schemes_open);
         desk.session().perform({kOpenBundled, std::string("icosahedron")});
         desk.session().perform({kSetScheme, std::string("loop")});
         desk.session().perform({kSetSchemeLevel, 2});
         desk.session().perform(kShowBoth);
         desk.session().perform(kToggleValences);
       }},
  };
  return all;
}

class GuidePicture : public testing::TestWithParam<Scene> {};

TEST_P(GuidePicture, IsWhatTheProgramShows) {
  Desk desk({1000, 640}, load_fonts());
  SteadyFigures figures;
  desk.adjust_model([&](ui::Model& model) { figures(model); });
  static_cast<void>(desk.picture());
  GetParam().play(desk);
  EXPECT_TRUE(
      test::matches_picture(desk.picture(), std::string("docs/guide/") + GetParam().name + ".png"));
}

INSTANTIATE_TEST_SUITE_P(Scenes, GuidePicture, testing::ValuesIn(scenes()),
                         [](const auto& scene) { return std::string(scene.param.name); });

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

/// "`Ctrl+Z` or `B`" of the action whose enumerator is written in the text.
std::string keys_of(const std::string& word) {
  static const std::vector<std::pair<std::string, ui::Action>> all{
      {"kHelp", kHelp},
      {"kBrushSmaller", kBrushSmaller},
      {"kBrushBigger", kBrushBigger},
      {"kPickDepth", kPickDepth},
      {"kUndo", kUndo},
      {"kRedo", kRedo},
      {"kToolFill", kToolFill},
      {"kToolSmartFill", kToolSmartFill},
      {"kToolRectangle", kToolRectangle},
      {"kToolLasso", kToolLasso},
      {"kTogglePaintThrough", kTogglePaintThrough},
      {"kToggleFine", kToggleFine},
      {"kToggleMirrorX", kToggleMirrorX},
      {"kToggleMirrorY", kToggleMirrorY},
      {"kToggleMirrorZ", kToggleMirrorZ},
      {"kRaiseVisible", kRaiseVisible},
      {"kRaiseDihedral", kRaiseDihedral},
      {"kChooseDepths", kChooseDepths},
      {"kGrowPainting", kGrowPainting},
      {"kShrinkPainting", kShrinkPainting},
      {"kSmoothPainting", kSmoothPainting},
      {"kShowControl", kShowControl},
      {"kShowRefined", kShowRefined},
      {"kShowBoth", kShowBoth},
      {"kTintDepth", kTintDepth},
      {"kTintLevel", kTintLevel},
      {"kTintNone", kTintNone},
      {"kTintDistance", kTintDistance},
      {"kCompareUniform", kCompareUniform},
      {"kStepNext", kStepNext},
      {"kStepPrevious", kStepPrevious},
      {"kSaveProject", kSaveProject},
      {"kExportRefined", kExportRefined},
      {"kSchemeForward", kSchemeForward},
      {"kSchemeBack", kSchemeBack}};
  for (const auto& [name, action] : all) {
    if (name == word) {
      const std::string keys = ui::key_text(ui::KeymapId::kOriginal, action);
      EXPECT_FALSE(keys.empty()) << word << " has no key to tell";
      return '`' + keys + '`';
    }
  }
  ADD_FAILURE() << "the guide's text has {" << word << "}, which stands for nothing";
  return {};
}

std::string filled(std::string text) {
  for (std::size_t at = text.find('{'); at != std::string::npos; at = text.find('{', at)) {
    const std::size_t end = text.find('}', at);
    text.replace(at, end + 1 - at, keys_of(text.substr(at + 1, end - at - 1)));
  }
  return text;
}

TEST(GuideText, NamesTheKeysThatThereAreAndThePicturesThatAreDrawn) {
  const std::filesystem::path docs = std::filesystem::path(test::source_folder()) / "docs";
  const std::string text = filled(read(docs / "guide" / "guide.md.in"));
  std::set<std::string> shown;
  const std::string before = "(guide/";
  for (std::size_t at = text.find(before); at != std::string::npos;
       at = text.find(before, at + 1)) {
    const std::size_t start = at + before.size();
    shown.insert(text.substr(start, text.find(".png)", start) - start));
  }
  std::set<std::string> drawn;
  for (const Scene& scene : scenes()) {
    drawn.insert(scene.name);
  }
  EXPECT_EQ(shown, drawn);
  if (test::is_updating_goldens()) {
    std::ofstream(docs / "guide.md", std::ios::binary) << text;
  }
  EXPECT_EQ(read(docs / "guide.md"), text) << "scripts/guide.sh writes it anew";
}

}  // namespace
}  // namespace limn::app
