// Every file of the corpus against what its manifest says. Passes without the corpus, by skipping.
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/mesh/import.h"
#include "limn/mesh/statistics.h"
#include "mesh/mesh_checks.h"
#include "support/corpus.h"

namespace limn {
namespace {

using testing::IsEmpty;
using testing::StartsWith;
using Row = std::map<std::string, std::string>;

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, '\t');) {
    cells.push_back(cell);
  }
  return cells;
}

std::vector<Row> rows_of(const std::filesystem::path& manifest) {
  std::ifstream in(manifest);
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> header = split(line);
  std::vector<Row> rows;
  while (std::getline(in, line)) {
    const std::vector<std::string> cells = split(line);
    Row row;
    for (std::size_t i = 0; i < header.size(); ++i) {
      row[header[i]] = i < cells.size() ? cells[i] : "";
    }
    rows.push_back(row);
  }
  return rows;
}

/// "3:32 4:468"
std::string sides_of(const MeshStatistics& statistics) {
  std::string text;
  for (const auto& [sides, faces] : statistics.faces_by_sides) {
    text += fmt::format("{}{}:{}", text.empty() ? "" : " ", sides, faces);
  }
  return text;
}

std::size_t number(const Row& row, const std::string& column) {
  return std::stoul(row.at(column));
}

void expect_statistics(const Row& row, const ImportedMesh& imported) {
  const MeshStatistics s = mesh_statistics(*imported.mesh);
  const auto mends = [&](MendKind kind) { return imported.report.count(kind); };
  const std::size_t dropped = mends(MendKind::kDegenerateFace) + mends(MendKind::kDuplicateFace);
  EXPECT_EQ(s.faces + dropped, number(row, "nF"));
  EXPECT_EQ(imported.mesh->is_closed(), s.boundary_edges == 0);
  EXPECT_EQ(s.boundary_edges == 0, s.boundary_loops == 0);
  if (number(row, "degF") > 0 || dropped > 0) {
    return;  // The manifest leaves faces with repeated corners out of what follows.
  }
  EXPECT_EQ(mends(MendKind::kCrowdedEdge), number(row, "nmE"));
  const std::size_t isolated = mends(MendKind::kLooseVertex) + mends(MendKind::kBrokenVertex);
  EXPECT_EQ(isolated, number(row, "iso"));
  EXPECT_EQ(s.vertices + isolated, number(row, "nV") + mends(MendKind::kSplitVertex));
  EXPECT_EQ(mends(MendKind::kFlippedFace) + mends(MendKind::kOneSidedEdge) > 0,
            number(row, "oriE") > 0);
  EXPECT_EQ(sides_of(s), row.at("val"));
  if (number(row, "nmV") + number(row, "oriE") + number(row, "nmE") == 0) {
    EXPECT_EQ(s.components, number(row, "comp"));
    EXPECT_EQ(s.euler_characteristic, std::stol(row.at("chi")));
  }
  if (mends(MendKind::kCrowdedEdge) + mends(MendKind::kOneSidedEdge) == 0) {
    EXPECT_EQ(s.boundary_edges, number(row, "bndE"));
    EXPECT_EQ(mends(MendKind::kSplitVertex) > 0, number(row, "nmV") > 0);
  }
}

TEST(Corpus, EveryFileImportsOrIsRefusedForAReasonInTheManifest) {
  const auto corpus = test::corpus_folder();
  if (!corpus) {
    GTEST_SKIP() << "no corpus of meshes: set LIMN_CORPUS or put one at ../shared/corpus";
  }
  const std::vector<Row> rows = rows_of(*corpus / "manifest.tsv");
  ASSERT_GT(rows.size(), 200U);
  std::size_t accepted = 0;
  for (const Row& row : rows) {
    SCOPED_TRACE(row.at("path"));
    const auto imported = import_mesh(*corpus / row.at("path"));
    const std::string& kind = row.at("kind");
    if (imported) {
      ++accepted;
      EXPECT_THAT(test::faults_of(*imported->mesh), IsEmpty());
      EXPECT_EQ(number(row, "oorF"), 0U);
      expect_statistics(row, *imported);
    } else {
      EXPECT_EQ(imported.error().kind, ErrorKind::kBadInput);
      EXPECT_THAT(to_string(imported.error()), StartsWith((*corpus / row.at("path")).string()));
      const bool is_surface = kind == "closed" || kind == "boundary";
      // A surface is refused only where its own vertices lie nowhere.
      EXPECT_TRUE(!is_surface || number(row, "nanV") > 0) << to_string(imported.error());
    }
  }
  EXPECT_GT(accepted, 190U);
}

TEST(Corpus, NoFileOfAnyKindBreaksTheReader) {
  if (!test::corpus_folder()) {
    GTEST_SKIP() << "no corpus of meshes: set LIMN_CORPUS or put one at ../shared/corpus";
  }
  for (const std::string ending : {".off", ".ply", ".stl", ".obj"}) {
    for (const auto& path : test::corpus_files(ending)) {
      std::ifstream in(path, std::ios::binary);
      const std::string text(std::istreambuf_iterator<char>(in), {});
      const auto imported = import_obj(text, path.string());
      if (imported) {
        EXPECT_THAT(test::faults_of(*imported->mesh), IsEmpty()) << path;
      } else {
        EXPECT_EQ(imported.error().kind, ErrorKind::kBadInput);
      }
    }
  }
}

}  // namespace
}  // namespace limn
