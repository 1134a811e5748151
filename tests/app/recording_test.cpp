// What a recording holds, and that playing it back does it again: with workers that take their
// time, files that are read, and files that must not be written.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/fonts.h"
#include "app/offscreen.h"
#include "app/recording/play.h"
#include "app/recording/recorder.h"
#include "limn/document/open.h"
#include "render/context/load_gl.h"
#include "support/scratch_folder.h"

namespace limn::app {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
namespace fs = std::filesystem;

std::string all_bytes() {
  std::string bytes;
  for (int byte = 0; byte < 256; ++byte) {
    bytes += static_cast<char>(byte);
  }
  return bytes;
}

RecordingHead some_head() {
  RecordingHead head;
  head.program = "limn 9";
  head.renderer = "a card";
  head.input = "bäh.obj";
  head.screen = {{640.0, 480.0}, {1280, 960}, {1.5, 2.0}};
  head.preferences.keymap = ui::KeymapId::kClassroom;
  head.preferences.brush.radius = 33.25;
  head.memory_budget = std::uint64_t{1} << 40U;
  head.files = {OpenedFile{"bäh.obj", all_bytes()}, OpenedFile{"cube", std::nullopt}};
  return head;
}

RecordedTurn some_turn() {
  using namespace ui;
  RecordedTurn turn;
  turn.time = 0.1 + 0.2;
  turn.screen = Screen{{800.5, 600.0}, {800, 600}, {1.0, 1.0}};
  turn.events = {{0.25, {}, MouseMoved{{1.0 / 3.0, -2.0}}},
                 {0.25, {.shift = true, .alt = true}, ButtonChanged{MouseButton::kMiddle, true}},
                 {0.26, {.ctrl = true, .super = true}, WheelTurned{0.0, -1.5}},
                 {0.27, {}, KeyChanged{Key::kLeftBracket, true, true}},
                 {0.28, {}, TextTyped{U'é'}},
                 {0.28, {}, MouseLeft{}},
                 {0.29, {}, FocusLost{}}};
  turn.news.dropped_files = {"/tmp/a b.obj"};
  turn.news.close_requested = true;
  turn.news.moved_under_alt = true;
  turn.news.chosen = {PathPrompt::Purpose::kSaveProject, "/tmp/c.limn"};
  turn.arrivals = {{"refinement", 2}, {"sphere", 1}};
  turn.files = {ImportedFile{"x.ply", "\xFF"},
                WrittenFile{"y.limn", std::nullopt},
                WrittenFile{"z.limn", "no room"},
                ListedFolder{"/home", "/", {{"a", true, 0}, {"b.obj", false, 7}}, ""},
                FoundPath{"/here"},
                ReadClipboard{"pasted"}};
  turn.exports = {{"out.obj", std::nullopt}};
  turn.has_frame = true;
  turn.actions = {"Raise all", "Target depth: 3"};
  turn.document = "0123456789abcdef";
  turn.picture = 4'000'000'000U;
  return turn;
}

TEST(Recording, ReadsWhatItWrites) {
  const RecordingHead head = some_head();
  const RecordedTurn turn = some_turn();
  const auto read = parse_recording(head_line(head) + turn_line(turn) + end_line(), "r");
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_TRUE(read->is_whole);
  EXPECT_EQ(read->head.program, head.program);
  EXPECT_EQ(read->head.renderer, head.renderer);
  EXPECT_EQ(read->head.input, head.input);
  EXPECT_EQ(read->head.screen, head.screen);
  EXPECT_EQ(read->head.preferences.keymap, head.preferences.keymap);
  EXPECT_EQ(read->head.preferences.brush.radius, head.preferences.brush.radius);
  EXPECT_EQ(read->head.memory_budget, head.memory_budget);
  EXPECT_EQ(read->head.files, head.files);
  ASSERT_EQ(read->turns.size(), 1u);
  const RecordedTurn& again = read->turns.front();
  EXPECT_EQ(again.time, turn.time);
  EXPECT_EQ(again.screen, turn.screen);
  EXPECT_EQ(again.events, turn.events);
  EXPECT_EQ(again.news.dropped_files, turn.news.dropped_files);
  EXPECT_TRUE(again.news.close_requested && again.news.moved_under_alt && again.has_frame);
  ASSERT_TRUE(again.news.chosen);
  EXPECT_EQ(again.news.chosen->purpose, turn.news.chosen->purpose);
  EXPECT_EQ(again.news.chosen->path, turn.news.chosen->path);
  EXPECT_EQ(again.arrivals, turn.arrivals);
  EXPECT_EQ(again.files, turn.files);
  EXPECT_EQ(again.exports, turn.exports);
  EXPECT_EQ(again.actions, turn.actions);
  EXPECT_EQ(again.document, turn.document);
  EXPECT_EQ(again.picture, turn.picture);
}

TEST(Recording, EndsWhereACrashCutItOff) {
  const std::string whole =
      head_line(some_head()) + turn_line(some_turn()) + turn_line(some_turn());
  const auto read = parse_recording(whole.substr(0, whole.size() - 10), "r");
  ASSERT_TRUE(read);
  EXPECT_FALSE(read->is_whole);
  EXPECT_EQ(read->turns.size(), 1u);
}

TEST(Recording, SaysWhichLineIsNone) {
  const std::string head = head_line(some_head());
  const auto error_of = [](const std::string& text) {
    const auto read = parse_recording(text, "r");
    EXPECT_FALSE(read);
    return read ? Error{} : read.error();
  };
  EXPECT_EQ(error_of("").kind, ErrorKind::kBadInput);
  EXPECT_EQ(error_of("v 1 2 3\n").line, 1u);
  EXPECT_THAT(error_of("v 1 2 3\n").message, HasSubstr("no recording"));
  EXPECT_THAT(error_of(head + "{\"t\":\n").message, HasSubstr("damaged"));
  EXPECT_EQ(error_of(head + "{\"t\":0}\n{\"t\":\"x\"}\n").line, 3u);
  EXPECT_EQ(error_of(head + R"({"t":0,"events":[[0,"",["key","Hyper",true,false]]]})" + "\n").line,
            2u);
  EXPECT_EQ(error_of(head + R"({"t":0,"screen":[0,0,0,0,0,0]})" + "\n").line, 2u);
  EXPECT_EQ(error_of(head + R"({"t":0,"files":[["steal","x"]]})" + "\n").line, 2u);
  EXPECT_THAT(error_of(R"({"limn_recording":99})"
                       "\n")
                  .message,
              HasSubstr("format 99"));
}

/// A run of the program without a window that is written down.
class RecordingTest : public testing::Test {
 protected:
  RecordingTest() {
    setenv("XDG_PICTURES_DIR", folder_.path().c_str(), 1);
    std::ofstream(mesh_) << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    auto recorder = Recorder::create(file_);
    EXPECT_TRUE(recorder);
    recorder_ = *std::move(recorder);
    const Screen screen{{800.0, 600.0}, {800, 600}, {1.0, 1.0}};
    Project project = *recorder_->open("creature");
    offscreen_ = std::make_unique<Offscreen>(WorkbenchHost{.wake = [] {},
                                                           .fonts = load_fonts(),
                                                           .files = recorder_.get(),
                                                           .arrivals = recorder_.get()},
                                             Preferences{}, std::move(project), screen);
    session().set_memory_budget(std::uint64_t{1} << 32U);
    recorder_->begin({.program = "test",
                      .renderer = render::renderer_text(),
                      .fonts = checksum_of(load_fonts()),
                      .input = "creature",
                      .project = {},
                      .screen = screen,
                      .preferences = offscreen_->workbench().preferences(),
                      .memory_budget = std::uint64_t{1} << 32U});
  }

  ~RecordingTest() override { unsetenv("XDG_PICTURES_DIR"); }

  [[nodiscard]] Session& session() { return offscreen_->workbench().session(); }

  void push(decltype(ui::InputEvent::what) what, ui::Modifiers modifiers = {}) {
    const ui::InputEvent event{time_ += 0.004, modifiers, what};
    recorder_->add(event);
    queue_.push(event);
  }

  void turn(const Workbench::News& news = {}) {
    time_ += 0.016;
    recorder_->begin_turn(news, time_);
    static_cast<void>(offscreen_->workbench().take_news(news, time_));
    const Workbench::Frame frame = offscreen_->frame(queue_.next_frame(), time_);
    recorder_->add_frame(offscreen_->screen(), frame);
    recorder_->end_turn(offscreen_->workbench());
  }
  void turns_until_rest() {
    do {
      turn();
    } while (queue_.has_pending() || session().is_busy());
  }

  void key(ui::Key which, ui::Modifiers modifiers = {}) {
    push(ui::KeyChanged{which, true, false}, modifiers);
    push(ui::KeyChanged{which, false, false}, modifiers);
    turn();
    turn();
  }
  void drag(ui::MouseButton button, ui::WindowPoint from, ui::WindowPoint to,
            ui::Modifiers modifiers = {}) {
    push(ui::MouseMoved{from});
    push(ui::ButtonChanged{button, true}, modifiers);
    turn();
    turn();
    push(ui::MouseMoved{{(from.x + to.x) / 2.0, (from.y + to.y) / 2.0}}, modifiers);
    turn();
    push(ui::MouseMoved{to}, modifiers);
    push(ui::ButtonChanged{button, false}, modifiers);
    turn();
    turn();
  }

  /// Types a path into the prompt that is open.
  void answer_path(const fs::path& path) {
    turn();
    key(ui::Key::kA, {.ctrl = true});
    for (const char c : path.string()) {
      push(ui::TextTyped{static_cast<char32_t>(c)});
    }
    turn();
    key(ui::Key::kEnter);
    turns_until_rest();
  }

  Recording finish() {
    recorder_->end(offscreen_->workbench());
    document_ = checksum_of(session().document());
    offscreen_.reset();
    recorder_.reset();
    std::ifstream file(file_, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(file), {});
    auto recording = parse_recording(text, file_.string());
    EXPECT_TRUE(recording) << to_string(recording.error());
    return recording.value_or(Recording{});
  }

  /// Plays it back to the same document.
  void expect_done_again(const Recording& recording) const {
    IgnoreProgress ignore;
    const auto played = play_headless(recording, {}, ignore);
    ASSERT_TRUE(played) << to_string(played.error());
    EXPECT_THAT(played->report.differences, IsEmpty());
    EXPECT_EQ(checksum_of(played->document), document_);
  }

  test::ScratchFolder folder_;
  fs::path file_ = folder_ / "run.limnrec";
  fs::path mesh_ = folder_ / "quad.obj";
  std::unique_ptr<Recorder> recorder_;
  std::unique_ptr<Offscreen> offscreen_;
  ui::InputQueue queue_;
  double time_ = 0.0;
  std::string document_;  ///< At the end.
};

TEST_F(RecordingTest, WhatWasDoneIsDoneAgain) {
  std::mt19937 random(4);
  const auto somewhere = [&] {
    return ui::WindowPoint{60.0 + static_cast<double>(random() % 400),
                           60.0 + static_cast<double>(random() % 480)};
  };
  for (int i = 0; i < 12; ++i) {
    drag(ui::MouseButton::kLeft, somewhere(), somewhere(), {.shift = random() % 4 == 0});
    if (random() % 3 == 0) {
      drag(ui::MouseButton::kMiddle, somewhere(), somewhere());
    }
    if (random() % 3 == 0) {
      key(ui::Key::kZ, {.ctrl = true});
    }
    if (random() % 2 == 0) {
      turns_until_rest();
    }
  }
  key(ui::Key::kK);
  key(ui::Key::kC);
  turns_until_rest();
  const Recording recording = finish();
  EXPECT_TRUE(recording.is_whole);

  IgnoreProgress ignore;
  const auto played = play_headless(recording, {}, ignore);
  ASSERT_TRUE(played) << to_string(played.error());
  EXPECT_THAT(played->report.differences, IsEmpty());
  EXPECT_EQ(checksum_of(played->document), document_);
  EXPECT_EQ(played->report.turns, recording.turns.size());
  EXPECT_GT(played->report.documents, 10u);
  EXPECT_TRUE(played->compared_pictures);
  EXPECT_GE(played->report.pictures, 1u);
}

TEST_F(RecordingTest, FineStrokesAreDoneAgain) {
  std::mt19937 random(9);
  const auto somewhere = [&] {
    return ui::WindowPoint{160.0 + static_cast<double>(random() % 180),
                           200.0 + static_cast<double>(random() % 180)};
  };
  turn({.dropped_files = {mesh_}});
  turns_until_rest();
  for (int level = 0; level < 4; ++level) {
    key(ui::Key::kA);
  }
  key(ui::Key::kY);
  turns_until_rest();
  for (int i = 0; i < 8; ++i) {
    drag(ui::MouseButton::kLeft, somewhere(), somewhere(), {.shift = i % 4 == 3});
    if (i % 3 == 2) {
      turns_until_rest();  // The other strokes begin while the mesh is refined.
    }
  }
  turns_until_rest();
  EXPECT_GT(session().document().demands.size(), 20u);
  expect_done_again(finish());
}

TEST_F(RecordingTest, FilesAreReadFromTheRecordingAndNoneIsWritten) {
  turn({.dropped_files = {mesh_}});
  turns_until_rest();
  EXPECT_EQ(session().document().control->face_count(), 1u);
  key(ui::Key::kA);
  key(ui::Key::kS, {.ctrl = true});
  answer_path(folder_ / "saved.limn");
  key(ui::Key::kE, {.ctrl = true});
  answer_path(folder_ / "out.obj");
  EXPECT_TRUE(fs::exists(folder_ / "saved.limn"));
  EXPECT_TRUE(fs::exists(folder_ / "out.obj"));
  Recording recording = finish();
  ASSERT_EQ(recording.turns.back().document, document_);

  fs::remove(mesh_);
  fs::remove(folder_ / "saved.limn");
  fs::remove(folder_ / "out.obj");
  IgnoreProgress ignore;
  const auto played = play_headless(recording, {}, ignore);
  ASSERT_TRUE(played) << to_string(played.error());
  EXPECT_THAT(played->report.differences, IsEmpty());
  EXPECT_EQ(played->document.control->face_count(), 1u) << "the file is in the recording";
  EXPECT_EQ(played->document.mesh_path, mesh_);
  EXPECT_FALSE(fs::exists(folder_ / "saved.limn"));
  EXPECT_FALSE(fs::exists(folder_ / "out.obj"));
}

TEST_F(RecordingTest, ChosenDepthsComeWhenTheyCame) {
  const fs::path roof = folder_ / "roof.obj";
  std::ofstream(roof) << "v 0 0 0\nv 1 0 1\nv 2 0 0\nv 0 1 0\nv 1 1 1\nv 2 1 0\n"
                         "f 1 2 5 4\nf 2 3 6 5\n";
  turn({.dropped_files = {roof}});
  turns_until_rest();
  key(ui::Key::kD, {.ctrl = true});
  turns_until_rest();
  EXPECT_GT(session().document().depths.deepest(), 0);
  key(ui::Key::kZ, {.ctrl = true});
  key(ui::Key::kD, {.ctrl = true});
  key(ui::Key::kA);
  turns_until_rest();
  expect_done_again(finish());
}

TEST_F(RecordingTest, AnotherRunIsToldApart) {
  key(ui::Key::kA);
  turns_until_rest();
  Recording recording = finish();
  for (RecordedTurn& turn : recording.turns) {
    for (ui::InputEvent& event : turn.events) {
      if (auto* change = std::get_if<ui::KeyChanged>(&event.what)) {
        change->key = ui::Key::kZ;
      }
    }
  }
  IgnoreProgress ignore;
  const auto played = play_headless(recording, {.patience = std::chrono::seconds(1)}, ignore);
  ASSERT_TRUE(played);
  EXPECT_THAT(played->report.differences, testing::Contains(HasSubstr("no news came")));
  EXPECT_THAT(played->report.differences, testing::Contains(HasSubstr("\"Raise all\"")));
  EXPECT_THAT(played->report.differences, testing::Contains(HasSubstr("the document is another")));
}

TEST_F(RecordingTest, PicturesComeOutAgain) {
  key(ui::Key::kF12);
  turns_until_rest();
  const Recording recording = finish();
  const fs::path pictures = folder_ / "pictures";
  fs::create_directories(pictures);
  IgnoreProgress ignore;
  const auto played = play_headless(recording, {pictures}, ignore);
  ASSERT_TRUE(played);
  EXPECT_THAT(played->report.differences, IsEmpty());
  EXPECT_EQ(played->report.pictures, 2u);
  EXPECT_EQ(std::distance(fs::directory_iterator(pictures), {}), 2);
}

TEST(Recorder, SaysWhereItCannotWrite) {
  const auto recorder = Recorder::create("/nowhere/at/all.limnrec");
  ASSERT_FALSE(recorder);
  EXPECT_EQ(recorder.error().path, "/nowhere/at/all.limnrec");
}

}  // namespace
}  // namespace limn::app
