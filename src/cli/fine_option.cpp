#include "cli/fine_option.h"

#include <charconv>
#include <cstdint>
#include <limits>

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Error.hpp>
#include <CLI/Formatter.hpp>

namespace limn::cli {
namespace {

tl::unexpected<Error> not_understood(std::string_view text) {
  return fail(
      ErrorKind::kUsage,
      fmt::format("\"{}\" is not understood: write FACE/LEVEL/COLUMN/ROW=DEPTH, for example "
                  "12/2/3/0=5, with FACE.CORNER where the face is no quad, or none.",
                  text));
}

/// Takes a whole number and what follows it off the front of the text.
std::optional<std::uint32_t> take_number(std::string_view& text, char then) {
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const auto length = static_cast<std::size_t>(end - text.data());
  const bool is_last = length == text.size();
  if (error != std::errc() || is_last != (then == '\0') || (!is_last && text[length] != then)) {
    return std::nullopt;
  }
  text.remove_prefix(is_last ? length : length + 1);
  return number;
}

template <class Narrow>
bool fits(std::uint32_t number) {
  return number <= std::numeric_limits<Narrow>::max();
}

}  // namespace

Result<FineRule> parse_fine_rule(std::string_view text) {
  if (text == "none") {
    return DropDemands{};
  }
  std::string_view rest = text;
  const bool has_corner = rest.substr(0, rest.find('/')).find('.') != std::string_view::npos;
  const auto face = take_number(rest, has_corner ? '.' : '/');
  const auto corner = face && has_corner ? take_number(rest, '/') : face ? std::optional(0U) : face;
  const auto level = corner ? take_number(rest, '/') : corner;
  const auto column = level ? take_number(rest, '/') : level;
  const auto row = column ? take_number(rest, '=') : column;
  const auto depth = row ? take_number(rest, '\0') : row;
  if (!depth || !fits<std::uint8_t>(*level) || !fits<std::uint16_t>(*column) ||
      !fits<std::uint16_t>(*row) || !fits<std::uint8_t>(*depth)) {
    return not_understood(text);
  }
  return FineDemand{{*face, *corner, static_cast<std::uint8_t>(*level),
                     static_cast<std::uint16_t>(*column), static_cast<std::uint16_t>(*row)},
                    static_cast<std::uint8_t>(*depth)};
}

void add_fine_option(CLI::App& command, std::vector<FineRule>& rules) {
  command
      .add_option_function<std::vector<std::string>>(
          "--fine",
          [&rules](const std::vector<std::string>& arguments) {
            for (const std::string& argument : arguments) {
              Result<FineRule> rule = parse_fine_rule(argument);
              if (!rule) {
                throw CLI::ValidationError("--fine", rule.error().message);
              }
              rules.push_back(*std::move(rule));
            }
          },
          "A face finer than a control face that is to be subdivided further, "
          "FACE/LEVEL/COLUMN/ROW=DEPTH, any number of times: of the 2^LEVEL columns and rows that "
          "control face FACE becomes, counted from its first corner, one goes down to DEPTH levels "
          "in all. FACE.CORNER where the face is no quad; there 2^(LEVEL-1) columns and rows lie "
          "at "
          "each corner. none drops those that a project has")
      ->type_name("DEMAND")
      ->expected(1)
      ->take_all();
}

Result<void> apply_fine_rules(Document& document, const std::vector<FineRule>& rules) {
  for (const FineRule& rule : rules) {
    const auto* demand = std::get_if<FineDemand>(&rule);
    if (demand == nullptr) {
      document.demands = {};
      continue;
    }
    const FineFace& face = demand->face;
    if (!is_face_of(*document.control, face)) {
      return fail(
          ErrorKind::kUsage,
          fmt::format("--fine: the mesh has no face of level {} at column {}, row {}, corner "
                      "{} of control face {}.",
                      face.level, face.column, face.row, face.corner, face.control_face));
    }
    if (!is_demand_on(*document.control, *demand)) {
      return fail(ErrorKind::kUsage,
                  fmt::format("--fine: a face of level {} goes down to {}..{} levels, not {}.",
                              face.level, face.level + 1, kMaxDepth, demand->depth));
    }
    document.demands.raise({demand, 1});
  }
  return {};
}

std::optional<std::string> demands_text(const Document& document) {
  const std::size_t count = document.demands.size();
  if (count == 0) {
    return std::nullopt;
  }
  const bool is_idle = document.settings.scheme != RefinementScheme::kCatmullClark;
  return fmt::format("{} demand{}{}", count, count == 1 ? "" : "s",
                     is_idle ? " (Catmull-Clark's; passed over here)" : "");
}

}  // namespace limn::cli
