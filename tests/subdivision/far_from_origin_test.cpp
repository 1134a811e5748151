// Refined positions are single precision, yet a mesh is as exact a million of its sizes away from
// the world's origin as at it; and where it lies near, its numbers are the world's own.
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "exactness_check.h"
#include "limn/mesh/export.h"
#include "limn/mesh/import.h"
#include "support/shapes.h"

namespace limn {
namespace {

using test::MeshPointer;

/// Coordinates of few enough bits that moving the mesh by `offset` rounds none of them.
PolygonSoup lumpy_cube_soup() {
  PolygonSoup soup = test::cube_soup();
  for (std::size_t v = 0; v < soup.positions.size(); ++v) {
    const auto i = static_cast<double>(v);
    soup.positions[v] += glm::dvec3(i * i, 3.0 * i, 7.0 - i) / 64.0;
  }
  return soup;
}

MeshPointer moved(PolygonSoup soup, const glm::dvec3& offset) {
  for (glm::dvec3& position : soup.positions) {
    position += offset;
  }
  return test::control_mesh(soup);
}

/// So many diagonals of the mesh away, in whole units.
glm::dvec3 offset_of(const PolygonSoup& soup, double diagonals) {
  const double distance = diagonals * test::control_mesh(soup)->bounds().diagonal();
  return glm::round(distance * glm::normalize(glm::dvec3(0.9, -1.0, 0.05)));
}

VertexLabels labels_of(const ControlMesh& mesh, std::uint8_t depth) {
  std::vector<std::uint8_t> depths(mesh.face_count(), 0);
  depths[0] = depth;
  IgnoreProgress progress;
  return legal_labels(mesh, depths, {}, progress).value().labels;
}

RefinedMesh refined_evenly(const ControlMesh& mesh, std::uint8_t depth) {
  IgnoreProgress progress;
  return refine(mesh, labels_of(mesh, depth), {}, {}, progress).value();
}

std::string obj_text(const RefinedMesh& mesh) {
  std::ostringstream out;
  write_mesh(out, MeshFormat::kObj, mesh);
  return out.str();
}

/// FNV-1a, 64 bits.
std::uint64_t hash_of(const std::string& text) {
  std::uint64_t hash = 0xCBF29CE484222325u;
  for (const char c : text) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
  }
  return hash;
}

TEST(FarFromTheOrigin, RefinementsAreAsExactAsNearIt) {
  const PolygonSoup soup = lumpy_cube_soup();
  for (const double diagonals : {0.0, 1.0, 4.0, 4.4, 4.6, 5.0, 6.0, 50.0, 1e3, 1e5, 1e7}) {
    SCOPED_TRACE(fmt::format("{} diagonals away", diagonals));
    const MeshPointer mesh = moved(soup, offset_of(soup, diagonals));
    const test::UniformReference reference(*mesh, 5, CornerRule::kSharp);
    const auto exactness = reference.compare(labels_of(*mesh, 5), {}, kAllLevels);
    EXPECT_EQ(exactness.difference, "");
    EXPECT_EQ(exactness.off, 0u);
    EXPECT_LT(exactness.greatest_deviation, 3e-7);
  }
}

TEST(FarFromTheOrigin, WrittenMeshesComeBackExact) {
  const PolygonSoup soup = lumpy_cube_soup();
  const MeshPointer near = moved(soup, glm::dvec3(0.0));
  const RefinedMesh expected = refined_evenly(*near, 3);
  for (const double diagonals : {1.0, 1e3, 1e5, 1e7}) {
    SCOPED_TRACE(fmt::format("{} diagonals away", diagonals));
    const glm::dvec3 offset = offset_of(soup, diagonals);
    const RefinedMesh far = refined_evenly(*moved(soup, offset), 3);
    const auto read = import_obj(obj_text(far), "written");
    ASSERT_TRUE(read) << to_string(read.error());
    ASSERT_EQ(read->mesh->vertex_count(), expected.vertex_count());
    for (std::size_t v = 0; v < expected.vertex_count(); ++v) {
      const glm::dvec3 here = read->mesh->positions()[v] - offset;
      ASSERT_LT(glm::distance(here, expected.position(v)), 1e-6 * near->bounds().diagonal())
          << "vertex " << v;
    }
  }
}

TEST(NearTheOrigin, WrittenNumbersAreThoseOfTheFloats) {
  // The order of vertices and faces decides the text, so the cube stands here.
  const auto cube = test::control_mesh(
      {{-1, -1, -1},
       {1, -1, -1},
       {-1, 1, -1},
       {1, 1, -1},
       {-1, -1, 1},
       {1, -1, 1},
       {-1, 1, 1},
       {1, 1, 1}},
      {{4, 5, 7, 6}, {0, 2, 3, 1}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
  const std::string text = obj_text(refined_evenly(*cube, 2));
  EXPECT_TRUE(
      text.starts_with("v -0.5555556 -0.5555556 -0.5555556\n"
                       "v 0.5555556 -0.5555556 -0.5555556\n"
                       "v -0.5555556 0.5555556 -0.5555556\n"
                       "v 0.5555556 0.5555556 -0.5555556\n"
                       "v -0.5092593 -0.5092593 0.5092593\n"
                       "v 0.5092593 -0.5092593 0.5092593\n"
                       "v -0.5092593 0.5092593 0.5092593\n"
                       "v 0.5092593 0.5092593 0.5092593\n"
                       "v -0.30208334 -0.5989583 0.5989583\n"))
      << text;
  EXPECT_EQ(hash_of(text), 0xCFB61F5F7B4B95DCu) << text;  // Every number to the last digit.
}

}  // namespace
}  // namespace limn
