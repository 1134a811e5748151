// Angles are gathered face by face from Newell normals of unit length; every selection comes out
// ascending and without repeats.
#include "limn/painting/selection.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <variant>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "limn/contract.h"
#include "limn/painting/depth_choice.h"
#include "limn/painting/face_regions.h"

namespace limn {
namespace {

/// Unit normal by Newell's sum, zero where the face has no area. Coordinates are taken relative to
/// the first corner and in units of the face's own size, so that neither a face far from the origin
/// nor a tiny or huge one loses its normal to rounding, underflow or overflow.
glm::dvec3 newell_normal(std::span<const glm::dvec3> positions,
                         std::span<const std::uint32_t> corners) {
  // Halved before subtracting: the difference of two finite numbers may be infinite.
  const glm::dvec3 origin = 0.5 * positions[corners[0]];
  double extent = 0.0;
  for (const std::uint32_t corner : corners) {
    const glm::dvec3 offset = 0.5 * positions[corner] - origin;
    extent = std::max({extent, std::abs(offset.x), std::abs(offset.y), std::abs(offset.z)});
  }
  if (extent == 0.0) {
    return glm::dvec3(0.0);
  }
  glm::dvec3 sum(0.0);
  glm::dvec3 from = (0.5 * positions[corners.back()] - origin) / extent;
  for (const std::uint32_t corner : corners) {
    const glm::dvec3 to = (0.5 * positions[corner] - origin) / extent;
    sum += glm::cross(from, to);
    from = to;
  }
  const double length = glm::length(sum);
  return length > 0.0 ? sum / length : glm::dvec3(0.0);
}

/// By atan2, which keeps its precision near 0 and 180 degrees where acos has none.
double degrees_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * (180.0 / std::numbers::pi);
}

std::vector<std::uint32_t> select_all(const ControlMesh& mesh) {
  std::vector<std::uint32_t> faces(mesh.face_count());
  std::iota(faces.begin(), faces.end(), 0U);
  return faces;
}

template <class IsWanted>
std::vector<std::uint32_t> faces_where(const ControlMesh& mesh, const IsWanted& is_wanted) {
  std::vector<std::uint32_t> faces;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    if (is_wanted(f)) {
      faces.push_back(f);
    }
  }
  return faces;
}

std::vector<std::uint32_t> select_sharper_than(const ControlMesh& mesh, double degrees) {
  const std::vector<double> angles = face_dihedral_angles(mesh);
  return faces_where(mesh, [&](std::size_t f) { return angles[f] > degrees + kDihedralTolerance; });
}

Result<std::vector<std::uint32_t>> select_measured(const ControlMesh& mesh,
                                                   const SelectMeasured& selection,
                                                   const PaintContext& context) {
  std::vector<ScreenView> views;
  if (info(selection.measure).needs_view) {
    auto found = find_views(context, {});
    if (!found) {
      return tl::unexpected(std::move(found.error()));
    }
    views = *std::move(found);
  }
  IgnoreProgress ignore;
  return measure_faces(mesh, context.settings, selection.measure, views,
                       context.progress != nullptr ? *context.progress : ignore)
      .map([&](const std::vector<double>& values) {
        return faces_where(mesh, [&](std::size_t f) {
          return selection.is_above ? values[f] > selection.value : values[f] < selection.value;
        });
      });
}

std::string no_such_face(const ControlMesh& mesh, std::uint32_t face) {
  return fmt::format("There is no face {}: the mesh has {} faces, numbered 0 to {}.", face,
                     mesh.face_count(), mesh.face_count() - 1);
}

Result<std::vector<std::uint32_t>> select_ranges(const ControlMesh& mesh,
                                                 const SelectFaces& selection) {
  for (const SelectFaces::Range& range : selection.ranges) {
    if (range.last >= mesh.face_count()) {
      return fail(ErrorKind::kUsage, no_such_face(mesh, range.last));
    }
    if (range.first > range.last) {
      return fail(ErrorKind::kUsage,
                  fmt::format("The face range {}-{} runs backwards; write {}-{}.", range.first,
                              range.last, range.last, range.first));
    }
  }
  std::vector<SelectFaces::Range> ranges = selection.ranges;
  std::sort(ranges.begin(), ranges.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::uint32_t> faces;
  std::uint32_t next = 0;  // Every face below has been dealt with.
  for (const SelectFaces::Range& range : ranges) {
    for (std::uint32_t f = std::max(next, range.first); f <= range.last; ++f) {
      faces.push_back(f);
    }
    next = std::max(next, range.last + 1);
  }
  return faces;
}

/// Carries out each kind of selection.
struct Select {
  using Faces = Result<std::vector<std::uint32_t>>;

  const ControlMesh& mesh;
  const FaceDepths& depths;
  const PaintContext& context;

  Faces operator()(const SelectAll&) const { return select_all(mesh); }
  Faces operator()(const SelectVisible&) const {
    if (!context.visible) {
      return fail(ErrorKind::kUsage,
                  "\"visible\" needs a camera to see from, and here is none; choose faces by "
                  "\"all\", \"dihedral>DEGREES\" or \"faces=LIST\".");
    }
    return context.visible();
  }
  Faces operator()(const SelectDihedral& dihedral) const {
    return select_sharper_than(mesh, dihedral.degrees);
  }
  Faces operator()(const SelectFaces& faces) const { return select_ranges(mesh, faces); }
  Faces operator()(const SelectFlood& flood) const {
    return from_seed(flood.seed, [&] { return flood_region(mesh, depths.values(), flood.seed); });
  }
  Faces operator()(const SelectSmart& smart) const {
    return from_seed(smart.seed, [&] {
      return smart_region(mesh, edge_dihedral_angles(mesh), smart.seed, smart.degrees);
    });
  }
  Faces operator()(const SelectConnected& connected) const {
    return from_seed(connected.seed, [&] { return connected_region(mesh, connected.seed); });
  }
  Faces operator()(const SelectMeasured& measured) const {
    return select_measured(mesh, measured, context);
  }
  Faces operator()(const SelectPainted& painted) const {
    return faces_where(mesh, [&](std::size_t f) { return (depths[f] > 0) == painted.is_painted; });
  }

  template <class Region>
  [[nodiscard]] Faces from_seed(std::uint32_t seed, Region&& region) const {
    if (seed >= mesh.face_count()) {
      return fail(ErrorKind::kUsage, no_such_face(mesh, seed));
    }
    return region();
  }
};

}  // namespace

std::vector<double> edge_dihedral_angles(const ControlMesh& mesh) {
  std::vector<glm::dvec3> normals(mesh.face_count());
  for (std::size_t f = 0; f < normals.size(); ++f) {
    normals[f] = newell_normal(mesh.positions(), mesh.face(f));
  }
  const FlatTopology& topology = mesh.topology();
  std::vector<double> angles(mesh.edge_count(), 0.0);
  for (std::size_t e = 0; e < angles.size(); ++e) {
    const auto [corner, twin] = topology.edge_corners[e];
    if (twin != kNone) {
      angles[e] = degrees_between(normals[topology.corner_faces[corner]],
                                  normals[topology.corner_faces[twin]]);
    }
  }
  return angles;
}

std::vector<double> face_dihedral_angles(const ControlMesh& mesh) {
  const std::vector<double> edge_angles = edge_dihedral_angles(mesh);
  const FlatTopology& topology = mesh.topology();
  std::vector<double> angles(mesh.face_count(), 0.0);
  for (std::size_t c = 0; c < topology.corner_edges.size(); ++c) {
    double& angle = angles[topology.corner_faces[c]];
    angle = std::max(angle, edge_angles[topology.corner_edges[c]]);
  }
  return angles;
}

Result<std::vector<std::uint32_t>> select_faces(const ControlMesh& mesh, const FaceDepths& depths,
                                                const Selection& selection,
                                                const PaintContext& context) {
  LIMN_EXPECTS(depths.size() == mesh.face_count());
  return std::visit(Select{mesh, depths, context}, selection);
}

}  // namespace limn
