// Words of the whole painting first; everything else is split at the colon.
#include "limn/painting/paint_rule.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "limn/contract.h"
#include "painting/rule_text.h"
#include "painting/selection_text.h"

namespace limn {
namespace {

using rule_text::misread;
using rule_text::quoted;
using rule_text::trimmed;

struct FilterWord {
  DepthFilter filter;
  std::string_view word;
};
constexpr std::array<FilterWord, 5> kFilterWords{{{DepthFilter::kGrow, "grow"},
                                                  {DepthFilter::kShrink, "shrink"},
                                                  {DepthFilter::kInvert, "invert"},
                                                  {DepthFilter::kSmooth, "smooth"},
                                                  {DepthFilter::kClear, "clear"}}};

constexpr std::string_view kForms =
    "write SELECTION:CHANGE, as in \"all:+1\", or \"grow\", \"shrink\", \"invert\", \"smooth\", "
    "\"clear\" or \"mirror=AXES\"";

/// What follows "mirror", its sign included.
Result<PaintRule> parse_mirror(std::string_view text) {
  MirrorAxes axes;
  const bool has_sign = !text.empty() && text.front() == '=';
  const std::string_view letters = has_sign ? trimmed(text.substr(1)) : std::string_view{};
  bool is_understood = !letters.empty();
  for (const char letter : letters) {
    bool* axis = letter == 'x'   ? &axes.x
                 : letter == 'y' ? &axes.y
                 : letter == 'z' ? &axes.z
                                 : nullptr;
    is_understood = is_understood && axis != nullptr && !*axis;
    if (axis != nullptr) {
      *axis = true;
    }
  }
  if (!is_understood) {
    return misread(
        fmt::format("{} after \"mirror\" does not name axes; write each once, as in "
                    "\"mirror=x\" or \"mirror=xz\".",
                    text.empty() ? "Nothing" : quoted(text)));
  }
  return PaintRule(MirrorPainting{axes});
}

Result<DepthChange> parse_change(std::string_view text) {
  const std::string changes =
      fmt::format("\"+N\", \"-N\" or \"=N\" with N from 0 to {}", kMaxDepth);
  if (text.empty()) {
    return misread(fmt::format("Nothing after the colon says how to paint; write {}.", changes));
  }
  const char sign = text.front();
  const std::optional<std::uint32_t> number = rule_text::read_whole_number(trimmed(text.substr(1)));
  if ((sign != '+' && sign != '-' && sign != '=') || !number ||
      *number > std::uint32_t{kMaxDepth}) {
    return misread(fmt::format("{} does not say how to paint; write {}.", quoted(text), changes));
  }
  const int amount = static_cast<int>(*number);
  return sign == '=' ? DepthChange::set(amount) : DepthChange::add(sign == '+' ? amount : -amount);
}

struct PaintRuleText {
  std::string operator()(const ChangeFaces& rule) const {
    const DepthChange& change = rule.change;
    return rule_text::to_text(rule.selection) + (change.kind == DepthChange::Kind::kSet
                                                     ? fmt::format(":={}", change.amount)
                                                     : fmt::format(":{:+}", change.amount));
  }
  std::string operator()(DepthFilter filter) const {
    return std::string(kFilterWords[static_cast<std::size_t>(filter)].word);
  }
  std::string operator()(const MirrorPainting& mirror) const {
    return "mirror=" + to_string(mirror.axes);
  }
};

/// What is different in `after`.
std::vector<DepthEdit> edits_between(const FaceDepths& before, const FaceDepths& after) {
  std::vector<DepthEdit> edits;
  for (std::uint32_t f = 0; f < before.size(); ++f) {
    if (before[f] != after[f]) {
      edits.push_back({f, before.values()[f], after.values()[f]});
    }
  }
  return edits;
}

struct Plan {
  using Edits = Result<std::vector<DepthEdit>>;

  const ControlMesh& mesh;
  const VisibleFaces& visible;
  const FaceDepths& depths;

  Edits operator()(const ChangeFaces& rule) const {
    const auto faces = select_faces(mesh, depths, rule.selection, visible);
    if (!faces) {
      return tl::unexpected(faces.error());
    }
    return plan_edits(depths, *faces, rule.change);
  }
  Edits operator()(DepthFilter filter) const {
    return edits_between(depths, filter_depths(mesh, depths, filter));
  }
  Edits operator()(const MirrorPainting& mirror) const {
    return edits_between(depths, mirror_depths(FaceMirror(mesh, mirror.axes), depths));
  }
};

}  // namespace

Result<PaintRule> parse_paint_rule(std::string_view text) {
  const std::string_view rule = trimmed(text);
  if (rule.empty()) {
    return misread(fmt::format("The paint rule is empty; {}.", kForms));
  }
  for (const auto& [filter, word] : kFilterWords) {
    if (rule == word) {
      return PaintRule(filter);
    }
  }
  const std::size_t colon = rule.find(':');
  if (colon == std::string_view::npos) {
    if (constexpr std::string_view kMirror = "mirror"; rule.starts_with(kMirror)) {
      return parse_mirror(trimmed(rule.substr(kMirror.size())));
    }
    return misread(fmt::format("The paint rule {} has no colon; {}.", quoted(rule), kForms));
  }
  Result<Selection> selection = rule_text::parse_selection(trimmed(rule.substr(0, colon)));
  if (!selection) {
    return tl::unexpected(std::move(selection.error()));
  }
  const Result<DepthChange> change = parse_change(trimmed(rule.substr(colon + 1)));
  if (!change) {
    return tl::unexpected(change.error());
  }
  return PaintRule(ChangeFaces{std::move(*selection), *change});
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
  return std::visit(PaintRuleText{}, rule);
}

Result<std::vector<DepthEdit>> plan_paint_rule(const ControlMesh& mesh, const PaintRule& rule,
                                               const VisibleFaces& visible,
                                               const FaceDepths& depths) {
  LIMN_EXPECTS(depths.size() == mesh.face_count());
  return std::visit(Plan{mesh, visible, depths}, rule);
}

Result<void> apply_paint_rule(const ControlMesh& mesh, const PaintRule& rule,
                              const VisibleFaces& visible, FaceDepths& depths) {
  const Result<std::vector<DepthEdit>> edits = plan_paint_rule(mesh, rule, visible, depths);
  if (!edits) {
    return tl::unexpected(edits.error());
  }
  apply_edits(depths, *edits);
  return {};
}

}  // namespace limn
