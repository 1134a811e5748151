#include "app/paint_tools/shown_faces.h"

#include <algorithm>
#include <iterator>

#include "app/refinement_job.h"
#include "limn/subdivision/fine_places.h"

namespace limn::app {
namespace {

RefinedFrom source_of(const JobResult& result) {
  return {result.control.get(), &result.labels->legal.labels, result.labels->fine.get(),
          result.prediction.levels};
}

/// Whether one lies in the other or is it.
bool overlap(const FineFace& a, const FineFace& b) {
  const FineFace& coarse = a.level <= b.level ? a : b;
  const FineFace& fine = a.level <= b.level ? b : a;
  const int levels = fine.level - coarse.level;
  return coarse.level == 0 ||
         (coarse.corner == fine.corner && fine.column >> levels == coarse.column &&
          fine.row >> levels == coarse.row);
}

}  // namespace

bool has_fine_faces(const JobResult& result) noexcept {
  return result.refinement != nullptr && result.labels->face_depths.empty();
}

std::vector<FineFace> names_of(const ShownFaces& shown) {
  if (shown.refined != nullptr) {
    return places_of(source_of(*shown.refined), *shown.refined->mesh, shown.faces);
  }
  std::vector<FineFace> names;
  names.reserve(shown.faces.size());
  for (const std::uint32_t face : shown.faces) {
    names.push_back({face, 0, 0, 0, 0});
  }
  return names;
}

std::vector<std::uint32_t> faces_named(const JobResult& refined, std::span<const FineFace> names) {
  std::vector<FineFace> wanted(names.begin(), names.end());
  std::ranges::sort(wanted, {}, &FineFace::control_face);
  const RefinedMesh& mesh = *refined.mesh;
  const auto quads = std::span(mesh.face_control_faces).first(mesh.quads.size());
  const auto polygons = std::span(mesh.face_control_faces).subspan(mesh.quads.size());
  std::vector<std::uint32_t> found;
  std::vector<std::uint32_t> within;
  for (auto name = wanted.begin(); name != wanted.end();) {
    const std::uint32_t control_face = name->control_face;
    const auto end = std::find_if(
        name, wanted.end(), [&](const FineFace& one) { return one.control_face != control_face; });
    const auto [begin, last] = std::equal_range(quads.begin(), quads.end(), control_face);
    within.clear();
    for (auto at = begin; at != last; ++at) {
      within.push_back(static_cast<std::uint32_t>(at - quads.begin()));
    }
    const std::vector<FineFace> places = places_of(source_of(refined), mesh, within);
    for (std::size_t i = 0; i < within.size(); ++i) {
      if (std::any_of(name, end, [&](const FineFace& one) { return overlap(one, places[i]); })) {
        found.push_back(within[i]);
      }
    }
    if (begin == last) {
      const auto whole = std::ranges::lower_bound(polygons, control_face);
      if (whole != polygons.end() && *whole == control_face) {
        found.push_back(static_cast<std::uint32_t>(quads.size()) +
                        static_cast<std::uint32_t>(whole - polygons.begin()));
      }
    }
    name = end;
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace limn::app
