#include "mesh/formats/words.h"

#include <fmt/format.h>

#include "mesh/printable.h"

namespace limn::detail {

std::string quoted(std::string_view word) {
  return fmt::format("\"{}\"", printable(word));
}

}  // namespace limn::detail
