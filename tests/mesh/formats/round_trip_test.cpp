// What is written is read again, and has to be what it was as far as the format holds it.
#include <cstdint>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/mesh/export.h"
#include "limn/mesh/import.h"
#include "limn/mesh/triangulate.h"
#include "support/attribute_shapes.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/mesh_difference.h"
#include "support/scratch_folder.h"

namespace limn {
namespace {

using test::difference;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

template <class Mesh>
std::string bytes_of(MeshFormat format, const Mesh& mesh, const ExportSettings& settings = {}) {
  std::ostringstream out;
  write_mesh(out, format, mesh, settings);
  return out.str();
}

ImportedMesh read(const std::string& bytes, MeshFormat format) {
  auto imported = import_bytes(bytes, format, "written");
  EXPECT_TRUE(imported.has_value()) << to_string(imported.error());
  return imported ? *imported : ImportedMesh{};
}

std::vector<std::uint8_t> some_depths(const ControlMesh& mesh) {
  std::vector<std::uint8_t> depths(mesh.face_count());
  for (std::size_t f = 0; f < depths.size(); ++f) {
    depths[f] = static_cast<std::uint8_t>(f / 3 % 4);
  }
  return depths;
}

bool is_lost(MeshFormat format, const ControlMesh& mesh, const std::string& what) {
  return testing::Value(lost_in(format, mesh), testing::Contains(HasSubstr(what)));
}

/// Through OBJ and both kinds of PLY everything comes back, names but for PLY.
void expect_whole(const ControlMesh& mesh) {
  const std::vector<std::uint8_t> depths = some_depths(mesh);
  for (const MeshFormat format : {MeshFormat::kObj, MeshFormat::kPly}) {
    for (const bool is_text : {true, false}) {
      ExportSettings settings{.depths = depths};
      settings.is_text = is_text;
      const std::string bytes = bytes_of(format, mesh, settings);
      const ImportedMesh again = read(bytes, format);
      ASSERT_NE(again.mesh, nullptr);
      const bool loses_seams = is_lost(format, mesh, "seams");
      EXPECT_EQ(
          difference(mesh, *again.mesh, {.uvs = !loses_seams, .names = format == MeshFormat::kObj}),
          "")
          << name_of(format) << is_text;
      EXPECT_THAT(again.depths, testing::ElementsAreArray(depths)) << name_of(format);
      EXPECT_THAT(again.report.unused_data, IsEmpty());
      if (format == MeshFormat::kObj) {
        EXPECT_EQ(bytes_of(format, *again.mesh, settings), bytes);
      }
    }
  }
}

void expect_surface_through_off(const ControlMesh& mesh) {
  const ImportedMesh again = read(bytes_of(MeshFormat::kOff, mesh), MeshFormat::kOff);
  ASSERT_NE(again.mesh, nullptr);
  const bool loses_uvs = is_lost(MeshFormat::kOff, mesh, "texture");
  EXPECT_EQ(difference(mesh, *again.mesh, {.sharpness = false, .uvs = !loses_uvs, .names = false}),
            "");
}

/// The positions of all triangles, corner by corner, in single precision.
std::vector<glm::vec3> triangles_of(const ControlMesh& mesh) {
  std::vector<glm::vec3> corners;
  for (const std::uint32_t v : mesh.topology().corner_vertices) {
    corners.emplace_back(mesh.positions()[v]);
  }
  return corners;
}

void expect_triangles_through_stl(const ControlMesh& mesh) {
  const auto triangles = triangulated(mesh);
  const auto soup = read_soup(bytes_of(MeshFormat::kStl, mesh), MeshFormat::kStl, "written");
  ASSERT_TRUE(soup.has_value());
  std::vector<glm::vec3> corners;
  for (const std::uint32_t v : soup->face_vertices) {
    corners.emplace_back(soup->positions[v]);
  }
  EXPECT_EQ(corners, triangles_of(*triangles));
  EXPECT_THAT(soup->unused_data.size(), testing::Le(1U));
}

TEST(RoundTrip, ShapesWithAttributes) {
  for (const auto& shapes : {test::creased_shapes(), test::textured_shapes()}) {
    for (const auto& [name, mesh] : shapes) {
      SCOPED_TRACE(name);
      expect_whole(*mesh);
      expect_surface_through_off(*mesh);
      expect_triangles_through_stl(*mesh);
    }
  }
}

// A quarter of the corpus in a sanitized build: all of it comes by in scripts/trust.sh.
TEST(RoundTrip, NamesOfOddBytes) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl a\x01\x04 \xff\x7f b#\nf 1 2 3\n";
  const ImportedMesh once = read(text, MeshFormat::kObj);
  EXPECT_THAT(once.mesh->attributes().names.materials.names, ElementsAre("a\x01\x04 \xff\x7f b#"));
  const ImportedMesh again = read(bytes_of(MeshFormat::kObj, *once.mesh), MeshFormat::kObj);
  EXPECT_EQ(again.mesh->attributes().names, once.mesh->attributes().names);
}

TEST(RoundTrip, NamesThatEndWithABackslash) {
  const std::string text = "mtllib a\\\\ #\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl a b\\ #\nf 1 2 3\n";
  const ImportedMesh once = read(text, MeshFormat::kObj);
  EXPECT_THAT(once.mesh->attributes().names.materials.names, ElementsAre("a b\\"));
  const ImportedMesh again = read(bytes_of(MeshFormat::kObj, *once.mesh), MeshFormat::kObj);
  EXPECT_EQ(again.mesh->attributes().names, once.mesh->attributes().names);
}

TEST(RoundTrip, EveryMeshOfTheCorpus) {
  if (!test::corpus_folder()) {
    GTEST_SKIP() << "no corpus of meshes: set LIMN_CORPUS or put one at ../shared/corpus";
  }
  std::size_t number = 0;
  std::size_t meshes = 0;
  const auto step = static_cast<std::size_t>(1.0 / test::effort());
  for (const std::string ending : {".obj", ".ply", ".off", ".stl"}) {
    for (const auto& path : test::corpus_files(ending)) {
      const auto imported = number++ % step == 0
                                ? import_mesh(path)
                                : Result<ImportedMesh>(fail(ErrorKind::kCancelled, "left out"));
      if (imported) {
        SCOPED_TRACE(path.string());
        expect_whole(*imported->mesh);
        expect_surface_through_off(*imported->mesh);
        expect_triangles_through_stl(*imported->mesh);
        ++meshes;
      }
    }
  }
  EXPECT_GT(meshes, 190 / step);
}

}  // namespace
}  // namespace limn
