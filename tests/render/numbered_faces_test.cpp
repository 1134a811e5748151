#include "render/surface/numbered_faces.h"

#include <gtest/gtest.h>

#include <set>

#include <glm/geometric.hpp>

#include "limn/subdivision/label_subdivision.h"
#include "support/shapes.h"

namespace limn::render {
namespace {

/// The middle of a drawn face.
glm::vec3 middle_of(const Surface& surface, std::uint32_t face) {
  for (const SurfaceGroup& group : surface.groups) {
    if (face >= group.first_face && face < group.first_face + group.face_count) {
      glm::vec3 sum(0.0F);
      for (std::uint32_t i = 0; i < group.sides; ++i) {
        sum += surface.positions[surface.corners[group.first_corner +
                                                 (face - group.first_face) * group.sides + i]];
      }
      return sum / static_cast<float>(group.sides);
    }
  }
  ADD_FAILURE() << face;
  return {};
}

TEST(NumberedFaces, EachControlFaceHasOneNearItsMiddle) {
  const test::MeshPointer mesh = test::cube();
  IgnoreProgress progress;
  // One face deep, its neighbours as shallow as may be.
  const auto labels =
      legal_labels(*mesh, std::vector<std::uint8_t>{0, 3, 0, 0, 0, 0}, {}, progress);
  ASSERT_TRUE(labels);
  const auto refined = refine(*mesh, labels->labels, {}, {}, progress);
  ASSERT_TRUE(refined);
  const Surface surface = make_surface(*refined, mesh->bounds().centre(), 6);
  const std::vector<NumberedFace> numbered = middle_faces(surface);
  ASSERT_EQ(numbered.size(), 6U);
  std::set<std::uint32_t> control_faces;
  std::vector<float> counts(6, 0.0F);
  for (const std::uint32_t face : surface.face_control_faces) {
    ++counts[face];
  }
  for (const NumberedFace& entry : numbered) {
    const std::uint32_t control_face = surface.face_control_faces[entry.face];
    control_faces.insert(control_face);
    EXPECT_FLOAT_EQ(entry.scale * entry.scale, counts[control_face]);
    // Faces of the cube look along an axis; the middle of a part is within a third of its face.
    const glm::vec3 middle = middle_of(surface, entry.face);
    const glm::vec3 size = glm::abs(middle);
    const int axis = static_cast<int>(control_face / 2);
    EXPECT_GT(size[axis], 0.5F);
    EXPECT_LT(size[(axis + 1) % 3], 0.5F);
    EXPECT_LT(size[(axis + 2) % 3], 0.5F);
  }
  EXPECT_EQ(control_faces.size(), 6U);
}

TEST(NumberedFaces, AControlSurfaceNumbersItself) {
  const Surface surface = make_surface(*test::mixed_prism());
  const std::vector<NumberedFace> numbered = middle_faces(surface);
  EXPECT_EQ(numbered.size(), surface.face_count());
  for (const NumberedFace& entry : numbered) {
    EXPECT_EQ(entry.scale, 1.0F);
  }
}

}  // namespace
}  // namespace limn::render
