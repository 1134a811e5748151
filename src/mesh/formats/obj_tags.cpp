// A tag says how many integers, numbers and strings follow its name. Only the names that are known
// are read on, so that what other programs write in a form of their own does no harm.
#include "mesh/formats/obj_tags.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "limn/mesh/control_mesh.h"
#include "mesh/formats/parse_number.h"
#include "mesh/formats/sharpness.h"
#include "mesh/formats/words.h"

namespace limn::detail {
namespace {

constexpr bool is_known(std::string_view name) {
  return name == "crease" || name == "corner" || name == "interpolateboundary" ||
         name == "creasemethod" || name == "limn_depth";
}

struct TagCounts {
  std::size_t integers = 0;
  std::size_t numbers = 0;
  std::size_t strings = 0;
};

struct Tag {
  std::vector<std::int64_t> integers;
  std::vector<float> numbers;
  std::vector<std::string_view> strings;
};

TagReading used() {
  TagReading reading;
  reading.is_used = true;
  return reading;
}

TagReading refused(std::string message, std::uint32_t line = 0) {
  return {false, std::move(message), line, {}};
}

std::optional<TagCounts> read_tag_counts(std::string_view word) {
  std::size_t counts[3];
  for (std::size_t part = 0; part < 3; ++part) {
    const std::size_t slash = word.find('/');
    if ((slash == std::string_view::npos) != (part == 2)) {
      return std::nullopt;
    }
    const std::optional<std::int64_t> count = parse_index(word.substr(0, slash));
    if (!count || *count < 0) {
      return std::nullopt;
    }
    counts[part] = static_cast<std::size_t>(*count);
    word.remove_prefix(part == 2 ? word.size() : slash + 1);
  }
  return TagCounts{counts[0], counts[1], counts[2]};
}

std::optional<float> read_sharpness(std::string_view word) {
  double value = 0.0;
  return parse_number(word, value) ? to_sharpness(value) : std::nullopt;
}

/// Reads the words after the name into `tag`.
TagReading read_words(TextCursor& words, Tag& tag) {
  const std::string_view first = words.next_word();
  const std::optional<TagCounts> counts = read_tag_counts(first);
  if (!counts) {
    return refused(fmt::format("A tag says after its name how many integers, numbers and strings "
                               "follow, like 2/1/0; this one says {}.",
                               quoted(first)),
                   words.line());
  }
  std::size_t found = 0;
  for (std::string_view word = words.next_word(); !word.empty(); word = words.next_word()) {
    if (found < counts->integers) {
      const std::optional<std::int64_t> integer = parse_index(word);
      if (!integer) {
        return refused(fmt::format("{} is not an integer.", quoted(word)), words.line());
      }
      tag.integers.push_back(*integer);
    } else if (found - counts->integers < counts->numbers) {
      const std::optional<float> number = read_sharpness(word);
      if (!number) {
        return refused(fmt::format("{} is not a number.", quoted(word)), words.line());
      }
      tag.numbers.push_back(*number);
    } else {
      tag.strings.push_back(word);
    }
    ++found;
  }
  if (tag.integers.size() != counts->integers || tag.numbers.size() != counts->numbers ||
      tag.strings.size() != counts->strings) {
    return refused(
        fmt::format("This tag announces {} integers, {} numbers and {} strings, but {} "
                    "{} in all.",
                    counts->integers, counts->numbers, counts->strings, found,
                    found == 1 ? "word follows" : "words follow"));
  }
  return used();
}

/// A vertex that no mesh has, for an index that is out of every range.
std::uint32_t vertex_of(std::int64_t index) {
  return index < 0 || index >= std::int64_t{kNone} ? kNone : static_cast<std::uint32_t>(index);
}

TagReading read_crease(const Tag& tag, PolygonSoup& soup) {
  const std::size_t n = tag.integers.size();
  const std::size_t s = tag.numbers.size();
  const bool are_pairs = n > 2 && n % 2 == 0 && s == n / 2;
  if (n < 2 || !(s == 1 || s == n - 1 || are_pairs)) {
    return refused(fmt::format("A crease of {} {} does not go with {} values of sharpness.", n,
                               n == 1 ? "vertex" : "vertices", s));
  }
  for (std::size_t i = 0; i + 1 < n; i += are_pairs ? 2 : 1) {
    const float sharpness = tag.numbers[s == 1 ? 0 : are_pairs ? i / 2 : i];
    soup.creases.push_back(
        {{vertex_of(tag.integers[i]), vertex_of(tag.integers[i + 1])}, sharpness});
  }
  return used();
}

TagReading read_corner(const Tag& tag, PolygonSoup& soup) {
  const std::size_t n = tag.integers.size();
  const std::size_t s = tag.numbers.size();
  if (n < 1 || !(s == 1 || s == n)) {
    return refused(fmt::format("{} {} do not go with {} values of sharpness.", n,
                               n == 1 ? "corner" : "corners", s));
  }
  for (std::size_t i = 0; i < n; ++i) {
    soup.corners.push_back({vertex_of(tag.integers[i]), tag.numbers[s == 1 ? 0 : i]});
  }
  return used();
}

/// Of its three values 0 leaves the faces at the boundary out, which Limn does not.
TagReading read_boundary_rule(const Tag& tag, PolygonSoup& soup) {
  if (tag.integers.size() != 1) {
    return refused(fmt::format("The boundary rule is one integer, 0, 1 or 2; here are {}.",
                               tag.integers.size()));
  }
  switch (tag.integers.front()) {
    case 1:
      soup.corner_rule = CornerRule::kSharp;
      return used();
    case 2:
      soup.corner_rule = CornerRule::kSmooth;
      return used();
    default:
      return {};
  }
}

TagReading read_crease_method(const Tag& tag, PolygonSoup& soup) {
  if (tag.strings.size() != 1) {
    return refused(fmt::format("The crease method is one word, normal or chaikin; here are {}.",
                               tag.strings.size()));
  }
  if (tag.strings.front() == "chaikin") {
    soup.creasing = CreasingMethod::kChaikin;
  } else if (tag.strings.front() == "normal") {
    soup.creasing = CreasingMethod::kUniform;
  } else {
    return {};
  }
  return used();
}

TagReading read_depth(const Tag& tag) {
  constexpr std::int64_t most = std::numeric_limits<std::uint32_t>::max();
  if (tag.integers.size() != 1 || tag.integers.front() < 0 || tag.integers.front() > most) {
    return refused("A depth is one integer from 0 on.");
  }
  TagReading reading = used();
  reading.depth = static_cast<std::uint32_t>(tag.integers.front());
  return reading;
}

}  // namespace

TagReading read_tag(std::string_view name, TextCursor& words, PolygonSoup& soup) {
  if (!is_known(name)) {
    return {};
  }
  Tag tag;
  if (TagReading reading = read_words(words, tag); !reading.is_used) {
    return reading;
  }
  if (name == "crease") {
    return read_crease(tag, soup);
  }
  if (name == "corner") {
    return read_corner(tag, soup);
  }
  if (name == "limn_depth") {
    return read_depth(tag);
  }
  return name == "creasemethod" ? read_crease_method(tag, soup) : read_boundary_rule(tag, soup);
}

}  // namespace limn::detail
