#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "limn/comparison/directed_distance.h"
#include "limn/comparison/sphere_fit.h"
#include "limn/document/scheme_refinement.h"
#include "limn/document/view_state.h"
#include "limn/error.h"
#include "limn/mesh/import_report.h"
#include "limn/mesh/mesh_format.h"
#include "limn/painting/crease_palette.h"
#include "limn/painting/mirror.h"
#include "limn/painting/valence_palette.h"
#include "limn/subdivision/legalisation_trace.h"
#include "limn/subdivision/settings.h"
#include "ui/auto_depth_model.h"
#include "ui/navigation_settings.h"
#include "ui/window_geometry.h"

namespace limn {
struct CrackCheck;
struct Document;
class History;
struct MeshStatistics;
struct RefinementPrediction;
}  // namespace limn

namespace limn::ui {

enum class ShowMode : std::uint8_t {
  kControl,  ///< The control mesh.
  kRefined,  ///< The refined mesh.
  kBoth,     ///< The control cage as lines over the refined mesh.
};
enum class Theme : std::uint8_t { kDark, kLight };
/// What colours the faces.
enum class Tint : std::uint8_t {
  kDepth,     ///< The depth painted on the control face.
  kLevel,     ///< How many times the refined face has been subdivided.
  kNone,      ///< Nothing: the material alone.
  kDistance,  ///< How far the refined face is from the limit surface.
};
/// What the surface seems to be made of.
enum class Material : std::uint8_t { kStudio, kClay, kDark, kShiny };
enum class KeymapId : std::uint8_t {
  kOriginal,   ///< The keys of the program Limn grew from; a plain left drag uses the brush.
  kClassroom,  ///< The keys of a course's mesh viewer; choosing it takes up the orbit tool.
};

/// How the picture is drawn.
struct DisplaySettings {
  ShowMode show = ShowMode::kRefined;
  Theme theme = Theme::kDark;
  bool wireframe = true;
  bool smooth = false;
  bool light = true;
  bool labels = false;         ///< Vertex labels as numbered points.
  bool illegal_marks = false;  ///< Illegal faces hatched, illegal vertices as dots.
  bool creases = true;         ///< Sharp edges and vertices, coloured by sharpness.
  bool faces = true;           ///< Otherwise the edges alone, as far as there is a wireframe.
  bool valences = false;       ///< Irregular vertices as dots with their valence.
  /// Where no stage of the subdivision is asked for, the refined mesh is that of the painting to
  /// the end.
  bool live = true;
  bool numbers = false;  ///< Depth or level on faces large enough to hold it.
  Tint tint = Tint::kDepth;
  Material material = Material::kStudio;
  /// `second` is the painting's own scheme, uniform to its greatest depth.
  bool is_second_uniform = false;
  std::optional<SchemeSettings> second{};  ///< A uniform scheme beside what the document shows.

  [[nodiscard]] bool operator==(const DisplaySettings&) const = default;
};

/// What a plain left drag in the viewport does; the fills, kSplitEdge and kFlipEdge act on a click.
/// Shift or Ctrl turns what paints into lowering by 1; Alt and the other buttons move the camera
/// whatever the tool.
enum class Tool : std::uint8_t {
  kPaint,
  kLower,
  kPick,
  kOrbit,
  kSplitEdge,
  kFlipEdge,
  kFill,       ///< Faces of equal depth that hang together.
  kSmartFill,  ///< Faces as far as the surface bends by so much in all.
  kRectangle,
  kLasso,
};

/// Whether the tool works under a ring.
[[nodiscard]] constexpr bool is_brush(Tool tool) noexcept {
  return tool == Tool::kPaint || tool == Tool::kLower;
}
/// Whether a click fills a region.
[[nodiscard]] constexpr bool is_fill(Tool tool) noexcept {
  return tool == Tool::kFill || tool == Tool::kSmartFill;
}
/// Whether a drag encloses a part of the picture.
[[nodiscard]] constexpr bool is_area(Tool tool) noexcept {
  return tool == Tool::kRectangle || tool == Tool::kLasso;
}
/// Whether the tool changes depths.
[[nodiscard]] constexpr bool is_painting(Tool tool) noexcept {
  return is_brush(tool) || is_fill(tool) || is_area(tool);
}

/// Whether the tool works on the edge nearest to the cursor.
[[nodiscard]] constexpr bool picks_edges(Tool tool) noexcept {
  return tool == Tool::kSplitEdge || tool == Tool::kFlipEdge;
}

/// Degrees that a notch of the wheel, or a key, adds to the angle of a smart fill.
inline constexpr double kFillAngleStep = 5.0;
inline constexpr double kMinBrushRadius = 2.0;
inline constexpr double kMaxBrushRadius = 300.0;

struct BrushSettings {
  Tool tool = Tool::kPaint;
  bool sets_depth = false;         ///< kPaint sets the target depth; otherwise it adds 1.
  int target_depth = 1;            ///< 0..kMaxDepth.
  double radius = 24.0;            ///< Window units.
  double fill_angle = 40.0;        ///< Of kSmartFill: degrees in all, 0..kMostFillAngle.
  bool goes_through = false;       ///< Hidden faces too.
  bool is_fine = false;            ///< Faces of the refined mesh instead of control faces.
  bool shift_draws_lines = false;  ///< With kPaint; otherwise Shift lowers.
  MirrorAxes mirror{};

  [[nodiscard]] bool operator==(const BrushSettings&) const = default;
};

/// What a click would do to the painting, and what that would cost.
struct PaintForecast {
  std::size_t faces = 0;         ///< That would change.
  std::optional<int> depth{};    ///< Which all of them would get; nothing where it differs.
  int amount = 0;                ///< By how much they would change then.
  std::int64_t added_faces = 0;  ///< Of the refined mesh, more or (negative) fewer.

  [[nodiscard]] bool operator==(const PaintForecast&) const = default;
};

/// A refinement that runs off the main thread right now.
struct RunningRefinement {
  double fraction = 0.0;  ///< 0..1.
  std::string stage;      ///< "Refining level 3".
};

/// The last refinement that was finished; it may be older than the painting.
struct RefinementResult {
  std::size_t faces = 0;
  std::size_t vertices = 0;
  std::size_t bytes = 0;
  /// Uniform Catmull-Clark at the same greatest level; 0 for a uniform scheme.
  std::size_t uniform_faces = 0;
  int levels = 0;  ///< Steps made.
  double legalise_seconds = 0.0;
  double refine_seconds = 0.0;
  const CrackCheck* cracks = nullptr;  ///< Null where it has not been checked yet.
};

/// Labels of the painting, before and after legalisation; of Loop's scheme only what was deepened.
struct LegalityStatus {
  std::size_t illegal_faces = 0;     ///< As painted.
  std::size_t illegal_vertices = 0;  ///< As painted.
  std::size_t relabelled = 0;        ///< Vertices that legalisation raises to 1.
  std::size_t deepened = 0;          ///< Faces made deeper than painted, for Loop's scheme.
  std::size_t left = 0;              ///< Illegal faces afterwards: 0, or Limn has a bug.
};

/// The removal of illegal vertices, step by step.
struct StepperStatus {
  bool is_shown = false;
  bool has_trace = false;  ///< There are labels to follow; otherwise the rest is empty.
  LegalisationMethod order = LegalisationMethod::kGreedy;
  std::size_t position = 0;  ///< Steps made,
  std::size_t size = 0;      ///< of so many.
  std::size_t illegal_faces = 0;
  std::size_t illegal_vertices = 0;
  std::size_t raised = 0;
  std::span<const LegalisationCandidate> candidates{};  ///< Of the next step, the picked one first.
  std::span<const std::uint32_t> falling{};             ///< Vertices that it sets back to 0.
};

struct RefinementStatus {
  std::optional<RunningRefinement> running;
  const RefinementPrediction* prediction = nullptr;  ///< To the end, for the painting as it is.
  std::optional<RefinementResult> result;            ///< Empty where nothing is refined.
  std::optional<LegalityStatus> legality;
};

/// Why a mesh is not one for a scheme, and what would make it so.
struct SchemeMisfit {
  std::string reason;
  std::optional<Fitting> fitting;  ///< Nothing: it is not for the kind of its faces.
};

/// The uniform scheme of the document, where it has one.
struct SchemeStatus {
  std::optional<SchemeMisfit> misfit;
  /// Of levels 0 to one more than can be shown without asking, at the least; empty at a misfit.
  std::span<const SchemeCounts> counts{};
  std::span<const SchemeStep> steps{};  ///< Of the levels made; empty where none are yet.
};

/// What stands in the second half of the viewport (`DisplaySettings::second`).
struct SecondStatus {
  std::optional<SchemeMisfit> misfit;
  std::optional<std::size_t> faces;  ///< Of the mesh shown; nothing where it is not there yet.
  int levels = 0;
  bool is_over_budget = false;  ///< The mesh shown is an older one for that reason.
};

/// The levels of a scheme held against spheres.
struct SphereSeries {
  SchemeSettings settings;
  std::vector<SphereComparison> rows;
};
struct SphereStatus {
  std::optional<double> running;  ///< 0..1.
  std::span<const SphereSeries> series{};
  std::string problem;  ///< Why there is none; empty where nothing went wrong.
};

/// How far the refined mesh shown is from its limit surface, in units of the mesh.
struct DistanceFigures {
  DirectedDistance to_limit;
  DirectedDistance from_limit;
  double diagonal = 1.0;  ///< Of the control mesh.
  bool is_settled = true;

  [[nodiscard]] double greatest() const noexcept { return greatest_of(to_limit, from_limit); }
  [[nodiscard]] double root_mean_square() const noexcept {
    return root_mean_square_of(to_limit, from_limit);
  }
};
struct DistanceStatus {
  std::optional<double> running{};  ///< 0..1.
  std::optional<DistanceFigures> figures{};
  std::string problem{};     ///< Why there are none; empty where nothing went wrong.
  bool can_measure = false;  ///< A refinement is shown that has a limit surface to be held against.
};

struct HistoryStatus {
  std::string undo_name;  ///< Empty where there is nothing to undo.
  std::string redo_name;
  std::size_t bytes = 0;
  const History* steps = nullptr;  ///< Null: none.
};

/// The mended element that the person was led to last.
struct MendFocus {
  MendKind kind{};
  std::size_t element = 0;   ///< Of the report's mend of that kind.
  glm::dvec3 position{0.0};  ///< In mesh units.
};

/// What may be amiss with a surface.
enum class FlawKind : std::uint8_t {
  kBoundary,   ///< A loop of boundary edges of the control mesh.
  kTJunction,  ///< A vertex of the control mesh on an edge that is not joined to it.
  kCrack,      ///< A face of the refined mesh beside a crack.
};
inline constexpr std::size_t kFlawKinds = 3;

/// The flaw that the person was led to last.
struct FlawFocus {
  FlawKind kind{};
  std::size_t element = 0;
  std::size_t count = 0;
  glm::dvec3 position{0.0};  ///< In mesh units.
};

/// The face of the refined mesh under the cursor, where one paints on such.
struct FineHover {
  int level = 0;
  int depth = 0;  ///< Asked for.
};

/// The control face under the cursor.
struct HoverInfo {
  std::uint32_t face = 0;
  int depth = 0;
  std::size_t sides = 4;
  std::optional<FineHover> fine{};
};

/// The control edge under the cursor, where the tool is for edges.
struct EdgeHover {
  std::uint32_t edge = 0;
  std::array<std::uint32_t, 2> vertices{};
};

/// A short message in the upper middle. The program drops it when its time is over.
struct Toast {
  enum class Kind : std::uint8_t { kDone, kNote, kProblem };
  Kind kind = Kind::kNote;
  std::string text;
};

/// The card that tells a newcomer the first things to know.
struct HintCard {
  bool has_painted = false;  ///< With the mouse, since the card came.
  bool has_orbited = false;

  [[nodiscard]] bool operator==(const HintCard&) const = default;
};

/// What is kept of unsaved work, in case the program or the machine ends all of a sudden.
struct CopyStatus {
  std::string when;     ///< Of the newest copy of what is not saved, "14:05"; empty: there is none.
  std::string problem;  ///< Why the last one could not be written; empty where it could.

  [[nodiscard]] bool operator==(const CopyStatus&) const = default;
};

/// Something failed; the document is as it was.
struct ErrorDialog {
  std::string title;  ///< "Cannot open spot.obj".
  Error error;        ///< With file, line and reason where known.
};
/// A refinement would give more faces than the budget.
struct OverBudgetQuestion {
  std::uint64_t faces = 0;
  std::uint64_t bytes = 0;
  std::uint64_t budget = 0;
  std::uint64_t memory = 0;  ///< Where `bytes` are too many for this machine, how many are not.
};

/// Work that another run of the program left unsaved when it was killed. Answered by kRecover,
/// kDiscardLost, or kCancel: later.
struct RecoveryQuestion {
  std::string document;    ///< "creature.limn".
  std::string path;        ///< Where it was last saved; empty if nowhere.
  std::string when;        ///< Of the newest copy: "22 November, 14:05".
  std::size_t others = 0;  ///< More of the kind, asked about afterwards.
};

/// The document has changes that are about to be lost.
struct UnsavedQuestion {
  std::string document;  ///< Its name.
  std::string next;      ///< What comes then, an infinitive: "quit", "open cube".
};
/// Keys and mouse of the keymap in use.
struct HelpSheet {};

struct FolderEntry {
  std::string name;
  bool is_folder = false;
  std::uint64_t bytes = 0;  ///< Files only.

  [[nodiscard]] bool operator==(const FolderEntry&) const = default;
};
/// Asks for a path. The program lists folders (folders first, then files that fit the purpose); a
/// kBrowse action makes it list another one. Answered by the action of the purpose with the path.
struct PathPrompt {
  enum class Purpose : std::uint8_t { kOpen, kSaveProject, kExportRefined, kReplaceMesh };
  Purpose purpose = Purpose::kOpen;
  std::uint64_t serial = 0;  ///< Another number for every prompt: resets the text field.
  std::string folder;        ///< Absolute, as shown; ends without a separator.
  std::string parent;        ///< Absolute; empty at the root.
  std::vector<FolderEntry> entries;
  std::string suggested_name;  ///< "creature.limn"; empty for kOpen.
  /// What a file of each format would not hold of the mesh that is exported, as a sentence; empty
  /// where nothing is lost.
  std::array<std::string, MeshFormats.size()> losses;
  std::string problem;  ///< Why the folder could not be listed; empty if it could.
};

/// A dialog of the desktop is open, perhaps behind the window. Answered there, or by kCancel, or by
/// kBrowse: a PathPrompt instead.
struct DesktopDialogNote {
  PathPrompt::Purpose purpose = PathPrompt::Purpose::kOpen;
  std::string folder;
};

/// What stands before everything else and wants an answer. One at a time.
using Modal = std::variant<std::monostate, ErrorDialog, OverBudgetQuestion, UnsavedQuestion,
                           HelpSheet, PathPrompt, RecoveryQuestion, DesktopDialogNote>;

/// Control faces of each depth.
using DepthCounts = std::array<std::size_t, kMaxDepth + 1>;

/// What the legends count. Those of creases and of irregular vertices are left out where there are
/// none.
struct LegendCounts {
  DepthCounts depths{};  ///< Where `tint` is kLevel, faces of each level.
  CreaseCounts creases{};
  ValenceCounts valences{};
  Tint tint = Tint::kDepth;  ///< What colours the faces; with kNone there is no legend of it.
  std::optional<DistanceFigures> distance{};  ///< With kDistance; without, there is none either.
};

/// Everything the panels read in one frame. They change nothing: what a person wants comes back as
/// actions. References and spans must live through the frame.
struct Model {
  const Document& document;
  const MeshStatistics& statistics;  ///< Of the control mesh.
  bool is_modified = false;

  DisplaySettings display{};
  BrushSettings brush{};
  KeymapId keymap = KeymapId::kOriginal;
  ViewState view{};
  NavigationSettings navigation{};

  DepthCounts depth_counts{};
  DepthCounts level_counts{};        ///< Faces of the mesh shown by level, where these colour it.
  CreaseCounts crease_counts{};      ///< Sharp edges and vertices by how sharp they are.
  ValenceCounts valence_counts{};    ///< Irregular vertices of the mesh shown, if they are.
  double dihedral_threshold = 30.0;  ///< Degrees.
  std::optional<std::size_t> dihedral_faces{};  ///< Faces over the threshold, if counted.
  std::optional<std::size_t> dihedral_edges{};  ///< Edges over the threshold, if counted.
  double crease_sharpness = 2.0;                ///< That "crease edges" gives, 0..10.

  RefinementStatus refinement{};
  StepperStatus steps{};
  SchemeStatus scheme{};
  SecondStatus second{};
  SphereStatus sphere{};
  DistanceStatus distance{};
  AutoDepthStatus auto_depth{};
  HistoryStatus history{};
  std::optional<HoverInfo> hover{};
  std::optional<EdgeHover> hover_edge{};
  std::optional<MendFocus> mend_focus{};
  std::size_t t_junctions = 0;               ///< Of the control mesh.
  std::optional<FlawFocus> flaw_focus{};     ///< At most one of the two is there.
  std::optional<WindowPoint> mend_marker{};  ///< Where it shows, if it does.
  bool is_stroking = false;                  ///< A brush stroke is going on.
  std::optional<PaintForecast> forecast{};   ///< Nothing while it is not known.
  std::size_t lone_faces = 0;                ///< Without a mirror image, of the axes that are on.
  double frame_seconds = 0.0;
  /// From the last stroke of the mouse to the picture of what was refined after it.
  std::optional<double> stroke_seconds{};

  std::span<const std::string> bundled_meshes{};
  std::span<const std::string> recent_files{};  ///< Paths, newest first.
  std::span<const Toast> toasts{};
  std::optional<HintCard> hints{};  ///< Nothing: the card is not shown.
  CopyStatus copies{};
  Modal modal{};
  bool has_desktop_dialogs = false;  ///< There is a program that shows them.
  bool uses_desktop_dialogs = true;
};

/// Whether the viewport has two halves.
[[nodiscard]] inline bool is_split(const Model& model) noexcept {
  return model.display.second.has_value();
}

}  // namespace limn::ui
