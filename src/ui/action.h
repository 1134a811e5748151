#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>

namespace limn::ui {

/// Everything a person can do, once. Menus, buttons and keys emit these; the program carries them
/// out in one place (app/). Labels, tooltips and keys are in action_table.h and keymap.h.
///
/// Where a comment names a value, the action carries it. A *toggle* carries a bool to set it
/// outright, or nothing to flip it. An action that wants a path and carries none asks for it by a
/// PathPrompt (model.h).
enum class ActionId : std::uint8_t {
  // File
  kOpen,           ///< std::string path of a mesh or project; without: ask.
  kOpenBundled,    ///< std::string name, one of Model::bundled_meshes.
  kSaveProject,    ///< To the document's project path; asks where there is none.
  kSaveProjectAs,  ///< std::string path; without: ask.
  kExportRefined,  ///< std::string path of the OBJ file to write; without: ask.
  kReplaceMesh,    ///< std::string path of a mesh that takes up the painting; without: ask.
  kScreenshot,
  kQuit,

  // Edit
  kUndo,
  kRedo,
  kGoToStep,  ///< int, 0..: undoes or redoes until so many steps of the history are applied.
  kRevert,    ///< Back to the mesh as it was opened, unpainted.

  // Painting rules
  kRaiseAll,
  kLowerAll,
  kZeroAll,
  kRaiseVisible,
  kRaiseDihedral,         ///< +1 on faces with an edge over the threshold.
  kSetDihedralThreshold,  ///< double, degrees, 0..180.
  kCreaseDihedral,        ///< Edges over the threshold get the crease sharpness.
  kSetCreaseSharpness,    ///< double, 0..kInfiniteSharpness.
  kClearCreases,          ///< Every edge and vertex smooth.
  kGrowPainting,          ///< depth_filter.h, as what follows it
  kShrinkPainting,
  kSmoothPainting,
  kInvertPainting,
  kMirrorPainting,  ///< Symmetric by the axes that are on.
  kClearFine,       ///< What is painted finer than control faces.

  // Depths that come about by themselves (auto_depth_model.h)
  kChooseDepths,          ///< As the panel is set, or as a preset says.
  kSetDepthSource,        ///< int, a DepthSource.
  kSetDepthRules,         ///< std::string rules, one a line (paint_rule.h).
  kSetDepthUnit,          ///< int: what the amount is counted in (unit_of).
  kToggleMeasuredDepths,  ///< Tolerances: what a measurement shows to be needless is taken back.
  kSetBudgetGoal,         ///< int, a FaceBudget::Goal.
  kSetSilhouettes,        ///< int, 0..kMostSilhouettes levels more.
  kSetCurveMeasure,       ///< int, a FaceMeasure.
  kSetDepthMerge,         ///< int, a DepthMerge.
  kSetDepthWithin,        ///< std::string selection (paint_rule.h); empty: all faces.
  kSetDepthAmount,        ///< double: the quantity that the source is about first (main_amount).
  kToggleLiveDepths,      ///< The painting follows what is set.
  kToggleLimitDepths,     ///< Rules that aim at the limit surface put vertices on it.
  kKeepView,              ///< Sizes on the screen are held in this view as well.
  kForgetViews,
  kUsePreset,      ///< std::string name.
  kSavePreset,     ///< std::string name.
  kDeletePreset,   ///< std::string name.
  kCompareBudget,  ///< With uniform and random paintings of as many faces.

  // Tools: what a plain left drag in the viewport does
  kToolPaint,
  kToolLower,
  kToolFill,
  kToolSmartFill,
  kToolRectangle,
  kToolLasso,
  kToolPick,
  kToolOrbit,
  kToolSplitEdge,
  kToolFlipEdge,

  // Brush
  kBrushAdds,       ///< The brush adds 1.
  kBrushSets,       ///< The brush sets the target depth.
  kSetTargetDepth,  ///< int, 0..kMaxDepth.
  kPickDepth,       ///< The depth of the face under the cursor becomes the target depth.
  kBrushBigger,
  kBrushSmaller,
  kSetBrushRadius,      ///< double, window units, kMinBrushRadius..kMaxBrushRadius (model.h).
  kSetFillAngle,        ///< double, degrees, 0..kMostFillAngle.
  kTogglePaintThrough,  ///< Hidden faces too, for brush, rectangle and lasso.
  kToggleFine,          ///< On the refined mesh, its faces alone are painted.
  kToggleShiftLine,     ///< What Shift does with the paint tool: a line, or it lowers.
  kToggleMirrorX,
  kToggleMirrorY,
  kToggleMirrorZ,

  // Subdivide
  kRemoveIllegal,
  kSubdivide,          ///< To the end.
  kSubdivideOneLevel,  ///< One level more than is shown now.
  kBackToControl,      ///< Stage 0: nothing subdivided, labels as painted.
  kToggleLive,         ///< At stage 0 the refined mesh follows the painting.
  kApply,              ///< The refined mesh becomes the control mesh.
  kAdaptiveCatmullClark,
  kAdaptiveLoop,        ///< With Loop's weights.
  kAdaptiveLoopWarren,  ///< With Warren's.
  kLegaliseLookAhead,
  kLegaliseGreedy,
  kNonQuadsUniformFirstStep,
  kNonQuadsWherePainted,
  kCornersSharp,
  kCornersSmooth,
  kPointsLevel,
  kPointsLimit,
  kTextureSmoothInside,
  kTextureLinear,

  // Legalisation, step by step
  kToggleSteps,
  kStepFirst,
  kStepPrevious,
  kStepNext,
  kStepLast,
  kFrameStep,  ///< Look at the vertex that the next step picks.

  // Edges of triangle meshes
  kSplitEdge,  ///< The edge under the cursor.
  kFlipEdge,   ///< The edge under the cursor.

  // Uniform schemes. Their texts are those of scheme_text.h.
  kSetScheme,       ///< std::string scheme to show; empty: what is painted.
  kSetSchemeLevel,  ///< int, 0..kMostSchemeLevels.
  kSchemeForward,   ///< One level more.
  kSchemeBack,      ///< One level less.
  kLoopOriginal,
  kLoopWarren,
  kLinearSplits,
  kLinearAverages,
  kMakeFit,          ///< The control mesh becomes one that the scheme takes.
  kSetSecondScheme,  ///< std::string scheme to show beside; empty: none.
  kCompareUniform,   ///< The painting's scheme beside it, uniform to the same depth.
  kCompareSphere,    ///< Every level of the scheme against its least-squares sphere.

  // Display
  kShowControl,
  kShowRefined,
  kShowBoth,
  kToggleWireframe,
  kToggleSmooth,
  kToggleLight,
  kToggleLabels,
  kToggleIllegalMarks,
  kToggleCreases,
  kToggleFaces,
  kToggleValences,
  kToggleNumbers,
  kTintDepth,
  kTintLevel,
  kTintNone,
  kTintDistance,
  kMeasureDistance,  ///< Of the refined mesh from the limit surface.
  kMaterialStudio,
  kMaterialClay,
  kMaterialDark,
  kMaterialShiny,
  kThemeDark,
  kThemeLight,

  // Camera
  kToggleOrthographic,
  kFrameAll,
  kFramePainted,
  kFrameHovered,  ///< The face under the cursor.
  kZoomIn,
  kZoomOut,
  kViewFront,
  kViewBack,
  kViewLeft,
  kViewRight,
  kViewTop,
  kViewBottom,
  kViewIso,
  kNavigationOriginal,   ///< Alt and the buttons move the camera.
  kNavigationMouseOnly,  ///< No key is needed.
  kNavigationClassroom,  ///< Left turns, right shifts, middle zooms.
  kToggleOrbitPivot,     ///< Orbit around what is under the cursor.

  // What was mended when the mesh was opened
  kNextMend,      ///< int, a MendKind: lead to its next element.
  kPreviousMend,  ///< int, a MendKind: lead to the one before.

  // What may be amiss with the surface
  kNextFlaw,      ///< int, a FlawKind: lead to its next place.
  kPreviousFlaw,  ///< int, a FlawKind: lead to the one before.

  // Program
  kHelp,
  kKeymapOriginal,
  kKeymapClassroom,
  kToggleDesktopDialogs,  ///< Files are chosen in the desktop's own dialogs, where it has any.
  kToggleHints,           ///< The card with the first things to know.

  // Answers to what Model::modal shows
  kCancel,          ///< Closes the dialog; otherwise stops the refinement, or gives up the stroke.
  kBrowse,          ///< std::string folder that the path prompt shall list.
  kRefineAnyway,    ///< OverBudgetQuestion: go on.
  kSaveFirst,       ///< UnsavedQuestion: save, then go on.
  kDiscardChanges,  ///< UnsavedQuestion: go on without saving.
  kRecover,         ///< RecoveryQuestion: open the unsaved work.
  kDiscardLost,     ///< RecoveryQuestion: delete it.
};

inline constexpr std::size_t kActionCount = static_cast<std::size_t>(ActionId::kDiscardLost) + 1;

using ActionValue = std::variant<std::monostate, bool, int, double, std::string>;

/// One wish of the person at the screen, as plain data: it can be written down and played back.
struct Action {
  ActionId id = ActionId::kCancel;
  ActionValue value;

  Action() = default;
  Action(ActionId what) : id(what) {}  // NOLINT(google-explicit-constructor): reads as the id.
  Action(ActionId what, ActionValue with) : id(what), value(std::move(with)) {}

  [[nodiscard]] bool operator==(const Action&) const = default;
};

}  // namespace limn::ui
