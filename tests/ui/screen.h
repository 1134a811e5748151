#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "limn/document/document.h"
#include "limn/mesh/statistics.h"
#include "limn/subdivision/crack_check.h"
#include "limn/subdivision/prediction.h"
#include "ui/gui.h"
#include "ui/input.h"
#include "ui/model.h"

namespace limn::ui {

/// A Gui without a window, and someone who sits before it: presses controls by their names, moves
/// the mouse, types. The model is theirs to change between frames.
class Screen {
 public:
  explicit Screen(WindowSize window = {1280, 800}, Scale scale = {}, FontFiles fonts = {});

  /// Runs frames until the queue is empty, one at least; collects what they emit.
  void settle();
  /// Runs one frame.
  const GuiFrame& frame();

  void move(WindowPoint to);
  void button(MouseButton which, bool is_down);
  void click(WindowPoint at);
  /// Presses the control of this name in its middle. The test fails where there is none.
  void click(std::string_view name);
  void key(Key which, Modifiers modifiers = {});
  void type(std::u32string_view text);
  void push(const InputEvent& event) { queue_.push(event); }

  [[nodiscard]] bool has(std::string_view name) const;
  [[nodiscard]] WindowRect rect(std::string_view name) const;
  [[nodiscard]] WindowPoint middle(std::string_view name) const;

  /// What was emitted since the last call.
  [[nodiscard]] std::vector<Action> take_actions();

  Gui& gui() { return gui_; }
  [[nodiscard]] const GuiFrame& last() const { return last_; }

  Document document;
  MeshStatistics statistics;
  RefinementPrediction prediction;
  CrackCheck cracks;
  std::vector<std::string> bundled{"creature", "cube", "teapot"};
  std::vector<std::string> recent;
  std::vector<Toast> toasts;
  Model model;
  WindowSize window;

 private:
  [[nodiscard]] InputEvent event(Modifiers modifiers = {});

  Gui gui_;
  InputQueue queue_;
  GuiFrame last_;
  std::vector<Action> actions_;
  double time_ = 0.0;
};

}  // namespace limn::ui
