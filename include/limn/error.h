#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include <tl/expected.hpp>

namespace limn {

/// What kind of failure an Error is. The command line turns each kind into its exit code.
enum class ErrorKind {
  kFailed,       ///< The operation itself went wrong (a write failed, a conversion is impossible).
  kUsage,        ///< The request was malformed: an unknown rule, an option out of range.
  kBadInput,     ///< A file could not be read, parsed or used as a control mesh.
  kOverBudget,   ///< The result would have more faces than the caller allows.
  kCancelled,    ///< The caller's Progress asked to stop.
  kEnvironment,  ///< The machine lacks something: OpenGL 4.5, a display, a library.
};

/// A failure as a value: what went wrong, where, and what to do about it.
///
/// `message` is a full sentence for people. `path` is empty where no file is involved; `line` is
/// 1-based and 0 where no line is meant. In a binary file `byte` says where, from 0.
struct Error {
  ErrorKind kind = ErrorKind::kFailed;
  std::string message;
  std::string path;
  std::size_t line = 0;
  std::optional<std::size_t> byte = std::nullopt;
};

/// The error on one line, `path:line: message` or `path: byte N: message`, leaving out what is not
/// known.
[[nodiscard]] std::string to_string(const Error& error);

/// Either a value or the Error that explains why there is none.
template <class T>
using Result = tl::expected<T, Error>;

/// Shorthand for returning a failure from a function that returns Result.
[[nodiscard]] inline tl::unexpected<Error> fail(ErrorKind kind, std::string message,
                                                std::string path = {}, std::size_t line = 0) {
  return tl::unexpected<Error>(Error{kind, std::move(message), std::move(path), line});
}

}  // namespace limn
