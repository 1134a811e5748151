// The text is taken apart as a paint rule's is: at the colon, then at the sign of each part.
#include "limn/painting/crease_rule.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "limn/painting/selection.h"
#include "painting/rule_text.h"

namespace limn {
namespace {

using rule_text::misread;
using rule_text::quoted;
using rule_text::trimmed;

constexpr std::string_view kEdgeSelections = "\"all\", \"creased\" or \"angle>DEGREES\"";
constexpr std::string_view kInfinite = "inf";

Result<EdgeSelection> parse_edge_selection(std::string_view text) {
  if (text == "all") {
    return EdgeSelection(SelectAllEdges{});
  }
  if (text == "creased") {
    return EdgeSelection(SelectCreases{});
  }
  const std::size_t sign = text.find('>');
  if (trimmed(text.substr(0, sign)) != "angle") {
    return misread(fmt::format("{} which edges to crease; write {}.",
                               text.empty() ? std::string("Nothing before the colon says")
                                            : quoted(text) + " does not say",
                               kEdgeSelections));
  }
  const std::string_view rest =
      sign == std::string_view::npos ? std::string_view{} : trimmed(text.substr(sign + 1));
  const std::optional<double> degrees = rule_text::read_degrees(rest);
  if (!degrees) {
    return misread(
        fmt::format("{} after \"angle>\" is not an angle; write degrees from 0 to 180, "
                    "as in \"angle>30\".",
                    rest.empty() ? "Nothing" : quoted(rest)));
  }
  return EdgeSelection(SelectEdgesOverAngle{*degrees});
}

/// Without sign; nothing where the text is no sharpness.
std::optional<float> read_amount(std::string_view text) {
  if (text == kInfinite) {
    return kInfiniteSharpness;
  }
  float amount = 0.0f;
  if (text.empty() || text.front() == '-') {
    return std::nullopt;
  }
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), amount);
  if (error != std::errc{} || end != text.data() + text.size() ||
      !(amount >= 0.0f && amount <= kInfiniteSharpness)) {
    return std::nullopt;
  }
  return amount;
}

std::string amount_text(float amount) {
  return amount == kInfiniteSharpness ? std::string(kInfinite) : fmt::format("{}", amount);
}

struct EdgeSelectionText {
  std::string operator()(const SelectAllEdges&) const { return "all"; }
  std::string operator()(const SelectCreases&) const { return "creased"; }
  std::string operator()(const SelectEdgesOverAngle& over) const {
    return fmt::format("angle>{}", over.degrees);
  }
};

struct RuleText {
  std::string operator()(const ClearCreases&) const { return "clear"; }
  std::string operator()(const SharpenEdges& rule) const {
    const char sign = rule.kind == SharpenEdges::Kind::kSet ? '=' : rule.amount < 0.0f ? '-' : '+';
    return fmt::format("{}:{}{}", std::visit(EdgeSelectionText{}, rule.selection), sign,
                       amount_text(std::abs(rule.amount)));
  }
};

/// One entry per edge.
std::vector<std::uint8_t> selected_edges(const ControlMesh& mesh, const EdgeSelection& selection) {
  const auto& sharpness = mesh.creases().edge_sharpness;
  std::vector<std::uint8_t> is_selected(mesh.edge_count());
  if (const auto* over = std::get_if<SelectEdgesOverAngle>(&selection)) {
    std::ranges::transform(edge_dihedral_angles(mesh), is_selected.begin(), [&](double angle) {
      return static_cast<std::uint8_t>(angle > over->degrees + kDihedralTolerance);
    });
    return is_selected;
  }
  const bool takes_all = std::holds_alternative<SelectAllEdges>(selection);
  for (std::size_t e = 0; e < is_selected.size(); ++e) {
    const bool is_inside = mesh.topology().edge_corners[e][1] != kNone;
    const bool is_wanted = takes_all || (!sharpness.empty() && sharpness[e] > 0.0f);
    is_selected[e] = static_cast<std::uint8_t>(is_inside && is_wanted);
  }
  return is_selected;
}

}  // namespace

Result<CreaseRule> parse_crease_rule(std::string_view text) {
  const std::string_view rule = trimmed(text);
  if (rule == "clear") {
    return CreaseRule(ClearCreases{});
  }
  const std::size_t colon = rule.find(':');
  if (colon == std::string_view::npos) {
    return misread(fmt::format("{}; write SELECTION:CHANGE, as in \"angle>30:=2\", or \"clear\".",
                               rule.empty()
                                   ? std::string("The crease rule is empty")
                                   : fmt::format("The crease rule {} has no colon", quoted(rule))));
  }
  Result<EdgeSelection> selection = parse_edge_selection(trimmed(rule.substr(0, colon)));
  if (!selection) {
    return tl::unexpected(std::move(selection.error()));
  }
  const std::string_view change = trimmed(rule.substr(colon + 1));
  const char sign = change.empty() ? '\0' : change.front();
  const std::optional<float> amount =
      change.empty() ? std::nullopt : read_amount(trimmed(change.substr(1)));
  if ((sign != '+' && sign != '-' && sign != '=') || !amount) {
    return misread(
        fmt::format("{} how sharp to make edges; write \"=S\", \"+S\" or \"-S\" with S "
                    "from 0 to {:g}, or \"inf\".",
                    change.empty() ? std::string("Nothing after the colon says")
                                   : quoted(change) + " does not say",
                    kInfiniteSharpness));
  }
  return CreaseRule(SharpenEdges{*std::move(selection),
                                 sign == '=' ? SharpenEdges::Kind::kSet : SharpenEdges::Kind::kAdd,
                                 sign == '-' ? -*amount : *amount});
}

std::string to_string(const CreaseRule& rule) {
  return std::visit(RuleText{}, rule);
}

Creases apply_crease_rule(const ControlMesh& mesh, const CreaseRule& rule) {
  Creases creases = mesh.creases();
  if (std::holds_alternative<ClearCreases>(rule)) {
    creases.edge_sharpness.clear();
    creases.vertex_sharpness.clear();
    return creases;
  }
  const auto& sharpen = std::get<SharpenEdges>(rule);
  const std::vector<std::uint8_t> is_selected = selected_edges(mesh, sharpen.selection);
  creases.edge_sharpness.resize(mesh.edge_count(), 0.0f);
  for (std::size_t e = 0; e < is_selected.size(); ++e) {
    if (is_selected[e] != 0) {
      float& sharpness = creases.edge_sharpness[e];
      const bool is_set = sharpen.kind == SharpenEdges::Kind::kSet;
      sharpness = std::clamp(is_set ? sharpen.amount : sharpness + sharpen.amount, 0.0f,
                             kInfiniteSharpness);
    }
  }
  if (std::ranges::none_of(creases.edge_sharpness, [](float s) { return s > 0.0f; })) {
    creases.edge_sharpness.clear();
  }
  return creases;
}

}  // namespace limn
