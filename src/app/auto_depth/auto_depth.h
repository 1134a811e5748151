#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/background_job.h"
#include "limn/document/document.h"
#include "limn/document/view_state.h"
#include "limn/painting/auto_depth/screen_view.h"
#include "limn/painting/paint_rule.h"
#include "limn/painting/rule_presets.h"
#include "ui/auto_depth_model.h"

namespace limn::app {

/// Depths that come about by themselves: what they are to be chosen by, and the work on threads of
/// their own. The document is the session's to change.
class AutoDepth {
 public:
  /// `wake` is called from workers whenever there is something new to look at. `arrivals` is that
  /// of the Mailboxes "auto depth", "depth measure" and "budget baselines".
  AutoDepth(const std::function<void()>& wake, Arrivals* arrivals);

  [[nodiscard]] const ui::AutoDepthSettings& settings() const noexcept { return settings_; }
  void restore(ui::AutoDepthSettings settings) { settings_ = std::move(settings); }
  void set_rules(std::vector<PaintRule> rules);
  /// What the source was set to last, merged and held to a selection as now.
  void set_source(ui::DepthSource source);
  void set_live(bool is_live) noexcept { settings_.is_live = is_live; }
  void set_moves_to_limit(bool moves) noexcept { settings_.moves_to_limit = moves; }

  [[nodiscard]] const std::vector<RulePreset>& presets() const noexcept { return presets_; }
  void set_presets(std::vector<RulePreset> presets) { presets_ = std::move(presets); }
  /// Under a name, in place of an older one of it. Errors: kUsage for a name that is none, and
  /// where the rules look through views that are kept for this run alone.
  [[nodiscard]] Result<void> save_preset(const std::string& name);
  /// False where there is none of this name.
  bool delete_preset(std::string_view name);

  /// Views that rules can name besides the one in force: "view1", "view2" and so on.
  void keep_view(const ViewState& view) { views_.push_back(view); }
  void forget_views();
  [[nodiscard]] const std::vector<ViewState>& views() const noexcept { return views_; }
  [[nodiscard]] static std::string view_name(std::size_t index);

  /// All that choosing depends on.
  struct Question {
    std::shared_ptr<const ControlMesh> control;
    SubdivisionSettings settings;  ///< How the painting will be refined.
    FaceDepths depths;             ///< Before.
    FineDemands demands;
    Revisions revisions;  ///< Of the document that was asked about.
    bool replaces_last =
        false;  ///< The document's last step, a choice as well, is taken back first.
    std::vector<PaintRule> rules;
    std::vector<std::uint32_t> visible_faces;  ///< Where a rule asks for them.
    /// By name, the one in force under the empty one; empty where nobody has cameras.
    std::map<std::string, ScreenView> views;
  };
  /// Gives up what runs and begins anew.
  void choose(Question question);
  [[nodiscard]] const Question& question() const noexcept { return question_; }
  [[nodiscard]] bool is_choosing() const noexcept { return choosing_.is_busy(); }
  void stop_choosing() { choosing_.cancel(); }
  [[nodiscard]] std::optional<Result<PlannedPaint>> take_choice() { return choosing_.take(); }

  /// What the faces are told apart by, for the curve.
  struct Measured {
    std::shared_ptr<const ControlMesh> control;
    SubdivisionSettings settings;
    FaceMeasure measure = FaceMeasure::kCurvature;
    std::optional<ViewState> view;  ///< For measures that need one.

    [[nodiscard]] bool operator==(const Measured&) const = default;
  };
  /// Counts faces by the measure, unless that is known or on its way.
  void follow(const Measured& measured, const std::optional<ScreenView>& view);
  /// Of the one asked about last; null where it is not known.
  [[nodiscard]] const ui::MeasureHistogram* histogram(const Measured& measured) const noexcept;

  /// Measures what else could be had for a budget: of the document as it is.
  void compare(const Document& document, const FaceBudget& budget);
  [[nodiscard]] bool is_comparing() const noexcept { return comparing_.is_busy(); }
  void stop_comparing() { comparing_.cancel(); }
  /// For the panels; nothing where the mesh or how it is subdivided has changed since.
  [[nodiscard]] ui::BaselineStatus baselines(const Document& document,
                                             const FaceBudget& budget) const;

  /// Whether anything is being worked out.
  [[nodiscard]] bool is_busy() const noexcept {
    return choosing_.is_busy() || measuring_.is_busy() || comparing_.is_busy();
  }
  [[nodiscard]] std::optional<double> running() const noexcept { return choosing_.running(); }
  /// Takes in what was found for the panels; true where there was anything.
  bool update();
  void wait();

 private:
  struct Compared {
    std::shared_ptr<const ControlMesh> control;
    SubdivisionSettings settings;
    FaceBudget budget;

    [[nodiscard]] bool operator==(const Compared&) const = default;
  };

  ui::AutoDepthSettings settings_;
  std::vector<RulePreset> presets_;
  std::vector<ViewState> views_;

  Question question_;
  BackgroundJob<PlannedPaint> choosing_;

  Measured measured_;  ///< Asked about last.
  std::optional<ui::MeasureHistogram> histogram_;
  BackgroundJob<ui::MeasureHistogram> measuring_;

  Compared compared_;  ///< Asked about last.
  ui::BaselineStatus baselines_;
  BackgroundJob<BudgetBaselines> comparing_;
};

}  // namespace limn::app
