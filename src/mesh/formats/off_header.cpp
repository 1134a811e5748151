#include "mesh/formats/off_header.h"

namespace limn::detail {

std::optional<OffVertex> read_off_keyword(std::string_view word) noexcept {
  constexpr std::string_view ending = "OFF";
  if (!word.ends_with(ending)) {
    return std::nullopt;
  }
  word.remove_suffix(ending.size());
  const auto take = [&word](std::string_view letters) {
    const bool is_there = word.starts_with(letters);
    word.remove_prefix(is_there ? letters.size() : 0);
    return is_there;
  };
  OffVertex vertex;
  vertex.has_uv = take("ST");
  vertex.has_colour = take("C");
  vertex.has_normal = take("N");
  vertex.has_weight = take("4");
  vertex.has_dimension = take("n");
  return word.empty() ? std::optional(vertex) : std::nullopt;
}

}  // namespace limn::detail
