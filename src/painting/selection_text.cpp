// Split at the sign that each selection has. Numbers go through std::from_chars, so no locale can
// change what a rule means.
#include "painting/selection_text.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "limn/painting/face_regions.h"
#include "painting/choice_text.h"
#include "painting/rule_text.h"

namespace limn::rule_text {
namespace {

constexpr std::string_view kSelections =
    "\"all\", \"visible\", \"painted\", \"unpainted\", \"dihedral>DEGREES\", "
    "\"curvature>DEGREES\", "
    "\"faces=LIST\", \"flood=FACE\", \"smart=FACE,DEGREES\" or \"connected=FACE\"";

Result<std::uint32_t> face_number(std::string_view text, std::string_view part) {
  if (const auto number = read_whole_number(text)) {
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
  constexpr std::string_view kUnit = "deg";
  const bool has_unit = text.ends_with(kUnit);
  const std::optional<double> degrees =
      read_degrees(has_unit ? trimmed(text.substr(0, text.size() - kUnit.size())) : text);
  if (!degrees) {
    return misread(
        fmt::format("{} after \"dihedral>\" is not an angle; write degrees from 0 to 180, as in "
                    "\"dihedral>30\".",
                    text.empty() ? "Nothing" : quoted(text)));
  }
  return Selection(SelectDihedral{*degrees});
}

/// `word` grows from a face: "flood", "smart" or "connected".
Result<Selection> region_of(std::string_view word, std::string_view text) {
  const bool is_smart = word == "smart";
  const std::string example = is_smart ? "smart=12,40" : fmt::format("{}=12", word);
  const std::size_t comma = is_smart ? text.find(',') : std::string_view::npos;
  const std::string_view number = trimmed(text.substr(0, comma));
  if (number.empty()) {
    return misread(fmt::format("\"{}\" needs the number of a face to begin with, as in \"{}\".",
                               word, example));
  }
  const auto seed = read_whole_number(number);
  if (!seed) {
    return misread(
        fmt::format("{} after \"{}=\" is not the number of a face; write one from 0 on, "
                    "as in \"{}\".",
                    quoted(number), word, example));
  }
  if (!is_smart) {
    return word == "flood" ? Selection(SelectFlood{*seed}) : Selection(SelectConnected{*seed});
  }
  const std::string_view angle =
      comma == std::string_view::npos ? std::string_view{} : trimmed(text.substr(comma + 1));
  const auto degrees = read_degrees(angle, kMostFillAngle);
  if (!degrees) {
    return misread(
        fmt::format("{} after the face of \"smart=\" is not an angle; write degrees from 0 "
                    "to {:g}, as in \"smart=12,40\".",
                    angle.empty() ? "Nothing" : quoted(angle), kMostFillAngle));
  }
  return Selection(SelectSmart{*seed, *degrees});
}

/// Behind a measure's word: which way, and the value.
Result<Selection> measured(const FaceMeasureInfo& measure, char sign, std::string_view text) {
  const auto value = read_measure(measure.measure, text);
  if ((sign != '>' && sign != '<') || !value) {
    return misread(fmt::format("\"{}\" needs a threshold, as in \"{}>{}{}\" or with <.",
                               measure.word, measure.word, measure.unit == "d" ? "0.01" : "12",
                               measure.unit));
  }
  return Selection(SelectMeasured{measure.measure, sign == '>', *value});
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
  std::string operator()(const SelectFlood& flood) const {
    return fmt::format("flood={}", flood.seed);
  }
  std::string operator()(const SelectSmart& smart) const {
    return fmt::format("smart={},{}", smart.seed, smart.degrees);
  }
  std::string operator()(const SelectConnected& connected) const {
    return fmt::format("connected={}", connected.seed);
  }
  std::string operator()(const SelectMeasured& measured) const {
    const FaceMeasureInfo& measure = info(measured.measure);
    return fmt::format("{}{}{}{}", measure.word, measured.is_above ? '>' : '<', measured.value,
                       measure.unit);
  }
  std::string operator()(const SelectPainted& painted) const {
    return painted.is_painted ? "painted" : "unpainted";
  }
};

}  // namespace

Result<Selection> parse_selection(std::string_view text) {
  if (text == "all") {
    return Selection(SelectAll{});
  }
  if (text == "visible") {
    return Selection(SelectVisible{});
  }
  if (text == "painted" || text == "unpainted") {
    return Selection(SelectPainted{text == "painted"});
  }
  const std::size_t sign = text.find_first_of("><=");
  const std::string_view word = trimmed(text.substr(0, sign));
  const char found = sign == std::string_view::npos ? '\0' : text[sign];
  const std::string_view rest =
      sign == std::string_view::npos ? std::string_view{} : trimmed(text.substr(sign + 1));
  if (word == "dihedral") {
    if (found == '<') {
      return measured(info(FaceMeasure::kDihedral), found, rest);
    }
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
  if (word == "flood" || word == "smart" || word == "connected") {
    return region_of(word, found == '=' ? rest : std::string_view{});
  }
  if (const auto measure = std::ranges::find(face_measures(), word, &FaceMeasureInfo::word);
      measure != face_measures().end()) {
    return measured(*measure, found, rest);
  }
  if (text.empty()) {
    return misread(
        fmt::format("Nothing before the colon says which faces to paint; write {}.", kSelections));
  }
  return misread(
      fmt::format("{} does not say which faces to paint; write {}.", quoted(text), kSelections));
}

std::string to_text(const Selection& selection) {
  return std::visit(SelectionText{}, selection);
}

}  // namespace limn::rule_text
