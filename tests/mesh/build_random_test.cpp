// Soups of few vertices against brute force, and shuffled manifolds against themselves.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/mesh/build.h"
#include "mesh/mesh_checks.h"
#include "support/effort.h"

namespace limn {
namespace {

using test::faults_of;
using test::soup_of;
using testing::IsEmpty;
using Faces = std::vector<std::vector<std::uint32_t>>;
using Random = std::mt19937;

std::uint32_t pick(Random& random, std::uint32_t below) {
  return std::uniform_int_distribution<std::uint32_t>(0, below - 1)(random);
}

std::vector<std::uint32_t> reversed(std::vector<std::uint32_t> face) {
  std::reverse(face.begin() + 1, face.end());
  return face;
}

/// The fewest flips after which no two faces run along an edge the same way, by trying all.
std::optional<std::size_t> fewest_flips(const Faces& faces) {
  std::optional<std::size_t> fewest;
  for (std::uint32_t flips = 0; flips < (1U << faces.size()); ++flips) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
    bool clashes = false;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const auto face = (flips >> f & 1U) != 0 ? reversed(faces[f]) : faces[f];
      for (std::size_t i = 0; i < face.size(); ++i) {
        clashes |= !seen.insert({face[i], face[(i + 1) % face.size()]}).second;
      }
    }
    const auto count = static_cast<std::size_t>(std::popcount(flips));
    if (!clashes && (!fewest || count < *fewest)) {
      fewest = count;
    }
  }
  return fewest;
}

/// Fans around all vertices beyond the first of each: faces joined where they share an edge there.
std::size_t extra_fans(std::size_t vertex_count, const Faces& faces) {
  std::size_t extra = 0;
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    std::map<std::size_t, std::set<std::uint32_t>> links;  // Face -> its two neighbours of v.
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const auto at = std::find(faces[f].begin(), faces[f].end(), v);
      if (at != faces[f].end()) {
        const auto i = static_cast<std::size_t>(at - faces[f].begin());
        const std::size_t n = faces[f].size();
        links[f] = {faces[f][(i + 1) % n], faces[f][(i + n - 1) % n]};
      }
    }
    std::size_t fans = 0;
    while (!links.empty()) {
      ++fans;
      std::set<std::uint32_t> reached = links.begin()->second;
      for (bool grows = true; grows;) {
        grows = false;
        for (auto it = links.begin(); it != links.end();) {
          const bool touches = std::any_of(it->second.begin(), it->second.end(),
                                           [&](std::uint32_t w) { return reached.count(w) > 0; });
          if (touches) {
            reached.insert(it->second.begin(), it->second.end());
            it = links.erase(it);
            grows = true;
          } else {
            ++it;
          }
        }
      }
    }
    extra += fans > 1 ? fans - 1 : 0;
  }
  return extra;
}

std::size_t vertices_in_use(const Faces& faces) {
  std::set<std::uint32_t> used;
  for (const auto& face : faces) {
    used.insert(face.begin(), face.end());
  }
  return used.size();
}

/// Each face must have its soup's positions, forwards or backwards from the same first corner.
/// `sources` has the soup's face for each.
void expect_same_geometry(const PolygonSoup& soup, const ImportedMesh& built,
                          const std::vector<std::size_t>& sources) {
  ASSERT_EQ(built.mesh->face_count(), sources.size());
  std::size_t flipped = 0;
  for (std::size_t f = 0; f < sources.size(); ++f) {
    const auto was = soup.face(sources[f]);
    const auto is = built.mesh->face(f);
    ASSERT_EQ(is.size(), was.size());
    const std::size_t n = is.size();
    const auto agrees = [&](bool backwards) {
      for (std::size_t i = 0; i < n; ++i) {
        const std::size_t j = backwards ? (n - i) % n : i;
        if (built.mesh->positions()[is[i]] != soup.positions[was[j]]) {
          return false;
        }
      }
      return true;
    };
    const bool is_flipped = !agrees(false);
    ASSERT_TRUE(!is_flipped || agrees(true)) << "face " << f;
    flipped += is_flipped ? 1 : 0;
  }
  EXPECT_EQ(flipped, built.report.count(MendKind::kFlippedFace));
}

void expect_same_geometry(const PolygonSoup& soup, const ImportedMesh& built) {
  std::vector<std::size_t> all(soup.face_count());
  std::iota(all.begin(), all.end(), 0U);
  expect_same_geometry(soup, built, all);
}

/// The faces that are not on the same circle of vertices as an earlier one, by comparing all.
std::vector<std::size_t> without_duplicates(const Faces& faces) {
  std::vector<std::size_t> kept;
  std::set<std::vector<std::uint32_t>> seen;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    std::vector<std::uint32_t> face = faces[f];
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    if (seen.insert(face).second) {
      kept.push_back(f);
    }
  }
  return kept;
}

Faces picked(const Faces& faces, const std::vector<std::size_t>& which) {
  Faces result;
  for (const std::size_t f : which) {
    result.push_back(faces[f]);
  }
  return result;
}

/// Neighbours over an edge with two faces must still be neighbours, but for so many edges.
std::size_t torn_edges(const Faces& faces, const ControlMesh& mesh) {
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  std::map<Edge, std::vector<std::size_t>> at_edges;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t i = 0; i < faces[f].size(); ++i) {
      const std::uint32_t a = faces[f][i];
      const std::uint32_t b = faces[f][(i + 1) % faces[f].size()];
      at_edges[{std::min(a, b), std::max(a, b)}].push_back(f);
    }
  }
  std::multiset<std::pair<std::size_t, std::size_t>> joined;
  for (const auto& [one, other] : mesh.topology().edge_corners) {
    if (other != kNone) {
      const std::size_t f = mesh.topology().corner_faces[one];
      const std::size_t g = mesh.topology().corner_faces[other];
      joined.insert({std::min(f, g), std::max(f, g)});
    }
  }
  std::size_t torn = 0;
  for (const auto& [edge, at_edge] : at_edges) {
    if (at_edge.size() == 2) {
      const auto found = joined.find({at_edge[0], at_edge[1]});
      if (found == joined.end()) {
        ++torn;
      } else {
        joined.erase(found);
      }
    }
  }
  return torn;
}

/// What was mended once needs no mending again.
void expect_lasting(const ControlMesh& mesh) {
  PolygonSoup soup;
  soup.positions.assign(mesh.positions().begin(), mesh.positions().end());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    soup.add_face(mesh.face(f));
  }
  const auto again = build_control_mesh(soup, {true});
  EXPECT_TRUE(again.has_value()) << to_string(again.error());
}

TEST(BuildRandomSoup, AgreesWithBruteForce) {
  Random random(20260101);
  std::size_t clean = 0;
  std::size_t crowded = 0;
  std::size_t one_sided = 0;
  std::size_t split = 0;
  std::size_t duplicates = 0;
  const double effort = test::effort();
  const auto rounds = static_cast<int>(6000 * effort);
  for (int round = 0; round < rounds; ++round) {
    const std::uint32_t vertex_count = 4 + pick(random, 6);
    Faces all(1 + pick(random, 8));
    for (auto& face : all) {
      std::vector<std::uint32_t> pool(vertex_count);
      std::iota(pool.begin(), pool.end(), 0U);
      std::shuffle(pool.begin(), pool.end(), random);
      pool.resize(3 + pick(random, 2));
      face = pool;
    }
    const PolygonSoup soup = soup_of(vertex_count, all);
    const auto built = build_control_mesh(soup);
    ASSERT_TRUE(built.has_value()) << "round " << round << ": " << to_string(built.error());
    const ImportReport& report = built->report;
    const std::vector<std::size_t> kept = without_duplicates(all);
    const Faces faces = picked(all, kept);
    ASSERT_EQ(report.count(MendKind::kDuplicateFace), all.size() - kept.size());
    ASSERT_THAT(faults_of(*built->mesh), IsEmpty()) << "round " << round;
    ASSERT_NO_FATAL_FAILURE(expect_same_geometry(soup, *built, kept));
    expect_lasting(*built->mesh);
    EXPECT_EQ(report.count(MendKind::kLooseVertex), vertex_count - vertices_in_use(faces));
    EXPECT_LE(torn_edges(faces, *built->mesh), report.count(MendKind::kOneSidedEdge))
        << "round " << round;
    duplicates += kept.size() < all.size() ? 1 : 0;

    const bool is_crowded = test::edge_use_counts(soup_of(vertex_count, faces)).size() > 3;
    EXPECT_EQ(report.count(MendKind::kCrowdedEdge) > 0, is_crowded);
    crowded += is_crowded ? 1 : 0;
    if (is_crowded) {
      continue;
    }
    const auto flips = fewest_flips(faces);
    ASSERT_EQ(report.count(MendKind::kOneSidedEdge) == 0, flips.has_value()) << "round " << round;
    if (!flips) {
      ++one_sided;
      EXPECT_EQ(torn_edges(faces, *built->mesh), report.count(MendKind::kOneSidedEdge));
      continue;
    }
    ++clean;
    EXPECT_EQ(report.count(MendKind::kFlippedFace), *flips);
    EXPECT_EQ(report.count(MendKind::kSplitVertex), extra_fans(vertex_count, faces));
    split += report.count(MendKind::kSplitVertex) > 0 ? 1 : 0;
  }
  // The sample must have met every case.
  EXPECT_GT(clean, 500 * effort);
  EXPECT_GT(crowded, 500 * effort);
  EXPECT_GT(one_sided, 20 * effort);
  EXPECT_GT(split, 200 * effort);
  EXPECT_GT(duplicates, 20 * effort);
}

/// A torus of quads, with some pairs of neighbours joined into hexagons and some quads cut.
Faces mixed_torus(std::uint32_t rows, std::uint32_t columns, Random& random) {
  Faces faces;
  const auto at = [&](std::uint32_t r, std::uint32_t c) {
    return r % rows * columns + c % columns;
  };
  for (std::uint32_t r = 0; r < rows; ++r) {
    for (std::uint32_t c = 0; c < columns; ++c) {
      const std::uint32_t kind = pick(random, 4);
      if (kind == 0) {
        faces.push_back({at(r, c), at(r, c + 1), at(r + 1, c + 1)});
        faces.push_back({at(r, c), at(r + 1, c + 1), at(r + 1, c)});
      } else if (kind == 1 && c + 1 < columns) {
        faces.push_back({at(r, c), at(r, c + 1), at(r, c + 2), at(r + 1, c + 2), at(r + 1, c + 1),
                         at(r + 1, c)});
        ++c;
      } else {
        faces.push_back({at(r, c), at(r, c + 1), at(r + 1, c + 1), at(r + 1, c)});
      }
    }
  }
  return faces;
}

TEST(BuildShuffledManifold, ComesBackOrientedWithTheSameGeometry) {
  Random random(99);
  for (int round = 0; round < 150; ++round) {
    const std::uint32_t rows = 4 + pick(random, 6);
    const std::uint32_t columns = 4 + pick(random, 6);
    Faces faces = mixed_torus(rows, columns, random);
    const bool is_open = round % 2 == 1;
    if (is_open) {
      faces.resize(faces.size() - 1 - pick(random, static_cast<std::uint32_t>(faces.size() / 2)));
    }
    std::shuffle(faces.begin(), faces.end(), random);
    std::vector<std::uint32_t> names(std::size_t{rows} * columns);
    std::iota(names.begin(), names.end(), 0U);
    std::shuffle(names.begin(), names.end(), random);
    for (auto& face : faces) {
      for (auto& v : face) {
        v = names[v];
      }
      std::rotate(face.begin(),
                  face.begin() + pick(random, static_cast<std::uint32_t>(face.size())), face.end());
      if (pick(random, 3) == 0) {
        face = reversed(face);
      }
    }
    const PolygonSoup soup = soup_of(names.size(), faces);
    const auto built = build_control_mesh(soup);
    ASSERT_TRUE(built.has_value()) << to_string(built.error());
    ASSERT_THAT(faults_of(*built->mesh), IsEmpty());
    ASSERT_NO_FATAL_FAILURE(expect_same_geometry(soup, *built));
    EXPECT_EQ(built->mesh->is_closed(), !is_open);
    EXPECT_EQ(built->report.count(MendKind::kSplitVertex), extra_fans(names.size(), faces));
    if (!is_open) {
      EXPECT_LE(2 * built->report.count(MendKind::kFlippedFace), faces.size());
    }
  }
}

TEST(BuildShuffledManifold, PinchedVerticesAreTornApartAgain) {
  // Vertices of a torus far from one another are named as one, which pinches the surface there.
  Random random(5);
  for (int round = 0; round < 60; ++round) {
    Faces faces = mixed_torus(12, 12, random);
    for (auto& face : faces) {
      for (auto& v : face) {
        const bool is_pinched = v % 12 % 4 == 0 && v / 12 % 4 == 0;
        v = is_pinched ? v / 48 * 48 : v;  // Three at a time, four columns apart.
      }
    }
    std::shuffle(faces.begin(), faces.end(), random);
    const PolygonSoup soup = soup_of(144, faces);
    const auto built = build_control_mesh(soup);
    ASSERT_TRUE(built.has_value()) << to_string(built.error());
    EXPECT_THAT(faults_of(*built->mesh), IsEmpty());
    ASSERT_NO_FATAL_FAILURE(expect_same_geometry(soup, *built));
    EXPECT_EQ(built->report.count(MendKind::kSplitVertex), 6U);
    EXPECT_EQ(built->report.count(MendKind::kLooseVertex), 6U);
    EXPECT_EQ(built->mesh->vertex_count(), 144U);
    EXPECT_TRUE(built->mesh->is_closed());
  }
}

}  // namespace
}  // namespace limn
