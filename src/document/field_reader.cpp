#include "field_reader.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace limn {
namespace {

constexpr std::size_t kLongestText = 4096;

}  // namespace

void FieldReader::complain(std::string_view path, std::string_view message) {
  if (!error_) {
    error_ = Error{ErrorKind::kBadInput, fmt::format("{}: {}", path.empty() ? "/" : path, message),
                   source_, 0};
  }
}

const JsonValue* FieldReader::find(std::string_view path) const {
  const auto found = std::find_if(fields_.begin(), fields_.end(),
                                  [&](const JsonField& field) { return field.path == path; });
  return found == fields_.end() ? nullptr : &found->value;
}

bool FieldReader::is_absent(std::string_view path) const {
  const JsonValue* value = find(path);
  return value == nullptr || std::holds_alternative<JsonNull>(*value);
}

template <class T>
const T* FieldReader::get(std::string_view path, std::string_view what) {
  const JsonValue* value = find(path);
  if (value == nullptr) {
    complain(path, "is missing.");
    return nullptr;
  }
  const T* typed = std::get_if<T>(value);
  if (typed == nullptr) {
    complain(path, fmt::format("must be {}.", what));
  }
  return typed;
}

void FieldReader::expect_object(std::string_view path) {
  (void)get<JsonObject>(path, "an object");
}

void FieldReader::expect_list(std::string_view path, std::size_t length) {
  if (get<JsonList>(path, fmt::format("a list of {} values", length)) == nullptr) {
    return;
  }
  // Members have been counted where the last one is there and the one behind it is not.
  if (find(fmt::format("{}/{}", path, length - 1)) == nullptr ||
      find(fmt::format("{}/{}", path, length)) != nullptr) {
    complain(path, fmt::format("must be a list of {} values.", length));
  }
}

double FieldReader::number(std::string_view path, NumberRange range) {
  const JsonValue* value = find(path);
  double number = 0.0;
  if (value == nullptr) {
    complain(path, "is missing.");
    return number;
  }
  if (const auto* real = std::get_if<double>(value)) {
    number = *real;
  } else if (const auto* natural = std::get_if<std::uint64_t>(value)) {
    number = static_cast<double>(*natural);
  } else if (const auto* integer = std::get_if<std::int64_t>(value)) {
    number = static_cast<double>(*integer);
  } else {
    complain(path, "must be a number.");
    return number;
  }
  if (!(number >= range.low && number <= range.high)) {
    complain(path, fmt::format("{} is out of range; it must lie between {} and {}.", number,
                               range.low, range.high));
  }
  return number;
}

std::int64_t FieldReader::whole_number(std::string_view path, std::int64_t low, std::int64_t high) {
  const JsonValue* value = find(path);
  if (value == nullptr) {
    complain(path, "is missing.");
    return low;
  }
  std::optional<std::int64_t> number;
  if (const auto* natural = std::get_if<std::uint64_t>(value)) {
    constexpr auto kGreatest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    number = static_cast<std::int64_t>(std::min(*natural, kGreatest));
  } else if (const auto* integer = std::get_if<std::int64_t>(value)) {
    number = *integer;
  }
  if (!number || *number < low || *number > high) {
    complain(path, fmt::format("must be a whole number from {} to {}.", low, high));
    return low;
  }
  return *number;
}

bool FieldReader::flag(std::string_view path) {
  const bool* value = get<bool>(path, "true or false");
  return value != nullptr && *value;
}

std::string FieldReader::text(std::string_view path) {
  const std::string* value = get<std::string>(path, "a text");
  if (value == nullptr) {
    return {};
  }
  if (value->size() > kLongestText) {
    complain(path, fmt::format("is longer than {} bytes.", kLongestText));
    return {};
  }
  if (value->find('\0') != std::string::npos) {
    complain(path, "holds a zero byte.");
    return {};
  }
  return *value;
}

void FieldReader::expect_long_list(std::string_view path, bool is_there) {
  if (!is_there) {
    complain(path, find(path) == nullptr ? "is missing." : "must be a list.");
  }
}

}  // namespace limn
