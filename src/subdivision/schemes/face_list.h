#pragma once

#include <cstdint>
#include <utility>

#include "subdivision/schemes/level_mesh.h"

// Internal to this folder.
namespace limn {

/// Faces written one corner after the other.
class FaceList {
 public:
  void reserve(std::size_t faces, std::size_t corners) {
    faces_.starts.reserve(faces + 1);
    faces_.control_faces.reserve(faces);
    faces_.corners.reserve(corners);
    faces_.starts.push_back(0);
  }
  void add_corner(std::uint32_t vertex) { faces_.corners.push_back(vertex); }
  /// Ends the face whose corners were added, in a control face. With fewer than three it is left
  /// out.
  void end_face(std::uint32_t control_face) {
    const auto end = static_cast<std::uint32_t>(faces_.corners.size());
    const std::uint32_t start = faces_.starts.back();
    if (end - start < 3) {
      faces_.corners.resize(start);
      return;
    }
    faces_.starts.push_back(end);
    faces_.control_faces.push_back(control_face);
  }
  [[nodiscard]] LevelFaces take() { return std::move(faces_); }

 private:
  LevelFaces faces_;
};

}  // namespace limn
