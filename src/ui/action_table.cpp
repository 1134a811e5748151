// One row per action, in the order of ActionId. `info` indexes the table, and a check at compile
// time keeps the two orders alike.

#include "ui/action_table.h"

namespace limn::ui {
namespace {

using enum ActionId;
using enum ActionGroup;
constexpr ValueKind kNothing = ValueKind::kNone;

constexpr std::array<ActionInfo, kActionCount> kTable{{
    {kOpen, kFile, ValueKind::kPathOrAsk, "Open…",
     "Open a mesh (OBJ, PLY, OFF or STL) or a Limn project. The mesh that is open stays if the "
     "file is bad."},
    {kOpenBundled, kFile, ValueKind::kText, "Open bundled mesh",
     "Open one of the control meshes that come with Limn."},
    {kSaveProject, kFile, kNothing, "Save project",
     "Save mesh, painting, settings and camera in one .limn file."},
    {kSaveProjectAs, kFile, ValueKind::kPathOrAsk, "Save project as…",
     "Save the project under another name."},
    {kExportRefined, kFile, ValueKind::kPathOrAsk, "Export mesh…",
     "Write the refined mesh to an OBJ, PLY, OFF or STL file. The painted depths go along where "
     "the "
     "format holds them."},
    {kReplaceMesh, kFile, ValueKind::kPathOrAsk, "Replace mesh…",
     "Carry painting and creases over to another version of the mesh, as another program wrote it: "
     "faces are found again by their vertices. Can be undone."},
    {kScreenshot, kFile, kNothing, "Take screenshot", "Save a picture of the window as PNG."},
    {kQuit, kFile, kNothing, "Quit", "Leave Limn. It asks before unsaved changes are lost."},

    {kUndo, kEdit, kNothing, "Undo", "Take back the last change."},
    {kRedo, kEdit, kNothing, "Redo", "Make the change again that was taken back last."},
    {kGoToStep, kEdit, ValueKind::kInt, "Go to this step",
     "Undo or redo until the document is as it was after this step."},
    {kRevert, kEdit, kNothing, "Revert to opened mesh",
     "Go back to the mesh as it was opened, with nothing painted. Can be undone."},

    {kRaiseAll, kPaint, kNothing, "Raise all", "Every face gets one level more."},
    {kLowerAll, kPaint, kNothing, "Lower all",
     "Every face gets one level less; faces at 0 stay there."},
    {kZeroAll, kPaint, kNothing, "Zero all", "Clear the painting: every face gets depth 0."},
    {kRaiseVisible, kPaint, kNothing, "Raise visible",
     "Every face of which at least one pixel shows gets one level more."},
    {kRaiseDihedral, kPaint, kNothing, "Raise sharp",
     "Every face with an edge bent by more than the threshold gets one level more."},
    {kSetDihedralThreshold, kPaint, ValueKind::kDouble, "Sharpness threshold",
     "The angle in degrees between two neighbouring faces above which their edge counts as sharp."},
    {kCreaseDihedral, kPaint, kNothing, "Crease sharp edges",
     "Edges bent by more than the threshold stay sharp for so many levels of subdivision. The "
     "creases that are there stay."},
    {kSetCreaseSharpness, kPaint, ValueKind::kDouble, "Crease sharpness",
     "For how many levels creased edges stay sharp before they are smoothed; a fraction blends. At "
     "10 they never wear off; 0 makes them smooth."},
    {kClearCreases, kPaint, kNothing, "Clear creases",
     "Make every edge and every corner of the control mesh smooth."},
    {kGrowPainting, kPaint, kNothing, "Grow",
     "Each face takes the greatest depth of itself and the faces around it: painted places widen "
     "by "
     "one ring."},
    {kShrinkPainting, kPaint, kNothing, "Shrink",
     "Each face takes the least depth of itself and the faces around it: painted places lose their "
     "outer ring."},
    {kSmoothPainting, kPaint, kNothing, "Even out",
     "Each face takes the rounded mean depth of itself and the faces around it: steps become "
     "stairs, "
     "lone faces go."},
    {kInvertPainting, kPaint, kNothing, "Invert",
     "Unpainted faces get the deepest depth and the deepest none; what lies between changes "
     "sides."},
    {kMirrorPainting, kPaint, kNothing, "Mirror painting",
     "Make the painting symmetric across the axes that are on: each face takes the greatest depth "
     "of "
     "itself and its mirror images."},
    {kClearFine, kPaint, kNothing, "Clear fine painting",
     "Drop all that is painted finer than control faces. The depths of control faces stay."},

    {kChooseDepths, kPaint, kNothing, "Choose depths",
     "Give every face the depth that the Auto depth panel asks for. One step to undo."},
    {kSetDepthSource, kPaint, ValueKind::kInt, "Depths by",
     "What depths are chosen by: a distance to the limit surface, a number of faces, a size on the "
     "screen, or a curve over what a face measures."},
    {kSetDepthRules, kPaint, ValueKind::kText, "Depth rule",
     "What choosing depths goes by, as on the command line."},
    {kSetDepthUnit, kPaint, ValueKind::kInt, "Counted in",
     "What the amount is counted in: parts of the mesh's diagonal, its units or pixels; faces or "
     "triangles; the length of edges or the area of faces."},
    {kToggleMeasuredDepths, kPaint, ValueKind::kToggle, "Measure while choosing",
     "Take back every level that a measurement shows to be needless. Slower, and fewer faces, most "
     "of all beside creases that wear off."},
    {kSetBudgetGoal, kPaint, ValueKind::kInt, "Spend it on",
     "The least mean error over all of the surface, the least greatest error, or nothing: faces at "
     "random, to compare with."},
    {kSetSilhouettes, kPaint, ValueKind::kInt, "Silhouettes",
     "How many levels more faces get where the surface turns away from the eye, where facets show "
     "first."},
    {kSetCurveMeasure, kPaint, ValueKind::kInt, "Curve over",
     "What the curve tells faces apart by."},
    {kSetDepthMerge, kPaint, ValueKind::kInt, "Chosen depths",
     "How they go together with what is painted."},
    {kSetDepthWithin, kPaint, ValueKind::kText, "Where",
     "Faces that may change; all others keep their depth."},
    {kSetDepthAmount, kPaint, ValueKind::kDouble, "Depth amount",
     "How far from the limit surface, how many faces, or how large on the screen, at the most. "
     "Ctrl and a click to type it."},
    {kToggleLiveDepths, kPaint, ValueKind::kToggle, "Live",
     "Depths are chosen anew whenever something is changed here. It stays one step to undo."},
    {kToggleLimitDepths, kPaint, ValueKind::kToggle, "On the limit",
     "Tolerances and budgets also move the vertices onto the limit surface, which takes fewer "
     "faces."},
    {kKeepView, kPaint, kNothing, "Keep this view",
     "Sizes on the screen are held as seen from here, wherever you look from later. Several views "
     "can be kept; what none of them sees stays coarse."},
    {kForgetViews, kPaint, kNothing, "Forget views", "Only the view in force counts again."},
    {kUsePreset, kPaint, ValueKind::kText, "Preset",
     "Rules under a name, those of Limn and your own."},
    {kSavePreset, kPaint, ValueKind::kText, "Save as preset",
     "Keep what is set here under this name, for other meshes and for the command line."},
    {kDeletePreset, kPaint, ValueKind::kText, "Delete preset",
     "Forget the preset of this name, one of your own."},
    {kCompareBudget, kPaint, kNothing, "Compare",
     "Measure what the finest uniform mesh within the budget, and faces painted at random, would "
     "leave of the distance to the limit surface."},

    {kToolPaint, kPaint, kNothing, "Paint tool",
     "Left drag paints the faces under the ring. Shift or Ctrl lowers them instead."},
    {kToolLower, kPaint, kNothing, "Lower tool",
     "Left drag lowers the faces under the ring by 1. Shift and a click draw a straight line from "
     "where the last stroke ended."},
    {kToolFill, kPaint, kNothing, "Fill tool",
     "A click paints the face under the cursor and all around it that have its depth, as far as "
     "they "
     "hang together. Shift or Ctrl lowers them."},
    {kToolSmartFill, kPaint, kNothing, "Smart fill tool",
     "A click paints the face under the cursor and what is around it, until the surface has bent "
     "by "
     "the fill angle in all. Shift or Ctrl lowers."},
    {kToolRectangle, kPaint, kNothing, "Rectangle tool",
     "Left drag spans a rectangle; the faces in it are painted when you let go. Shift or Ctrl "
     "lowers "
     "them, Esc gives it up."},
    {kToolLasso, kPaint, kNothing, "Lasso tool",
     "Left drag draws around faces; they are painted when you let go. Shift or Ctrl lowers them, "
     "Esc "
     "gives it up."},
    {kToolPick, kPaint, kNothing, "Pick tool",
     "A click makes the depth of the face under the cursor the target depth."},
    {kToolOrbit, kCamera, kNothing, "Orbit tool",
     "Left drag turns the view. The middle button does so with every tool."},
    {kToolSplitEdge, kEdges, kNothing, "Split edge tool",
     "A click puts a vertex in the middle of the edge under the cursor and joins it to the "
     "vertices "
     "opposite. For triangles."},
    {kToolFlipEdge, kEdges, kNothing, "Flip edge tool",
     "A click turns the edge under the cursor: it then joins the other two vertices of its two "
     "triangles."},

    {kBrushAdds, kPaint, kNothing, "Brush adds 1",
     "The brush raises each face by 1, once a stroke."},
    {kBrushSets, kPaint, kNothing, "Brush sets depth",
     "The brush gives each face the target depth, whatever it had."},
    {kSetTargetDepth, kPaint, ValueKind::kInt, "Target depth",
     "The depth that the brush sets: how many times a face is subdivided."},
    {kPickDepth, kPaint, kNothing, "Pick depth here",
     "The depth of the face under the cursor becomes the target depth."},
    {kBrushBigger, kPaint, kNothing, "Bigger brush",
     "Widen the ring of the brush, or the angle of a smart fill. Ctrl and the wheel do so too."},
    {kBrushSmaller, kPaint, kNothing, "Smaller brush",
     "Narrow the ring of the brush, or the angle of a smart fill. Ctrl and the wheel do so too."},
    {kSetBrushRadius, kPaint, ValueKind::kDouble, "Brush radius",
     "How wide the brush is on the screen."},
    {kSetFillAngle, kPaint, ValueKind::kDouble, "Fill angle",
     "By how many degrees in all the surface may bend on the way from where you click. A flat face "
     "is filled by any angle; a whole round bottle needs 180."},
    {kTogglePaintThrough, kPaint, ValueKind::kToggle, "Paint through",
     "Brush, rectangle and lasso also paint faces that are hidden behind others. Otherwise only "
     "what "
     "you see is painted."},
    {kToggleFine, kPaint, ValueKind::kToggle, "Fine",
     "On the refined mesh, brush, rectangle and lasso paint the small faces that you see instead "
     "of "
     "the control faces they lie in. The surface they approach stays the same."},
    {kToggleShiftLine, kPaint, ValueKind::kToggle, "Line with Shift",
     "With the paint tool, Shift and a click paint a straight line from where the last stroke "
     "ended, "
     "instead of lowering. Ctrl always lowers."},
    {kToggleMirrorX, kPaint, ValueKind::kToggle, "Mirror X",
     "Paint the mirror image too, left and right of the middle of the mesh. Goes together with the "
     "other two."},
    {kToggleMirrorY, kPaint, ValueKind::kToggle, "Mirror Y",
     "Paint the mirror image too, above and below the middle of the mesh."},
    {kToggleMirrorZ, kPaint, ValueKind::kToggle, "Mirror Z",
     "Paint the mirror image too, in front of and behind the middle of the mesh."},

    {kRemoveIllegal, kRefine, kNothing, "Remove illegal vertices",
     "Raise as few vertices as the rule needs so that every face can be split without a crack. "
     "Subdividing does this by itself; here you see the labels it gives."},
    {kSubdivide, kRefine, kNothing, "Subdivide",
     "Refine every face as deep as it is painted. The control mesh and the painting stay."},
    {kSubdivideOneLevel, kRefine, kNothing, "Subdivide one level",
     "Show one level of the subdivision more."},
    {kBackToControl, kRefine, kNothing, "Back to control mesh",
     "Show the mesh before any subdivision. The painting stays."},
    {kToggleLive, kRefine, ValueKind::kToggle, "Follow the painting",
     "Refine anew after every stroke, so that the refined mesh is always that of the painting. "
     "Without it you subdivide step by step."},
    {kApply, kRefine, kNothing, "Apply as control mesh",
     "Make the refined mesh the new control mesh, unpainted. From then on it is a mesh of its own "
     "with another limit surface. Can be undone."},
    {kAdaptiveCatmullClark, kRefine, kNothing, "Paint Catmull-Clark",
     "Painted faces are subdivided by label-driven Catmull-Clark, on any mesh."},
    {kAdaptiveLoop, kRefine, kNothing, "Paint Loop",
     "Painted triangles are subdivided by Loop's scheme with his weights. Faces that share an edge "
     "are kept within one level of each other, and triangle fans close the steps. Triangle meshes "
     "only."},
    {kAdaptiveLoopWarren, kRefine, kNothing, "Paint Loop, Warren's weights",
     "The same with Warren's simpler weights. Triangle meshes only."},
    {kLegaliseLookAhead, kRefine, kNothing, "Look ahead",
     "Raise the vertices that mend the most for the fewest faces, look one further ahead, and take "
     "back what proves needless. Never gives more faces than the published order."},
    {kLegaliseGreedy, kRefine, kNothing, "Greedy order",
     "Raise vertices in the published order: most illegal neighbours first."},
    {kNonQuadsUniformFirstStep, kRefine, kNothing, "Split all faces once",
     "On a mesh with faces that are not quads, the first level splits every face, so that only "
     "quads are left. This is the published rule."},
    {kNonQuadsWherePainted, kRefine, kNothing, "Split where painted",
     "Faces that are not quads are split only where the painting reaches them; the others stay as "
     "they are. Gives fewer faces."},
    {kCornersSharp, kRefine, kNothing, "Keep corners",
     "A boundary corner that belongs to one face stays where it is."},
    {kCornersSmooth, kRefine, kNothing, "Round corners off",
     "A boundary corner that belongs to one face is rounded off with the rest of the boundary."},

    {kPointsLevel, kRefine, kNothing, "Vertices at their level",
     "Each vertex lies where uniform subdivision to its level puts it, so that going on "
     "subdividing "
     "gives the same surface."},
    {kPointsLimit, kRefine, kNothing, "Vertices on the limit",
     "Each vertex lies on the surface that endless subdivision would give: fewer levels come as "
     "close. For a mesh that is not subdivided any further."},
    {kTextureSmoothInside, kRefine, kNothing, "Smooth texture inside",
     "Texture coordinates are smoothed as the surface is, but stay straight along seams and "
     "boundaries."},
    {kTextureLinear, kRefine, kNothing, "Linear texture",
     "Texture coordinates are spread evenly in every face: nothing slides, but the texture bends "
     "at "
     "the edges of the control mesh."},

    {kToggleSteps, kRefine, ValueKind::kToggle, "Show the steps",
     "See how illegal vertices are removed, one step after the other: candidates with what they "
     "are "
     "weighed by, which one is picked, and why. Nothing is changed."},
    {kStepFirst, kRefine, kNothing, "Before the first step", "What is illegal as it is painted."},
    {kStepPrevious, kRefine, kNothing, "Previous step", "Take the last step back."},
    {kStepNext, kRefine, kNothing, "Next step", "Raise the vertex that is picked."},
    {kStepLast, kRefine, kNothing, "After the last step", "What all steps together make."},
    {kFrameStep, kRefine, kNothing, "Look at picked vertex",
     "Turn and move the camera to the vertex that the next step changes."},

    {kSplitEdge, kEdges, kNothing, "Split this edge",
     "Put a vertex in the middle of the edge under the cursor, whichever tool of the two for edges "
     "is taken up."},
    {kFlipEdge, kEdges, kNothing, "Flip this edge",
     "Turn the edge under the cursor, whichever tool of the two for edges is taken up."},

    {kSetScheme, kSchemes, ValueKind::kText, "Scheme",
     "The subdivision scheme to see at work: as painted, or one that subdivides every face at "
     "every level."},
    {kSetSchemeLevel, kSchemes, ValueKind::kInt, "Level", "Show this level of the scheme."},
    {kSchemeForward, kSchemes, kNothing, "Forward", "Subdivide every face once more."},
    {kSchemeBack, kSchemes, kNothing, "Back", "Go back by one level."},
    {kLoopOriginal, kSchemes, kNothing, "Original weights",
     "With n neighbours, each counts for (5/8 - (3/8 + cos(2 pi / n) / 4)^2) / n (Loop 1987)."},
    {kLoopWarren, kSchemes, kNothing, "Warren's weights",
     "With n neighbours, each counts for 3 / (8 n), and for 3/16 where there are three (Warren "
     "1995)."},
    {kLinearSplits, kSchemes, kNothing, "Split only",
     "New vertices lie in the middles of edges and faces; nothing moves."},
    {kLinearAverages, kSchemes, kNothing, "Then average",
     "After each split every vertex goes to the mean of the centroids of the faces around it."},
    {kMakeFit, kSchemes, kNothing, "Make the mesh fit",
     "Change the control mesh into one that the scheme takes: triangles by cutting its faces along "
     "short diagonals, quads by one step of Catmull-Clark. Can be undone."},
    {kSetSecondScheme, kSchemes, ValueKind::kText, "Beside it",
     "Show another scheme at the same level in the second half of the view. Both halves move "
     "together."},
    {kCompareUniform, kSchemes, ValueKind::kToggle, "Uniform beside",
     "Show uniform subdivision to the greatest painted depth in the second half of the view, with "
     "its faces. Both halves move together."},
    {kCompareSphere, kSchemes, kNothing, "Compare with a sphere",
     "Fit a sphere to the vertices of each level by least squares, and show how far they are from "
     "it. Loop is compared with both its weights."},

    {kShowControl, kDisplay, kNothing, "Show control mesh",
     "Show the mesh you paint, coloured by depth."},
    {kShowRefined, kDisplay, kNothing, "Show refined mesh",
     "Show the subdivided mesh. Painting on it paints the control face underneath."},
    {kShowBoth, kDisplay, kNothing, "Show both",
     "Show the subdivided mesh with the control mesh as a cage of lines."},
    {kToggleWireframe, kDisplay, ValueKind::kToggle, "Wireframe", "Draw the edges of the faces."},
    {kToggleSmooth, kDisplay, ValueKind::kToggle, "Smooth",
     "Shade the surface without facets. Only the light changes, not the mesh."},
    {kToggleLight, kDisplay, ValueKind::kToggle, "Lighting",
     "Light the surface. Without it the pure depth colours show."},
    {kToggleLabels, kDisplay, ValueKind::kToggle, "Vertex labels",
     "Show at each vertex how many more levels the faces around it get."},
    {kToggleIllegalMarks, kDisplay, ValueKind::kToggle, "Illegal faces",
     "Hatch the quads that could not be split without a crack (exactly two of their labels are 0) "
     "and dot those vertices."},
    {kToggleCreases, kDisplay, ValueKind::kToggle, "Creases",
     "Draw sharp edges as lines and sharp vertices as dots, the lighter and wider the sharper. On "
     "the refined mesh what is still sharp is drawn."},
    {kToggleFaces, kDisplay, ValueKind::kToggle, "Faces",
     "Fill the faces. Without them the edges alone are drawn, and one sees through the mesh."},
    {kToggleValences, kDisplay, ValueKind::kToggle, "Valences",
     "Mark irregular vertices, those that have not as many edges as in a regular grid (6 among "
     "triangles, otherwise 4), with how many they have."},
    {kToggleNumbers, kDisplay, ValueKind::kToggle, "Numbers",
     "Write on each face the number that its colour stands for, where the face is large enough on "
     "the screen to hold it. On the refined mesh depths are written once for each control face."},
    {kTintDepth, kDisplay, kNothing, "Colour by depth",
     "Colour each face by the depth that is painted on its control face."},
    {kTintLevel, kDisplay, kNothing, "Colour by level",
     "Colour each refined face by how many times it has been subdivided itself. That shows where "
     "the seams between depths run."},
    {kTintNone, kDisplay, kNothing, "No colours",
     "Show the surface in its material alone, whatever is painted."},
    {kTintDistance, kDisplay, kNothing, "Colour by distance",
     "Colour each refined face by how far it is from the limit surface, the smooth surface that "
     "subdividing for ever would give. Measured again whenever the refined mesh changes."},
    {kMeasureDistance, kDisplay, kNothing, "Measure",
     "Measure how far the refined mesh is from the limit surface, both ways: the greatest distance "
     "and the root of the mean square."},
    {kMaterialStudio, kDisplay, kNothing, "Studio",
     "A matt surface under a key light, a fill and a rim. Depth colours are seen best."},
    {kMaterialClay, kDisplay, kNothing, "Clay",
     "Warm and soft, as what one models with. Shows the big shapes."},
    {kMaterialDark, kDisplay, kNothing, "Dark stone",
     "Dark, with light from both sides. Shows outlines and creases."},
    {kMaterialShiny, kDisplay, kNothing, "Polish",
     "Shiny, with two windows mirrored in it. Shows dents and seams that a matt surface hides."},
    {kThemeDark, kDisplay, kNothing, "Dark theme", "Light text on a dark ground."},
    {kThemeLight, kDisplay, kNothing, "Light theme", "Dark text on a light ground."},

    {kToggleOrthographic, kCamera, ValueKind::kToggle, "Orthographic",
     "Look without perspective: parallel lines stay parallel."},
    {kFrameAll, kCamera, kNothing, "Frame all", "Move the camera so that the whole mesh fits."},
    {kFramePainted, kCamera, kNothing, "Frame painted",
     "Move the camera so that the painted faces fill the view."},
    {kFrameHovered, kCamera, kNothing, "Frame face",
     "Move the camera to the face under the cursor and turn around it from now on."},
    {kZoomIn, kCamera, kNothing, "Zoom in", "Move the camera closer. The wheel does so too."},
    {kZoomOut, kCamera, kNothing, "Zoom out", "Move the camera away. The wheel does so too."},
    {kViewFront, kCamera, kNothing, "Front view", "Look at the front of the mesh, along -Z."},
    {kViewBack, kCamera, kNothing, "Back view", "Look at the back of the mesh, along +Z."},
    {kViewLeft, kCamera, kNothing, "Left view", "Look from the left, along +X."},
    {kViewRight, kCamera, kNothing, "Right view", "Look from the right, along -X."},
    {kViewTop, kCamera, kNothing, "Top view", "Look from above, along -Y."},
    {kViewBottom, kCamera, kNothing, "Bottom view", "Look from below, along +Y."},
    {kViewIso, kCamera, kNothing, "Three-quarter view", "Look from the upper right front."},
    {kNavigationOriginal, kCamera, kNothing, "Navigate with Alt",
     "Alt and the left button orbit, Alt and the middle one pan, Alt and the right one zoom; the "
     "middle button alone orbits."},
    {kNavigationMouseOnly, kCamera, kNothing, "Navigate with the mouse alone",
     "The right button orbits, and so does a left drag that begins beside the mesh; the middle "
     "button pans."},
    {kNavigationClassroom, kCamera, kNothing, "Navigate as in class",
     "A left drag beside the mesh orbits, with the orbit tool a left drag anywhere; the right "
     "button pans, the middle one zooms."},
    {kToggleOrbitPivot, kCamera, ValueKind::kToggle, "Orbit around cursor",
     "Turn the view around the place of the mesh that is under the cursor when the drag begins, "
     "so that it stays there. Otherwise around the middle of the view."},

    {kNextMend, kCamera, ValueKind::kInt, "Show next mended place",
     "Move the camera to the next place of this kind and mark it. After the last comes the first."},
    {kPreviousMend, kCamera, ValueKind::kInt, "Show mended place before",
     "Move the camera back to the place before and mark it."},

    {kNextFlaw, kCamera, ValueKind::kInt, "Show next place",
     "Move the camera to the next place of this kind and mark it. After the last comes the first."},
    {kPreviousFlaw, kCamera, ValueKind::kInt, "Show place before",
     "Move the camera back to the place before and mark it."},

    {kHelp, kProgram, kNothing, "Keys and mouse", "Show everything the keys and the mouse do."},
    {kKeymapOriginal, kProgram, kNothing, "Original keys",
     "The keys of the program Limn grew from. A plain left drag paints."},
    {kKeymapClassroom, kProgram, kNothing, "Classroom keys",
     "The keys of a course's mesh viewer: S smooth, E edges, L light. A plain left drag orbits."},
    {kToggleDesktopDialogs, kProgram, ValueKind::kToggle, "Dialogs of the desktop",
     "Choose files in the dialogs of your desktop (zenity or kdialog) instead of in Limn's own."},
    {kToggleHints, kProgram, ValueKind::kToggle, "Show hints",
     "A card in the viewport that says how to paint, lower and orbit. It goes by itself once you "
     "have painted and orbited."},

    {kCancel, kProgram, kNothing, "Cancel",
     "Close the dialog, stop the refinement, or give up the stroke."},
    {kBrowse, kAnswer, ValueKind::kText, "Open folder", "List the contents of this folder."},
    {kRefineAnyway, kAnswer, kNothing, "Refine anyway",
     "Carry out the refinement although it has more faces than the budget."},
    {kSaveFirst, kAnswer, kNothing, "Save", "Save the project, then go on."},
    {kDiscardChanges, kAnswer, kNothing, "Discard changes",
     "Go on without saving. What was painted since the last save is lost."},
    {kRecover, kAnswer, kNothing, "Recover", "Open the newest copy. It is kept until you save it."},
    {kDiscardLost, kAnswer, kNothing, "Discard", "Delete all copies of this work for good."},
}};

constexpr bool is_in_order() {
  for (std::size_t i = 0; i < kActionCount; ++i) {
    if (static_cast<std::size_t>(kTable[i].id) != i) {
      return false;
    }
  }
  return true;
}
static_assert(is_in_order());

}  // namespace

const std::array<ActionInfo, kActionCount>& action_table() noexcept {
  return kTable;
}

const ActionInfo& info(ActionId id) noexcept {
  return kTable[static_cast<std::size_t>(id)];
}

std::string_view heading(ActionGroup group) noexcept {
  switch (group) {
    case kFile:
      return "File";
    case kEdit:
      return "Edit";
    case kPaint:
      return "Paint";
    case kRefine:
      return "Subdivide";
    case kSchemes:
      return "Schemes";
    case kEdges:
      return "Edges";
    case kDisplay:
      return "Display";
    case kCamera:
      return "Camera";
    case kProgram:
      return "Program";
    case kAnswer:
      return "Dialogs";
  }
  return {};
}

}  // namespace limn::ui
