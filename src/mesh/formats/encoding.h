#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace limn::detail {

/// The text as UTF-8 if a byte order mark says that it is UTF-16; what is no character becomes `?`.
/// Nothing where it is not. Line ends stay what and where they are.
[[nodiscard]] std::optional<std::string> utf8_of_utf16(std::string_view bytes);

}  // namespace limn::detail
