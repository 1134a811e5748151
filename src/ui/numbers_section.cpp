// Figures in two columns: what, and how many.

#include <string>

#include "limn/document/document.h"
#include "limn/mesh/statistics.h"
#include "limn/subdivision/crack_check.h"
#include "ui/availability.h"
#include "ui/format.h"
#include "ui/panels.h"
#include "ui/widgets.h"

namespace limn::ui {
namespace {

constexpr const char* kNothing = "–";

std::size_t faces_with(const MeshStatistics& statistics, std::size_t sides) {
  const auto found = statistics.faces_by_sides.find(sides);
  return found == statistics.faces_by_sides.end() ? 0 : found->second;
}

/// The way from one place of a kind to the next, where there are any.
void way_to(PanelContext& context, FlawKind kind, const std::string& name) {
  const std::size_t count = count_of(context.model, kind);
  if (count == 0) {
    return;
  }
  ImGui::PushID(name.c_str());
  const std::optional<FlawFocus>& focus = context.model.flaw_focus;
  const bool is_shown = focus && focus->kind == kind;
  const auto value = static_cast<int>(kind);
  if (is_shown && count > 1) {
    action_button(context, Action(ActionId::kPreviousFlaw, value),
                  {.label = "Previous", .width = context.px(80)});
    remember(context, "previous " + name);
    ImGui::SameLine();
  }
  action_button(context, Action(ActionId::kNextFlaw, value),
                {.label = is_shown && count > 1 ? "Next" : "Show", .width = context.px(80)});
  remember(context, "next " + name);
  if (is_shown) {
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    const std::string text = grouped(focus->element + 1) + " of " + grouped(focus->count);
    ImGui::TextUnformatted(text.c_str());
  }
  ImGui::Dummy({0.0F, context.px(2)});
  ImGui::PopID();
}

void control_rows(PanelContext& context) {
  const MeshStatistics& s = context.model.statistics;
  const std::size_t triangles = faces_with(s, 3);
  const std::size_t quads = faces_with(s, 4);
  value_row(context, {"Vertices", grouped(s.vertices), "Vertices of the control mesh."});
  value_row(context, {"Edges", grouped(s.edges), "Edges of the control mesh."});
  value_row(context, {"Faces", grouped(s.faces), "Faces of the control mesh."});
  value_row(context, {"Triangles", grouped(triangles), "Faces with three sides."});
  value_row(context, {"Quads", grouped(quads), "Faces with four sides."});
  value_row(context, {"Other faces", grouped(s.faces - triangles - quads),
                      "Faces with five sides or more."});
  value_row(context, {"Boundary edges", grouped(s.boundary_edges),
                      "Edges with one face only, where the surface ends."});
  value_row(context, {"Boundary loops", grouped(s.boundary_loops),
                      "Rims and holes: closed ways along boundary edges."});
  way_to(context, FlawKind::kBoundary, "boundary loop");
  const std::size_t t_junctions = context.model.t_junctions;
  value_row(context, {"T-junctions", t_junctions == 0 ? "none" : grouped(t_junctions),
                      "Vertices on a boundary edge that they are not joined to. The mesh looks "
                      "closed there, but cracks open when it is subdivided.",
                      t_junctions > 0});
  way_to(context, FlawKind::kTJunction, "T-junction");
  value_row(context, {"Creased edges", grouped(s.crease_edges),
                      "Edges that stay sharp for a number of levels, or for ever."});
  value_row(context, {"Sharp vertices", grouped(s.sharp_vertices),
                      "Vertices that are pulled to a corner for a number of levels."});
  value_row(context, {"Texture seams", s.uv_points == 0 ? kNothing : grouped(s.uv_seams),
                      "Edges at which the texture is cut; a mesh without texture coordinates has "
                      "no figure here."});
  if (const std::size_t demands = context.model.document.demands.size(); demands > 0) {
    value_row(context, {"Finer than faces", counted(demands, "demand"),
                        "Faces of the refined mesh that are asked to be finer than the paint on "
                        "their control face makes them. \"Clear fine painting\" drops them."});
  }
  value_row(context, {"Euler characteristic", grouped(s.euler_characteristic),
                      "Vertices - edges + faces: 2 for a surface like a ball, 0 like a ring."});
}

/// `cracks` is null where it is not known yet.
std::string crack_text(const CrackCheck* cracks) {
  if (cracks == nullptr) {
    return kNothing;
  }
  if (cracks->is_watertight()) {
    return "none";
  }
  return cracks->crack_faces.empty() ? "pieces missing"
                                     : counted(cracks->crack_faces.size(), "face");
}

void refined_rows(PanelContext& context) {
  const std::optional<RefinementResult>& result = context.model.refinement.result;
  const auto row = [&](std::string_view label, std::string_view meaning, auto&& value) {
    value_row(context, {label, result ? value(*result) : std::string(kNothing), meaning});
  };
  row("Vertices", "Vertices of the refined mesh.",
      [](const RefinementResult& r) { return grouped(r.vertices); });
  row("Faces", "Faces of the refined mesh.",
      [](const RefinementResult& r) { return grouped(r.faces); });
  row("Uniform at this depth", "Faces of uniform subdivision to the same greatest level.",
      [](const RefinementResult& r) {
        return r.uniform_faces > 0 ? grouped(r.uniform_faces) : std::string(kNothing);
      });
  row("Saved", "The part of the uniform faces that is not needed.", [](const RefinementResult& r) {
    return percent_text(static_cast<double>(r.uniform_faces) - static_cast<double>(r.faces),
                        static_cast<double>(r.uniform_faces));
  });
  row("Levels", "Subdivision steps made.",
      [](const RefinementResult& r) { return std::to_string(r.levels); });

  const CrackCheck* cracks = result ? result->cracks : nullptr;
  const bool is_cracked = cracks != nullptr && !cracks->is_watertight();
  value_row(context, {"Cracks", crack_text(cracks),
                      "Faces beside a hole or a T-junction that the control mesh does not have. "
                      "Checked edge by edge after every refinement.",
                      is_cracked});
  way_to(context, FlawKind::kCrack, "crack");
  row("Memory", "Of the refined mesh.",
      [](const RefinementResult& r) { return bytes_text(r.bytes); });
  row("Time", "To find the labels, and to refine.", [](const RefinementResult& r) {
    return seconds_text(r.legalise_seconds) + " + " + seconds_text(r.refine_seconds);
  });
}

void distance_rows(PanelContext& context) {
  const DistanceStatus& status = context.model.distance;
  if (status.running) {
    draw_progress(context, {*status.running, "Measuring"}, std::nullopt);
    return;
  }
  const std::optional<DistanceFigures>& figures = status.figures;
  const auto row = [&](std::string_view label, std::string_view meaning, double distance) {
    value_row(context, {label,
                        figures ? distance_text(distance) + " · " +
                                      diagonal_text(distance, figures->diagonal)
                                : std::string(kNothing),
                        meaning});
  };
  row("Greatest",
      "The farthest that a point of the refined mesh is from the limit surface, or a point of that "
      "from the mesh; in units of the mesh, and as a part of its diagonal.",
      figures ? figures->greatest() : 0.0);
  row("R.m.s.", "The root of the mean square of these distances, over the area of both surfaces.",
      figures ? figures->root_mean_square() : 0.0);
  action_button(context, ActionId::kMeasureDistance,
                {.label = figures ? "Measure again" : "Measure", .width = context.px(120)});
  if (!status.problem.empty()) {
    wrapped_text(context, context.colours.problem, status.problem);
  } else if (figures && !figures->is_settled) {
    wrapped_text(context, context.colours.problem,
                 "The figures still changed by more than 1 % with the last samples.");
  }
}

}  // namespace

void draw_numbers_section(PanelContext& context) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {context.px(8), context.px(1)});
  sub_heading(context, "Control mesh");
  control_rows(context);
  ImGui::Dummy({0.0F, context.px(8)});
  sub_heading(context, context.model.refinement.result ? "Refined mesh"
                                                       : "Refined mesh: none yet, paint for one");
  refined_rows(context);
  ImGui::Dummy({0.0F, context.px(8)});
  sub_heading(context, "Distance to the limit surface");
  distance_rows(context);
  ImGui::Dummy({0.0F, context.px(8)});
  sub_heading(context, "Program");
  value_row(context, {"Frame", seconds_text(context.model.frame_seconds),
                      "Time between the last two pictures."});
  value_row(context, {"Stroke to picture",
                      context.model.stroke_seconds ? seconds_text(*context.model.stroke_seconds)
                                                   : std::string(kNothing),
                      "From a move of the brush to the refined mesh that follows from it."});
  value_row(context, {"Undo memory", bytes_text(context.model.history.bytes),
                      "What the history of changes keeps."});
  ImGui::PopStyleVar();
}

}  // namespace limn::ui
