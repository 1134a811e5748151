// Bytes of files go into JSON strings one character a byte (U+0000 to U+00FF), so that text files
// can be read and any other is kept as well.
#include "app/recording/recording.h"

#include <array>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <zlib.h>
#include <nlohmann/json.hpp>

#include "limn/contract.h"
#include "limn/document/project_file.h"
#include "ui/action_table.h"
#include "ui/keymap.h"

namespace limn::app {
namespace {

using Line = nlohmann::ordered_json;  // One of the file's, or a part of it.

constexpr int kFormat = 1;

Line bytes_json(const std::optional<std::string>& bytes) {
  if (!bytes) {
    return nullptr;
  }
  std::string text;
  text.reserve(bytes->size());
  for (const char c : *bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80U) {
      text += c;
    } else {
      text += static_cast<char>(0xC0U | (byte >> 6U));
      text += static_cast<char>(0x80U | (byte & 0x3FU));
    }
  }
  return text;
}

std::optional<std::string> bytes_of(const Line& json) {
  if (json.is_null()) {
    return std::nullopt;
  }
  const auto& text = json.get_ref<const std::string&>();
  std::string bytes;
  bytes.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto first = static_cast<unsigned char>(text[i]);
    if (first < 0x80U || i + 1 == text.size()) {
      bytes += text[i];
    } else {
      const auto second = static_cast<unsigned char>(text[++i]);
      bytes += static_cast<char>((first & 0x03U) << 6U | (second & 0x3FU));
    }
  }
  return bytes;
}

/// Paths and clipboards are bytes, not necessarily UTF-8.
Line text_json(const std::string& text) {
  return bytes_json(text);
}
std::string text_of_json(const Line& json) {
  return bytes_of(json).value_or(std::string());
}
std::optional<std::string> optional_text(const Line& json) {
  return json.is_null() ? std::nullopt : std::optional(text_of_json(json));
}

Line screen_json(const Screen& screen) {
  return {screen.window.width,       screen.window.height,   screen.framebuffer.width,
          screen.framebuffer.height, screen.scale.interface, screen.scale.density};
}

Screen screen_of(const Line& json) {
  Screen screen;
  screen.window = {json.at(0), json.at(1)};
  screen.framebuffer = {json.at(2), json.at(3)};
  screen.scale = {json.at(4), json.at(5)};
  const auto is_size = [](double side) { return side >= 1.0 && side <= 65536.0; };
  if (!is_size(screen.framebuffer.width) || !is_size(screen.framebuffer.height) ||
      !is_size(screen.window.width) || !is_size(screen.window.height) ||
      !(screen.scale.interface >= 0.25 && screen.scale.interface <= 16.0) ||
      !(screen.scale.density >= 0.25 && screen.scale.density <= 16.0)) {
    throw Line::other_error::create(501, "no screen has that size or scale", &json);
  }
  return screen;
}

std::string modifier_letters(const ui::Modifiers& modifiers) {
  std::string letters;
  letters += modifiers.shift ? "S" : "";
  letters += modifiers.ctrl ? "C" : "";
  letters += modifiers.alt ? "A" : "";
  letters += modifiers.super ? "W" : "";
  return letters;
}

ui::Modifiers modifiers_of(const std::string& letters) {
  const auto has = [&](char letter) { return letters.find(letter) != std::string::npos; };
  return {has('S'), has('C'), has('A'), has('W')};
}

struct EventJson {
  Line operator()(const ui::MouseMoved& moved) const { return {"move", moved.to.x, moved.to.y}; }
  Line operator()(const ui::MouseLeft&) const { return Line::array({"leave"}); }
  Line operator()(const ui::ButtonChanged& change) const {
    return {"button", static_cast<int>(change.button), change.is_down};
  }
  Line operator()(const ui::WheelTurned& turned) const { return {"wheel", turned.x, turned.y}; }
  Line operator()(const ui::KeyChanged& change) const {
    return {"key", ui::to_text({change.key, {}}), change.is_down, change.is_repeat};
  }
  Line operator()(const ui::TextTyped& typed) const {
    return {"text", static_cast<std::uint32_t>(typed.character)};
  }
  Line operator()(const ui::FocusLost&) const { return Line::array({"blur"}); }
};

decltype(ui::InputEvent::what) event_of(const Line& json) {
  const auto kind = json.at(0).get<std::string>();
  if (kind == "move") {
    return ui::MouseMoved{{json.at(1), json.at(2)}};
  }
  if (kind == "leave") {
    return ui::MouseLeft{};
  }
  if (kind == "button") {
    const int button = json.at(1);
    if (button < 0 || button >= static_cast<int>(ui::kMouseButtonCount)) {
      throw Line::other_error::create(501, "there is no such mouse button", &json);
    }
    return ui::ButtonChanged{static_cast<ui::MouseButton>(button), json.at(2)};
  }
  if (kind == "wheel") {
    return ui::WheelTurned{json.at(1), json.at(2)};
  }
  if (kind == "key") {
    const auto chord = ui::chord_from_text(json.at(1).get<std::string>());
    if (!chord) {
      throw Line::other_error::create(501, "there is no such key", &json);
    }
    return ui::KeyChanged{chord->key, json.at(2), json.at(3)};
  }
  if (kind == "text") {
    return ui::TextTyped{static_cast<char32_t>(json.at(1).get<std::uint32_t>())};
  }
  if (kind == "blur") {
    return ui::FocusLost{};
  }
  throw Line::other_error::create(501, "there is no such kind of event", &json);
}

struct AnswerJson {
  Line operator()(const OpenedFile& file) const {
    return {"open", text_json(file.name), bytes_json(file.bytes)};
  }
  Line operator()(const ImportedFile& file) const {
    return {"import", text_json(file.path), bytes_json(file.bytes)};
  }
  Line operator()(const WrittenFile& file) const {
    return {"write", text_json(file.path), bytes_json(file.problem)};
  }
  Line operator()(const ListedFolder& folder) const {
    Line entries = Line::array();
    for (const ui::FolderEntry& entry : folder.entries) {
      entries.push_back({text_json(entry.name), entry.is_folder, entry.bytes});
    }
    return {"list", text_json(folder.folder), text_json(folder.parent), std::move(entries),
            text_json(folder.problem)};
  }
  Line operator()(const FoundPath& found) const { return {"path", text_json(found.path)}; }
  Line operator()(const ReadClipboard& read) const { return {"clipboard", text_json(read.text)}; }
};

FileAnswer answer_of(const Line& json) {
  const auto kind = json.at(0).get<std::string>();
  if (kind == "open") {
    return OpenedFile{text_of_json(json.at(1)), bytes_of(json.at(2))};
  }
  if (kind == "import") {
    return ImportedFile{text_of_json(json.at(1)), bytes_of(json.at(2))};
  }
  if (kind == "write") {
    return WrittenFile{text_of_json(json.at(1)), optional_text(json.at(2))};
  }
  if (kind == "list") {
    ListedFolder folder{
        text_of_json(json.at(1)), text_of_json(json.at(2)), {}, text_of_json(json.at(4))};
    for (const Line& entry : json.at(3)) {
      folder.entries.push_back({text_of_json(entry.at(0)), entry.at(1), entry.at(2)});
    }
    return folder;
  }
  if (kind == "path") {
    return FoundPath{text_of_json(json.at(1))};
  }
  if (kind == "clipboard") {
    return ReadClipboard{text_of_json(json.at(1))};
  }
  throw Line::other_error::create(501, "there is no such answer", &json);
}

Line answers_json(const std::vector<FileAnswer>& answers) {
  Line json = Line::array();
  for (const FileAnswer& answer : answers) {
    json.push_back(std::visit(AnswerJson{}, answer));
  }
  return json;
}

std::vector<FileAnswer> answers_of(const Line& json) {
  std::vector<FileAnswer> answers;
  for (const Line& answer : json) {
    answers.push_back(answer_of(answer));
  }
  return answers;
}

std::string line_of(const Line& json) {
  return json.dump(-1, ' ', false, Line::error_handler_t::replace) + '\n';
}

RecordingHead head_of(const Line& json) {
  if (const int format = json.at("limn_recording"); format != kFormat) {
    throw Line::other_error::create(
        501, fmt::format("the recording has format {}; this program reads {}", format, kFormat),
        &json);
  }
  RecordingHead head;
  head.program = json.at("program");
  head.renderer = json.at("renderer");
  head.fonts = json.at("fonts");
  head.input = text_of_json(json.at("input"));
  head.project = text_of_json(json.at("project"));
  head.screen = screen_of(json.at("screen"));
  auto preferences = parse_preferences(json.at("preferences").dump(), "");
  if (!preferences) {
    throw Line::other_error::create(501, preferences.error().message, &json);
  }
  head.preferences = *std::move(preferences);
  head.memory_budget = json.at("memory_budget");
  head.has_desktop_dialogs = json.at("desktop_dialogs");
  head.files = answers_of(json.at("files"));
  return head;
}

RecordedTurn turn_of(const Line& json) {
  RecordedTurn turn;
  turn.time = json.at("t");
  const Line none = Line::array();
  const auto list = [&](const char* name) -> const Line& {
    const auto found = json.find(name);
    return found == json.end() ? none : *found;
  };
  if (const auto screen = json.find("screen"); screen != json.end()) {
    turn.screen = screen_of(*screen);
  }
  for (const Line& event : list("events")) {
    turn.events.push_back(
        {event.at(0), modifiers_of(event.at(1).get<std::string>()), event_of(event.at(2))});
  }
  for (const Line& file : list("dropped")) {
    turn.news.dropped_files.emplace_back(text_of_json(file));
  }
  turn.news.close_requested = json.value("close", false);
  turn.news.moved_under_alt = json.value("moved_under_alt", false);
  if (const auto chosen = json.find("chosen"); chosen != json.end()) {
    const int purpose = chosen->at(0);
    if (purpose < 0 || purpose > static_cast<int>(ui::PathPrompt::Purpose::kReplaceMesh)) {
      throw Line::other_error::create(501, "no dialog is for that", &json);
    }
    turn.news.chosen = {static_cast<ui::PathPrompt::Purpose>(purpose), text_of_json(chosen->at(1))};
  }
  for (const Line& arrival : list("arrivals")) {
    turn.arrivals.emplace_back(arrival.at(0).get<std::string>(), arrival.at(1).get<std::size_t>());
  }
  turn.files = answers_of(list("files"));
  for (const Line& file : list("exports")) {
    turn.exports.push_back({text_of_json(file.at(0)), optional_text(file.at(1))});
  }
  turn.has_frame = json.value("frame", false);
  for (const Line& action : list("actions")) {
    turn.actions.push_back(text_of_json(action));
  }
  if (const auto document = json.find("document"); document != json.end()) {
    turn.document = document->get<std::string>();
  }
  if (const auto picture = json.find("picture"); picture != json.end()) {
    turn.picture = picture->get<std::uint32_t>();
  }
  return turn;
}

}  // namespace

std::string head_line(const RecordingHead& head) {
  return line_of({{"limn_recording", kFormat},
                  {"program", head.program},
                  {"renderer", head.renderer},
                  {"fonts", head.fonts},
                  {"input", text_json(head.input)},
                  {"project", text_json(head.project)},
                  {"screen", screen_json(head.screen)},
                  {"preferences", Line::parse(preferences_text(head.preferences))},
                  {"memory_budget", head.memory_budget},
                  {"desktop_dialogs", head.has_desktop_dialogs},
                  {"files", answers_json(head.files)}});
}

std::string turn_line(const RecordedTurn& turn) {
  Line json{{"t", turn.time}};
  if (turn.screen) {
    json["screen"] = screen_json(*turn.screen);
  }
  for (const ui::InputEvent& event : turn.events) {
    json["events"].push_back(
        {event.time, modifier_letters(event.modifiers), std::visit(EventJson{}, event.what)});
  }
  for (const auto& file : turn.news.dropped_files) {
    json["dropped"].push_back(text_json(file.string()));
  }
  if (turn.news.close_requested) {
    json["close"] = true;
  }
  if (turn.news.moved_under_alt) {
    json["moved_under_alt"] = true;
  }
  if (turn.news.chosen) {
    json["chosen"] = Line::array(
        {static_cast<int>(turn.news.chosen->purpose), text_json(turn.news.chosen->path.string())});
  }
  for (const auto& [box, count] : turn.arrivals) {
    json["arrivals"].push_back(Line::array({box, count}));
  }
  if (!turn.files.empty()) {
    json["files"] = answers_json(turn.files);
  }
  for (const WrittenFile& file : turn.exports) {
    json["exports"].push_back(Line::array({text_json(file.path), bytes_json(file.problem)}));
  }
  if (turn.has_frame) {
    json["frame"] = true;
  }
  for (const std::string& action : turn.actions) {
    json["actions"].push_back(text_json(action));
  }
  if (turn.document) {
    json["document"] = *turn.document;
  }
  if (turn.picture) {
    json["picture"] = *turn.picture;
  }
  return line_of(json);
}

std::string end_line() {
  return line_of({{"end", true}});
}

Result<Recording> parse_recording(std::string_view text, const std::string& source) {
  Recording recording;
  std::size_t line = 0;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos && line > 0) {
      break;  // Cut off.
    }
    const std::string_view one = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    ++line;
    try {
      const Line json = Line::parse(one);
      if (line == 1) {
        recording.head = head_of(json);
      } else if (json.contains("end")) {
        recording.is_whole = true;
      } else {
        recording.turns.push_back(turn_of(json));
      }
    } catch (const Line::parse_error&) {
      return fail(ErrorKind::kBadInput,
                  line == 1 ? "This is no recording. limn --record FILE writes one."
                            : "This line is damaged: the recording cannot be played back.",
                  source, line);
    } catch (const Line::exception& error) {
      return fail(ErrorKind::kBadInput,
                  fmt::format("This is not a line of a recording that `limn --record` writes: {}.",
                              error.what()),
                  source, line);
    }
  }
  if (line == 0) {
    return fail(ErrorKind::kBadInput, "The file is empty: it is not a recording.", source);
  }
  return recording;
}

std::string text_of(const ui::Action& action) {
  struct ValueText {
    std::string operator()(std::monostate) const { return {}; }
    std::string operator()(bool value) const { return value ? ": on" : ": off"; }
    std::string operator()(int value) const { return fmt::format(": {}", value); }
    std::string operator()(double value) const { return fmt::format(": {}", value); }
    std::string operator()(const std::string& value) const { return ": " + value; }
  };
  return std::string(ui::info(action.id).label) + std::visit(ValueText{}, action.value);
}

std::string checksum_of(const Document& document) {
  std::ostringstream out;
  write_project(out, document, std::nullopt);
  // The text ends with its checksum, a string.
  const std::string text = std::move(out).str();
  const std::size_t end = text.rfind('"');
  LIMN_EXPECTS(end != std::string::npos && end > 0);
  const std::size_t begin = text.rfind('"', end - 1) + 1;
  return text.substr(begin, end - begin);
}

std::uint32_t checksum_of(const ui::FontFiles& fonts) {
  uLong checksum = crc32_z(0, nullptr, 0);
  for (const std::vector<std::byte>* file : {&fonts.regular, &fonts.semi_bold}) {
    checksum = crc32_z(checksum, reinterpret_cast<const Bytef*>(file->data()), file->size());
  }
  return static_cast<std::uint32_t>(checksum);
}

std::uint32_t checksum_of(const render::Image& image) {
  return static_cast<std::uint32_t>(
      crc32_z(crc32_z(0, nullptr, 0), image.rgba.data(), image.rgba.size()));
}

}  // namespace limn::app
