#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "limn/error.h"

namespace limn::cli {

/// The same work on file after file: a bad one is reported and the others are done all the same.
class Batch {
 public:
  explicit Batch(const std::vector<std::string>& inputs) : is_single_(inputs.size() == 1) {}

  /// Does the work on one input. What it returns is its report; a failure is printed and noted.
  /// Nothing is done any more once the user has cancelled.
  void run(const std::string& input, const std::function<Result<nlohmann::ordered_json>()>& work);

  /// Of a single input its own report, or how it failed; of several a list with `input` and `ok` in
  /// each.
  [[nodiscard]] nlohmann::ordered_json report() const;
  /// Done, or the first failure's kind. Where there are several inputs it says how many failed.
  [[nodiscard]] Result<void> result() const;

 private:
  bool is_single_;
  std::size_t count_ = 0;
  std::size_t failed_ = 0;
  std::optional<Error> first_;
  std::vector<nlohmann::ordered_json> reports_;
};

}  // namespace limn::cli
