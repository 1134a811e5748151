// The format has big-endian numbers, and after each face's corners the size of its colour. Some
// libraries write their machine's own order, or no colours. What a file is follows from its size:
// the counts have to lead exactly to its end.
#include "mesh/formats/off_binary.h"

#include <bit>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

#include "mesh/formats/byte_cursor.h"
#include "mesh/formats/refusal.h"
#include "mesh/formats/soup_values.h"
#include "mesh/formats/unused_data.h"

namespace limn::detail {
namespace {

constexpr std::size_t OffWord = 4;

struct OffLayout {
  std::endian order;
  bool has_face_colours;
};
constexpr OffLayout OffLayouts[] = {
    {std::endian::big, true}, {std::endian::little, false}, {std::endian::little, true}};

struct OffCounts {
  std::uint64_t vertices;
  std::uint64_t faces;
};

std::size_t floats_of(const OffVertex& vertex) {
  return vertex.coordinates() + (vertex.has_normal ? 3 : 0) + (vertex.has_colour ? 4 : 0) +
         (vertex.has_uv ? 2 : 0);
}

/// Reads the counts and goes to the first vertex; nothing where the vertices and the least that
/// faces take do not fit.
std::optional<OffCounts> read_off_counts(ByteCursor& cursor, const OffVertex& vertex,
                                         const OffLayout& layout) {
  if (cursor.bytes_left() < 3 * OffWord) {
    return std::nullopt;
  }
  const OffCounts counts{cursor.next<std::uint32_t>(), cursor.next<std::uint32_t>()};
  cursor.skip(OffWord);
  const std::size_t face_words = layout.has_face_colours ? 2 : 1;
  const std::uint64_t least =
      OffWord * (counts.vertices * floats_of(vertex) + counts.faces * face_words);
  return least <= cursor.bytes_left() ? std::optional(counts) : std::nullopt;
}

/// Whether the faces from here on end where the file does.
bool do_faces_fit(ByteCursor cursor, std::uint64_t faces, const OffLayout& layout) {
  for (std::uint64_t f = 0; f < faces; ++f) {
    for (int list = 0; list < (layout.has_face_colours ? 2 : 1); ++list) {
      if (cursor.bytes_left() < OffWord) {
        return false;
      }
      const std::size_t size = OffWord * std::size_t{cursor.next<std::uint32_t>()};
      if (size > cursor.bytes_left()) {
        return false;
      }
      cursor.skip(size);
    }
  }
  return cursor.bytes_left() == 0;
}

PolygonSoup read_fitting(ByteCursor cursor, const OffCounts& counts, const OffVertex& vertex,
                         const OffLayout& layout) {
  PolygonSoup soup;
  soup.place_unit = PlaceUnit::kByte;
  soup.positions.reserve(counts.vertices);
  UnusedData unused;
  for (std::uint64_t v = 0; v < counts.vertices; ++v) {
    const std::size_t place = cursor.at();
    glm::dvec3 position(0.0);
    for (int i = 0; i < 3; ++i) {
      position[i] = cursor.next<float>();
    }
    if (vertex.has_weight) {
      position /= double{cursor.next<float>()};
    }
    cursor.skip(OffWord * ((vertex.has_normal ? 3 : 0) + (vertex.has_colour ? 4 : 0)));
    if (vertex.has_uv) {
      const float u = cursor.next<float>();
      add_uv(soup, u, cursor.next<float>());
    }
    add_vertex(soup, position, place);
  }
  for (std::uint64_t f = 0; f < counts.faces; ++f) {
    const std::size_t place = cursor.at();
    for (auto corners = cursor.next<std::uint32_t>(); corners > 0; --corners) {
      soup.face_vertices.push_back(cursor.next<std::uint32_t>());
    }
    if (layout.has_face_colours) {
      const auto size = cursor.next<std::uint32_t>();
      cursor.skip(OffWord * std::size_t{size});
      unused.add(size > 0 ? 1 : 0, "face colour");
    }
    end_face(soup, place);
  }
  unused.add(vertex.has_normal ? counts.vertices : 0, "normal");
  unused.add(vertex.has_colour ? counts.vertices : 0, "vertex colour");
  soup.face_uvs = vertex.has_uv ? soup.face_vertices : std::vector<std::uint32_t>{};
  soup.unused_data = unused.phrases();
  return soup;
}

}  // namespace

Result<PolygonSoup> read_off_binary(std::string_view bytes, std::size_t begin,
                                    const OffVertex& vertex, const std::string& source) {
  for (const OffLayout& layout : OffLayouts) {
    ByteCursor cursor(bytes, begin, layout.order);
    const std::optional<OffCounts> counts = read_off_counts(cursor, vertex, layout);
    if (!counts) {
      continue;
    }
    ByteCursor faces = cursor;
    faces.skip(OffWord * counts->vertices * floats_of(vertex));
    if (do_faces_fit(faces, counts->faces, layout)) {
      PolygonSoup soup = read_fitting(cursor, *counts, vertex, layout);
      soup.source = source;
      return soup;
    }
  }
  return refuse_byte(source, begin,
                     "The counts that begin here do not lead to the end of the file, in neither "
                     "byte order. The file is cut off or damaged.");
}

}  // namespace limn::detail
