// A hand-written parser over string_view: split at the colon, then at the sign that each selection
// has. Numbers go through std::from_chars, so no locale can change what a rule means.
#include "limn/painting/paint_rule.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "painting/rule_text.h"

namespace limn {
namespace {

using rule_text::misread;
using rule_text::quoted;
using rule_text::trimmed;

constexpr std::string_view kSelections =
    "\"all\", \"visible\", \"dihedral>DEGREES\" or \"faces=LIST\"";
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Digits alone, no sign. nullopt where the text is anything else, or too big for the type.
template <class Integer>
std::optional<Integer> whole_number(std::string_view text) {
  Integer value = 0;
  if (text.empty() || !is_digit(text.front())) {
    return std::nullopt;
  }
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) {
    return std::nullopt;
  }
  return value;
}

Result<std::uint32_t> face_number(std::string_view text, std::string_view part) {
  if (const auto number = whole_number<std::uint32_t>(text)) {
    return *number;
  }
  if (!text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos) {
    return misread(fmt::format("The face number {} is too large.", quoted(text)));
  }
  return misread(
      fmt::format("{} in the list of faces is not understood; write face numbers and ranges from 0 "
                  "on, as in \"faces=0,3-9\".",
                  quoted(part)));
}

Result<SelectFaces::Range> face_range(std::string_view part) {
  const std::size_t dash = part.find('-');
  const Result<std::uint32_t> first = face_number(trimmed(part.substr(0, dash)), part);
  if (!first) {
    return tl::unexpected(first.error());
  }
  if (dash == std::string_view::npos) {
    return SelectFaces::Range{*first, *first};
  }
  const Result<std::uint32_t> last = face_number(trimmed(part.substr(dash + 1)), part);
  if (!last) {
    return tl::unexpected(last.error());
  }
  if (*last < *first) {
    return misread(fmt::format("The face range {} runs backwards; write \"{}-{}\".", quoted(part),
                               *last, *first));
  }
  return SelectFaces::Range{*first, *last};
}

Result<Selection> face_list(std::string_view list) {
  if (list.empty()) {
    return misread("\"faces=\" names no face; write numbers and ranges, as in \"faces=0,3-9\".");
  }
  SelectFaces selection;
  while (true) {
    const std::size_t comma = list.find(',');
    const std::string_view part = trimmed(list.substr(0, comma));
    if (part.empty()) {
      return misread(
          "A face number is missing beside a comma; write numbers and ranges, as in "
          "\"faces=0,3-9\".");
    }
    const Result<SelectFaces::Range> range = face_range(part);
    if (!range) {
      return tl::unexpected(range.error());
    }
    selection.ranges.push_back(*range);
    if (comma == std::string_view::npos) {
      return Selection(std::move(selection));
    }
    list.remove_prefix(comma + 1);
  }
}

Result<Selection> dihedral_threshold(std::string_view text) {
  const std::optional<double> degrees = rule_text::read_degrees(text);
  if (!degrees) {
    return misread(
        fmt::format("{} after \"dihedral>\" is not an angle; write degrees from 0 to 180, as in "
                    "\"dihedral>30\".",
                    text.empty() ? "Nothing" : quoted(text)));
  }
  return Selection(SelectDihedral{*degrees});
}

Result<Selection> parse_selection(std::string_view text) {
  if (text == "all") {
    return Selection(SelectAll{});
  }
  if (text == "visible") {
    return Selection(SelectVisible{});
  }
  const std::size_t sign = text.find_first_of(">=");
  const std::string_view word = trimmed(text.substr(0, sign));
  const char found = sign == std::string_view::npos ? '\0' : text[sign];
  const std::string_view rest =
      sign == std::string_view::npos ? std::string_view{} : trimmed(text.substr(sign + 1));
  if (word == "dihedral") {
    if (found != '>') {
      return misread("\"dihedral\" needs a threshold in degrees, as in \"dihedral>30\".");
    }
    return dihedral_threshold(rest);
  }
  if (word == "faces") {
    if (found != '=') {
      return misread("\"faces\" needs a list of face numbers, as in \"faces=0,3-9\".");
    }
    return face_list(rest);
  }
  if (text.empty()) {
    return misread(
        fmt::format("Nothing before the colon says which faces to paint; write {}.", kSelections));
  }
  return misread(
      fmt::format("{} does not say which faces to paint; write {}.", quoted(text), kSelections));
}

Result<DepthChange> parse_change(std::string_view text) {
  const std::string changes =
      fmt::format("\"+N\", \"-N\" or \"=N\" with N from 0 to {}", kMaxDepth);
  if (text.empty()) {
    return misread(fmt::format("Nothing after the colon says how to paint; write {}.", changes));
  }
  const char sign = text.front();
  const std::optional<int> number = whole_number<int>(trimmed(text.substr(1)));
  if ((sign != '+' && sign != '-' && sign != '=') || !number || *number > kMaxDepth) {
    return misread(fmt::format("{} does not say how to paint; write {}.", quoted(text), changes));
  }
  return sign == '=' ? DepthChange::set(*number)
                     : DepthChange::add(sign == '+' ? *number : -*number);
}

struct SelectionText {
  std::string operator()(const SelectAll&) const { return "all"; }
  std::string operator()(const SelectVisible&) const { return "visible"; }
  std::string operator()(const SelectDihedral& dihedral) const {
    return fmt::format("dihedral>{}", dihedral.degrees);
  }
  std::string operator()(const SelectFaces& faces) const {
    std::string text = "faces=";
    for (std::size_t i = 0; i < faces.ranges.size(); ++i) {
      const auto [first, last] = faces.ranges[i];
      text += i == 0 ? "" : ",";
      text += first == last ? fmt::format("{}", first) : fmt::format("{}-{}", first, last);
    }
    return text;
  }
};

}  // namespace

Result<PaintRule> parse_paint_rule(std::string_view text) {
  const std::string_view rule = trimmed(text);
  if (rule.empty()) {
    return misread("The paint rule is empty; write SELECTION:CHANGE, as in \"all:+1\".");
  }
  const std::size_t colon = rule.find(':');
  if (colon == std::string_view::npos) {
    return misread(fmt::format(
        "The paint rule {} has no colon; write SELECTION:CHANGE, as in \"all:+1\".", quoted(rule)));
  }
  Result<Selection> selection = parse_selection(trimmed(rule.substr(0, colon)));
  if (!selection) {
    return tl::unexpected(std::move(selection.error()));
  }
  const Result<DepthChange> change = parse_change(trimmed(rule.substr(colon + 1)));
  if (!change) {
    return tl::unexpected(change.error());
  }
  return PaintRule{std::move(*selection), *change};
}

Result<std::vector<PaintRule>> parse_paint_rules(std::string_view text, const std::string& source) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
    text.remove_prefix(kByteOrderMark.size());
  }
  std::vector<PaintRule> rules;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view content = text.substr(0, end);
    const std::string_view rule_text = trimmed(content.substr(0, content.find('#')));
    if (!rule_text.empty()) {
      Result<PaintRule> rule = parse_paint_rule(rule_text);
      if (!rule) {
        return fail(rule.error().kind, std::move(rule.error().message), source, line);
      }
      rules.push_back(std::move(*rule));
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return rules;
}

std::string to_string(const PaintRule& rule) {
  const DepthChange& change = rule.change;
  return std::visit(SelectionText{}, rule.selection) + (change.kind == DepthChange::Kind::kSet
                                                            ? fmt::format(":={}", change.amount)
                                                            : fmt::format(":{:+}", change.amount));
}

Result<void> apply_paint_rule(const ControlMesh& mesh, const PaintRule& rule,
                              const VisibleFaces& visible, FaceDepths& depths) {
  LIMN_EXPECTS(depths.size() == mesh.face_count());
  const Result<std::vector<std::uint32_t>> faces = select_faces(mesh, rule.selection, visible);
  if (!faces) {
    return tl::unexpected(faces.error());
  }
  apply_edits(depths, plan_edits(depths, *faces, rule.change));
  return {};
}

}  // namespace limn
