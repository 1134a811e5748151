// Creases, corners and texture coordinates from OBJ text to the control mesh.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/mesh/import.h"
#include "mesh/mesh_checks.h"
#include "support/corpus.h"

namespace limn {
namespace {

using test::faces_of;
using test::import_text;
using test::refusal_of;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

using Edge = std::pair<std::uint32_t, std::uint32_t>;
using Uv = glm::dvec2;

/// A strip of two squares: 4 5 6 over 1 2 3.
const std::string Strip =
    "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nf 1 2 5 4\nf 2 3 6 5\n";

/// The sharp edges by their ends, lower first.
std::map<Edge, float> creases_of(const ControlMesh& mesh) {
  std::map<Edge, float> creases;
  const auto& sharpness = mesh.creases().edge_sharpness;
  for (std::size_t e = 0; e < sharpness.size(); ++e) {
    const auto [a, b] = mesh.topology().edge_vertices[e];
    if (sharpness[e] != 0.0f) {
      creases[std::minmax(a, b)] = sharpness[e];
    }
  }
  return creases;
}

/// The texture points of a face's corners.
std::vector<Uv> uvs_of(const ControlMesh& mesh, std::size_t f) {
  std::vector<Uv> uvs;
  for (std::uint32_t c = mesh.topology().face_offsets[f]; c < mesh.topology().face_offsets[f + 1];
       ++c) {
    uvs.push_back(mesh.texture().values[mesh.texture().corner_values[c]]);
  }
  return uvs;
}

TEST(ImportCreases, NameEdgesByVerticesFromZero) {
  const ImportedMesh imported = import_text(
      Strip + "t crease 2/1/0 1 4 2.5\nt crease 2/1/0 5 2 1e1\nt crease 2/1/0 0 1 .75 # end\n");
  EXPECT_THAT(creases_of(*imported.mesh),
              ElementsAre(std::pair(Edge(0, 1), 0.75f), std::pair(Edge(1, 4), 2.5f),
                          std::pair(Edge(2, 5), 10.0f)));
  EXPECT_THAT(imported.mesh->creases().vertex_sharpness, IsEmpty());
  EXPECT_EQ(imported.mesh->creases().method, CreasingMethod::kUniform);
  EXPECT_FALSE(imported.mesh->attributes().corners.has_value());
  EXPECT_THAT(imported.report.sentences(), IsEmpty());
}

TEST(ImportCreases, TagsMayComeBeforeWhatTheyName) {
  const ImportedMesh imported = import_text("t crease 2/1/0 1 4 2\nt corner 1/1/0 5 3\n" + Strip);
  EXPECT_THAT(creases_of(*imported.mesh), ElementsAre(std::pair(Edge(1, 4), 2.0f)));
  EXPECT_THAT(imported.mesh->creases().vertex_sharpness, ElementsAre(0, 0, 0, 0, 0, 3));
}

TEST(ImportCreases, ChainsWithOneSharpnessOrOneEach) {
  EXPECT_THAT(creases_of(*import_text(Strip + "t crease 4/1/0 0 1 2 5 1.5\n").mesh),
              ElementsAre(std::pair(Edge(0, 1), 1.5f), std::pair(Edge(1, 2), 1.5f),
                          std::pair(Edge(2, 5), 1.5f)));
  EXPECT_THAT(creases_of(*import_text(Strip + "t crease 4/3/0 0 1 2 5 1 2 3\n").mesh),
              ElementsAre(std::pair(Edge(0, 1), 1.0f), std::pair(Edge(1, 2), 2.0f),
                          std::pair(Edge(2, 5), 3.0f)));
  // As many values as pairs: separate edges.
  EXPECT_THAT(creases_of(*import_text(Strip + "t crease 4/2/0 0 1 5 4 1 2\n").mesh),
              ElementsAre(std::pair(Edge(0, 1), 1.0f), std::pair(Edge(4, 5), 2.0f)));
}

TEST(ImportCreases, TheLastTagOfAnEdgeCounts) {
  EXPECT_THAT(creases_of(*import_text(Strip + "t crease 2/1/0 1 4 2\nt crease 2/1/0 4 1 3\n").mesh),
              ElementsAre(std::pair(Edge(1, 4), 3.0f)));
  EXPECT_THAT(import_text(Strip + "t crease 2/1/0 1 4 2\nt crease 2/1/0 4 1 0\n")
                  .mesh->creases()
                  .edge_sharpness,
              IsEmpty());
}

TEST(ImportCreases, CornersOneByOneAndTogether) {
  EXPECT_THAT(
      import_text(Strip + "t corner 1/1/0 0 2.8\nt corner 2/1/0 1 2 1\nt corner 2/2/0 4 5 3 4\n")
          .mesh->creases()
          .vertex_sharpness,
      ElementsAre(2.8f, 1, 1, 0, 3, 4));
}

TEST(ImportCreases, BoundaryRuleAndMethod) {
  const auto sharp =
      import_text(Strip + "t interpolateboundary 1/0/0 1\nt creasemethod 0/0/1 chaikin\n");
  EXPECT_EQ(sharp.mesh->attributes().corners, CornerRule::kSharp);
  EXPECT_EQ(sharp.mesh->creases().method, CreasingMethod::kChaikin);
  EXPECT_THAT(sharp.report.sentences(), IsEmpty());
  const auto smooth =
      import_text(Strip + "t interpolateboundary 1/0/0 2\nt creasemethod 0/0/1 normal\n");
  EXPECT_EQ(smooth.mesh->attributes().corners, CornerRule::kSmooth);
  EXPECT_EQ(smooth.mesh->creases().method, CreasingMethod::kUniform);
  const auto other =
      import_text(Strip + "t interpolateboundary 1/0/0 0\nt creasemethod 0/0/1 odd\n");
  EXPECT_FALSE(other.mesh->attributes().corners.has_value());
  EXPECT_THAT(other.report.unused_data,
              ElementsAre("1 \"interpolateboundary\" tag", "1 \"creasemethod\" tag"));
}

TEST(ImportCreases, SharpnessBeyondAllBoundsIsInfinite) {
  const ImportedMesh imported = import_text(
      Strip + "t crease 2/1/0 1 4 inf\nt crease 2/1/0 0 1 1e300\nt corner 1/1/0 0 12.5\n");
  EXPECT_THAT(creases_of(*imported.mesh), ElementsAre(std::pair(Edge(0, 1), kInfiniteSharpness),
                                                      std::pair(Edge(1, 4), kInfiniteSharpness)));
  EXPECT_EQ(imported.mesh->creases().vertex_sharpness[0], 12.5f);
}

TEST(ImportCreases, TagsThatFitNothingAreReported) {
  const ImportedMesh imported =
      import_text(Strip +
                  "v 7 7 7\nt crease 2/1/0 0 4 2\nt crease 2/1/0 0 99 2\nt crease 2/1/0 -1 1 2\n"
                  "t crease 2/1/0 1 1 2\nt crease 2/1/0 0 99999999999 2\nt corner 1/1/0 6 2\n"
                  "t corner 1/1/0 7 2\nt corner 1/1/0 -3 2\nt crease 2/1/0 1 4 -2\n"
                  "t corner 1/1/0 0 -inf\n");
  EXPECT_THAT(imported.mesh->creases().edge_sharpness, IsEmpty());
  EXPECT_THAT(imported.mesh->creases().vertex_sharpness, IsEmpty());
  EXPECT_TRUE(imported.report.is_mended());
  EXPECT_THAT(imported.report.sentences(),
              ElementsAre("1 vertex is in no face; it is kept aside and written back.",
                          "5 crease tags were left out: they name no edge of the mesh.",
                          "3 corner tags were left out: they name no vertex of the mesh.",
                          "2 values of sharpness were negative and became 0."));
}

TEST(ImportCreases, MalformedTagsAreErrorsWithTheirLine) {
  const auto refuse = [](const std::string& tag) { return refusal_of(Strip + tag + "\n"); };
  EXPECT_EQ(refuse("t crease 0 1 2.5"),
            "text.obj:9: A tag says after its name how many integers, numbers and strings follow, "
            "like 2/1/0; this one says \"0\".");
  for (const char* counts : {"", "2/1", "2/1/0/0", "2//0", "-2/1/0", "a/b/c", "2/1/0x"}) {
    EXPECT_THAT(refuse("t crease " + std::string(counts) + " 0 1 2"),
                AllOf(StartsWith("text.obj:9: "), HasSubstr("how many integers")))
        << counts;
  }
  EXPECT_THAT(refuse("t crease 2/1/0 0 x 2"), StartsWith("text.obj:9: \"x\" is not an integer"));
  EXPECT_THAT(refuse("t crease 2/1/0 0 1.5 2"), HasSubstr("\"1.5\" is not an integer"));
  EXPECT_THAT(refuse("t crease 2/1/0 0 1 nan"), StartsWith("text.obj:9: \"nan\" is not a number"));
  EXPECT_THAT(refuse("t corner 1/1/0 0 sharp"), HasSubstr("\"sharp\" is not a number"));
  EXPECT_THAT(refuse("t crease 2/1/0 0 1"),
              HasSubstr("text.obj:9: This tag announces 2 integers, 1 "
                        "numbers and 0 strings, but 2 words follow"));
  EXPECT_THAT(refuse("t crease 2/1/0 0 1 2 3"), HasSubstr("but 4 words follow"));
  EXPECT_THAT(refuse("t crease 999999999999/1/0 0"), HasSubstr("but 1 word follows"));
  EXPECT_THAT(refuse("t crease 1/1/0 0 2"), HasSubstr("A crease of 1 vertex does not go with 1"));
  EXPECT_THAT(refuse("t crease 0/0/0"), HasSubstr("A crease of 0 vertices does not go with 0"));
  EXPECT_THAT(refuse("t crease 4/4/0 0 1 2 5 1 1 1 1"), HasSubstr("A crease of 4 vertices"));
  EXPECT_THAT(refuse("t corner 2/3/0 0 1 2 2 2"), HasSubstr("2 corners do not go with 3 values"));
  EXPECT_THAT(refuse("t interpolateboundary 0/0/0"), HasSubstr("The boundary rule is one integer"));
  EXPECT_THAT(refuse("t creasemethod 0/0/0"), HasSubstr("The crease method is one word"));
  // The line is that of the word, also within a continued statement.
  EXPECT_THAT(refuse("t crease 2/1/0 \\\n 0 1 \\\n oops"), StartsWith("text.obj:11: \"oops\""));
  // What is unknown is not looked into.
  EXPECT_THAT(import_text(Strip + "t weird a b\nt\n").report.unused_data,
              ElementsAre("1 \"weird\" tag", "1 \"\" tag"));
}

TEST(ImportCreases, GoWithTheirEdgesThroughMending) {
  // The first square is turned over, the triangle beside it hangs on by vertex 3 alone, vertex 1 is
  // in no face and one corner is doubled.
  const ImportedMesh imported = import_text(
      "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 0 0\nv 3 -1 0\n"
      "v 2 -1 0\nv 1 -1 0\nf 2 3 3 6 5\nf 3 6 7 4\nf 3 4 10 11\nf 4 9 8\n"
      "t crease 2/1/0 2 5 1.25\nt crease 2/1/0 3 8 2\nt crease 2/1/0 3 6 3\nt corner 1/1/0 3 4\n"
      "t corner 1/1/0 0 5\n");
  const ControlMesh& mesh = *imported.mesh;
  EXPECT_EQ(imported.report.count(MendKind::kFlippedFace), 1U);
  EXPECT_EQ(imported.report.count(MendKind::kSplitVertex), 1U);
  EXPECT_EQ(imported.report.count(MendKind::kLooseVertex), 1U);
  EXPECT_EQ(imported.report.count(MendKind::kRepeatedCorner), 1U);
  EXPECT_EQ(imported.report.count(MendKind::kLostCorner), 1U);
  EXPECT_EQ(imported.report.count(MendKind::kLostCrease), 0U);
  // File vertices 1.. are 0.. now; file vertex 3 is 2, and its copy comes last, as 10.
  EXPECT_EQ(faces_of(mesh)[3], (std::vector<std::uint32_t>{10, 7, 6}));
  EXPECT_THAT(creases_of(mesh),
              ElementsAre(std::pair(Edge(1, 4), 1.25f), std::pair(Edge(2, 5), 3.0f),
                          std::pair(Edge(7, 10), 2.0f)));
  EXPECT_THAT(mesh.creases().vertex_sharpness, ElementsAre(0, 0, 4, 0, 0, 0, 0, 0, 0, 0, 4));
}

TEST(ImportUvs, BelongToCorners) {
  const std::string points = "vt 0 0\nvt .5 0\nvt 1 0\nvt 0 1\nvt .5 1\nvt 1 1\n";
  const std::string strip = Strip.substr(0, Strip.find('f'));
  const ImportedMesh whole =
      import_text(strip + points + "f 1/1 2/2 5/5/9 4/4\nf 2/2 3/3 6/6 5/-2\n");
  EXPECT_EQ(uvs_of(*whole.mesh, 0), (std::vector<Uv>{{0, 0}, {0.5, 0}, {0.5, 1}, {0, 1}}));
  EXPECT_EQ(uvs_of(*whole.mesh, 1), (std::vector<Uv>{{0.5, 0}, {1, 0}, {1, 1}, {0.5, 1}}));
  EXPECT_THAT(whole.mesh->texture().corner_values, ElementsAre(0, 1, 4, 3, 1, 2, 5, 4));
  EXPECT_THAT(whole.report.sentences(), IsEmpty());
  // Points may come after the faces that name them.
  EXPECT_EQ(import_text(strip + "f 1/1 2/2 5/5 4/4\nf 2/2 3/3 6/6 5/5\n" + points).mesh->texture(),
            whole.mesh->texture());
}

TEST(ImportUvs, WhatIsUnusedIsDroppedAndTheRestKeepsItsOrder) {
  const ImportedMesh imported =
      import_text(Strip.substr(0, Strip.find('f')) +
                  "vt 9 9\nvt 0.1 0\nvt 9 9\nvt 0.2\nvt 0.3 0 0\nvt 0.4 0.5 7\n"
                  "f 1/6 2/5 5/4 4/2\nf 2/2 3/2 6/2 5/2\n");
  EXPECT_EQ(imported.mesh->texture().values,
            (std::vector<Uv>{{0.1, 0}, {0.2, 0}, {0.3, 0}, {0.4, 0.5}}));
  EXPECT_THAT(imported.mesh->texture().corner_values, ElementsAre(3, 2, 1, 0, 0, 0, 0, 0));
  EXPECT_THAT(imported.report.unused_data,
              ElementsAre("1 third texture coordinate", "2 texture coordinates"));
}

TEST(ImportUvs, CornersWithoutAPointShareOne) {
  const std::string points = "vt 1 1\nvt 2 1\nvt 2 2\nvt 1 2\n";
  const std::string vertices = Strip.substr(0, Strip.find('f'));
  for (const char* second : {"f 2 3 6 5", "f 2// 3//1 6/ 5/99", "f 2/0 3/-5 6/5 5/99999999999"}) {
    const ImportedMesh imported = import_text(vertices + points + "f 1/1 2/2 5/3 4/4\n" + second);
    EXPECT_EQ(imported.mesh->texture().values,
              (std::vector<Uv>{{1, 1}, {2, 1}, {2, 2}, {1, 2}, {0, 0}}));
    EXPECT_THAT(imported.mesh->texture().corner_values, ElementsAre(0, 1, 2, 3, 4, 4, 4, 4));
    EXPECT_THAT(imported.report.sentences(),
                ElementsAre("4 corners without texture coordinates were given one point, 0 0."));
  }
  // Where no corner has one there is no texture.
  const ImportedMesh none = import_text(vertices + "f 1/1 2/2 5/3 4/4\n");
  EXPECT_TRUE(none.mesh->texture().empty());
  EXPECT_THAT(none.report.sentences(),
              ElementsAre("2 vertices are in no face; they are kept aside and written back."));
}

TEST(ImportUvs, BadNumbers) {
  EXPECT_THAT(refusal_of(Strip + "vt 0 x\n"), StartsWith("text.obj:9: \"x\" is not a number"));
  EXPECT_THAT(refusal_of(Strip + "vt 0,5 1\n"), HasSubstr("is not a number"));
  EXPECT_THAT(refusal_of(Strip + "vt\n"), HasSubstr("text.obj:9: A texture coordinate needs two"));
  EXPECT_THAT(refusal_of(Strip + "vt 1 2 3 4\n"), HasSubstr("this one has more"));
  const ImportedMesh imported =
      import_text(Strip.substr(0, Strip.find('f')) +
                  "vt nan 1\nvt 1 inf\nvt 1e19 0\nvt 0.25 1e18\nf 1/1 2/2 5/3 4/4\n");
  EXPECT_EQ(imported.mesh->texture().values,
            (std::vector<Uv>{{0, 0}, {0, 0}, {0, 0}, {0.25, 1e18}}));
  EXPECT_THAT(imported.report.sentences(),
              Contains("3 texture coordinates were no usable numbers and became 0."));
}

TEST(ImportUvs, GoWithTheirCornersThroughMending) {
  // The first face is turned over and has a doubled corner, whose first point stays; the last one
  // repeats its first corner at the end.
  const ImportedMesh imported = import_text(
      "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 0 0\nv 3 1 0\n"
      "vt 0 1\nvt 0 2\nvt 0 3\nvt 0 4\nvt 0 5\nvt 0 6\nvt 0 7\nvt 0 8\nvt 0 9\n"
      "f 1/1 4/2 5/3 5/9 2/4\nf 2/4 3/5 6/6 5/3\nf 3/7 7/8 8/1 6/2 3/9\n");
  EXPECT_EQ(imported.report.count(MendKind::kFlippedFace), 1U);
  EXPECT_EQ(imported.report.count(MendKind::kRepeatedCorner), 2U);
  EXPECT_EQ(faces_of(*imported.mesh)[0], (std::vector<std::uint32_t>{0, 1, 4, 3}));
  EXPECT_EQ(uvs_of(*imported.mesh, 0), (std::vector<Uv>{{0, 1}, {0, 4}, {0, 3}, {0, 2}}));
  EXPECT_EQ(uvs_of(*imported.mesh, 1), (std::vector<Uv>{{0, 4}, {0, 5}, {0, 6}, {0, 3}}));
  EXPECT_EQ(uvs_of(*imported.mesh, 2), (std::vector<Uv>{{0, 7}, {0, 8}, {0, 1}, {0, 2}}));
  EXPECT_THAT(imported.report.unused_data, ElementsAre("1 texture coordinate"));
}

// OpenSubdiv's own shapes: every tag they have is understood, as their sums by another reading say.
TEST(Corpus, EveryTagOfOpenSubdivsShapesArrives) {
  if (!test::corpus_folder()) {
    GTEST_SKIP() << "no corpus of meshes: set LIMN_CORPUS or put one at ../shared/corpus";
  }
  std::size_t with_tags = 0;
  for (const auto& path : test::corpus_files(".obj")) {
    if (path.parent_path().filename() != "opensubdiv_shapes") {
      continue;
    }
    SCOPED_TRACE(path.string());
    const auto imported = import_mesh(path);
    if (!imported) {
      continue;  // Not a manifold: another test looks into why.
    }
    EXPECT_EQ(imported->report.count(MendKind::kLostCrease), 0U);
    EXPECT_EQ(imported->report.count(MendKind::kLostCorner), 0U);
    EXPECT_EQ(imported->report.count(MendKind::kNegativeSharpness), 0U);
    EXPECT_EQ(imported->report.count(MendKind::kBrokenUv), 0U);
    for (const std::string& data : imported->report.unused_data) {
      EXPECT_THAT(data, testing::Not(HasSubstr("crease")));
      EXPECT_THAT(data, testing::Not(HasSubstr("corner")));
    }
    std::map<Edge, float> creases;
    std::map<std::uint32_t, float> corners;
    std::ifstream in(path);
    for (std::string line; std::getline(in, line);) {
      unsigned a = 0;
      unsigned b = 0;
      float s = 0.0f;
      if (std::sscanf(line.c_str(), "t crease 2/1/0 %u %u %f", &a, &b, &s) == 3 && s > 0.0f) {
        creases[std::minmax(a, b)] = s;
      } else if (std::sscanf(line.c_str(), "t corner 1/1/0 %u %f", &a, &s) == 2 && s > 0.0f) {
        corners[a] = s;
      }
    }
    with_tags += creases.empty() && corners.empty() ? 0 : 1;
    if (imported->report.count(MendKind::kLooseVertex) +
            imported->report.count(MendKind::kSplitVertex) >
        0) {
      continue;  // Numbered otherwise.
    }
    EXPECT_EQ(creases_of(*imported->mesh), creases);
    std::map<std::uint32_t, float> read_corners;
    const auto& sharpness = imported->mesh->creases().vertex_sharpness;
    for (std::uint32_t v = 0; v < sharpness.size(); ++v) {
      if (sharpness[v] != 0.0f) {
        read_corners[v] = sharpness[v];
      }
    }
    EXPECT_EQ(read_corners, corners);
  }
  EXPECT_GT(with_tags, 20U);
}

}  // namespace
}  // namespace limn
