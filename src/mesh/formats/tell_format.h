#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "limn/error.h"
#include "limn/mesh/mesh_format.h"

namespace limn::detail {

/// The format that bytes have. `expected` is what the name of the file says, if it says anything;
/// it counts where the bytes leave it open.
/// Errors, kBadInput: the bytes are none of the formats, with what they are where that can be told.
[[nodiscard]] Result<MeshFormat> tell_format(std::string_view bytes,
                                             std::optional<MeshFormat> expected,
                                             const std::string& source);

}  // namespace limn::detail
