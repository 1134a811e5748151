#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "limn/error.h"

namespace limn {

/// The bytes of a regular file. Never waits and never reads without end: pipes, devices and folders
/// are refused before anything is read.
/// Errors: kBadInput where it cannot be opened or read, is no regular file, or has more than
/// `most_bytes`.
[[nodiscard]] Result<std::string> read_regular_file(const std::filesystem::path& path,
                                                    std::size_t most_bytes);

/// The message for a file of `bytes` where `most_bytes`, a whole number of MiB, are read.
[[nodiscard]] std::string too_large(std::size_t bytes, std::size_t most_bytes);

}  // namespace limn
