#include "limn/document/project_file.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "files/regular_file.h"
#include "limn/contract.h"
#include "limn/files/atomic_file.h"
#include "limn/subdivision/schemes/uniform.h"
#include "view_json.h"

namespace limn {
namespace {

/// Some five million control faces; a file beyond this is no painting.
constexpr std::size_t kMostProjectBytes = std::size_t{1} << 30U;

bool is_finite(const ControlMesh& mesh) {
  const auto is_finite_point = [](const glm::dvec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  };
  return std::ranges::all_of(mesh.positions(), is_finite_point) &&
         std::ranges::all_of(mesh.attributes().loose_vertices, is_finite_point);
}

}  // namespace

Result<void> save_project(const std::filesystem::path& path, const Document& document,
                          const std::optional<ViewState>& view) {
  LIMN_EXPECTS(document.control != nullptr);
  LIMN_EXPECTS(document.depths.size() == document.control->face_count());
  LIMN_EXPECTS(document.stage.levels >= 0 &&
               document.stage.levels <= (document.scheme ? kMostSchemeLevels : kAllLevels));
  if (view) {
    if (std::string fault = fault_of(*view); !fault.empty()) {
      return fail(ErrorKind::kFailed, std::move(fault), path.string());
    }
  }
  if (!is_finite(*document.control) ||
      (document.opened != nullptr && !is_finite(*document.opened))) {
    return fail(ErrorKind::kFailed,
                "The mesh has vertices at infinity, which a project cannot hold.", path.string());
  }
  return write_file_atomically(path,
                               [&](std::ostream& out) { write_project(out, document, view); });
}

Result<Project> load_project(const std::filesystem::path& path) {
  Result<Project> project =
      read_regular_file(path, kMostProjectBytes).and_then([&](const std::string& bytes) {
        return parse_project(bytes, path.string());
      });
  if (project) {
    project->document.project_path = path;
  }
  return project;
}

}  // namespace limn
