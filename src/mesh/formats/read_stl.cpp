// Corners are gathered as they come and welded at the end. Binary data that begins with "solid",
// which some programs write, is told by its size.
#include <algorithm>
#include <bit>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "mesh/counted.h"
#include "mesh/formats/byte_cursor.h"
#include "mesh/formats/parse_number.h"
#include "mesh/formats/readers.h"
#include "mesh/formats/refusal.h"
#include "mesh/formats/soup_values.h"
#include "mesh/formats/text_cursor.h"
#include "mesh/formats/unused_data.h"
#include "mesh/formats/weld.h"
#include "mesh/formats/words.h"

namespace limn::detail {
namespace {

constexpr std::size_t StlHeaderSize = 80;
constexpr std::size_t StlFacetsBegin = StlHeaderSize + 4;
constexpr std::size_t StlFacetSize = 50;

/// Gives corners at the same place the same vertex. So far every corner has one of its own.
void weld_corners(PolygonSoup& soup) {
  std::vector<WeldKey> keys;
  keys.reserve(soup.positions.size());
  for (const glm::dvec3& position : soup.positions) {
    keys.push_back(weld_key(position));
  }
  Welding welding = weld(keys);
  // The first of equal ones come in rising order, so nothing is overwritten before it is read.
  for (std::size_t v = 0; v < welding.first.size(); ++v) {
    soup.positions[v] = soup.positions[welding.first[v]];
    soup.vertex_places[v] = soup.vertex_places[welding.first[v]];
  }
  soup.positions.resize(welding.first.size());
  soup.vertex_places.resize(welding.first.size());
  soup.face_vertices = std::move(welding.numbers);
}

std::size_t announced_facets(std::string_view bytes) {
  return ByteCursor(bytes, StlHeaderSize, std::endian::little).next<std::uint32_t>();
}

Result<PolygonSoup> read_stl_binary(std::string_view bytes, const std::string& source) {
  if (bytes.size() < StlFacetsBegin) {
    return refuse_byte(source, bytes.size(),
                       fmt::format("The file ends within the header of {} bytes.", StlFacetsBegin));
  }
  const std::size_t facets = announced_facets(bytes);
  const std::size_t held = (bytes.size() - StlFacetsBegin) / StlFacetSize;
  if (facets > held) {
    return refuse_byte(source, StlHeaderSize,
                       fmt::format("This announces {}, but there is room for {}. The file is cut "
                                   "off, or no STL.",
                                   counted(facets, "facet"), held));
  }
  PolygonSoup soup;
  soup.source = source;
  soup.place_unit = PlaceUnit::kByte;
  soup.positions.reserve(3 * facets);
  soup.vertex_places.reserve(3 * facets);
  std::size_t normals = 0;
  std::size_t attributes = 0;
  ByteCursor cursor(bytes, StlFacetsBegin, std::endian::little);
  for (std::size_t f = 0; f < facets; ++f) {
    const std::size_t place = cursor.at();
    bool has_normal = false;
    for (int i = 0; i < 3; ++i) {
      has_normal |= cursor.next<float>() != 0.0f;
    }
    for (int corner = 0; corner < 3; ++corner) {
      const std::size_t corner_place = cursor.at();
      glm::dvec3 position;
      for (int i = 0; i < 3; ++i) {
        position[i] = cursor.next<float>();
      }
      add_vertex(soup, position, corner_place);
    }
    attributes += cursor.next<std::uint16_t>() != 0 ? 1 : 0;
    normals += has_normal ? 1 : 0;
    soup.face_offsets.push_back(static_cast<std::uint32_t>(3 * (f + 1)));
    soup.face_places.push_back(static_cast<std::uint32_t>(place));
  }
  UnusedData unused;
  const std::string_view header = bytes.substr(0, StlHeaderSize);
  unused.add(header.find_first_not_of(std::string_view(" \0", 2)) != std::string_view::npos ? 1 : 0,
             "header text");
  unused.add(normals, "facet normal");
  unused.add(attributes, "facet attribute");
  unused.add(cursor.bytes_left(), "byte after the last facet", "bytes after the last facet");
  soup.unused_data = unused.phrases();
  weld_corners(soup);
  return soup;
}

/// Keywords come in either case.
bool is_stl_word(std::string_view word, std::string_view keyword) {
  return word.size() == keyword.size() &&
         std::equal(word.begin(), word.end(), keyword.begin(), [](char a, char b) {
           return std::tolower(static_cast<unsigned char>(a)) == b;
         });
}

class StlText {
 public:
  StlText(std::string_view text, const std::string& source) : cursor_(text) {
    soup_.source = source;
  }
  [[nodiscard]] Result<PolygonSoup> read();

 private:
  bool read_solid();
  bool read_facet();
  bool read_numbers(glm::dvec3& numbers);
  bool expect(std::string_view keyword);
  void begin_object(std::string_view name);
  bool refuse(std::string message);

  TextCursor cursor_;
  PolygonSoup soup_;
  UnusedData unused_;
  std::uint32_t object_ = kNone;
  Error error_;
};

Result<PolygonSoup> StlText::read() {
  while (true) {
    const std::string_view word = cursor_.next_word_anywhere();
    if (word.empty()) {
      break;
    }
    if (!is_stl_word(word, "solid")) {
      refuse(fmt::format("{} stands where a solid should begin.", quoted(word)));
      return tl::unexpected<Error>(std::move(error_));
    }
    if (!read_solid()) {
      return tl::unexpected<Error>(std::move(error_));
    }
  }
  if (soup_.names.objects.names.empty()) {
    soup_.names.objects.of_faces.clear();
  }
  weld_corners(soup_);
  soup_.unused_data = unused_.phrases();
  return std::move(soup_);
}

bool StlText::refuse(std::string message) {
  error_ = refuse_line(soup_.source, cursor_.line(), std::move(message)).value();
  return false;
}

void StlText::begin_object(std::string_view name) {
  object_ = kNone;
  if (!name.empty()) {
    object_ = static_cast<std::uint32_t>(soup_.names.objects.names.size());
    soup_.names.objects.names.emplace_back(name);
  }
}

bool StlText::read_solid() {
  begin_object(cursor_.rest_of_line());
  while (true) {
    const std::string_view word = cursor_.next_word_anywhere();
    if (word.empty()) {
      return refuse("The file ends before its solid does, at \"endsolid\".");
    }
    if (is_stl_word(word, "endsolid")) {
      static_cast<void>(cursor_.rest_of_line());
      return true;
    }
    if (is_stl_word(word, "color")) {
      static_cast<void>(cursor_.rest_of_line());
      unused_.add(1, "colour");
    } else if (!is_stl_word(word, "facet")) {
      return refuse(
          fmt::format("{} stands where a facet or the end of the solid should be.", quoted(word)));
    } else if (!read_facet()) {
      return false;
    }
  }
}

bool StlText::expect(std::string_view keyword) {
  const std::string_view word = cursor_.next_word_anywhere();
  if (word.empty()) {
    return refuse(fmt::format("The file ends where \"{}\" should stand.", keyword));
  }
  return is_stl_word(word, keyword) ||
         refuse(fmt::format("{} stands where \"{}\" should.", quoted(word), keyword));
}

bool StlText::read_numbers(glm::dvec3& numbers) {
  for (int i = 0; i < 3; ++i) {
    const std::string_view word = cursor_.next_word_anywhere();
    if (!parse_number(word, numbers[i])) {
      return refuse(word.empty() ? std::string("The file ends where a number should stand.")
                                 : fmt::format("{} is not a number.", quoted(word)));
    }
  }
  return true;
}

bool StlText::read_facet() {
  const std::uint32_t line = cursor_.line();
  glm::dvec3 normal;
  if (!expect("normal") || !read_numbers(normal) || !expect("outer") || !expect("loop")) {
    return false;
  }
  unused_.add(normal != glm::dvec3(0.0) ? 1 : 0, "facet normal");
  while (true) {
    const std::string_view word = cursor_.next_word_anywhere();
    if (is_stl_word(word, "endloop")) {
      break;
    }
    if (!is_stl_word(word, "vertex")) {
      return refuse(word.empty() ? std::string("The file ends within a facet.")
                                 : fmt::format("{} stands where a vertex or the end of the loop "
                                               "should be.",
                                               quoted(word)));
    }
    const std::uint32_t corner_line = cursor_.line();
    glm::dvec3 position;
    if (!read_numbers(position)) {
      return false;
    }
    add_vertex(soup_, position, corner_line);
  }
  soup_.face_offsets.push_back(static_cast<std::uint32_t>(soup_.positions.size()));
  soup_.face_places.push_back(line);
  soup_.names.objects.of_faces.push_back(object_);
  return expect("endfacet");
}

}  // namespace

bool is_binary_stl(std::string_view bytes) noexcept {
  return bytes.size() >= StlFacetsBegin &&
         bytes.size() == StlFacetsBegin + StlFacetSize * announced_facets(bytes);
}

Result<PolygonSoup> read_stl(std::string_view bytes, const std::string& source) {
  TextCursor first(bytes);
  const bool is_text = is_stl_word(first.next_word_anywhere(), "solid") &&
                       bytes.find('\0') == std::string_view::npos;
  return is_text && !is_binary_stl(bytes) ? StlText(bytes, source).read()
                                          : read_stl_binary(bytes, source);
}

}  // namespace limn::detail
