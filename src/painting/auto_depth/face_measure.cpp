#include "limn/painting/auto_depth/face_measure.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <glm/geometric.hpp>

#include "limn/contract.h"
#include "limn/painting/auto_depth/screen_size.h"
#include "limn/painting/selection.h"
#include "limn/subdivision/face_errors.h"

namespace limn {
namespace {

constexpr std::array<FaceMeasureInfo, 5> kMeasures{
    {{FaceMeasure::kCurvature, "curvature", "Curvature", "deg", false,
      "By how much the limit surface turns within the face."},
     {FaceMeasure::kDihedral, "dihedral", "Dihedral angle", "deg", false,
      "The greatest angle to a neighbour of the control mesh."},
     {FaceMeasure::kDistance, "distance", "Distance to the limit", "d", false,
      "From the unrefined face to the limit surface, in diagonals of the mesh."},
     {FaceMeasure::kEdge, "edge", "Longest side", "d", false,
      "Of the control mesh's face, in diagonals of the mesh."},
     {FaceMeasure::kScreen, "screen", "Size on the screen", "px", true,
      "The longest side as seen by the camera, in pixels; 0 where the face does not show."}}};

template <class T>
std::vector<double> to_doubles(const std::vector<T>& values, double factor = 1.0) {
  std::vector<double> doubles(values.size());
  std::ranges::transform(values, doubles.begin(),
                         [factor](T value) { return factor * static_cast<double>(value); });
  return doubles;
}

Result<std::vector<double>> unrefined_distances(const ControlMesh& mesh,
                                                const SubdivisionSettings& settings,
                                                Progress& progress) {
  FaceErrorOptions options;
  options.corners = settings.corners;
  options.points = settings.points;
  options.deepest = 1;
  return face_errors(mesh, options, progress).map([&](const std::vector<LevelErrors>& errors) {
    std::vector<double> distances(errors.size());
    std::ranges::transform(errors, distances.begin(), [&](const LevelErrors& of_face) {
      return of_face[0] / mesh.bounds().diagonal();
    });
    return distances;
  });
}

std::vector<double> longest_sides(const ControlMesh& mesh) {
  std::vector<double> sides(mesh.face_count(), 0.0);
  for (std::size_t f = 0; f < sides.size(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      sides[f] = std::max(sides[f],
                          glm::distance(mesh.positions()[face[i]],
                                        mesh.positions()[face[i + 1 == face.size() ? 0 : i + 1]]));
    }
    sides[f] /= mesh.bounds().diagonal();
  }
  return sides;
}

}  // namespace

std::span<const FaceMeasureInfo> face_measures() noexcept {
  return kMeasures;
}

const FaceMeasureInfo& info(FaceMeasure measure) noexcept {
  return kMeasures[static_cast<std::size_t>(measure)];
}

Result<std::vector<double>> measure_faces(const ControlMesh& mesh,
                                          const SubdivisionSettings& settings, FaceMeasure measure,
                                          std::span<const ScreenView> views, Progress& progress) {
  switch (measure) {
    case FaceMeasure::kCurvature:
      return face_bends(mesh, settings.corners, progress).map([](const std::vector<float>& bends) {
        return to_doubles(bends);
      });
    case FaceMeasure::kDihedral:
      return face_dihedral_angles(mesh);
    case FaceMeasure::kDistance:
      return unrefined_distances(mesh, settings, progress);
    case FaceMeasure::kEdge:
      return longest_sides(mesh);
    case FaceMeasure::kScreen:
      return screen_sizes(mesh, settings.corners, ScreenSize::Of::kEdge, views, progress);
  }
  LIMN_EXPECTS(!"a known measure");
  return {};
}

}  // namespace limn
