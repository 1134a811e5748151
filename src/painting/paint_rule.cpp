// What a rule is held to is split off first. Words of the whole painting and choices of depths are
// known by their first word; everything else is split at the colon.
#include "limn/painting/paint_rule.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "limn/contract.h"
#include "painting/choice_text.h"
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
    "write SELECTION:CHANGE, as in \"all:+1\"; \"tolerance=0.001d\", \"budget=50000\", "
    "\"screen=4px\" or \"curve=curvature,5/0,40/3\"; or \"grow\", \"shrink\", \"invert\", "
    "\"smooth\", "
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
      fmt::format("\"+N\", \"-N\", \"=N\", \"maxN\" or \"minN\" with N from 0 to {}", kMaxDepth);
  if (text.empty()) {
    return misread(fmt::format("Nothing after the colon says how to paint; write {}.", changes));
  }
  for (const auto& [word, kind] : {std::pair("max", DepthChange::Kind::kAtLeast),
                                   std::pair("min", DepthChange::Kind::kAtMost)}) {
    if (const std::string_view name = word; text.starts_with(name)) {
      const auto depth = rule_text::read_whole_number(trimmed(text.substr(name.size())));
      if (depth && *depth <= std::uint32_t{kMaxDepth}) {
        return DepthChange{kind, static_cast<int>(*depth)};
      }
    }
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
    const std::string selection = rule_text::to_text(rule.selection);
    switch (change.kind) {
      case DepthChange::Kind::kSet:
        return fmt::format("{}:={}", selection, change.amount);
      case DepthChange::Kind::kAtLeast:
        return fmt::format("{}:max{}", selection, change.amount);
      case DepthChange::Kind::kAtMost:
        return fmt::format("{}:min{}", selection, change.amount);
      case DepthChange::Kind::kAdd:
        break;
    }
    return fmt::format("{}:{:+}", selection, change.amount);
  }
  std::string operator()(DepthFilter filter) const {
    return std::string(kFilterWords[static_cast<std::size_t>(filter)].word);
  }
  std::string operator()(const MirrorPainting& mirror) const {
    return "mirror=" + to_string(mirror.axes);
  }
  std::string operator()(const ChooseDepths& choose) const {
    const std::string choice = rule_text::to_text(choose.choice);
    return choose.merge == DepthMerge::kSet
               ? choice
               : fmt::format("{}:{}", choice, rule_text::to_text(choose.merge));
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

/// Carries out each kind of action on all faces.
struct Plan {
  using Planned = Result<PlannedPaint>;

  const ControlMesh& mesh;
  const PaintContext& context;
  const FaceDepths& depths;
  const std::vector<bool>& is_within;  ///< Empty: all.

  Planned operator()(const ChangeFaces& rule) const {
    return select_faces(mesh, depths, rule.selection, context)
        .map([&](const std::vector<std::uint32_t>& faces) {
          return PlannedPaint{plan_edits(depths, faces, rule.change), std::nullopt, 0};
        });
  }
  Planned operator()(DepthFilter filter) const {
    return PlannedPaint{edits_between(depths, filter_depths(mesh, depths, filter)), std::nullopt,
                        0};
  }
  Planned operator()(const MirrorPainting& mirror) const {
    return PlannedPaint{edits_between(depths, mirror_depths(FaceMirror(mesh, mirror.axes), depths)),
                        std::nullopt, 0};
  }
  Planned operator()(const ChooseDepths& choose) const {
    return choose_depths(mesh, choose.choice, choose.merge, context, depths, is_within)
        .map([&](const ChosenDepths& chosen) {
          PlannedPaint plan{edits_between(depths, chosen.depths), std::nullopt, chosen.short_faces};
          if (aims_at_limit(choose)) {
            plan.expected_error = chosen.expected_error;
          }
          return plan;
        });
  }
};

/// An action and, behind the last " in ", the selection it is held to.
struct RuleParts {
  std::string_view action;
  std::optional<std::string_view> within;
};

RuleParts parts_of(std::string_view rule) {
  constexpr std::string_view kIn = " in ";
  const std::size_t at = rule.rfind(kIn);
  if (at == std::string_view::npos) {
    return {rule, std::nullopt};
  }
  return {trimmed(rule.substr(0, at)), trimmed(rule.substr(at + kIn.size()))};
}

Result<PaintRule> parse_choose(std::string_view text) {
  ChooseDepths choose{FaceBudget{}, DepthMerge::kSet};
  if (const std::size_t colon = text.rfind(':'); colon != std::string_view::npos) {
    const std::string_view word = trimmed(text.substr(colon + 1));
    const auto merge = rule_text::parse_merge(word);
    if (!merge) {
      return misread(fmt::format(
          "{} does not say how chosen depths go together with what is painted; write \":set\", "
          "\":max\", \":min\" or \":add\".",
          word.empty() ? "Nothing after the colon" : quoted(word)));
    }
    choose.merge = *merge;
    text = trimmed(text.substr(0, colon));
  }
  return rule_text::parse_choice(text).map([&](DepthChoice choice) {
    choose.choice = std::move(choice);
    return PaintRule(std::move(choose));
  });
}

Result<PaintRule> parse_action(std::string_view rule) {
  for (const auto& [filter, word] : kFilterWords) {
    if (rule == word) {
      return PaintRule(filter);
    }
  }
  if (rule_text::is_choice(rule)) {
    return parse_choose(rule);
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
  return parse_change(trimmed(rule.substr(colon + 1))).map([&](DepthChange change) {
    return PaintRule(ChangeFaces{*std::move(selection), change});
  });
}

}  // namespace

bool aims_at_limit(const PaintRule& rule) {
  const auto* choose = std::get_if<ChooseDepths>(&rule.action);
  return choose != nullptr && (std::holds_alternative<ChooseByTolerance>(choose->choice) ||
                               std::holds_alternative<FaceBudget>(choose->choice));
}

bool clears_all(const PaintRule& rule) {
  const auto* filter = std::get_if<DepthFilter>(&rule.action);
  return filter != nullptr && *filter == DepthFilter::kClear && !rule.within;
}

bool asks_what_is_visible(const PaintRule& rule) {
  const auto* change = std::get_if<ChangeFaces>(&rule.action);
  return (change != nullptr && std::holds_alternative<SelectVisible>(change->selection)) ||
         (rule.within && std::holds_alternative<SelectVisible>(*rule.within));
}

Result<PaintRule> parse_paint_rule(std::string_view text) {
  const std::string_view rule_text = trimmed(text);
  if (rule_text.empty()) {
    return misread(fmt::format("The paint rule is empty; {}.", kForms));
  }
  const RuleParts parts = parts_of(rule_text);
  Result<PaintRule> rule = parse_action(parts.action);
  if (rule && parts.within) {
    Result<Selection> within = rule_text::parse_selection(*parts.within);
    if (!within) {
      return tl::unexpected(std::move(within.error()));
    }
    rule->within = *std::move(within);
  }
  return rule;
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
  const std::string action = std::visit(PaintRuleText{}, rule.action);
  return rule.within ? fmt::format("{} in {}", action, rule_text::to_text(*rule.within)) : action;
}

Result<PlannedPaint> plan_paint_rule(const ControlMesh& mesh, const PaintRule& rule,
                                     const PaintContext& context, const FaceDepths& depths) {
  LIMN_EXPECTS(depths.size() == mesh.face_count());
  std::vector<bool> is_within;
  if (rule.within) {
    const auto faces = select_faces(mesh, depths, *rule.within, context);
    if (!faces) {
      return tl::unexpected(faces.error());
    }
    is_within.resize(mesh.face_count(), false);
    for (const std::uint32_t f : *faces) {
      is_within[f] = true;
    }
  }
  Result<PlannedPaint> plan = std::visit(Plan{mesh, context, depths, is_within}, rule.action);
  if (plan && rule.within) {
    std::erase_if(plan->edits, [&](const DepthEdit& edit) { return !is_within[edit.face]; });
  }
  if (plan) {
    plan->drops_demands = clears_all(rule);
  }
  return plan;
}

Result<PlannedPaint> plan_paint_rules(const ControlMesh& mesh, std::span<const PaintRule> rules,
                                      const PaintContext& context, const FaceDepths& depths) {
  PlannedPaint all;
  FaceDepths painted = depths;
  PaintContext now = context;
  for (const PaintRule& rule : rules) {
    const Result<PlannedPaint> plan = plan_paint_rule(mesh, rule, now, painted);
    if (!plan) {
      return tl::unexpected(plan.error());
    }
    apply_edits(painted, plan->edits);
    if (plan->drops_demands) {
      all.drops_demands = true;
      now.demands = nullptr;
    }
    if (plan->expected_error) {
      all.expected_error = plan->expected_error;
      all.short_faces = plan->short_faces;
    }
  }
  all.edits = edits_between(depths, painted);
  return all;
}

Result<void> apply_paint_rule(const ControlMesh& mesh, const PaintRule& rule,
                              const PaintContext& context, FaceDepths& depths) {
  const Result<PlannedPaint> plan = plan_paint_rule(mesh, rule, context, depths);
  if (!plan) {
    return tl::unexpected(plan.error());
  }
  apply_edits(depths, plan->edits);
  return {};
}

}  // namespace limn
