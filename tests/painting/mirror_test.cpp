#include "limn/painting/mirror.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "limn/mesh/bundled.h"
#include "support/shapes.h"

namespace limn {
namespace {

using test::MeshPointer;
using ::testing::ElementsAre;
using ::testing::UnorderedElementsAre;

constexpr MirrorAxes kX{.x = true};
constexpr MirrorAxes kXY{.x = true, .y = true};
constexpr MirrorAxes kXYZ{.x = true, .y = true, .z = true};

glm::dvec3 centroid(const ControlMesh& mesh, std::uint32_t face) {
  glm::dvec3 sum(0.0);
  for (const std::uint32_t vertex : mesh.face(face)) {
    sum += mesh.positions()[vertex];
  }
  return sum / static_cast<double>(mesh.face(face).size());
}

/// Every face against every other.
std::vector<std::uint32_t> searched(const ControlMesh& mesh, const MirrorAxes& axes,
                                    double tolerance) {
  const glm::dvec3 centre = mesh.bounds().centre();
  std::vector<std::uint32_t> partners(mesh.face_count(), kNone);
  for (std::uint32_t f = 0; f < partners.size(); ++f) {
    glm::dvec3 image = centroid(mesh, f) - centre;
    image.x *= axes.x ? -1.0 : 1.0;
    image.y *= axes.y ? -1.0 : 1.0;
    image.z *= axes.z ? -1.0 : 1.0;
    double nearest = tolerance * mesh.bounds().diagonal();
    for (std::uint32_t other = 0; other < partners.size(); ++other) {
      const double away = glm::distance(centroid(mesh, other) - centre, image);
      if (away < nearest && mesh.face(other).size() == mesh.face(f).size()) {
        nearest = away;
        partners[f] = other;
      }
    }
  }
  return partners;
}

constexpr std::array<MirrorAxes, 8> kAllAxes{{{},
                                              {true, false, false},
                                              {false, true, false},
                                              {false, false, true},
                                              {true, true, false},
                                              {true, false, true},
                                              {false, true, true},
                                              {true, true, true}}};

TEST(MirrorPartners, AreWhatSearchingAllFacesFinds) {
  test::Random random(17);
  for (int round = 0; round < 4; ++round) {
    auto soup = round % 2 == 0 ? test::torus_soup(12, 8) : test::grid_soup(9, 9);
    soup = test::with_mixed_faces(soup, random);
    // Jitter of the order of the tolerance: some faces find their partner, some do not.
    const MeshPointer mesh = test::control_mesh(test::jittered(soup, 0.02, random));
    for (const MirrorAxes& axes : kAllAxes) {
      for (const double tolerance : {1e-4, 1e-2, 0.2}) {
        EXPECT_EQ(mirror_partners(*mesh, axes, tolerance), searched(*mesh, axes, tolerance))
            << to_string(axes) << ' ' << tolerance;
      }
    }
  }
}

TEST(MirrorPartners, OfACubeAreTheOppositeFaces) {
  EXPECT_THAT(mirror_partners(*test::cube(), kX), ElementsAre(1, 0, 2, 3, 4, 5));
  EXPECT_THAT(mirror_partners(*test::cube(), kXYZ), ElementsAre(1, 0, 3, 2, 5, 4));
  EXPECT_THAT(mirror_partners(*test::cube(), {}), ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(MirrorPartners, DoNotDependOnPlaceOrSize) {
  for (const double scale : {1e-9, 1.0, 1e9}) {
    auto soup = test::cube_soup();
    for (glm::dvec3& position : soup.positions) {
      position = scale * (position + glm::dvec3(100.0, -40.0, 3.0));
    }
    EXPECT_THAT(mirror_partners(*test::control_mesh(soup), kX), ElementsAre(1, 0, 2, 3, 4, 5));
  }
}

TEST(MirrorPartners, OfASymmetricMeshLeadThereAndBack) {
  const MeshPointer mesh = test::control_mesh(test::torus_soup(24, 10));
  for (const MirrorAxes& axes : kAllAxes) {
    const auto partners = mirror_partners(*mesh, axes);
    for (std::uint32_t f = 0; f < partners.size(); ++f) {
      ASSERT_NE(partners[f], kNone) << to_string(axes);
      EXPECT_EQ(partners[partners[f]], f);
    }
  }
}

TEST(FaceMirror, TakesAllImagesOfAllCombinations) {
  const MeshPointer mesh = test::control_mesh(test::torus_soup(24, 10));
  const FaceMirror mirror(*mesh, kXYZ);
  EXPECT_EQ(mirror.lone_faces(), 0U);
  for (std::uint32_t f = 0; f < mesh->face_count(); f += 7) {
    std::vector<std::uint32_t> expected;
    expected.reserve(kAllAxes.size());
    for (const MirrorAxes& axes : kAllAxes) {
      expected.push_back(mirror_partners(*mesh, axes)[f]);
    }
    std::ranges::sort(expected);
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    auto images = mirror.with_images(std::vector{f});
    EXPECT_EQ(images.front(), f) << "the face itself comes first";
    std::ranges::sort(images);
    EXPECT_EQ(images, expected);
  }
}

TEST(FaceMirror, NamesEachFaceOnce) {
  const FaceMirror mirror(*test::cube(), kXY);
  EXPECT_THAT(mirror.with_images(std::vector<std::uint32_t>{0, 1, 4}), ElementsAre(0, 1, 4));
  EXPECT_THAT(mirror.with_images(std::vector<std::uint32_t>{2}), UnorderedElementsAre(2, 3));
  EXPECT_THAT(FaceMirror(*test::cube(), {}).with_images(std::vector<std::uint32_t>{2}),
              ElementsAre(2));
}

TEST(FaceMirror, CountsFacesWithoutAnImage) {
  // Three squares in a row and one more at the right end, further up.
  const MeshPointer mesh =
      test::control_mesh({{0, 0, 0},
                          {1, 0, 0},
                          {2, 0, 0},
                          {3, 0, 0},
                          {0, 1, 0},
                          {1, 1, 0},
                          {2, 1, 0},
                          {3, 1, 0},
                          {2, 2, 0},
                          {3, 2, 0}},
                         {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {6, 7, 9, 8}});
  const FaceMirror mirror(*mesh, kX);
  EXPECT_EQ(mirror.lone_faces(), 1U);
  EXPECT_THAT(mirror.with_images(std::vector<std::uint32_t>{0, 3}), ElementsAre(0, 3, 2));
}

TEST(MirrorDepths, TakesTheGreatestOfAllImages) {
  FaceDepths depths(6);
  depths.set(0, 3);
  depths.set(1, 1);
  depths.set(2, 2);
  const FaceDepths mirrored = mirror_depths(FaceMirror(*test::cube(), kXY), depths);
  EXPECT_THAT(mirrored.values(), ElementsAre(3, 3, 2, 2, 0, 0));
  EXPECT_EQ(mirror_depths(FaceMirror(*test::cube(), kXY), mirrored), mirrored);
}

}  // namespace
}  // namespace limn
