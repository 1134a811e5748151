#pragma once

#include <cstddef>

namespace limn::detail {

/// The largest file that is read. OBJ text below it cannot overflow 32-bit counts: a vertex takes
/// at least eight bytes, a corner two.
inline constexpr std::size_t most_import_bytes = std::size_t{4} << 30U;

}  // namespace limn::detail
