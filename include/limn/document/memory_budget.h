#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "limn/error.h"

namespace limn {

/// Memory in bytes that this process may still take without others losing theirs: what the kernel
/// says is available, or less where a control group of this process allows less. `root` is the file
/// system in which /proc and /sys are looked up. 2^64 - 1 where nothing says anything.
[[nodiscard]] std::uint64_t available_memory(const std::filesystem::path& root = "/");

/// What a refined mesh may take unless a person says otherwise: 70 % of the available memory. The
/// rest is for the work on it, which takes a fifth of its size on top, and for what shows it.
[[nodiscard]] std::uint64_t memory_budget();

/// "812 bytes", "39.3 MB", "1.2 GB": units of 1000, as people compare them.
[[nodiscard]] std::string memory_text(std::uint64_t bytes);

/// The error for a mesh that takes more memory than it may: kOverBudget, with the numbers.
[[nodiscard]] tl::unexpected<Error> over_memory(std::uint64_t faces, std::uint64_t bytes,
                                                std::uint64_t budget);

}  // namespace limn
