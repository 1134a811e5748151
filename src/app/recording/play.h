#pragma once

#include <chrono>
#include <filesystem>

#include "app/recording/player.h"
#include "limn/document/document.h"
#include "limn/progress.h"

namespace limn::app {

struct PlayOptions {
  /// Pictures that the person took go here, and the window as it was at the end ("end.png"); empty:
  /// nowhere.
  std::filesystem::path pictures{};
  /// For a result that the recorded run had: where it does not come, the two runs differ.
  std::chrono::seconds patience{120};
};

/// What is there when everything was played.
struct Played {
  PlayReport report;
  Document document;
  ViewState view;
  bool compared_pictures = false;  ///< The driver is the recorded one.
  bool has_same_fonts = true;      ///< Otherwise controls may lie elsewhere.
};

/// Plays a recording without a window, as fast as it goes.
/// Errors: kCancelled; those of opening what the recording began with.
/// Throws render::EnvironmentError where there is no OpenGL.
[[nodiscard]] Result<Played> play_headless(Recording recording, const PlayOptions& options,
                                           Progress& progress);

/// The same in a window, as fast as it was done, times `speed`; Esc or closing the window ends it.
/// Pictures are not compared.
[[nodiscard]] Result<Played> play_in_window(Recording recording, double speed);

}  // namespace limn::app
