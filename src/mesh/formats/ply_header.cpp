// Lines of words. Whether lines end with CR alone is told by the first one. It matters at the last:
// a binary body may begin with a byte that looks like LF.
#include "mesh/formats/ply_header.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "mesh/counted.h"
#include "mesh/formats/parse_number.h"
#include "mesh/formats/refusal.h"
#include "mesh/formats/text_cursor.h"
#include "mesh/formats/words.h"

namespace limn::detail {
namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr TypeName TypeNames[] = {
    {"char", PlyType::kInt8},       {"int8", PlyType::kInt8},      {"uchar", PlyType::kUint8},
    {"uint8", PlyType::kUint8},     {"short", PlyType::kInt16},    {"int16", PlyType::kInt16},
    {"ushort", PlyType::kUint16},   {"uint16", PlyType::kUint16},  {"int", PlyType::kInt32},
    {"int32", PlyType::kInt32},     {"uint", PlyType::kUint32},    {"uint32", PlyType::kUint32},
    {"int64", PlyType::kInt64},     {"uint64", PlyType::kUint64},  {"float", PlyType::kFloat32},
    {"float32", PlyType::kFloat32}, {"double", PlyType::kFloat64}, {"float64", PlyType::kFloat64},
};

class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, const std::string& source)
      : bytes_(bytes), source_(source), cursor_(bytes) {}
  [[nodiscard]] Result<PlyHeader> read();

 private:
  bool read_line(std::string_view keyword);
  bool read_format();
  bool read_element();
  bool read_property();
  bool read_type(std::string_view word, PlyType& type);
  bool find_body();
  bool check_size();
  bool refuse(std::string message);

  std::string_view bytes_;
  const std::string& source_;
  TextCursor cursor_;
  PlyHeader header_;
  bool has_format_ = false;
  Error error_;
};

bool HeaderReader::refuse(std::string message) {
  error_ = refuse_line(source_, cursor_.line(), std::move(message)).value();
  return false;
}

Result<PlyHeader> HeaderReader::read() {
  bool is_good = cursor_.next_word() == "ply" || refuse("A PLY file begins with a line \"ply\".");
  std::string_view keyword;
  while (is_good) {
    is_good = cursor_.next_line() || refuse("The file ends within its header.");
    keyword = cursor_.next_word();
    if (!is_good || keyword == "end_header") {
      break;
    }
    is_good = read_line(keyword);
  }
  is_good = is_good && (has_format_ || refuse("The header does not say what format it has."));
  is_good = is_good && find_body() && check_size();
  if (!is_good) {
    return tl::unexpected<Error>(std::move(error_));
  }
  return std::move(header_);
}

bool HeaderReader::read_line(std::string_view keyword) {
  if (keyword == "format") {
    return read_format();
  }
  if (keyword == "element") {
    return read_element();
  }
  if (keyword == "property") {
    return read_property();
  }
  if (keyword == "obj_info") {
    header_.remarks.push_back(cursor_.rest_of_line());
    return true;
  }
  return keyword.empty() || keyword == "comment" ||
         refuse(fmt::format("{} is no line of a PLY header.", quoted(keyword)));
}

bool HeaderReader::read_format() {
  const std::string_view word = cursor_.next_word();
  has_format_ = true;
  if (word == "ascii") {
    header_.encoding = PlyEncoding::kAscii;
  } else if (word == "binary_little_endian") {
    header_.encoding = PlyEncoding::kLittleEndian;
  } else if (word == "binary_big_endian") {
    header_.encoding = PlyEncoding::kBigEndian;
  } else {
    return refuse(
        fmt::format("{} is no PLY format; there are ascii, binary_little_endian and "
                    "binary_big_endian.",
                    quoted(word)));
  }
  const std::string_view version = cursor_.next_word();
  return version == "1.0" ||
         refuse(fmt::format("PLY version {} is not known; 1.0 is.", quoted(version)));
}

bool HeaderReader::read_element() {
  PlyElement element;
  element.line = cursor_.line();
  element.name = cursor_.next_word();
  const std::string_view word = cursor_.next_word();
  const std::optional<std::int64_t> count = parse_index(word);
  if (element.name.empty() || !count || *count < 0) {
    return refuse(
        fmt::format("An element has a name and a number, as in \"element vertex 8\"; "
                    "here the number is {}.",
                    quoted(word)));
  }
  if (*count > std::numeric_limits<std::uint32_t>::max()) {
    return refuse(fmt::format("The file announces {} {} elements, more than a mesh can have.",
                              *count, quoted(element.name)));
  }
  element.count = static_cast<std::uint64_t>(*count);
  header_.elements.push_back(std::move(element));
  return true;
}

bool HeaderReader::read_type(std::string_view word, PlyType& type) {
  for (const TypeName& known : TypeNames) {
    if (known.name == word) {
      type = known.type;
      return true;
    }
  }
  return refuse(fmt::format("{} is no type of a PLY property.", quoted(word)));
}

bool HeaderReader::read_property() {
  if (header_.elements.empty()) {
    return refuse("A property stands before any element.");
  }
  PlyProperty property{};
  std::string_view word = cursor_.next_word();
  if (word == "list") {
    PlyType count_type{};
    if (!read_type(cursor_.next_word(), count_type)) {
      return false;
    }
    property.count_type = count_type;
    word = cursor_.next_word();
  }
  if (!read_type(word, property.type)) {
    return false;
  }
  property.name = cursor_.next_word();
  header_.elements.back().properties.push_back(property);
  return !property.name.empty() || refuse("This property has no name.");
}

/// Goes over the end of the header's last line.
bool HeaderReader::find_body() {
  const std::string_view first_end = bytes_.substr(bytes_.find_first_of("\r\n"));
  const bool is_single = first_end.starts_with('\r') && !first_end.starts_with("\r\n");
  static_cast<void>(cursor_.rest_of_line());
  const std::string_view rest = bytes_.substr(bytes_.size() - cursor_.bytes_left());
  const std::size_t length = !is_single && rest.starts_with("\r\n") ? 2 : 1;
  header_.size = bytes_.size() - rest.size() + std::min(length, rest.size());
  header_.lines = cursor_.line();
  return true;
}

bool HeaderReader::check_size() {
  const bool is_text = header_.encoding == PlyEncoding::kAscii;
  std::uint64_t left = bytes_.size() - header_.size;
  // In a text every number takes a byte, and one to part it from the next.
  left += is_text ? 1 : 0;
  for (const PlyElement& element : header_.elements) {
    std::uint64_t least = 0;
    for (const PlyProperty& property : element.properties) {
      least += is_text ? 2 : size_of(property.count_type.value_or(property.type));
    }
    if (element.count * least > left) {
      error_ = refuse_line(source_, element.line,
                           fmt::format("The file announces {} {} elements and ends before it "
                                       "could hold them; {} follow the header.",
                                       element.count, quoted(element.name),
                                       counted(bytes_.size() - header_.size, "byte")))
                   .value();
      return false;
    }
    left -= element.count * least;
  }
  return true;
}

}  // namespace

std::size_t size_of(PlyType type) noexcept {
  switch (type) {
    case PlyType::kInt8:
    case PlyType::kUint8:
      return 1;
    case PlyType::kInt16:
    case PlyType::kUint16:
      return 2;
    case PlyType::kInt32:
    case PlyType::kUint32:
    case PlyType::kFloat32:
      return 4;
    case PlyType::kInt64:
    case PlyType::kUint64:
    case PlyType::kFloat64:
      return 8;
  }
  return 0;
}

Result<PlyHeader> read_ply_header(std::string_view bytes, const std::string& source) {
  return HeaderReader(bytes, source).read();
}

}  // namespace limn::detail
