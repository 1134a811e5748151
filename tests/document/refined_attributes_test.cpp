// What a refined mesh carries on: written, read back and applied, and subdivided further.
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "limn/document/refinement.h"
#include "limn/mesh/export.h"
#include "limn/mesh/import.h"
#include "support/attribute_shapes.h"

namespace limn {
namespace {

using Depths = std::vector<std::uint8_t>;

RefinedMesh refined(const ControlMesh& mesh, const Depths& depths,
                    const SubdivisionSettings& settings = {}) {
  IgnoreProgress progress;
  const DerivedLabels labels = derive_labels(mesh, depths, settings, progress).value();
  return *derive_refinement(mesh, labels, {settings}, progress).value().mesh;
}

/// The control mesh of the written text, as another program would read it.
ImportedMesh read_back(const RefinedMesh& mesh) {
  std::ostringstream text;
  write_mesh(text, MeshFormat::kObj, mesh);
  auto imported = import_obj(text.str(), "written");
  EXPECT_TRUE(imported.has_value()) << to_string(imported.error());
  return imported.value_or(ImportedMesh{});
}

std::vector<test::NamedShape> shapes() {
  std::vector<test::NamedShape> all = test::creased_shapes();
  std::ranges::move(test::textured_shapes(), std::back_inserter(all));
  return all;
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::map<Edge, float> creases_of(const RefinedMesh& mesh) {
  std::map<Edge, float> creases;
  for (const RefinedCrease& crease : mesh.creases) {
    creases[std::minmax(crease.vertices[0], crease.vertices[1])] = crease.sharpness;
  }
  return creases;
}

std::map<Edge, float> creases_in(const ControlMesh& mesh) {
  std::map<Edge, float> creases;
  for (std::size_t e = 0; e < mesh.creases().edge_sharpness.size(); ++e) {
    const auto [a, b] = mesh.topology().edge_vertices[e];
    if (mesh.creases().edge_sharpness[e] > 0.0f) {
      creases[std::minmax(a, b)] = mesh.creases().edge_sharpness[e];
    }
  }
  return creases;
}

TEST(RefinedAttributes, ComeBackFromWhatIsWritten) {
  test::Random random(3);
  std::size_t creases = 0;
  std::size_t points = 0;
  for (const auto& [name, mesh] : shapes()) {
    SCOPED_TRACE(name);
    const RefinedMesh adaptive = refined(*mesh, test::random_depths(*mesh, 0.4, 3, random));
    const ImportedMesh again = read_back(adaptive);
    ASSERT_NE(again.mesh, nullptr);
    EXPECT_FALSE(again.report.is_mended());
    EXPECT_EQ(creases_in(*again.mesh), creases_of(adaptive));
    EXPECT_EQ(again.mesh->creases().method, mesh->creases().method);
    EXPECT_EQ(again.mesh->attributes().corners.has_value(), !mesh->is_closed());
    ASSERT_EQ(again.mesh->texture().empty(), adaptive.uvs.empty());
    creases += adaptive.creases.size();
    points += adaptive.uvs.size();

    // Apply gives what would be read, but for rounding to decimals.
    const auto applied = to_control_mesh(adaptive);
    EXPECT_EQ(applied->creases(), again.mesh->creases());
    EXPECT_EQ(applied->attributes().corners, again.mesh->attributes().corners);
    EXPECT_EQ(applied->topology().corner_vertices, again.mesh->topology().corner_vertices);
    EXPECT_EQ(applied->texture().corner_values.size(), again.mesh->texture().corner_values.size());
    for (std::size_t c = 0; c < applied->texture().corner_values.size(); ++c) {
      const glm::dvec2 a = applied->texture().values[applied->texture().corner_values[c]];
      const glm::dvec2 b = again.mesh->texture().values[again.mesh->texture().corner_values[c]];
      ASSERT_EQ(glm::vec2(a), glm::vec2(b));
    }
  }
  EXPECT_GT(creases, 100U);
  EXPECT_GT(points, 500U);
}

/// The largest distance of a point of `a` from the nearest of `b`.
double farthest(const RefinedMesh& a, const RefinedMesh& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.vertex_count(); ++i) {
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t j = 0; j < b.vertex_count(); ++j) {
      nearest = std::min(nearest, glm::distance(a.position(i), b.position(j)));
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

// The remaining sharpness, the boundary rule and the creasing method are what is needed to go on:
// one level, written and read, and another one give two levels.
TEST(RefinedAttributes, SubdividingWhatWasWrittenGoesOnWhereItStopped) {
  for (const CornerRule corners : {CornerRule::kSharp, CornerRule::kSmooth}) {
    SubdivisionSettings settings;
    settings.corners = corners;
    for (const auto& [name, mesh] : shapes()) {
      SCOPED_TRACE(name);
      const RefinedMesh two = refined(*mesh, Depths(mesh->face_count(), 2), settings);
      const RefinedMesh one = refined(*mesh, Depths(mesh->face_count(), 1), settings);
      const ImportedMesh again = read_back(one);
      ASSERT_NE(again.mesh, nullptr);
      SubdivisionSettings rest;
      rest.corners = again.mesh->attributes().corners.value_or(rest.corners);
      const RefinedMesh further = refined(*again.mesh, Depths(again.mesh->face_count(), 1), rest);
      ASSERT_EQ(further.face_count(), two.face_count());
      ASSERT_EQ(further.vertex_count(), two.vertex_count());
      EXPECT_LT(farthest(further, two), 2e-6 * mesh->bounds().diagonal());
      EXPECT_EQ(further.uvs.size(), two.uvs.size());
      EXPECT_EQ(further.creases.size(), two.creases.size());
    }
  }
}

}  // namespace
}  // namespace limn
