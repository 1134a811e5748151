#pragma once

#include <string>
#include <string_view>

#include "limn/mesh/polygon_soup.h"

namespace limn::detail {

/// What became of a tag.
struct TagReading {
  bool is_used = false;      ///< The soup holds it now. Tags that Limn does not know are not used.
  std::string message;       ///< What is wrong with it, or empty.
  std::string_view culprit;  ///< The word to blame, within the arguments, or empty for all of it.
};

/// Reads the arguments of an OBJ statement `t NAME INTEGERS/NUMBERS/STRINGS ...` in the form of
/// OpenSubdiv's regression shapes (forms and meaning: mesh/import.h) into the soup.
[[nodiscard]] TagReading read_tag(std::string_view arguments, PolygonSoup& soup);

}  // namespace limn::detail
