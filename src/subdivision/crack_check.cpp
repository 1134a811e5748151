// Nearly all edges are settled by one of their ends (closed_stars.cpp); the sides that are left,
// along the rims of what is looked at together and along boundaries and cracks, are matched one by
// one (side_matching.cpp). Sides without a partner belong to a control boundary edge
// (boundary_paths.cpp), or they are a crack.
#include "limn/subdivision/crack_check.h"

#include <algorithm>
#include <atomic>
#include <span>
#include <string_view>

#include "limn/contract.h"
#include "subdivision/boundary_paths.h"
#include "subdivision/closed_stars.h"
#include "subdivision/side_matching.h"

namespace limn {

struct CrackChecker::Workspace {
  ClosedStars stars;
  SideMatching sides;
  BoundaryPaths paths;
  std::vector<std::uint8_t> is_covered;

  [[nodiscard]] std::size_t missing_control_faces(const ControlMesh& control,
                                                  const RefinedMesh& refined);
};

CrackChecker::CrackChecker() : workspace_(std::make_unique<Workspace>()) {}
CrackChecker::~CrackChecker() = default;
CrackChecker::CrackChecker(CrackChecker&&) noexcept = default;
CrackChecker& CrackChecker::operator=(CrackChecker&&) noexcept = default;

std::size_t CrackChecker::Workspace::missing_control_faces(const ControlMesh& control,
                                                           const RefinedMesh& refined) {
  is_covered.assign(control.face_count(), 0);
  const Lanes lanes(refined.face_count());
  lanes.each([&](std::size_t lane) {
    const std::size_t first_face = lanes.begin(lane);
    const std::size_t size = lanes.end(lane) - first_face;
    std::uint32_t last = kNone;
    for (const std::uint32_t face :
         std::span(refined.face_control_faces).subspan(first_face, size)) {
      if (face != last) {
        LIMN_EXPECTS(face < is_covered.size());
        std::atomic_ref(is_covered[face]).store(1, std::memory_order_relaxed);
        last = face;
      }
    }
  });
  return static_cast<std::size_t>(std::ranges::count(is_covered, std::uint8_t{0}));
}

void CrackChecker::check(const ControlMesh& control, const RefinedMesh& refined,
                         CrackCheck& result) {
  IgnoreProgress progress;
  (void)check(control, refined, result, progress);
}

bool CrackChecker::check(const ControlMesh& control, const RefinedMesh& refined, CrackCheck& result,
                         Progress& progress) {
  constexpr std::string_view stage = "Checking for cracks";
  Workspace& work = *workspace_;
  result.crack_faces.clear();
  result.missing_control_faces = work.missing_control_faces(control, refined);
  if (!progress.report(0.2, stage)) {
    return false;
  }
  work.stars.find(refined, control.vertex_count());
  result.unused_vertices = work.stars.unused_vertices();
  if (!progress.report(0.6, stage)) {
    return false;
  }
  work.sides.match(refined, work.stars.settled());
  if (!progress.report(0.9, stage)) {
    return false;
  }
  result.nonmanifold_edges = work.sides.nonmanifold_edges();

  const std::span<const Side> singles = work.sides.single_sides();
  work.paths.find(control, refined, singles);
  const std::span<const std::uint8_t> is_on_path = work.paths.is_on_path();
  result.boundary_edges = singles.size();
  result.control_boundary_edges =
      static_cast<std::size_t>(std::ranges::count(is_on_path, std::uint8_t{1}));
  for (std::size_t i = 0; i < singles.size(); ++i) {
    if (is_on_path[i] == 0) {
      result.crack_faces.push_back(singles[i].face);
    }
  }
  std::vector<std::uint32_t>& faces = result.crack_faces;
  std::ranges::sort(faces);
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return true;
}

CrackCheck check_cracks(const ControlMesh& control, const RefinedMesh& refined) {
  CrackCheck check;
  CrackChecker().check(control, refined, check);
  return check;
}

}  // namespace limn
