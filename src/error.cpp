#include "limn/error.h"

#include <fmt/format.h>

namespace limn {

std::string to_string(const Error& error) {
  if (error.path.empty()) {
    return error.message;
  }
  if (error.byte) {
    return fmt::format("{}: byte {}: {}", error.path, *error.byte, error.message);
  }
  if (error.line == 0) {
    return fmt::format("{}: {}", error.path, error.message);
  }
  return fmt::format("{}:{}: {}", error.path, error.line, error.message);
}

}  // namespace limn
