// /proc/meminfo counts kB. A control group bounds what all of its processes take together, page
// cache included, and so do the groups above it; the figures are at /sys/fs/cgroup (version 2) or
// /sys/fs/cgroup/memory (version 1), under the path that /proc/self/cgroup gives.
#include "limn/document/memory_budget.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <limits>
#include <optional>
#include <string_view>

#include <fmt/format.h>

namespace limn {
namespace {

namespace fs = std::filesystem;
constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

std::optional<std::uint64_t> number_in(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} ? std::optional(number) : std::nullopt;
}

/// The number in the first line of a file, after `key` where one is given.
std::optional<std::uint64_t> read_number(const fs::path& file, std::string_view key = {}) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (std::string_view(line).starts_with(key)) {
      return number_in(std::string_view(line).substr(key.size()));
    }
  }
  return std::nullopt;
}

struct GroupFiles {
  const char* limit;
  const char* used;
  const char* cache;  ///< In memory.stat: what is given back where it is wanted.
};

/// The least that a group and those above it leave.
std::uint64_t left_in_groups(const fs::path& base, fs::path group, const GroupFiles& files) {
  std::uint64_t left = kUnlimited;
  while (true) {
    const fs::path folder = group.empty() ? base : base / group;
    const auto limit = read_number(folder / files.limit);
    const auto used = read_number(folder / files.used);
    if (limit && used) {
      const std::uint64_t cache =
          std::min(*used, read_number(folder / "memory.stat", files.cache).value_or(0));
      const std::uint64_t taken = *used - cache;
      left = std::min(left, *limit - std::min(*limit, taken));
    }
    if (group.empty()) {
      return left;
    }
    group = group.parent_path();
  }
}

std::uint64_t left_by_control_groups(const fs::path& root) {
  constexpr GroupFiles version_2{"memory.max", "memory.current", "inactive_file "};
  constexpr GroupFiles version_1{"memory.limit_in_bytes", "memory.usage_in_bytes",
                                 "total_inactive_file "};
  std::uint64_t left = kUnlimited;
  std::ifstream in(root / "proc/self/cgroup");
  for (std::string line; std::getline(in, line);) {
    // NUMBER:CONTROLLERS:/PATH
    const std::size_t first = line.find(':');
    const std::size_t second = first == std::string::npos ? first : line.find(':', first + 1);
    if (second == std::string::npos) {
      continue;
    }
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const fs::path group = fs::path(line.substr(second + 1)).relative_path();
    if (controllers.empty()) {
      left = std::min(left, left_in_groups(root / "sys/fs/cgroup", group, version_2));
    } else if (("," + controllers + ",").find(",memory,") != std::string::npos) {
      left = std::min(left, left_in_groups(root / "sys/fs/cgroup/memory", group, version_1));
    }
  }
  return left;
}

}  // namespace

std::uint64_t available_memory(const fs::path& root) {
  constexpr std::uint64_t kilobyte = 1024;
  const auto available = read_number(root / "proc/meminfo", "MemAvailable:");
  return std::min(available ? *available * kilobyte : kUnlimited, left_by_control_groups(root));
}

std::uint64_t memory_budget() {
  const std::uint64_t available = available_memory();
  return available == kUnlimited ? kUnlimited : available / 10 * 7;
}

std::string memory_text(std::uint64_t bytes) {
  constexpr std::array units{"kB", "MB", "GB", "TB", "PB", "EB"};
  if (bytes < 1000) {
    return fmt::format("{} bytes", bytes);
  }
  auto size = static_cast<double>(bytes) / 1000.0;
  std::size_t unit = 0;
  for (; size >= 999.95 && unit + 1 < units.size(); ++unit) {
    size /= 1000.0;
  }
  return fmt::format("{:.1f} {}", size, units.at(unit));
}

tl::unexpected<Error> over_memory(std::uint64_t faces, std::uint64_t bytes, std::uint64_t budget) {
  return fail(ErrorKind::kOverBudget,
              fmt::format("The result would have {} faces and take {} of memory ({} bytes), more "
                          "than the {} that it may take here. Lower the depths, refine fewer "
                          "levels, or allow more memory.",
                          faces, memory_text(bytes), bytes, memory_text(budget)));
}

}  // namespace limn
