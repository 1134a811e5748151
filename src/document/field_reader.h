#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "json_lists.h"
#include "limn/contract.h"
#include "limn/error.h"

namespace limn {

/// Smallest and greatest value allowed, both included.
struct NumberRange {
  double low = -std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::max();
};

/// What an enumerator is called in a file.
template <class T>
struct Named {
  std::string_view name;
  T value;
};

template <class T, std::size_t n>
std::string_view name_of(T value, const std::array<Named<T>, n>& choices) {
  const auto found = std::ranges::find(choices, value, &Named<T>::value);
  LIMN_EXPECTS(found != choices.end());
  return found->name;
}

/// Looks fields up by their JSON path and remembers the first thing that was wrong, so that one
/// check at the end is enough. What is asked for after that gives arbitrary values.
class FieldReader {
 public:
  FieldReader(const std::vector<JsonField>& fields, std::string source)
      : fields_(fields), source_(std::move(source)) {}

  [[nodiscard]] const std::optional<Error>& error() const noexcept { return error_; }
  /// Remembers `message` about the value at `path`, unless something was wrong before.
  void complain(std::string_view path, std::string_view message);

  /// nullptr where there is none.
  [[nodiscard]] const JsonValue* find(std::string_view path) const;
  [[nodiscard]] bool is_absent(std::string_view path) const;
  void expect_object(std::string_view path);
  void expect_list(std::string_view path, std::size_t length);
  /// Of the lists that are kept apart from the fields: complains where one is not there.
  void expect_long_list(std::string_view path, bool is_there);

  double number(std::string_view path, NumberRange range = {});
  std::int64_t whole_number(std::string_view path, std::int64_t low, std::int64_t high);
  bool flag(std::string_view path);
  /// Without a zero byte, and of a length that a name or a path can have.
  std::string text(std::string_view path);

  template <class T, std::size_t n>
  T choice(std::string_view path, const std::array<Named<T>, n>& choices) {
    const std::string chosen = text(path);
    std::string names;
    for (const Named<T>& choice : choices) {
      if (choice.name == chosen) {
        return choice.value;
      }
      names += (names.empty() ? "\"" : ", \"") + std::string(choice.name) + "\"";
    }
    complain(path, "must be one of " + names + ".");
    return choices.front().value;
  }

 private:
  /// The value where it is a T; complains, and returns nullptr, where it is missing or is not.
  template <class T>
  const T* get(std::string_view path, std::string_view what);

  const std::vector<JsonField>& fields_;
  std::string source_;
  std::optional<Error> error_;
};

}  // namespace limn
