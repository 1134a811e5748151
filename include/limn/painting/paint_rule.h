#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "limn/error.h"
#include "limn/painting/depth_change.h"
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

/// What is done to a painting: some faces change, or all of them at once.
using PaintRule = std::variant<ChangeFaces, DepthFilter, MirrorPainting>;

/// Reads `all:+1`, `visible:+1`, `dihedral>30:+2`, `faces=0,3-9:=4`, `flood=12:=3`,
/// `smart=12,40:+1`, `connected=12:+1`; and, of the whole painting, `grow`, `shrink`, `invert`,
/// `smooth`, `clear` and `mirror=xz`. Blanks around the parts are allowed; the change is at most
/// kMaxDepth. Whether the faces exist is asked when it is applied.
/// Errors: kUsage, naming the part that was not understood and what may stand there.
[[nodiscard]] Result<PaintRule> parse_paint_rule(std::string_view text);

/// Reads the rules of a text, one a line, in order. From `#` to the end of a line is a comment;
/// blank lines are passed over. `source` is the path or name for messages.
/// Errors: those of `parse_paint_rule`, with `source` and the 1-based line.
[[nodiscard]] Result<std::vector<PaintRule>> parse_paint_rules(std::string_view text,
                                                               const std::string& source);

/// The rule as `parse_paint_rule` reads it.
[[nodiscard]] std::string to_string(const PaintRule& rule);

/// What the rule changes in a painting with one depth per face, ascending by face. Errors: those of
/// `select_faces`.
[[nodiscard]] Result<std::vector<DepthEdit>> plan_paint_rule(const ControlMesh& mesh,
                                                             const PaintRule& rule,
                                                             const VisibleFaces& visible,
                                                             const FaceDepths& depths);

/// Plans and paints. Errors: those of `select_faces`; `depths` is then left as it was.
[[nodiscard]] Result<void> apply_paint_rule(const ControlMesh& mesh, const PaintRule& rule,
                                            const VisibleFaces& visible, FaceDepths& depths);

}  // namespace limn
