#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/live_refinement.h"
#include "limn/error.h"
#include "ui/gui.h"
#include "ui/model.h"
#include "ui/window_geometry.h"

namespace limn::app {

/// What a person has chosen once and finds again at the next start. Nothing of a document.
struct Preferences {
  /// Theme, wireframe, smooth, light, creases, live, material; the rest starts as default.
  ui::DisplaySettings display;
  ui::KeymapId keymap = ui::KeymapId::kOriginal;
  ui::NavigationSettings navigation;
  ui::BrushSettings brush;  ///< All but the tool.
  double dihedral_threshold = 30.0;
  double crease_sharpness = 2.0;
  ui::AutoDepthSettings auto_depth;  ///< Never live at a start.
  std::vector<RulePreset> presets;   ///< The person's own.
  bool uses_desktop_dialogs = true;  ///< Where there are any.
  bool shows_hints = false;          ///< True at the very first start.
  std::uint64_t face_budget = LiveRefinement::kDefaultBudget;
  ui::PanelLayout layout;
  ui::WindowSize window{1280.0, 800.0};  ///< Design units: before the monitor's scale.
  bool is_maximised = false;
  std::vector<std::string> recent_files;  ///< Absolute paths, newest first.

  [[nodiscard]] bool operator==(const Preferences&) const = default;
};

inline constexpr std::size_t kMostRecentFiles = 10;

/// Where they are kept: `preferences.json` in `config_folder()`. Empty where there is no folder.
[[nodiscard]] std::filesystem::path preferences_path();

/// The text of a preferences file, and what is read from it; as `save_preferences` and
/// `load_preferences`. `source` is for messages.
[[nodiscard]] std::string preferences_text(const Preferences& preferences);
[[nodiscard]] Result<Preferences> parse_preferences(std::string_view text,
                                                    const std::string& source);

/// Reads preferences; numbers out of range are brought into it, what is missing stays as default. A
/// file that is not there gives the defaults and, since nobody has been here before, the hints.
/// Errors: kBadInput where the file is not what `save_preferences` writes.
[[nodiscard]] Result<Preferences> load_preferences(const std::filesystem::path& path);

/// Writes them atomically, making the folder where needed. Errors: kFailed.
[[nodiscard]] Result<void> save_preferences(const std::filesystem::path& path,
                                            const Preferences& preferences);

/// Puts `file` first and forgets the oldest beyond kMostRecentFiles.
void remember_recent(std::vector<std::string>& recent, const std::string& file);

}  // namespace limn::app
