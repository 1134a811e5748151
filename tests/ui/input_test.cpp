#include "ui/input.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limn::ui {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Optional;

constexpr WindowPoint kA{10, 10};
constexpr WindowPoint kB{200, 100};

struct Feeder {
  InputQueue queue;
  double time = 0.0;
  Modifiers modifiers;

  template <class What>
  void operator()(What what) {
    time += 0.001;
    queue.push({time, modifiers, what});
  }
  void press(MouseButton button = MouseButton::kLeft) { (*this)(ButtonChanged{button, true}); }
  void release(MouseButton button = MouseButton::kLeft) { (*this)(ButtonChanged{button, false}); }
};

TEST(InputQueue, ClickOnAThenMoveToBOnASlowFrameIsAClickOnA) {
  Feeder feed;
  feed(MouseMoved{kA});
  feed.press();
  feed.release();
  feed(MouseMoved{kB});

  InputFrame frame = feed.queue.next_frame();
  EXPECT_THAT(frame.cursor, Optional(kA));
  EXPECT_THAT(frame.button, Optional(ButtonChanged{MouseButton::kLeft, true}));
  EXPECT_TRUE(frame.is_down(MouseButton::kLeft));
  EXPECT_TRUE(feed.queue.has_pending());

  frame = feed.queue.next_frame();
  EXPECT_THAT(frame.cursor, Optional(kA));
  EXPECT_THAT(frame.button, Optional(ButtonChanged{MouseButton::kLeft, false}));
  EXPECT_FALSE(frame.is_down(MouseButton::kLeft));

  frame = feed.queue.next_frame();
  EXPECT_THAT(frame.cursor, Optional(kB));
  EXPECT_EQ(frame.button, std::nullopt);
  EXPECT_FALSE(feed.queue.has_pending());
}

TEST(InputQueue, MovesBetweenButtonChangesAreOnePath) {
  Feeder feed;
  feed(MouseMoved{{1, 1}});
  feed.press();
  feed(MouseMoved{{2, 1}});
  feed(MouseMoved{{3, 1}});
  feed(MouseMoved{{3, 1}});
  feed.release();
  EXPECT_THAT(feed.queue.next_frame().path, ElementsAre(WindowPoint{1, 1}));
  const InputFrame drag = feed.queue.next_frame();
  EXPECT_THAT(drag.path, ElementsAre(WindowPoint{2, 1}, WindowPoint{3, 1}));
}

TEST(InputQueue, ADragIsStillHeldWhereItsLastMoveEnds) {
  // A slider that sees the release together with the last move stays where it was before.
  Feeder feed;
  feed(MouseMoved{{1, 1}});
  feed.press();
  feed(MouseMoved{{2, 1}});
  feed.release();
  (void)feed.queue.next_frame();
  const InputFrame held = feed.queue.next_frame();
  EXPECT_EQ(held.cursor, (WindowPoint{2, 1}));
  EXPECT_TRUE(held.is_down(MouseButton::kLeft));
  EXPECT_EQ(held.button, std::nullopt);
  EXPECT_TRUE(feed.queue.has_pending());
  const InputFrame released = feed.queue.next_frame();
  EXPECT_EQ(released.cursor, (WindowPoint{2, 1}));
  EXPECT_THAT(released.button, Optional(ButtonChanged{MouseButton::kLeft, false}));
}

TEST(InputQueue, ModifiersAreThoseOfTheButtonChange) {
  Feeder feed;
  feed.modifiers.shift = true;
  feed.press();
  feed.modifiers.shift = false;
  feed(MouseMoved{kB});
  EXPECT_TRUE(feed.queue.next_frame().modifiers.shift);
  EXPECT_FALSE(feed.queue.next_frame().modifiers.shift);
}

TEST(InputQueue, AFrameWithoutEventsKeepsTheState) {
  Feeder feed;
  feed(MouseMoved{kA});
  feed.press();
  (void)feed.queue.next_frame();
  const InputFrame idle = feed.queue.next_frame();
  EXPECT_THAT(idle.cursor, Optional(kA));
  EXPECT_TRUE(idle.is_down(MouseButton::kLeft));
  EXPECT_EQ(idle.button, std::nullopt);
  EXPECT_THAT(idle.path, IsEmpty());
}

TEST(InputQueue, AKeyTappedWithinOneFrameIsSeenDownAndThenUp) {
  Feeder feed;
  feed(KeyChanged{Key::kEnter, true});
  feed(KeyChanged{Key::kEnter, false});
  const auto enter = static_cast<std::size_t>(Key::kEnter);
  InputFrame frame = feed.queue.next_frame();
  EXPECT_THAT(frame.presses, ElementsAre(KeyPress{Key::kEnter, {}, false}));
  EXPECT_TRUE(frame.keys_down.test(enter));
  frame = feed.queue.next_frame();
  EXPECT_THAT(frame.presses, IsEmpty());
  EXPECT_FALSE(frame.keys_down.test(enter));
}

TEST(InputQueue, TypingKeepsItsOrderAcrossFrames) {
  Feeder feed;
  for (const char32_t c : std::u32string_view(U"aab")) {
    const Key key = c == U'a' ? Key::kA : Key::kB;
    feed(KeyChanged{key, true});
    feed(TextTyped{c});
    feed(KeyChanged{key, false});
  }
  std::u32string typed;
  int presses = 0;
  while (feed.queue.has_pending()) {
    const InputFrame frame = feed.queue.next_frame();
    typed += frame.text;
    presses += static_cast<int>(frame.presses.size());
  }
  EXPECT_EQ(typed, U"aab");
  EXPECT_EQ(presses, 3);
}

TEST(InputQueue, WheelNotchesAddUp) {
  Feeder feed;
  feed(WheelTurned{0, 1});
  feed(MouseMoved{kA});
  feed(WheelTurned{0.5, 2});
  EXPECT_EQ(feed.queue.next_frame().wheel, (WheelTurned{0.5, 3}));
  EXPECT_EQ(feed.queue.next_frame().wheel, (WheelTurned{}));
}

TEST(InputQueue, LosingTheFocusLetsGoOfEverything) {
  Feeder feed;
  feed(KeyChanged{Key::kA, true});
  feed.press();
  feed.press(MouseButton::kMiddle);
  feed(FocusLost{});
  InputFrame last;
  while (feed.queue.has_pending()) {
    last = feed.queue.next_frame();
  }
  EXPECT_FALSE(last.any_button_down());
  EXPECT_TRUE(last.keys_down.none());
}

TEST(InputQueue, ARepeatedReleaseIsNoChange) {
  Feeder feed;
  feed.release();
  EXPECT_EQ(feed.queue.next_frame().button, std::nullopt);
}

TEST(InputQueue, TheCursorIsNowhereAfterLeavingTheWindow) {
  Feeder feed;
  feed(MouseMoved{kA});
  feed(MouseLeft{});
  EXPECT_EQ(feed.queue.next_frame().cursor, std::nullopt);
}

TEST(InputRouter, ADragBelongsToTheViewportUntilItsLastButtonIsReleased) {
  Feeder feed;
  InputRouter router;
  feed(MouseMoved{kA});
  feed.press();
  EXPECT_TRUE(router.route(feed.queue.next_frame(), true).owns_drag);

  feed(MouseMoved{kB});
  ViewportInput input = router.route(feed.queue.next_frame(), false);
  EXPECT_TRUE(input.owns_drag);
  EXPECT_THAT(input.path, ElementsAre(kB));

  feed.release();
  input = router.route(feed.queue.next_frame(), false);
  EXPECT_TRUE(input.owns_drag);
  EXPECT_THAT(input.button, Optional(ButtonChanged{MouseButton::kLeft, false}));
  EXPECT_FALSE(router.route(feed.queue.next_frame(), false).owns_drag);
}

TEST(InputRouter, ADragThatBeganOnAPanelNeverReachesTheViewport) {
  Feeder feed;
  InputRouter router;
  feed(MouseMoved{kA});
  feed.press();
  feed(MouseMoved{kB});
  feed(WheelTurned{0, 1});
  feed.press(MouseButton::kRight);
  feed.release(MouseButton::kRight);
  feed.release();
  bool is_over_viewport = false;
  while (feed.queue.has_pending()) {
    const ViewportInput input = router.route(feed.queue.next_frame(), is_over_viewport);
    is_over_viewport = true;
    EXPECT_FALSE(input.owns_drag);
    EXPECT_FALSE(input.is_hovered);
    EXPECT_EQ(input.button, std::nullopt);
    EXPECT_THAT(input.path, IsEmpty());
    EXPECT_EQ(input.wheel, (WheelTurned{}));
  }
  feed.press();
  EXPECT_TRUE(router.route(feed.queue.next_frame(), true).owns_drag);
}

TEST(InputRouter, HoveringReportsThePathAndTheWheel) {
  Feeder feed;
  InputRouter router;
  feed(MouseMoved{kA});
  feed(WheelTurned{0, -1});
  const ViewportInput input = router.route(feed.queue.next_frame(), true);
  EXPECT_TRUE(input.is_hovered);
  EXPECT_FALSE(input.owns_drag);
  EXPECT_THAT(input.path, ElementsAre(kA));
  EXPECT_EQ(input.wheel.y, -1);
}

}  // namespace
}  // namespace limn::ui
