// One pass, statement by statement; words are views into the text.
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "limn/mesh/control_mesh.h"
#include "mesh/counted.h"
#include "mesh/formats/depth_material.h"
#include "mesh/formats/obj_names.h"
#include "mesh/formats/obj_tags.h"
#include "mesh/formats/parse_number.h"
#include "mesh/formats/readers.h"
#include "mesh/formats/refusal.h"
#include "mesh/formats/soup_values.h"
#include "mesh/formats/text_cursor.h"
#include "mesh/formats/unused_data.h"
#include "mesh/formats/words.h"

namespace limn::detail {
namespace {

/// Depths that hold for the faces after them.
struct DepthLayer {
  std::uint32_t current = 0;
  std::vector<std::uint32_t> of_faces;
  bool is_used = false;

  void set(std::uint32_t depth) {
    current = depth;
    is_used = true;
  }
  void add_face(std::size_t face) {
    if (is_used) {
      of_faces.resize(face, 0);
      of_faces.push_back(current);
    }
  }
};

class ObjText {
 public:
  ObjText(std::string_view text, const std::string& source) : cursor_(text, {'#', true}) {
    soup_.source = source;
  }
  [[nodiscard]] Result<PolygonSoup> read();

 private:
  bool read_statement(std::string_view keyword);
  bool read_other(std::string_view keyword);
  bool read_vertex();
  bool read_uv();
  bool read_face();
  bool read_corner(std::string_view word);
  bool read_vertex_index(std::string_view word, std::string_view index);
  bool read_tag();
  void read_material();
  std::string joined_words();
  void skip_words();
  bool check_indices();
  bool check_malformed();
  void finish();
  bool refuse(std::string message) { return refuse(cursor_.line(), std::move(message)); }
  bool refuse(std::uint32_t line, std::string message);

  /// A coordinate that is no number.
  struct Malformed {
    std::uint32_t vertex;
    std::uint32_t line;
    std::string message;
  };

  TextCursor cursor_;
  PolygonSoup soup_;
  std::vector<Malformed> malformed_;
  UnusedData unused_;
  std::uint32_t line_ = 1;  ///< On which the statement begins.
  NameLayer objects_;
  NameLayer groups_;
  NameLayer materials_;
  DepthLayer tagged_;
  DepthLayer by_material_;
  Error error_;
};

Result<PolygonSoup> ObjText::read() {
  do {
    const std::string_view keyword = cursor_.next_word();
    line_ = cursor_.line();
    if (!keyword.empty() && !read_statement(keyword)) {
      return tl::unexpected<Error>(std::move(error_));
    }
  } while (cursor_.next_line());
  if (!check_indices() || !check_malformed()) {
    return tl::unexpected<Error>(std::move(error_));
  }
  finish();
  return std::move(soup_);
}

bool ObjText::refuse(std::uint32_t line, std::string message) {
  error_ = refuse_line(soup_.source, line, std::move(message)).value();
  return false;
}

bool ObjText::read_statement(std::string_view keyword) {
  if (keyword == "v") {
    return read_vertex();
  }
  // `fo` is the old name of `f`.
  if (keyword == "f" || keyword == "fo") {
    return read_face();
  }
  if (keyword == "vt") {
    return read_uv();
  }
  return read_other(keyword);
}

bool ObjText::read_other(std::string_view keyword) {
  if (keyword == "t") {
    return read_tag();
  }
  if (keyword == "usemtl") {
    read_material();
  } else if (keyword == "g") {
    groups_.set(joined_words());
  } else if (keyword == "o") {
    objects_.set(joined_words());
  } else if (keyword == "mtllib") {
    if (std::string library = joined_words(); library != DepthLibrary && !library.empty()) {
      soup_.names.material_libraries.push_back(std::move(library));
    }
  } else {
    count_obj_statement(unused_, keyword);
    skip_words();
  }
  return true;
}

void ObjText::skip_words() {
  while (!cursor_.next_word().empty()) {
  }
}

std::string ObjText::joined_words() {
  std::string joined;
  for (std::string_view word = cursor_.next_word(); !word.empty(); word = cursor_.next_word()) {
    joined += joined.empty() ? "" : " ";
    joined += word;
  }
  return joined;
}

/// Materials that are named for a depth are a painting and no materials.
void ObjText::read_material() {
  const std::string name = joined_words();
  const std::optional<std::uint32_t> depth = depth_of_material(name);
  materials_.set(depth ? std::string() : name);
  if (depth || by_material_.is_used) {
    by_material_.set(depth.value_or(0));
  }
}

bool ObjText::read_vertex() {
  std::array<double, 8> numbers{};
  std::size_t count = 0;
  for (std::string_view word = cursor_.next_word(); !word.empty(); word = cursor_.next_word()) {
    if (count == numbers.size()) {
      return refuse(
          "A vertex has three coordinates, perhaps a weight and a colour; this one has more than "
          "eight numbers.");
    }
    if (!parse_number(word, numbers[count])) {
      numbers[count] = std::numeric_limits<double>::quiet_NaN();
      malformed_.push_back({static_cast<std::uint32_t>(soup_.positions.size()), cursor_.line(),
                            fmt::format("{} is not a number.", quoted(word))});
    }
    ++count;
  }
  if (count < 3) {
    return refuse(line_, fmt::format("A vertex needs three coordinates; this one has {}.", count));
  }
  add_vertex(soup_, {numbers[0], numbers[1], numbers[2]}, line_);
  if (count == 4 && numbers[3] != 1.0) {
    unused_.add(1, "vertex weight");
  } else if (count > 4) {
    unused_.add(1, "vertex colour");
  }
  return true;
}

/// A second number that is left out is 0; a third one is not used.
bool ObjText::read_uv() {
  std::array<double, 3> numbers{};
  std::size_t count = 0;
  for (std::string_view word = cursor_.next_word(); !word.empty(); word = cursor_.next_word()) {
    if (count == numbers.size()) {
      return refuse("A texture coordinate has two numbers, perhaps three; this one has more.");
    }
    if (!parse_number(word, numbers[count])) {
      return refuse(fmt::format("{} is not a number.", quoted(word)));
    }
    ++count;
  }
  if (count == 0) {
    return refuse(line_, "A texture coordinate needs two numbers; this one has none.");
  }
  unused_.add(numbers[2] != 0.0 ? 1 : 0, "third texture coordinate");
  add_uv(soup_, numbers[0], numbers[1]);
  return true;
}

bool ObjText::read_face() {
  const std::size_t before = soup_.face_vertices.size();
  for (std::string_view word = cursor_.next_word(); !word.empty(); word = cursor_.next_word()) {
    if (!read_corner(word)) {
      return false;
    }
  }
  if (soup_.face_vertices.size() == before) {
    return refuse(line_, "This face has no corners.");
  }
  const std::size_t face = soup_.face_count();
  end_face(soup_, line_);
  objects_.add_face(face);
  groups_.add_face(face);
  materials_.add_face(face);
  tagged_.add_face(face);
  by_material_.add_face(face);
  return true;
}

/// v, v/vt, v/vt/vn or v//vn; normals are not used, but all have to be numbers.
bool ObjText::read_corner(std::string_view word) {
  std::string_view rest = word;
  std::uint32_t uv = kNone;
  for (int part = 0;; ++part) {
    const std::size_t slash = std::min(rest.find('/'), rest.size());
    const std::string_view text = rest.substr(0, slash);
    if (part == 0) {
      if (!read_vertex_index(word, text)) {
        return false;
      }
    } else if (!text.empty()) {
      const std::optional<std::int64_t> index = parse_index(text);
      if (!index) {
        return refuse(
            fmt::format("{} is not a corner of a face; it should read like 7, 7/2, 7/2/5 "
                        "or 7//5.",
                        quoted(word)));
      }
      // It may name what comes later.
      const std::int64_t resolved =
          *index > 0 ? *index - 1 : static_cast<std::int64_t>(soup_.uvs.size()) + *index;
      if (part == 1 && *index != 0 && resolved >= 0 && resolved < std::int64_t{kNone}) {
        uv = static_cast<std::uint32_t>(resolved);
      }
    }
    if (slash == rest.size()) {
      break;
    }
    if (part == 2) {
      return refuse(fmt::format("{} has more than three indices.", quoted(word)));
    }
    rest.remove_prefix(slash + 1);
  }
  if (uv != kNone || !soup_.face_uvs.empty()) {
    soup_.face_uvs.resize(soup_.face_vertices.size() - 1, kNone);
    soup_.face_uvs.push_back(uv);
  }
  return true;
}

bool ObjText::read_vertex_index(std::string_view word, std::string_view index) {
  const std::optional<std::int64_t> value = parse_index(index);
  const auto count = static_cast<std::int64_t>(soup_.positions.size());
  if (!value) {
    return refuse(
        fmt::format("{} is not a corner of a face; it should read like 7, 7/2, 7/2/5 or "
                    "7//5.",
                    quoted(word)));
  }
  if (*value == 0) {
    return refuse("A face names vertex 0; vertices are counted from 1.");
  }
  if (*value < -count) {
    return refuse(
        fmt::format("A face names vertex {}, counted back from here, but only {} {} "
                    "before it.",
                    *value, count, count == 1 ? "stands" : "stand"));
  }
  if (*value > std::int64_t{kNone}) {
    return refuse(fmt::format("A face names vertex {}, more than a mesh can have.", *value));
  }
  soup_.face_vertices.push_back(
      static_cast<std::uint32_t>(*value > 0 ? *value - 1 : count + *value));
  return true;
}

bool ObjText::read_tag() {
  const std::string_view name = cursor_.next_word();
  const TagReading reading = detail::read_tag(name, cursor_, soup_);
  if (!reading.message.empty()) {
    return refuse(reading.line != 0 ? reading.line : line_, reading.message);
  }
  if (reading.depth) {
    tagged_.set(*reading.depth);
  }
  if (!reading.is_used) {
    unused_.add_named(1, name, "tag");
    skip_words();
  }
  return true;
}

/// A face may name vertices that come later, so this waits for the end.
bool ObjText::check_indices() {
  for (std::size_t f = 0; f < soup_.face_count(); ++f) {
    for (const std::uint32_t v : soup_.face(f)) {
      if (v >= soup_.positions.size()) {
        return refuse(soup_.face_places[f],
                      fmt::format("A face names vertex {}, but the file has {}.", v + 1ULL,
                                  counted(soup_.positions.size(), "vertex", "vertices")));
      }
    }
  }
  return true;
}

/// Numbers that could not be read do no harm in vertices of no face, where there are others.
bool ObjText::check_malformed() {
  if (malformed_.empty()) {
    return true;
  }
  std::vector<std::uint8_t> is_used(soup_.positions.size(), 0);
  for (const std::uint32_t v : soup_.face_vertices) {
    is_used[v] = 1;
  }
  for (Malformed& malformed : malformed_) {
    if (is_used[malformed.vertex] != 0 || soup_.face_count() == 0) {
      return refuse(malformed.line, std::move(malformed.message));
    }
  }
  return true;
}

void ObjText::finish() {
  const std::size_t faces = soup_.face_count();
  if (!soup_.face_uvs.empty()) {
    soup_.face_uvs.resize(soup_.face_vertices.size(), kNone);
  }
  unused_.add(objects_.unused(), "object without faces", "objects without faces");
  unused_.add(groups_.unused(), "group without faces", "groups without faces");
  unused_.add(materials_.unused(), "material without faces", "materials without faces");
  soup_.names.objects = objects_.take(faces);
  soup_.names.groups = groups_.take(faces);
  soup_.names.materials = materials_.take(faces);
  // Tags are more than materials, which other programs may have changed.
  DepthLayer& depths = tagged_.is_used ? tagged_ : by_material_;
  if (!depths.of_faces.empty()) {
    depths.of_faces.resize(faces, 0);
    soup_.face_depths = std::move(depths.of_faces);
  }
  soup_.unused_data = unused_.phrases();
}

}  // namespace

Result<PolygonSoup> read_obj(std::string_view bytes, const std::string& source) {
  if (const std::size_t zero = bytes.find('\0'); zero != std::string_view::npos) {
    return refuse_byte(source, zero, "This is binary data and not the text of an OBJ file.");
  }
  return ObjText(bytes, source).read();
}

}  // namespace limn::detail
