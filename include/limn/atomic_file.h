#pragma once

#include <filesystem>
#include <functional>
#include <ostream>

#include "limn/error.h"

namespace limn {

/// Writes a file so that a crash or a full disk leaves either the old file or the whole new one:
/// `write` fills a temporary file in the same folder, which is flushed to disk and then renamed
/// over `path`. Errors (kFailed) name the path and the system's reason; the temporary is removed.
[[nodiscard]] Result<void> write_file_atomically(const std::filesystem::path& path,
                                                 const std::function<void(std::ostream&)>& write);

}  // namespace limn
