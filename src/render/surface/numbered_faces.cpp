// Two passes over the faces: where the middle of each control face's part is, and who is nearest.
#include "render/surface/numbered_faces.h"

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace limn::render {
namespace {

static_assert(sizeof(NumberedFace) == 8);

/// Calls `visit(face, middle)` for every drawn face.
template <class Visit>
void for_each_middle(const Surface& surface, const Visit& visit) {
  for (const SurfaceGroup& group : surface.groups) {
    for (std::uint32_t f = 0; f < group.face_count; ++f) {
      const std::uint32_t* corners = &surface.corners[group.first_corner + f * group.sides];
      glm::vec3 sum(0.0F);
      for (std::uint32_t i = 0; i < group.sides; ++i) {
        sum += surface.positions[corners[i]];
      }
      visit(group.first_face + f, sum / static_cast<float>(group.sides));
    }
  }
}

}  // namespace

std::vector<NumberedFace> middle_faces(const Surface& surface) {
  struct Part {
    glm::vec3 sum{0.0F};
    std::uint32_t count = 0;
    float nearest = std::numeric_limits<float>::infinity();
    std::uint32_t face = 0;
  };
  std::vector<Part> parts(surface.control_face_count);
  for_each_middle(surface, [&](std::uint32_t face, const glm::vec3& middle) {
    Part& part = parts[surface.face_control_faces[face]];
    part.sum += middle;
    ++part.count;
  });
  for_each_middle(surface, [&](std::uint32_t face, const glm::vec3& middle) {
    Part& part = parts[surface.face_control_faces[face]];
    const float distance = glm::distance(middle, part.sum / static_cast<float>(part.count));
    if (distance < part.nearest) {
      part.nearest = distance;
      part.face = face;
    }
  });
  std::vector<NumberedFace> faces;
  faces.reserve(parts.size());
  for (const Part& part : parts) {
    if (part.count > 0) {
      faces.push_back({part.face, std::sqrt(static_cast<float>(part.count))});
    }
  }
  return faces;
}

NumberedFaces::NumberedFaces() : records_(gl::Buffer::create("numbered faces")) {}

void NumberedFaces::upload(std::span<const NumberedFace> faces) {
  records_.upload(faces);
  count_ = faces.size();
}

}  // namespace limn::render
