#include "app/preferences.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/user_folders.h"
#include "limn/files/atomic_file.h"
#include "limn/painting/face_regions.h"

namespace limn::app {
namespace {

using Json = nlohmann::json;

/// Reads members of one JSON object into variables that keep their value where a member is missing.
/// Throws Json::exception where a member has the wrong type.
class Reader {
 public:
  explicit Reader(const Json& object) : object_(object) {
    if (!object.is_object()) {
      throw Json::type_error::create(302, "an object is expected", &object);
    }
  }

  template <class T>
  void read(const char* name, T& value) const {
    if (const auto found = object_.find(name); found != object_.end()) {
      value = found->get<T>();
    }
  }
  void read(const char* name, double& value, double low, double high) const {
    read(name, value);
    value = std::isfinite(value) ? std::clamp(value, low, high) : low;
  }
  /// An object that is missing reads as an empty one.
  [[nodiscard]] Reader child(const char* name) const {
    static const Json none = Json::object();
    const auto found = object_.find(name);
    return Reader(found == object_.end() ? none : *found);
  }

 private:
  const Json& object_;
};

constexpr std::array<std::string_view, 3> kPresetNames{"original", "mouse", "classroom"};

/// The first for a name that there is not.
ui::NavigationPreset preset_named(std::string_view name) {
  const auto found = std::ranges::find(kPresetNames, name);
  return found == kPresetNames.end()
             ? ui::NavigationPreset::kOriginal
             : static_cast<ui::NavigationPreset>(found - kPresetNames.begin());
}

constexpr std::array<std::string_view, 4> kMaterialNames{"studio", "clay", "dark", "shiny"};

ui::Material material_named(std::string_view name) {
  const auto found = std::ranges::find(kMaterialNames, name);
  return found == kMaterialNames.end() ? ui::Material::kStudio
                                       : static_cast<ui::Material>(found - kMaterialNames.begin());
}

void read_brush(const Reader& root, ui::BrushSettings& brush) {
  root.read("brush_radius", brush.radius, ui::kMinBrushRadius, ui::kMaxBrushRadius);
  const Reader settings = root.child("brush");
  settings.read("sets_depth", brush.sets_depth);
  settings.read("target_depth", brush.target_depth);
  brush.target_depth = std::clamp(brush.target_depth, 0, kMaxDepth);
  settings.read("fill_angle", brush.fill_angle, 0.0, kMostFillAngle);
  settings.read("through", brush.goes_through);
  settings.read("fine", brush.is_fine);
  settings.read("shift_draws_lines", brush.shift_draws_lines);
  settings.read("mirror_x", brush.mirror.x);
  settings.read("mirror_y", brush.mirror.y);
  settings.read("mirror_z", brush.mirror.z);
}

/// Rules that cannot be read, of a newer version perhaps, leave the default.
void read_auto_depth(const Reader& settings, ui::AutoDepthSettings& auto_depth) {
  std::string text;
  settings.read("rules", text);
  if (auto rules = parse_paint_rules(text, "preferences"); rules && !rules->empty()) {
    auto_depth.rules = *std::move(rules);
    if (const ChooseDepths* choose = auto_depth.choice()) {
      auto_depth.choices.at(choose->choice.index()) = choose->choice;
    }
  }
  settings.read("moves_to_limit", auto_depth.moves_to_limit);
}

std::vector<RulePreset> read_presets(const Json& root) {
  std::vector<RulePreset> presets;
  const auto found = root.find("presets");
  for (const Json& json : found != root.end() ? *found : Json::array()) {
    const Reader entry(json);
    RulePreset& preset = presets.emplace_back();
    entry.read("name", preset.name);
    entry.read("description", preset.description);
    entry.read("rules", preset.rules);
    if (!check_preset_name(preset.name)) {
      presets.pop_back();
    }
  }
  return presets;
}

Json presets_json(const std::vector<RulePreset>& presets) {
  Json list = Json::array();
  for (const RulePreset& preset : presets) {
    list.push_back(
        {{"name", preset.name}, {"description", preset.description}, {"rules", preset.rules}});
  }
  return list;
}

Preferences from_json(const Json& json) {
  Preferences preferences;
  const Reader root(json);
  std::string theme = "dark";
  root.read("theme", theme);
  preferences.display.theme = theme == "light" ? ui::Theme::kLight : ui::Theme::kDark;
  std::string keymap = "original";
  root.read("keymap", keymap);
  preferences.keymap = keymap == "classroom" ? ui::KeymapId::kClassroom : ui::KeymapId::kOriginal;

  const Reader navigation = root.child("navigation");
  std::string preset = keymap;
  navigation.read("preset", preset);
  preferences.navigation.preset = preset_named(preset);
  navigation.read("around_cursor", preferences.navigation.orbits_around_cursor);

  const Reader display = root.child("display");
  display.read("wireframe", preferences.display.wireframe);
  display.read("smooth", preferences.display.smooth);
  display.read("light", preferences.display.light);
  display.read("creases", preferences.display.creases);
  display.read("live", preferences.display.live);
  std::string material;
  display.read("material", material);
  preferences.display.material = material_named(material);

  read_brush(root, preferences.brush);
  root.read("dihedral_threshold", preferences.dihedral_threshold, 0.0, 180.0);
  root.read("crease_sharpness", preferences.crease_sharpness, 0.0, 10.0);
  read_auto_depth(root.child("auto_depth"), preferences.auto_depth);
  preferences.presets = read_presets(json);
  root.read("desktop_dialogs", preferences.uses_desktop_dialogs);
  root.read("hints", preferences.shows_hints);
  root.read("face_budget", preferences.face_budget);
  preferences.face_budget = std::max<std::uint64_t>(preferences.face_budget, 1000);

  const Reader panel = root.child("panel");
  panel.read("width", preferences.layout.panel_width, 200.0, 1000.0);
  panel.read("paint_open", preferences.layout.paint_open);
  panel.read("auto_depth_open", preferences.layout.auto_depth_open);
  panel.read("subdivide_open", preferences.layout.subdivide_open);
  panel.read("steps_open", preferences.layout.steps_open);
  panel.read("schemes_open", preferences.layout.schemes_open);
  panel.read("history_open", preferences.layout.history_open);
  panel.read("display_open", preferences.layout.display_open);
  panel.read("numbers_open", preferences.layout.numbers_open);
  panel.read("report_open", preferences.layout.report_open);

  const Reader window = root.child("window");
  window.read("width", preferences.window.width, 640.0, 16384.0);
  window.read("height", preferences.window.height, 400.0, 16384.0);
  window.read("maximised", preferences.is_maximised);

  root.read("recent_files", preferences.recent_files);
  preferences.recent_files.resize(std::min(preferences.recent_files.size(), kMostRecentFiles));
  return preferences;
}

Json to_json(const Preferences& preferences) {
  const ui::DisplaySettings& display = preferences.display;
  const ui::PanelLayout& layout = preferences.layout;
  return {
      {"theme", display.theme == ui::Theme::kLight ? "light" : "dark"},
      {"keymap", preferences.keymap == ui::KeymapId::kClassroom ? "classroom" : "original"},
      {"navigation",
       {{"preset", kPresetNames.at(static_cast<std::size_t>(preferences.navigation.preset))},
        {"around_cursor", preferences.navigation.orbits_around_cursor}}},
      {"display",
       {{"wireframe", display.wireframe},
        {"smooth", display.smooth},
        {"light", display.light},
        {"creases", display.creases},
        {"live", display.live},
        {"material", kMaterialNames.at(static_cast<std::size_t>(display.material))}}},
      {"brush_radius", preferences.brush.radius},
      {"brush",
       {{"sets_depth", preferences.brush.sets_depth},
        {"target_depth", preferences.brush.target_depth},
        {"fill_angle", preferences.brush.fill_angle},
        {"through", preferences.brush.goes_through},
        {"fine", preferences.brush.is_fine},
        {"shift_draws_lines", preferences.brush.shift_draws_lines},
        {"mirror_x", preferences.brush.mirror.x},
        {"mirror_y", preferences.brush.mirror.y},
        {"mirror_z", preferences.brush.mirror.z}}},
      {"dihedral_threshold", preferences.dihedral_threshold},
      {"crease_sharpness", preferences.crease_sharpness},
      {"auto_depth",
       {{"rules", ui::text_of(preferences.auto_depth.rules)},
        {"moves_to_limit", preferences.auto_depth.moves_to_limit}}},
      {"presets", presets_json(preferences.presets)},
      {"desktop_dialogs", preferences.uses_desktop_dialogs},
      {"hints", preferences.shows_hints},
      {"face_budget", preferences.face_budget},
      {"panel",
       {{"width", layout.panel_width},
        {"paint_open", layout.paint_open},
        {"auto_depth_open", layout.auto_depth_open},
        {"subdivide_open", layout.subdivide_open},
        {"steps_open", layout.steps_open},
        {"schemes_open", layout.schemes_open},
        {"history_open", layout.history_open},
        {"display_open", layout.display_open},
        {"numbers_open", layout.numbers_open},
        {"report_open", layout.report_open}}},
      {"window",
       {{"width", preferences.window.width},
        {"height", preferences.window.height},
        {"maximised", preferences.is_maximised}}},
      {"recent_files", preferences.recent_files},
  };
}

}  // namespace

std::filesystem::path preferences_path() {
  const std::filesystem::path folder = config_folder();
  return folder.empty() ? folder : folder / "preferences.json";
}

std::string preferences_text(const Preferences& preferences) {
  // Paths are bytes, not necessarily UTF-8; those that are not lose their odd characters here.
  return to_json(preferences).dump(2, ' ', false, Json::error_handler_t::replace);
}

Result<Preferences> parse_preferences(std::string_view text, const std::string& source) {
  try {
    return from_json(Json::parse(text));
  } catch (const Json::exception& error) {
    return fail(
        ErrorKind::kBadInput,
        fmt::format("The preferences cannot be read ({}); the defaults are used.", error.what()),
        source);
  }
}

Result<Preferences> load_preferences(const std::filesystem::path& path) {
  std::error_code ignored;
  if (path.empty() || !std::filesystem::exists(path, ignored)) {
    Preferences first;
    first.shows_hints = true;
    return first;
  }
  std::ifstream file(path, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  return parse_preferences(text, path.string());
}

Result<void> save_preferences(const std::filesystem::path& path, const Preferences& preferences) {
  std::error_code error;
  std::filesystem::create_directories(path.parent_path(), error);
  if (error) {
    return fail(ErrorKind::kFailed,
                fmt::format("The folder for preferences cannot be made: {}.", error.message()),
                path.parent_path().string());
  }
  const std::string text = preferences_text(preferences);
  return write_file_atomically(path, [&](std::ostream& out) { out << text << '\n'; });
}

void remember_recent(std::vector<std::string>& recent, const std::string& file) {
  std::erase(recent, file);
  recent.insert(recent.begin(), file);
  recent.resize(std::min(recent.size(), kMostRecentFiles));
}

}  // namespace limn::app
