#pragma once

#include <string>
#include <string_view>

namespace limn::detail {

/// A word of a file in quotes, fit for a message.
[[nodiscard]] std::string quoted(std::string_view word);

}  // namespace limn::detail
