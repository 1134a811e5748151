#include "mesh/formats/depth_material.h"

#include <algorithm>

namespace limn::detail {
namespace {

bool are_digits(std::string_view text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

std::optional<std::uint32_t> depth_of_material(std::string_view name) noexcept {
  constexpr std::string_view beginning = "depth_";
  constexpr std::size_t most_digits = 4;
  constexpr std::size_t count_digits = 3;
  if (!name.starts_with(beginning)) {
    return std::nullopt;
  }
  name.remove_prefix(beginning.size());
  if (const std::size_t dot = name.find('.'); dot != std::string_view::npos) {
    const std::string_view count = name.substr(dot + 1);
    if (count.size() != count_digits || !are_digits(count)) {
      return std::nullopt;
    }
    name = name.substr(0, dot);
  }
  if (!are_digits(name) || name.size() > most_digits) {
    return std::nullopt;
  }
  std::uint32_t depth = 0;
  for (const char c : name) {
    depth = 10 * depth + static_cast<std::uint32_t>(c - '0');
  }
  return depth;
}

}  // namespace limn::detail
