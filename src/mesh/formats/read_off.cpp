// Numbers may wrap over lines as they like, except that a face's colour is what is left of its
// line. Where the text has a line for every vertex and face, what is left of a vertex's line is the
// vertex's; else vertices share lines, and each has the numbers that the header gives it.
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "mesh/counted.h"
#include "mesh/formats/off_binary.h"
#include "mesh/formats/off_header.h"
#include "mesh/formats/parse_number.h"
#include "mesh/formats/readers.h"
#include "mesh/formats/refusal.h"
#include "mesh/formats/soup_values.h"
#include "mesh/formats/text_cursor.h"
#include "mesh/formats/unused_data.h"
#include "mesh/formats/words.h"

namespace limn::detail {
namespace {

class OffText {
 public:
  /// `cursor` has read the header and `first_count`.
  OffText(const TextCursor& cursor, const OffVertex& vertex, const std::string& source)
      : cursor_(cursor), vertex_(vertex) {
    soup_.source = source;
  }
  [[nodiscard]] Result<PolygonSoup> read(std::string_view first_count);

 private:
  bool read_counts(std::string_view first_count);
  bool read_count(std::string_view word, std::string_view what, std::uint64_t& count);
  bool is_at_line_end() const;
  bool has_line_for_each() const;
  bool read_vertex();
  bool read_vertex_data();
  bool read_face();
  bool read_face_colour();
  bool read_number(std::string_view word, double& value);
  void count_what_follows();
  bool refuse(std::string message);

  TextCursor cursor_;
  OffVertex vertex_;
  PolygonSoup soup_;
  UnusedData unused_;
  std::uint64_t vertices_ = 0;
  std::uint64_t faces_ = 0;
  bool are_lines_ = true;  ///< Whether every vertex has a line of its own.
  Error error_;
};

Result<PolygonSoup> OffText::read(std::string_view first_count) {
  const auto refusal = [this] { return tl::unexpected<Error>(std::move(error_)); };
  if (!read_counts(first_count)) {
    return refusal();
  }
  are_lines_ = is_at_line_end() && has_line_for_each();
  soup_.positions.reserve(vertices_);
  while (soup_.positions.size() < vertices_) {
    if (!read_vertex()) {
      return refusal();
    }
  }
  while (soup_.face_count() < faces_) {
    if (!read_face()) {
      return refusal();
    }
  }
  count_what_follows();
  soup_.face_uvs = vertex_.has_uv ? soup_.face_vertices : std::vector<std::uint32_t>{};
  soup_.unused_data = unused_.phrases();
  return std::move(soup_);
}

bool OffText::refuse(std::string message) {
  error_ = refuse_line(soup_.source, cursor_.line(), std::move(message)).value();
  return false;
}

bool OffText::read_number(std::string_view word, double& value) {
  return parse_number(word, value) || refuse(fmt::format("{} is not a number.", quoted(word)));
}

bool OffText::read_count(std::string_view word, std::string_view what, std::uint64_t& count) {
  if (word.empty()) {
    return refuse(fmt::format("The file ends before it says how many {} it has.", what));
  }
  const std::optional<std::int64_t> value = parse_index(word);
  if (!value || *value < 0) {
    return refuse(fmt::format("{} is not a number of {}.", quoted(word), what));
  }
  count = static_cast<std::uint64_t>(*value);
  return true;
}

bool OffText::read_counts(std::string_view first_count) {
  if (!read_count(first_count, "vertices", vertices_)) {
    return false;
  }
  std::string_view word = cursor_.next_word();
  const bool is_one_line = !word.empty();
  if (!read_count(is_one_line ? word : cursor_.next_word_anywhere(), "faces", faces_)) {
    return false;
  }
  // The number of edges is often wrong and sometimes left out; nobody needs it.
  std::uint64_t edges = 0;
  word = is_one_line ? cursor_.next_word() : cursor_.next_word_anywhere();
  if (!word.empty() && !read_count(word, "edges", edges)) {
    return false;
  }
  // Every number takes a byte, and one to part it from the next.
  constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
  const std::size_t numbers = (cursor_.bytes_left() + 1) / 2;
  if (vertices_ > most || faces_ > most || vertices_ * vertex_.coordinates() + faces_ > numbers) {
    return refuse(fmt::format("This announces {} and {}, but only {} follow.",
                              counted(vertices_, "vertex", "vertices"), counted(faces_, "face"),
                              counted(cursor_.bytes_left(), "byte")));
  }
  return true;
}

bool OffText::is_at_line_end() const {
  TextCursor probe = cursor_;
  return probe.next_word().empty();
}

bool OffText::has_line_for_each() const {
  TextCursor probe = cursor_;
  std::uint64_t lines = 0;
  while (lines < vertices_ + faces_ && probe.next_line()) {
    lines += probe.next_word().empty() ? 0 : 1;
  }
  return lines >= vertices_ + faces_;
}

bool OffText::read_vertex() {
  std::array<double, 4> p{0.0, 0.0, 0.0, 1.0};
  std::uint32_t line = 0;
  for (std::size_t i = 0; i < vertex_.coordinates(); ++i) {
    const std::string_view word = cursor_.next_word_anywhere();
    if (word.empty()) {
      return refuse(fmt::format("The file ends within vertex {} of {}.", soup_.positions.size() + 1,
                                vertices_));
    }
    if (!read_number(word, p[i])) {
      return false;
    }
    line = i == 0 ? cursor_.line() : line;
  }
  if (vertex_.has_weight) {
    p = {p[0] / p[3], p[1] / p[3], p[2] / p[3], 1.0};
  }
  add_vertex(soup_, {p[0], p[1], p[2]}, line);
  return read_vertex_data();
}

/// Normal, colour and texture coordinate, in this order.
bool OffText::read_vertex_data() {
  const std::size_t normal = vertex_.has_normal ? 3 : 0;
  const std::size_t uv = vertex_.has_uv ? 2 : 0;
  constexpr std::size_t most_colour = 4;
  std::array<double, 3 + most_colour + 2> numbers{};
  const std::size_t most = normal + uv + (vertex_.has_colour || are_lines_ ? most_colour : 0);
  std::size_t count = 0;
  while (are_lines_ || count < most) {
    const std::string_view word = are_lines_ ? cursor_.next_word() : cursor_.next_word_anywhere();
    if (word.empty()) {
      break;
    }
    if (count == most) {
      return refuse("This line has more numbers than a vertex.");
    }
    if (!read_number(word, numbers[count])) {
      return false;
    }
    ++count;
  }
  if (count < normal + uv) {
    return refuse(fmt::format("Vertex {} has {} after its coordinates; the header announces {}.",
                              soup_.positions.size(), counted(count, "number"), normal + uv));
  }
  if (const std::size_t colour = count - normal - uv; colour == 1 || colour == 2) {
    return refuse(fmt::format("Vertex {} has {} more than a vertex, and not enough for a colour.",
                              soup_.positions.size(), counted(colour, "number")));
  }
  unused_.add(normal / 3, "normal");
  unused_.add(count > normal + uv ? 1 : 0, "vertex colour");
  if (uv > 0) {
    add_uv(soup_, numbers[count - 2], numbers[count - 1]);
  }
  return true;
}

bool OffText::read_face() {
  std::string_view word = cursor_.next_word_anywhere();
  if (word.empty()) {
    return refuse(
        fmt::format("The file ends after {} of {}.", soup_.face_count(), counted(faces_, "face")));
  }
  const std::uint32_t line = cursor_.line();
  const std::optional<std::int64_t> corners = parse_index(word);
  if (!corners || *corners < 0) {
    return refuse(fmt::format("{} is not a number of corners.", quoted(word)));
  }
  if (static_cast<std::uint64_t>(*corners) > (cursor_.bytes_left() + 1) / 2) {
    return refuse(fmt::format("A face announces {} corners, but only {} follow.", *corners,
                              counted(cursor_.bytes_left(), "byte")));
  }
  for (std::int64_t i = 0; i < *corners; ++i) {
    word = cursor_.next_word_anywhere();
    if (word.empty()) {
      return refuse(
          fmt::format("The file ends within face {} of {}.", soup_.face_count() + 1, faces_));
    }
    const std::optional<std::int64_t> vertex = parse_index(word);
    if (!vertex) {
      return refuse(fmt::format("{} is not the number of a vertex.", quoted(word)));
    }
    if (*vertex < 0 || static_cast<std::uint64_t>(*vertex) >= vertices_) {
      return refuse(fmt::format("A face names vertex {}, counted from 0, but the file has {}.",
                                *vertex, counted(vertices_, "vertex", "vertices")));
    }
    soup_.face_vertices.push_back(static_cast<std::uint32_t>(*vertex));
  }
  end_face(soup_, line);
  return read_face_colour();
}

/// Up to four numbers, or the number of a colour in a map.
bool OffText::read_face_colour() {
  constexpr int most = 4;
  double ignored = 0.0;
  int count = 0;
  for (std::string_view word = cursor_.next_word(); !word.empty(); word = cursor_.next_word()) {
    if (!read_number(word, ignored)) {
      return false;
    }
    if (++count > most) {
      return refuse("This line has more numbers than a face and its colour.");
    }
  }
  unused_.add(count > 0 ? 1 : 0, "face colour");
  return true;
}

void OffText::count_what_follows() {
  std::size_t lines = 0;
  while (cursor_.next_line()) {
    lines += cursor_.next_word().empty() ? 0 : 1;
  }
  unused_.add(lines, "line after the last face", "lines after the last face");
}

}  // namespace

Result<PolygonSoup> read_off(std::string_view bytes, const std::string& source) {
  TextCursor cursor(bytes, {'#', false});
  std::string_view word = cursor.next_word_anywhere();
  OffVertex vertex;
  // The keyword may be left out; then the counts come first.
  if (const std::optional<OffVertex> keyword = read_off_keyword(word)) {
    vertex = *keyword;
    const TextCursor behind = cursor;
    word = cursor.next_word();
    if (word == "BINARY") {
      static_cast<void>(cursor.next_line());
      return read_off_binary(bytes, bytes.size() - cursor.bytes_left(), vertex, source);
    }
    cursor = behind;
    word = cursor.next_word_anywhere();
    if (vertex.has_dimension) {
      if (word != "3") {
        return refuse_line(
            source, cursor.line(),
            fmt::format("The vertices have {} dimensions; three are read.", quoted(word)));
      }
      word = cursor.next_word_anywhere();
    }
  } else if (!parse_index(word)) {
    return refuse_line(source, cursor.line(),
                       fmt::format("{} is not how an OFF file begins.", quoted(word)));
  }
  return OffText(cursor, vertex, source).read(word);
}

}  // namespace limn::detail
