#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "limn/mesh/control_mesh.h"
#include "limn/painting/face_depths.h"

namespace limn {

/// Across which planes to mirror: those through the centre of a mesh's bounds, normal to X, Y, Z.
struct MirrorAxes {
  bool x = false;
  bool y = false;
  bool z = false;

  [[nodiscard]] bool any() const noexcept { return x || y || z; }
  [[nodiscard]] bool operator==(const MirrorAxes&) const = default;
};

/// "xz".
[[nodiscard]] std::string to_string(const MirrorAxes& axes);

/// How far, as a part of the bounds' diagonal, a face's centroid may lie from where the mirror puts
/// that of its partner: meshes modelled by hand are symmetric to three digits or so, and the faces
/// of one are seldom that small.
inline constexpr double kMirrorTolerance = 1e-3;

/// For every face the one whose centroid (the mean of its vertices) lies nearest to its own
/// mirrored across all planes of `axes` at once, kNone where none lies within `tolerance`
/// diagonals. A partner has as many sides. Of several equally near the lowest counts. No axis:
/// every face is its own.
[[nodiscard]] std::vector<std::uint32_t> mirror_partners(const ControlMesh& mesh,
                                                         const MirrorAxes& axes,
                                                         double tolerance = kMirrorTolerance);

/// The mirror images of faces under every combination of the axes: one for X alone, three for X and
/// Y, seven for all. Works on any faces of the mesh it was made for, in time proportional to them.
class FaceMirror {
 public:
  FaceMirror() = default;
  FaceMirror(const ControlMesh& mesh, const MirrorAxes& axes, double tolerance = kMirrorTolerance);

  [[nodiscard]] const MirrorAxes& axes() const noexcept { return axes_; }
  /// The faces and their images, each once: `faces` in their order, then what is new.
  [[nodiscard]] std::vector<std::uint32_t> with_images(std::span<const std::uint32_t> faces) const;
  /// Faces without an image under at least one combination of the axes.
  [[nodiscard]] std::size_t lone_faces() const noexcept { return lone_faces_; }
  /// Partner tables, one a combination; empty where no axis is on.
  [[nodiscard]] std::span<const std::vector<std::uint32_t>> partners() const noexcept {
    return partners_;
  }

 private:
  MirrorAxes axes_;
  std::vector<std::vector<std::uint32_t>> partners_;
  std::size_t lone_faces_ = 0;
};

/// The painting made symmetric: each face takes the greatest depth of itself and its images.
[[nodiscard]] FaceDepths mirror_depths(const FaceMirror& mirror, const FaceDepths& depths);

}  // namespace limn
