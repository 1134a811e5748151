#include "app/status_file.h"

#include <array>
#include <string>
#include <variant>

#include <nlohmann/json.hpp>

#include "app/session.h"
#include "limn/files/atomic_file.h"
#include "limn/mesh/refined_mesh.h"
#include "ui/scheme_text.h"

namespace limn::app {
namespace {

using Json = nlohmann::ordered_json;

Json rect_json(const ui::WindowRect& rect) {
  return {rect.origin.x, rect.origin.y, rect.size.width, rect.size.height};
}

std::string modal_name(const ui::Modal& modal) {
  constexpr std::array kNames = {"",     "error", "over_budget", "unsaved",
                                 "help", "path",  "recovery",    "desktop_dialog"};
  static_assert(kNames.size() == std::variant_size_v<ui::Modal>);
  return kNames.at(modal.index());
}

Json refined_json(const Session& session) {
  const JobResult* result = session.refinement().refined();
  if (result == nullptr) {
    return nullptr;
  }
  const Refinement* refinement = result->refinement.get();
  return {{"faces", result->mesh->face_count()},
          {"vertices", result->mesh->vertex_count()},
          {"watertight", refinement == nullptr || refinement->cracks.is_watertight()}};
}

/// The vertices of the edge under the cursor.
Json hover_edge_json(const Session& session) {
  if (!session.hover_edge()) {
    return nullptr;
  }
  const auto& ends = session.document().control->topology().edge_vertices[*session.hover_edge()];
  return {ends[0], ends[1]};
}

const char* tool_name(ui::Tool tool) {
  constexpr std::array kNames{"paint",     "lower", "pick",       "orbit",     "split edge",
                              "flip edge", "fill",  "smart fill", "rectangle", "lasso"};
  return kNames.at(static_cast<std::size_t>(tool));
}

/// What a click would change, and what that would add to the refined mesh.
Json forecast_json(const Session& session) {
  const auto forecast = session.forecast();
  return forecast ? Json{{"faces", forecast->faces}, {"added", forecast->added_faces}}
                  : Json(nullptr);
}

Json matrix_json(const glm::dmat4& matrix) {
  Json rows = Json::array();
  for (int row = 0; row < 4; ++row) {
    rows.push_back({matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row]});
  }
  return rows;
}

}  // namespace

Result<void> write_status_file(const std::filesystem::path& path, const Status& status) {
  const Session& session = status.session;
  const Document& document = session.document();
  Json toasts = Json::array();
  for (const ui::Toast& toast : session.toasts()) {
    toasts.push_back(toast.text);
  }
  Json items = Json::object();
  for (const ui::ItemRect& item : status.items) {
    items[item.name] = rect_json(item.rect);
  }
  const ViewState& view = session.view();
  const Json json = {
      {"title", session.title()},
      {"window", {status.window.width, status.window.height}},
      {"framebuffer", {status.framebuffer.width, status.framebuffer.height}},
      {"viewport", rect_json(status.place.rect)},
      {"view_projection", matrix_json(status.camera.view_projection)},
      {"view",
       {{"target", {view.target.x, view.target.y, view.target.z}},
        {"yaw", view.yaw},
        {"pitch", view.pitch},
        {"distance", view.distance},
        {"orthographic", view.orthographic}}},
      {"control_faces", document.control->face_count()},
      {"crease_edges", session.model().statistics.crease_edges},
      {"depths",
       std::vector<int>(document.depths.values().begin(), document.depths.values().end())},
      {"demands", document.demands.size()},
      {"steps",
       {{"shown", session.steps().is_shown()},
        {"position", session.steps().position()},
        {"size", session.steps().size()}}},
      {"split", session.is_split()},
      {"stage", {{"legalised", document.stage.is_legalised}, {"levels", document.stage.levels}}},
      {"scheme", document.scheme ? Json(ui::scheme_word(*document.scheme)) : Json(nullptr)},
      {"control_vertices", document.control->vertex_count()},
      {"undo", session.history().undo_name()},
      {"redo", session.history().redo_name()},
      {"modified", session.history().is_modified()},
      {"busy", session.is_busy() || !session.refinement().is_up_to_date()},
      {"refined", refined_json(session)},
      {"hover", session.hover() ? Json(*session.hover()) : Json(nullptr)},
      {"hover_edge", hover_edge_json(session)},
      {"dihedral_threshold", session.dihedral_threshold()},
      {"brush_radius", session.brush().radius},
      {"fill_angle", session.brush().fill_angle},
      {"tool", tool_name(session.brush().tool)},
      {"through", session.brush().goes_through},
      {"fine", session.brush().is_fine},
      {"mirror", to_string(session.brush().mirror)},
      {"shift_draws_lines", session.brush().shift_draws_lines},
      {"forecast", forecast_json(session)},
      {"hints", session.shows_hints()},
      {"copy", {{"when", session.copies().when}, {"problem", session.copies().problem}}},
      {"modal", modal_name(session.modal())},
      {"toasts", toasts},
      {"items", items},
  };
  const std::string text = json.dump(1, ' ', false, Json::error_handler_t::replace);
  return write_file_atomically(path, [&](std::ostream& out) { out << text << '\n'; });
}

}  // namespace limn::app
