#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "limn/document/document.h"
#include "limn/error.h"
#include "limn/subdivision/fine_demands.h"

namespace CLI {
class App;
}

// Demands on faces finer than control faces, on the command line.
namespace limn::cli {

/// Drops all demands there are.
struct DropDemands {};
using FineRule = std::variant<FineDemand, DropDemands>;

/// "FACE/LEVEL/COLUMN/ROW=DEPTH", FACE.CORNER where the face is no quad, or "none".
/// Errors: kUsage.
[[nodiscard]] Result<FineRule> parse_fine_rule(std::string_view text);

/// Adds --fine.
void add_fine_option(CLI::App& command, std::vector<FineRule>& rules);

/// Errors: kUsage, for a face that the mesh has not and a depth that it cannot have.
[[nodiscard]] Result<void> apply_fine_rules(Document& document, const std::vector<FineRule>& rules);

/// How many demands there are, in words; nothing where there are none.
[[nodiscard]] std::optional<std::string> demands_text(const Document& document);

}  // namespace limn::cli
