#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/preferences.h"
#include "app/workbench.h"
#include "limn/error.h"
#include "ui/input.h"
#include "ui/model.h"

/// What a person did in one run of the program, as plain data: every input, whatever came from
/// outside, and when. Enough to do it all again without the person, the window or the files.
namespace limn::app {

/// What the file system, or the clipboard, said when it was asked. In the order of the questions.
struct OpenedFile {
  std::string name;                  ///< As it was asked for.
  std::optional<std::string> bytes;  ///< Nothing for a bundled mesh, or where there is no file.

  [[nodiscard]] bool operator==(const OpenedFile&) const = default;
};
struct ImportedFile {
  std::string path;
  std::optional<std::string> bytes;

  [[nodiscard]] bool operator==(const ImportedFile&) const = default;
};
struct WrittenFile {
  std::string path;
  std::optional<std::string> problem;  ///< Why it could not be written.

  [[nodiscard]] bool operator==(const WrittenFile&) const = default;
};
struct ListedFolder {
  std::string folder;  ///< As it is shown.
  std::string parent;
  std::vector<ui::FolderEntry> entries;
  std::string problem;

  [[nodiscard]] bool operator==(const ListedFolder&) const = default;
};
struct FoundPath {  ///< The working folder, or a name for a picture.
  std::string path;

  [[nodiscard]] bool operator==(const FoundPath&) const = default;
};
struct ReadClipboard {
  std::string text;

  [[nodiscard]] bool operator==(const ReadClipboard&) const = default;
};
using FileAnswer =
    std::variant<OpenedFile, ImportedFile, WrittenFile, ListedFolder, FoundPath, ReadClipboard>;

/// One turn of the program's main loop.
struct RecordedTurn {
  double time = 0.0;                   ///< Seconds, as the session was told.
  std::optional<Screen> screen;        ///< Where it is another than in the turn before.
  std::vector<ui::InputEvent> events;  ///< That came since the turn before.
  Workbench::News news;
  std::vector<std::pair<std::string, std::size_t>> arrivals;  ///< Taken in, by mailbox.
  std::vector<FileAnswer> files;
  std::vector<WrittenFile> exports;  ///< Of the worker that writes meshes.
  bool has_frame = false;

  // What came of it, to be compared.
  std::vector<std::string> actions;      ///< "Raise all", "Target depth 3".
  std::optional<std::string> document;   ///< Its checksum, where it was taken.
  std::optional<std::uint32_t> picture;  ///< CRC-32 of the viewport's pixels, where it was taken.
};

/// How the run began.
struct RecordingHead {
  std::string program;      ///< "limn 1.2".
  std::string renderer;     ///< What OpenGL says of itself: others draw other pixels.
  std::uint32_t fonts = 0;  ///< CRC-32 of the typefaces: with others, controls lie elsewhere.
  std::string input;        ///< What was opened, as for `open_document`; or
  std::string project;      ///< the text of the project that was there already.
  Screen screen;
  Preferences preferences;
  std::uint64_t memory_budget = 0;  ///< Bytes.
  bool has_desktop_dialogs = false;
  std::vector<FileAnswer> files{};  ///< Of what was asked before the first turn.
};

struct Recording {
  RecordingHead head;
  std::vector<RecordedTurn> turns;
  bool is_whole = false;  ///< It was ended, not cut off by a crash.
};

/// JSON, one object a line: the head, the turns, and an end. Each line stands for itself, so that
/// what a crash cut off can be read up to there.
[[nodiscard]] std::string head_line(const RecordingHead& head);
[[nodiscard]] std::string turn_line(const RecordedTurn& turn);
[[nodiscard]] std::string end_line();

/// Reads what these write. Errors: kBadInput with the line; a last line without an end is left out.
[[nodiscard]] Result<Recording> parse_recording(std::string_view text, const std::string& source);

/// An action for people to read, and to compare: its label and its value.
[[nodiscard]] std::string text_of(const ui::Action& action);
/// The checksum of the document as a project, without the camera.
[[nodiscard]] std::string checksum_of(const Document& document);
/// CRC-32 of both files.
[[nodiscard]] std::uint32_t checksum_of(const ui::FontFiles& fonts);
/// CRC-32 of the pixels.
[[nodiscard]] std::uint32_t checksum_of(const render::Image& image);

}  // namespace limn::app
