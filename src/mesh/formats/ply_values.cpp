// Every number becomes a double: no type that is used holds more than one can. A number in text is
// of the type that the header gives it, so that what is written as a float comes back as that.
#include "mesh/formats/ply_values.h"

#include <bit>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "mesh/counted.h"
#include "mesh/formats/parse_number.h"
#include "mesh/formats/refusal.h"
#include "mesh/formats/words.h"

namespace limn::detail {

PlyValues::PlyValues(std::string_view bytes, const PlyHeader& header, const std::string& source)
    : source_(source),
      is_text_(header.encoding == PlyEncoding::kAscii),
      lines_before_(header.lines),
      text_(bytes.substr(header.size)),
      bytes_(bytes, header.size,
             header.encoding == PlyEncoding::kBigEndian ? std::endian::big : std::endian::little) {}

void PlyValues::begin(const PlyElement& element, std::uint64_t number) {
  element_ = &element;
  number_ = number;
  has_place_ = !is_text_;
  place_ = static_cast<std::uint32_t>(bytes_.at());
}

bool PlyValues::refuse(std::string message) {
  error_ = is_text_ ? refuse_line(source_, lines_before_ + text_.line(), std::move(message)).value()
                    : refuse_byte(source_, bytes_.at(), std::move(message)).value();
  return false;
}

bool PlyValues::refuse_end() {
  return refuse(fmt::format("The file ends within {} element {} of {}.", quoted(element_->name),
                            number_ + 1, element_->count));
}

bool PlyValues::next_in_text(double& value) {
  const std::string_view word = text_.next_word_anywhere();
  if (word.empty()) {
    return refuse_end();
  }
  if (!std::exchange(has_place_, true)) {
    place_ = lines_before_ + text_.line();
  }
  return parse_number(word, value) || refuse(fmt::format("{} is not a number.", quoted(word)));
}

bool PlyValues::next(PlyType type, double& value) {
  if (is_text_) {
    const bool is_read = next_in_text(value);
    value = type == PlyType::kFloat32 ? static_cast<double>(static_cast<float>(value)) : value;
    return is_read;
  }
  if (bytes_.bytes_left() < size_of(type)) {
    return refuse_end();
  }
  switch (type) {
    case PlyType::kInt8:
      value = bytes_.next<std::int8_t>();
      break;
    case PlyType::kUint8:
      value = bytes_.next<std::uint8_t>();
      break;
    case PlyType::kInt16:
      value = bytes_.next<std::int16_t>();
      break;
    case PlyType::kUint16:
      value = bytes_.next<std::uint16_t>();
      break;
    case PlyType::kInt32:
      value = bytes_.next<std::int32_t>();
      break;
    case PlyType::kUint32:
      value = bytes_.next<std::uint32_t>();
      break;
    case PlyType::kInt64:
      value = static_cast<double>(bytes_.next<std::int64_t>());
      break;
    case PlyType::kUint64:
      value = static_cast<double>(bytes_.next<std::uint64_t>());
      break;
    case PlyType::kFloat32:
      value = bytes_.next<float>();
      break;
    case PlyType::kFloat64:
      value = bytes_.next<double>();
      break;
  }
  return true;
}

bool PlyValues::next_length(const PlyProperty& list, std::size_t& length) {
  double value = 0.0;
  if (!next(*list.count_type, value)) {
    return false;
  }
  const std::size_t most =
      is_text_ ? (text_.bytes_left() + 1) / 2 : bytes_.bytes_left() / size_of(list.type);
  // Written so that what is not a number fails it too.
  if (!(value >= 0.0 && value <= static_cast<double>(most)) || std::floor(value) != value) {
    return refuse(
        fmt::format("A list {} announces {} numbers, but only {} follow.", quoted(list.name), value,
                    counted(is_text_ ? text_.bytes_left() : bytes_.bytes_left(), "byte")));
  }
  length = static_cast<std::size_t>(value);
  return true;
}

bool PlyValues::end() {
  if (!is_text_ || !has_place_) {
    return true;
  }
  const std::string_view word = text_.next_word();
  return word.empty() || refuse(fmt::format("{} is one number more than this {} has.", quoted(word),
                                            quoted(element_->name)));
}

std::size_t PlyValues::count_rest() {
  if (!is_text_) {
    return bytes_.bytes_left();
  }
  std::size_t lines = 0;
  while (text_.next_line()) {
    lines += text_.next_word().empty() ? 0 : 1;
  }
  return lines;
}

}  // namespace limn::detail
