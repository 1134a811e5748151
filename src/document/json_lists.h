#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "limn/error.h"

namespace limn {

struct JsonNull {};
struct JsonObject {};
struct JsonList {};
using JsonValue = std::variant<JsonNull, JsonObject, JsonList, bool, std::int64_t, std::uint64_t,
                               double, std::string>;

/// What stands at a JSON path ("/settings/corners", RFC 6901).
struct JsonField {
  std::string path;
  JsonValue value;
};

/// A list of rows of numbers, all of one length.
struct NumberRows {
  bool is_there = false;
  std::vector<double> numbers;
};

/// A list of rows of indices, of three or more each. What they index is not checked.
struct IndexRows {
  bool is_there = false;
  std::vector<std::uint32_t> offsets{0};
  std::vector<std::uint32_t> indices;
};

/// A list of texts, of any bytes (`json_bytes`).
struct TextList {
  bool is_there = false;
  std::vector<std::string> texts;
};

/// A list of indices, kNone where the file says -1. What they index is not checked.
struct ChoiceList {
  bool is_there = false;
  std::vector<std::uint32_t> choices;
};

/// The long lists of a mesh, as flat as they are going to be used.
struct MeshLists {
  NumberRows positions;  ///< Three a vertex.
  IndexRows faces;
  NumberRows uvs;             ///< Two a texture point.
  IndexRows face_uvs;         ///< A texture point for each corner of `faces`.
  NumberRows creases;         ///< Two vertices and a sharpness.
  NumberRows corners;         ///< A vertex and a sharpness.
  NumberRows loose_vertices;  ///< Three each.
  /// Names, and for each face one of them.
  TextList object_names;
  ChoiceList face_objects;
  TextList group_names;
  ChoiceList face_groups;
  TextList material_names;
  ChoiceList face_materials;
  TextList material_libraries;
};

/// A project file's text, taken apart: the long lists apart from the rest, so that memory stays
/// within a few times the text's size whatever the text says.
struct ProjectText {
  std::vector<JsonField> fields;
  MeshLists mesh;
  MeshLists opened_mesh;
  bool has_depths = false;
  std::vector<std::uint8_t> depths;  ///< 0..kMaxDepth.
  bool has_demands = false;
  std::vector<std::uint32_t> demands;  ///< Six numbers each (FineDemand). Not checked.
  /// The first thing in a list that does not belong there. Kept apart from syntax errors, because a
  /// file in a newer format may put other things there, and then its version is what to complain
  /// about.
  std::optional<Error> misfit;
};

/// Takes JSON text apart. `source` is for messages.
/// Errors: kBadInput with the line, where the text is not JSON or nested beyond reason.
[[nodiscard]] Result<ProjectText> parse_project_text(std::string_view text,
                                                     const std::string& source);

/// `text` as a JSON string with its quotes. Bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string json_quoted(std::string_view text);
[[nodiscard]] bool is_utf8(std::string_view text);

/// Any bytes as a JSON string with its quotes: UTF-8 as it is, every byte that belongs to none as a
/// character from U+F780 on (and so those characters themselves, byte by byte). `bytes_of_json`
/// gives the bytes of such a string.
[[nodiscard]] std::string json_bytes(std::string_view bytes);
[[nodiscard]] std::string bytes_of_json(std::string_view text);

}  // namespace limn
