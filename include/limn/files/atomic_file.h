#pragma once

#include <filesystem>
#include <functional>
#include <ostream>

#include "limn/error.h"

namespace limn {

/// Writes a file so that a crash, a kill or a full disk leaves either the old file or the whole new
/// one: `write` fills a temporary file in the same folder, which is flushed to disk and then put in
/// the place of `path`. Links are followed to what they point to; an old file's rights are kept,
/// and its owner where this process may. Temporaries that killed processes of this program left in
/// the folder are removed on the way.
///
/// Errors (kFailed) name the path and the system's reason; the temporary is removed and the old
/// file is as it was. The one exception says so itself: a file system that cannot exchange two
/// files, and then fails to flush the folder.
[[nodiscard]] Result<void> write_file_atomically(const std::filesystem::path& path,
                                                 const std::function<void(std::ostream&)>& write);

}  // namespace limn
