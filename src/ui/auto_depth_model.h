#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "limn/document/measured_refinement.h"
#include "limn/painting/paint_rule.h"
#include "limn/painting/rule_presets.h"

namespace limn::ui {

/// Where a depth comes from, in the order of DepthChoice's alternatives.
enum class DepthSource : std::uint8_t { kTolerance, kBudget, kScreen, kCurve };
inline constexpr std::size_t kDepthSources = std::variant_size_v<DepthChoice>;

/// What the panel is set to.
struct AutoDepthSettings {
  /// What choosing carries out, in order: one ChooseDepths, or the rules of a preset.
  std::vector<PaintRule> rules;
  std::array<DepthChoice, kDepthSources> choices;  ///< What each source was set to last.
  bool is_live = false;                            ///< The painting follows what is set.
  bool moves_to_limit = true;  ///< Vertices go on the limit surface for rules that aim at it.

  /// Within 0.001 diagonals of the limit surface.
  AutoDepthSettings();
  [[nodiscard]] bool operator==(const AutoDepthSettings&) const = default;

  /// The one rule, where it can be set by controls; null for those of a preset.
  [[nodiscard]] const ChooseDepths* choice() const noexcept;
  [[nodiscard]] std::optional<DepthSource> source() const noexcept;
};

/// As `parse_paint_rules` reads them.
[[nodiscard]] std::string text_of(std::span<const PaintRule> rules);

/// The quantity that a choice is about first: a distance, a count of faces, pixels. Nothing for a
/// curve. `diagonal` is the control mesh's, in its units.
struct MainAmount {
  double value = 0.0;
  double low = 0.0;
  double high = 1.0;
};
[[nodiscard]] std::optional<MainAmount> main_amount(const DepthChoice& choice, double diagonal);
/// The choice with another one, brought into its range.
[[nodiscard]] DepthChoice with_amount(DepthChoice choice, double value, double diagonal);

/// What the amount is counted in: a ChooseByTolerance::Unit, FaceBudget::Unit or ScreenSize::Of as
/// a number; nothing for a curve.
[[nodiscard]] std::optional<int> unit_of(const DepthChoice& choice);
/// The choice with another unit; a length stays the same one as far as can be.
[[nodiscard]] DepthChoice with_unit(DepthChoice choice, int unit, double diagonal);
inline constexpr int kMostSilhouettes = 3;
/// A curve over another measure, one to begin with.
[[nodiscard]] ChooseByCurve curve_over(FaceMeasure measure);
/// The selection that rules are held to, as a rule names it; empty: all faces.
[[nodiscard]] std::string within_text(const AutoDepthSettings& settings);

/// The views that a choice names, where it looks through any; null where it does not.
[[nodiscard]] const ViewNames* views_of(const DepthChoice& choice);
[[nodiscard]] DepthChoice with_views(DepthChoice choice, const ViewNames& names);

/// Faces counted by a measure, along an axis from `low` to `high` in equal steps, of the value or,
/// on a logarithmic one, of its logarithm.
struct MeasureHistogram {
  FaceMeasure measure = FaceMeasure::kCurvature;
  double low = 0.0;
  double high = 1.0;
  bool is_logarithmic = false;
  std::vector<std::size_t> counts{};
};

/// What was chosen last, as long as it is what is painted.
struct AutoDepthOutcome {
  std::size_t changed_faces = 0;
  std::optional<double> tolerance{};       ///< Mesh units; nothing where it is no length.
  std::optional<double> expected_error{};  ///< Likewise; of rules that aim at the limit surface.
  std::size_t short_faces = 0;             ///< That the deepest painting does not suffice for.
  std::optional<FaceBudget> budget{};
};

/// What else could be had for the budget.
struct BaselineStatus {
  std::optional<double> running;  ///< 0..1.
  std::optional<BudgetBaselines> found;
  std::string problem;  ///< Why there are none; empty where nothing went wrong.
};

struct AutoDepthStatus {
  AutoDepthSettings settings{};
  std::optional<double> running{};              ///< Depths are being chosen: 0..1.
  const MeasureHistogram* histogram = nullptr;  ///< For a curve; null while it is not known.
  std::optional<AutoDepthOutcome> outcome{};
  BaselineStatus baselines{};
  std::span<const RulePreset> own_presets{};
  std::size_t kept_views = 0;
};

}  // namespace limn::ui
