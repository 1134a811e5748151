// Pictures of the whole window as a person sees it: both themes, at 100 and 200 per cent, every
// panel unfolded, every dialog. Drawn with the typeface that comes with the program's packages.
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/desk.h"
#include "app/fonts.h"
#include "app/steady_figures.h"
#include "support/image_compare.h"

namespace limn::app {
namespace {

using enum ui::ActionId;

class WindowPicture : public testing::Test {
 protected:
  explicit WindowPicture(ui::WindowSize size = {1280, 800}, double scale = 1.0)
      : desk_(size, load_fonts(), scale) {
    desk_.adjust_model([this](ui::Model& model) { figures_(model); });
    // A dragon whose head is smoother than the rest of it, and its ears sharper still.
    desk_.draw_frame();
    desk_.session().perform(kRaiseAll);
    desk_.session().perform(kRaiseVisible);
    desk_.session().perform({kSetDihedralThreshold, 45.0});
    desk_.session().perform(kRaiseDihedral);
    desk_.session().perform(kToggleCreases);
  }

  void light() { desk_.session().perform(kThemeLight); }

  SteadyFigures figures_;
  Desk desk_;
};

/// The first that anyone sees of Limn.
TEST_F(WindowPicture, Dark) {
  EXPECT_TRUE(test::matches_picture(desk_.picture(), "docs/window.png"));
}

TEST_F(WindowPicture, Light) {
  light();
  EXPECT_TRUE(test::matches_golden(desk_.picture(), "window_light"));
}

/// 800 x 600, the smallest window that all is made for, on a monitor at 200 per cent.
class DoubledWindowPicture : public WindowPicture {
 protected:
  DoubledWindowPicture() : WindowPicture({1600, 1200}, 2.0) {}
};

TEST_F(DoubledWindowPicture, Dark) {
  EXPECT_TRUE(test::matches_golden(desk_.picture(), "window_doubled_dark"));
}

TEST_F(DoubledWindowPicture, Light) {
  light();
  EXPECT_TRUE(test::matches_golden(desk_.picture(), "window_doubled_light"));
}

struct Panel {
  const char* name;
  bool ui::PanelLayout::*is_open;
};

void PrintTo(const Panel& panel, std::ostream* out) {
  *out << panel.name;
}

class PanelPicture : public WindowPicture, public testing::WithParamInterface<Panel> {
 protected:
  PanelPicture() : WindowPicture({700, 900}) {
    ui::PanelLayout layout;
    layout.paint_open = layout.subdivide_open = layout.display_open = layout.numbers_open = false;
    layout.*GetParam().is_open = true;
    desk_.gui().set_layout(layout);
  }
};

TEST_P(PanelPicture, InBothThemes) {
  const std::string name = std::string("panel_") + GetParam().name;
  EXPECT_TRUE(test::matches_golden(desk_.panel_of(desk_.picture()), name + "_dark"));
  light();
  EXPECT_TRUE(test::matches_golden(desk_.panel_of(desk_.picture()), name + "_light"));
}

INSTANTIATE_TEST_SUITE_P(Panels, PanelPicture,
                         testing::Values(Panel{"paint", &ui::PanelLayout::paint_open},
                                         Panel{"auto_depth", &ui::PanelLayout::auto_depth_open},
                                         Panel{"subdivide", &ui::PanelLayout::subdivide_open},
                                         Panel{"display", &ui::PanelLayout::display_open},
                                         Panel{"numbers", &ui::PanelLayout::numbers_open},
                                         Panel{"history", &ui::PanelLayout::history_open}),
                         [](const auto& panel) { return std::string(panel.param.name); });

struct Dialog {
  const char* name;
  ui::Modal modal;
};

void PrintTo(const Dialog& dialog, std::ostream* out) {
  *out << dialog.name;
}

ui::Modal error_dialog() {
  return ui::ErrorDialog{"Cannot open spot.obj",
                         {ErrorKind::kBadInput,
                          "Face 12 names vertex 99, but there are only 42. The mesh that was open "
                          "stays.",
                          "/home/anna/meshes/spot.obj", 1204}};
}

ui::Modal path_prompt() {
  ui::PathPrompt prompt;
  prompt.purpose = ui::PathPrompt::Purpose::kOpen;
  prompt.serial = 1;
  prompt.folder = "/home/anna/meshes";
  prompt.parent = "/home/anna";
  prompt.entries = {{"characters", true, 0},
                    {"old", true, 0},
                    {"creature.limn", false, 81'234},
                    {"spot.obj", false, 1'204'511},
                    {"teapot.ply", false, 43'002}};
  return prompt;
}

class DialogPicture : public WindowPicture, public testing::WithParamInterface<Dialog> {
 protected:
  DialogPicture() : WindowPicture({960, 800}) {
    desk_.adjust_model([this](ui::Model& model) {
      figures_(model);
      model.modal = GetParam().modal;
    });
  }
};

TEST_P(DialogPicture, IsDrawnOverTheWindow) {
  EXPECT_TRUE(test::matches_golden(desk_.picture(), std::string("dialog_") + GetParam().name));
}

INSTANTIATE_TEST_SUITE_P(
    Dialogs, DialogPicture,
    testing::Values(Dialog{"help", ui::HelpSheet{}}, Dialog{"error", error_dialog()},
                    Dialog{"open", path_prompt()},
                    Dialog{"unsaved", ui::UnsavedQuestion{"creature", "open spot.obj"}}),
    [](const auto& dialog) { return std::string(dialog.param.name); });

}  // namespace
}  // namespace limn::app
