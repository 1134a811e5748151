#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "limn/error.h"
#include "limn/painting/depth_change.h"
#include "limn/painting/depth_choice.h"
#include "limn/painting/depth_filter.h"
#include "limn/painting/mirror.h"
#include "limn/painting/selection.h"

namespace limn {

/// A selection and what happens to it: `SELECTION:CHANGE`.
struct ChangeFaces {
  Selection selection;
  DepthChange change;

  [[nodiscard]] bool operator==(const ChangeFaces&) const = default;
};

/// The painting made symmetric (`mirror_depths`): `mirror=AXES`.
struct MirrorPainting {
  MirrorAxes axes;

  [[nodiscard]] bool operator==(const MirrorPainting&) const = default;
};

/// Depths that come about by themselves: `tolerance=...`, `budget=...`, `screen=...`, `curve=...`,
/// with `:max`, `:min` or `:add` where they shall not replace what is painted.
struct ChooseDepths {
  DepthChoice choice;
  DepthMerge merge = DepthMerge::kSet;

  [[nodiscard]] bool operator==(const ChooseDepths&) const = default;
};

/// What is done to a painting: some faces change, or all of them at once.
using PaintAction = std::variant<ChangeFaces, DepthFilter, MirrorPainting, ChooseDepths>;

/// What is done, and to which faces at the most: `ACTION in SELECTION`.
struct PaintRule {
  PaintAction action;
  std::optional<Selection> within;  ///< Nothing: all faces. Asked before anything is done.

  PaintRule() = default;
  PaintRule(PaintAction done, std::optional<Selection> among)
      : action(std::move(done)), within(std::move(among)) {}
  // An action is a rule for all faces.
  PaintRule(ChangeFaces done) : action(std::move(done)) {}   // NOLINT(google-explicit-constructor)
  PaintRule(DepthFilter done) : action(done) {}              // NOLINT(google-explicit-constructor)
  PaintRule(MirrorPainting done) : action(done) {}           // NOLINT(google-explicit-constructor)
  PaintRule(ChooseDepths done) : action(std::move(done)) {}  // NOLINT(google-explicit-constructor)

  [[nodiscard]] bool operator==(const PaintRule&) const = default;
};

/// Whether a rule chooses depths by their distance to the limit surface: by a tolerance or a
/// budget. Vertices then had better stand on it (SurfacePoints::kLimit), which takes fewer faces.
[[nodiscard]] bool aims_at_limit(const PaintRule& rule);

/// Whether nothing is painted after a rule, whatever was before.
[[nodiscard]] bool clears_all(const PaintRule& rule);

/// Whether a rule asks which faces are visible (`PaintContext::visible`).
[[nodiscard]] bool asks_what_is_visible(const PaintRule& rule);

/// Reads `all:+1`, `visible:+1`, `dihedral>30:+2`, `curvature>12deg:+1`, `faces=0,3-9:=4`,
/// `painted:max3`, `flood=12:=3`, `smart=12,40:+1`, `connected=12:+1`; of the whole painting
/// `grow`, `shrink`, `invert`, `smooth`, `clear` and `mirror=xz`; and choices of depths,
/// `tolerance=0.001d`, `tolerance=0.5px@camera.json`, `budget=50000`, `budget=50000t,greatest`,
/// `screen=4px`, `curve=curvature,5/0,40/3`, with `:max`, `:min`, `:add` or `:set` behind them.
/// After any of these ` in SELECTION`. Blanks around the parts are allowed; depths are at most
/// kMaxDepth. Whether faces and cameras exist is asked when it is applied. Errors: kUsage, naming
/// the part that was not understood and what may stand there.
[[nodiscard]] Result<PaintRule> parse_paint_rule(std::string_view text);

/// Reads the rules of a text, one a line, in order. From `#` to the end of a line is a comment;
/// blank lines are passed over. `source` is the path or name for messages.
/// Errors: those of `parse_paint_rule`, with `source` and the 1-based line.
[[nodiscard]] Result<std::vector<PaintRule>> parse_paint_rules(std::string_view text,
                                                               const std::string& source);

/// The rule as `parse_paint_rule` reads it.
[[nodiscard]] std::string to_string(const PaintRule& rule);

/// What a rule does to a painting.
struct PlannedPaint {
  std::vector<DepthEdit> edits;  ///< Ascending by face.
  /// Of a rule that aims at the limit surface: how far from it the chosen faces are expected to be
  /// at the most, in mesh units, and how many of them kMaxDepth levels do not suffice for.
  std::optional<double> expected_error;
  std::size_t short_faces = 0;
  bool drops_demands = false;  ///< What is painted on finer faces goes as well.
};

/// What the rule changes in a painting with one depth per face. Errors: those of `select_faces` and
/// `choose_depths`.
[[nodiscard]] Result<PlannedPaint> plan_paint_rule(const ControlMesh& mesh, const PaintRule& rule,
                                                   const PaintContext& context,
                                                   const FaceDepths& depths);

/// What rules do that are carried out in order. Of the limit surface, what the last one expects
/// that aims at it. Errors: those of the first that fails.
[[nodiscard]] Result<PlannedPaint> plan_paint_rules(const ControlMesh& mesh,
                                                    std::span<const PaintRule> rules,
                                                    const PaintContext& context,
                                                    const FaceDepths& depths);

/// Plans and paints. Errors: as for one rule; `depths` is then left as it was.
[[nodiscard]] Result<void> apply_paint_rule(const ControlMesh& mesh, const PaintRule& rule,
                                            const PaintContext& context, FaceDepths& depths);

}  // namespace limn
