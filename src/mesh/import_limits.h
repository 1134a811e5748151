#pragma once

#include <cstddef>
#include <string>

namespace limn::detail {

/// The largest file that is read. OBJ text below it cannot overflow 32-bit counts: a vertex takes
/// at least eight bytes, a corner two.
inline constexpr std::size_t most_import_bytes = std::size_t{4} << 30U;

/// The message for a file above it.
[[nodiscard]] std::string too_large(std::size_t bytes);

}  // namespace limn::detail
