#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "limn/mesh/polygon_soup.h"
#include "mesh/formats/text_cursor.h"

namespace limn::detail {

/// What became of a tag.
struct TagReading {
  bool is_used = false;    ///< The soup holds it now. Tags that Limn does not know are not used.
  std::string message;     ///< What is wrong with it, or empty.
  std::uint32_t line = 0;  ///< Where that is, or 0: all of it is to blame.
  std::optional<std::uint32_t> depth;  ///< Of the faces that follow.
};

/// Reads the arguments of an OBJ statement `t NAME INTEGERS/NUMBERS/STRINGS ...` in the form of
/// OpenSubdiv's regression shapes (forms and meaning: mesh/import.h) into the soup. `words` stands
/// behind the name.
[[nodiscard]] TagReading read_tag(std::string_view name, TextCursor& words, PolygonSoup& soup);

}  // namespace limn::detail
