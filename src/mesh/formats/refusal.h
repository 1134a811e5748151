#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "limn/error.h"

namespace limn::detail {

/// A text is bad at this line.
[[nodiscard]] inline tl::unexpected<Error> refuse_line(const std::string& source, std::size_t line,
                                                       std::string message) {
  return fail(ErrorKind::kBadInput, std::move(message), source, line);
}

/// Binary data is bad at this byte.
[[nodiscard]] inline tl::unexpected<Error> refuse_byte(const std::string& source, std::size_t byte,
                                                       std::string message) {
  Error error{ErrorKind::kBadInput, std::move(message), source, 0};
  error.byte = byte;
  return tl::unexpected<Error>(std::move(error));
}

}  // namespace limn::detail
