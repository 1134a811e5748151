#pragma once

#include <string>
#include <string_view>

#include "field_reader.h"
#include "limn/document/view_state.h"

namespace limn {

/// What a person may not see from: numbers that are not finite or out of range. Empty where all is
/// well.
[[nodiscard]] std::string fault_of(const ViewState& view);

/// The view as a JSON object on several lines, each after the first with `indent` before it.
[[nodiscard]] std::string view_json(const ViewState& view, std::string_view indent);

/// The view whose members stand under `prefix` ("/view", or "" for a camera file).
[[nodiscard]] ViewState read_view(FieldReader& fields, const std::string& prefix);

/// A number with as many digits as give it back; always read again as the same double.
[[nodiscard]] std::string json_number(double value);

}  // namespace limn
