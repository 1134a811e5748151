// What the help sheet says of the mouse is what the mouse does.
#include "ui/mouse_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limn::ui {
namespace {

using testing::Optional;

constexpr NavigationPreset kPresets[] = {NavigationPreset::kOriginal, NavigationPreset::kMouseOnly,
                                         NavigationPreset::kClassroom};

TEST(MouseMap, EveryLineOfTheHelpSheetIsTrue) {
  for (const NavigationPreset preset : kPresets) {
    std::size_t gesture = 0;
    for (const GestureLine& line : gesture_lines(preset)) {
      EXPECT_EQ(static_cast<std::size_t>(line.gesture), gesture++);
      EXPECT_FALSE(line.how.empty());
      ASSERT_GE(line.grip_count, 1U);
      for (std::size_t i = 0; i < line.grip_count; ++i) {
        EXPECT_THAT(camera_gesture(preset, line.grips[i]), Optional(line.gesture))
            << line.how << ", grip " << i;
      }
    }
  }
}

TEST(MouseMap, AltMeansTheSameUnderEveryPreset) {
  const Modifiers alt{.alt = true};
  for (const NavigationPreset preset : kPresets) {
    for (const bool is_beside : {false, true}) {
      const auto at = [&](MouseGrip grip) {
        grip.modifiers = alt;
        grip.is_beside_mesh = is_beside;
        return camera_gesture(preset, grip);
      };
      EXPECT_THAT(at({.left = true}), Optional(CameraGesture::kOrbit));
      EXPECT_THAT(at({.middle = true}), Optional(CameraGesture::kPan));
      EXPECT_THAT(at({.left = true, .right = true}), Optional(CameraGesture::kPan));
      EXPECT_THAT(at({.right = true}), Optional(CameraGesture::kZoom));
    }
  }
}

TEST(MouseMap, LeftOnTheMeshIsTheToolsUnderEveryPreset) {
  for (const NavigationPreset preset : kPresets) {
    for (const Modifiers held : {Modifiers{}, Modifiers{.shift = true}, Modifiers{.ctrl = true}}) {
      EXPECT_EQ(camera_gesture(preset, {.left = true, .modifiers = held}), std::nullopt);
    }
  }
}

TEST(MouseMap, LeftBesideTheMeshTurnsWhereNoKeyIsNeeded) {
  const MouseGrip beside{.left = true, .is_beside_mesh = true};
  EXPECT_EQ(camera_gesture(NavigationPreset::kOriginal, beside), std::nullopt);
  EXPECT_THAT(camera_gesture(NavigationPreset::kMouseOnly, beside),
              Optional(CameraGesture::kOrbit));
  MouseGrip lowering = beside;
  lowering.modifiers.shift = true;  // A stroke that begins beside the mesh and lowers.
  EXPECT_EQ(camera_gesture(NavigationPreset::kMouseOnly, lowering), std::nullopt);
}

TEST(MouseMap, LeftTurnsAndWithShiftPansWhereItIsFree) {
  for (const NavigationPreset preset : kPresets) {
    EXPECT_THAT(camera_gesture(preset, {.left = true, .is_left_free = true}),
                Optional(CameraGesture::kOrbit));
    EXPECT_THAT(
        camera_gesture(preset, {.left = true, .modifiers = {.shift = true}, .is_left_free = true}),
        Optional(CameraGesture::kPan));
  }
}

TEST(MouseMap, PresetsDifferInTheirButtons) {
  const auto gestures = [](NavigationPreset preset) {
    return std::pair(camera_gesture(preset, {.right = true}),
                     camera_gesture(preset, {.middle = true}));
  };
  using Pair = std::pair<std::optional<CameraGesture>, std::optional<CameraGesture>>;
  EXPECT_EQ(gestures(NavigationPreset::kOriginal),
            Pair(CameraGesture::kOrbit, CameraGesture::kOrbit));
  EXPECT_EQ(gestures(NavigationPreset::kMouseOnly),
            Pair(CameraGesture::kOrbit, CameraGesture::kPan));
  EXPECT_EQ(gestures(NavigationPreset::kClassroom),
            Pair(CameraGesture::kPan, CameraGesture::kZoom));
}

TEST(MouseMap, HintsTellPresetsApart) {
  EXPECT_THAT(navigation_hint(NavigationPreset::kOriginal, false), testing::HasSubstr("Alt"));
  EXPECT_THAT(navigation_hint(NavigationPreset::kMouseOnly, false),
              testing::HasSubstr("beside the mesh"));
  EXPECT_THAT(navigation_hint(NavigationPreset::kClassroom, true),
              testing::StartsWith("Left drag: orbit"));
}

}  // namespace
}  // namespace limn::ui
