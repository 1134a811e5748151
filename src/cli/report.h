#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "cli/input.h"
#include "limn/document/document.h"
#include "limn/mesh/statistics.h"

namespace limn::cli {

/// The control mesh in numbers, and what was mended on import.
[[nodiscard]] nlohmann::ordered_json control_report(const Document& document);

/// The painting, its legalisation, the refined mesh against uniform subdivision, the crack check
/// and the times.
[[nodiscard]] nlohmann::ordered_json refinement_report(const Document& document,
                                                       const Derived& derived);

/// The moves of its legalisation in order: which vertices, to what label, and what they were chosen
/// by.
[[nodiscard]] nlohmann::ordered_json legalisation_report(const Document& document,
                                                         const Derived& derived);

/// The same for people: lines of "name  value", thousands separated.
[[nodiscard]] std::string control_text(const Document& document);
[[nodiscard]] std::string refinement_text(const Document& document, const Derived& derived);

}  // namespace limn::cli
