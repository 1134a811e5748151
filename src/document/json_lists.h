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

/// The long lists of a mesh, as flat as they are going to be used.
struct MeshLists {
  bool has_positions = false;
  std::vector<double> positions;  ///< Three a vertex.
  bool has_faces = false;
  std::vector<std::uint32_t> face_offsets{0};
  std::vector<std::uint32_t> face_vertices;  ///< Not checked against the number of positions.
};

/// A project file's text, taken apart: the long lists apart from the rest, so that memory stays
/// within a few times the text's size whatever the text says.
struct ProjectText {
  std::vector<JsonField> fields;
  MeshLists mesh;
  MeshLists opened_mesh;
  bool has_depths = false;
  std::vector<std::uint8_t> depths;  ///< 0..kMaxDepth.
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

}  // namespace limn
