// The text is walked once, line by line. A statement is copied only to join its lines and cut its
// comment off; words are views into the copy, so that the line of a bad one follows from where it
// stands.
#include "mesh/obj_statements.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "limn/mesh/control_mesh.h"
#include "mesh/obj_tags.h"
#include "mesh/obj_words.h"
#include "mesh/parse_number.h"

namespace limn::detail {
namespace {

/// Resolves an index to one from 0; kNone where it names nothing. An index may name what comes
/// later, so those beyond `count` pass.
std::uint32_t resolve_uv(std::int64_t index, std::size_t count) {
  const std::int64_t resolved = index > 0 ? index - 1 : static_cast<std::int64_t>(count) + index;
  return index == 0 || resolved < 0 || resolved >= std::int64_t{kNone}
             ? kNone
             : static_cast<std::uint32_t>(resolved);
}

}  // namespace

ObjStatements::ObjStatements(std::string_view text, PolygonSoup& soup, UnusedData& unused)
    : rest_(text), soup_(soup), unused_(unused) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (rest_.starts_with(byte_order_mark)) {
    rest_.remove_prefix(byte_order_mark.size());
  }
  breaks_.push_back({0, 1});
}

ObjStatements::int_type ObjStatements::underflow() {
  while (error_.message.empty() && read_statement()) {
    std::string_view arguments = statement_;
    const std::string_view keyword = take_word(arguments);
    if (keyword == "v") {
      if (!check_vertex(arguments)) {
        break;
      }
      ++vertices_;
    } else if (keyword == "f" || keyword == "fo") {
      if (!check_face(arguments)) {
        break;
      }
      // `fo` is the old name of `f`, which tinyobjloader does not know.
      if (keyword == "fo") {
        statement_[static_cast<std::size_t>(keyword.data() - statement_.data()) + 1] = ' ';
      }
    } else if (keyword == "vt" || keyword == "t") {
      if (!(keyword == "t" ? read_tag(arguments) : read_uv(arguments))) {
        break;
      }
      continue;
    } else {
      if (!keyword.empty()) {
        unused_.count(keyword, take_word(arguments));
      }
      continue;
    }
    // What is left of the arguments is a comment, or nothing.
    const std::size_t comment = statement_.find(" #");
    const std::size_t tabbed_comment = statement_.find("\t#");
    statement_.resize(std::min({comment, tabbed_comment, statement_.size()}));
    statement_.push_back('\n');
    setg(statement_.data(), statement_.data(), statement_.data() + statement_.size());
    return traits_type::to_int_type(statement_.front());
  }
  return traits_type::eof();
}

std::string_view ObjStatements::read_line() {
  std::size_t end = 0;
  while (end < rest_.size() && rest_[end] != '\n' && rest_[end] != '\r') {
    ++end;
  }
  const std::string_view line = rest_.substr(0, end);
  const bool is_pair = rest_.substr(end).starts_with("\r\n");
  rest_.remove_prefix(std::min(end + (is_pair ? 2 : 1), rest_.size()));
  ++next_line_;
  return line;
}

/// Joins the lines of the next statement into `statement_`. A comment is never continued: many end
/// with a Windows path.
bool ObjStatements::read_statement() {
  if (rest_.empty()) {
    return false;
  }
  statement_.clear();
  breaks_.clear();
  bool goes_on = true;
  while (goes_on && !rest_.empty()) {
    breaks_.push_back({statement_.size(), next_line_});
    std::string_view line = read_line();
    while (!line.empty() && is_blank(line.back())) {
      line.remove_suffix(1);
    }
    goes_on = line.ends_with('\\');
    if (goes_on && statement_.empty()) {
      std::string_view words = line;
      goes_on = !take_word(words).empty();
    }
    if (goes_on) {
      line.remove_suffix(1);
    }
    statement_.append(line);
    if (goes_on) {
      statement_.push_back(' ');
    }
  }
  return true;
}

bool ObjStatements::check_vertex(std::string_view arguments) {
  constexpr int most_numbers = 8;
  double numbers[most_numbers];
  int count = 0;
  for (std::string_view word = take_word(arguments); !word.empty(); word = take_word(arguments)) {
    if (count == most_numbers) {
      return refuse(word,
                    "A vertex has three coordinates, perhaps a weight and a colour; this one "
                    "has more than eight numbers.");
    }
    if (!parse_number(word, numbers[count])) {
      return refuse(word, fmt::format("{} is not a number.", quoted(word)));
    }
    ++count;
  }
  if (count < 3) {
    return refuse(statement_,
                  fmt::format("A vertex needs three coordinates; this one has {}.", count));
  }
  position_ = {numbers[0], numbers[1], numbers[2]};
  if (count == 4 && numbers[3] != 1.0) {
    unused_.count_weight();
  } else if (count > 4) {
    unused_.count_colour();
  }
  return true;
}

bool ObjStatements::check_face(std::string_view arguments) {
  face_uvs_.clear();
  for (std::string_view word = take_word(arguments); !word.empty(); word = take_word(arguments)) {
    if (!check_corner(word)) {
      return false;
    }
  }
  if (face_uvs_.size() < 3) {
    return refuse(statement_, fmt::format("A face needs at least three corners; this one has {}.",
                                          face_uvs_.size()));
  }
  return true;
}

/// v, v/vt, v/vt/vn or v//vn; normals are not used, but all have to be numbers.
bool ObjStatements::check_corner(std::string_view word) {
  std::string_view rest = word;
  std::uint32_t uv = kNone;
  for (int part = 0; part < 3; ++part) {
    const std::size_t slash = std::min(rest.find('/'), rest.size());
    const std::string_view text = rest.substr(0, slash);
    if (part == 0) {
      if (!check_index(word, text)) {
        return false;
      }
    } else if (!text.empty()) {
      const std::optional<std::int64_t> index = parse_index(text);
      if (!index) {
        return refuse(word, fmt::format("{} is not a corner of a face; it should read like 7, "
                                        "7/2, 7/2/5 or 7//5.",
                                        quoted(word)));
      }
      uv = part == 1 ? resolve_uv(*index, soup_.uvs.size()) : uv;
    }
    const bool has_more = slash < rest.size();
    if (has_more && part == 2) {
      return refuse(word, fmt::format("{} has more than three indices.", quoted(word)));
    }
    rest.remove_prefix(std::min(slash + 1, rest.size()));
    if (!has_more) {
      break;
    }
  }
  face_uvs_.push_back(uv);
  return true;
}

bool ObjStatements::check_index(std::string_view token, std::string_view index) {
  const std::optional<std::int64_t> value = parse_index(index);
  if (!value) {
    return refuse(token, fmt::format("{} is not a corner of a face; it should read like 7, 7/2, "
                                     "7/2/5 or 7//5.",
                                     quoted(token)));
  }
  if (*value == 0) {
    return refuse(token, "A face names vertex 0; vertices are counted from 1.");
  }
  if (*value < -vertices_) {
    return refuse(token, fmt::format("A face names vertex {}, counted back from here, but only {} "
                                     "{} before it.",
                                     *value, vertices_, vertices_ == 1 ? "stands" : "stand"));
  }
  if (*value > std::numeric_limits<int>::max()) {
    return refuse(token, fmt::format("A face names vertex {}; the most a mesh can have are {}.",
                                     *value, std::numeric_limits<int>::max()));
  }
  return true;
}

/// A second number that is left out is 0; a third one is not used.
bool ObjStatements::read_uv(std::string_view arguments) {
  constexpr double largest_uv = 1e18;  // Refined ones are single precision.
  double numbers[3] = {0.0, 0.0, 0.0};
  std::size_t count = 0;
  for (std::string_view word = take_word(arguments); !word.empty(); word = take_word(arguments)) {
    if (count == std::size(numbers)) {
      return refuse(word,
                    "A texture coordinate has two numbers, perhaps three; this one has more.");
    }
    if (!parse_number(word, numbers[count])) {
      return refuse(word, fmt::format("{} is not a number.", quoted(word)));
    }
    ++count;
  }
  if (count == 0) {
    return refuse(statement_, "A texture coordinate needs two numbers; this one has none.");
  }
  if (numbers[2] != 0.0) {
    unused_.count_uv_depth();
  }
  glm::dvec2 uv(numbers[0], numbers[1]);
  // Written so that what is not a number fails it too.
  if (!(std::abs(uv.x) <= largest_uv && std::abs(uv.y) <= largest_uv)) {
    uv = glm::dvec2(0.0);
    ++broken_uvs_;
  }
  soup_.uvs.push_back(uv);
  return true;
}

bool ObjStatements::read_tag(std::string_view arguments) {
  const TagReading reading = detail::read_tag(arguments, soup_);
  if (!reading.message.empty()) {
    return refuse(reading.culprit.empty() ? std::string_view(statement_) : reading.culprit,
                  reading.message);
  }
  if (!reading.is_used) {
    unused_.count("t", take_word(arguments));
  }
  return true;
}

/// `culprit` points into `statement_`; it tells the line.
bool ObjStatements::refuse(std::string_view culprit, std::string message) {
  const auto offset = static_cast<std::size_t>(culprit.data() - statement_.data());
  const auto after =
      std::upper_bound(breaks_.begin(), breaks_.end(), offset,
                       [](std::size_t o, const LineBreak& b) { return o < b.offset; });
  error_ = Error{ErrorKind::kBadInput, std::move(message), {}, std::prev(after)->line};
  return false;
}

}  // namespace limn::detail
