// Meshes broken at random, against a checker that is as plain as can be.
#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "limn/subdivision/crack_check.h"
#include "limn/subdivision/label_subdivision.h"
#include "support/effort.h"
#include "support/shapes.h"

namespace limn {
namespace {

using test::MeshPointer;

struct PlainSide {
  std::uint32_t from;
  std::uint32_t to;
  std::uint32_t face;
};
struct PlainBoundarySide {
  std::uint32_t to;
  std::uint32_t face;
  bool is_marked = false;
};

/// How many edges an edge between vertices of two labels becomes: the one between their children,
/// summed.
std::size_t plain_edge_count(int a, int b) {
  if (a == 0 && b == 0) {
    return 1;
  }
  const int middle = std::max(std::min(a, b) - 1, 0);
  return plain_edge_count(std::max(a - 1, 0), middle) +
         plain_edge_count(middle, std::max(b - 1, 0));
}

/// The definition of CrackCheck, word by word.
CrackCheck plain_check(const ControlMesh& control, const RefinedMesh& mesh) {
  CrackCheck check;
  const std::set<std::uint32_t> covered(mesh.face_control_faces.begin(),
                                        mesh.face_control_faces.end());
  check.missing_control_faces = control.face_count() - covered.size();
  std::vector<std::size_t> faces_around(mesh.vertex_count(), 0);
  std::vector<PlainSide> sides;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      sides.push_back({face[i], face[(i + 1) % face.size()], f});
      ++faces_around[face[i]];
    }
  }
  check.unused_vertices = static_cast<std::size_t>(std::ranges::count(faces_around, 0u));
  const auto edge_of = [](const PlainSide& side) {
    return std::pair(std::min(side.from, side.to), std::max(side.from, side.to));
  };
  std::ranges::sort(sides, {}, edge_of);
  std::map<std::uint32_t, std::vector<PlainBoundarySide>> boundary;
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    while (last < sides.size() && edge_of(sides[last]) == edge_of(sides[first])) {
      ++last;
    }
    if (last - first == 1) {
      boundary[sides[first].from].push_back({sides[first].to, sides[first].face});
      ++check.boundary_edges;
    } else if (last - first > 2 || sides[first].from == sides[first + 1].from) {
      ++check.nonmanifold_edges;
    }
  }

  const FlatTopology& topology = control.topology();
  for (std::uint32_t f = 0; f < control.face_count(); ++f) {
    const auto face = control.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      if (topology.corner_twins[topology.face_offsets[f] + i] != kNone) {
        continue;
      }
      const std::uint32_t end = face[(i + 1) % face.size()];
      const int label = mesh.vertex_levels[face[i]];
      const int end_label = mesh.vertex_levels[end];
      const std::size_t most = plain_edge_count(label, end_label);
      const std::size_t least = std::max(label, end_label) <= 1 ? 1 : most;
      std::vector<PlainBoundarySide*> path;
      std::uint32_t at = face[i];
      do {
        std::vector<PlainBoundarySide*> ways;
        for (PlainBoundarySide& side : boundary[at]) {
          if (mesh.face_control_faces[side.face] == f && !side.is_marked) {
            ways.push_back(&side);
          }
        }
        if (ways.size() != 1 || path.size() == most) {
          break;
        }
        path.push_back(ways.front());
        at = path.back()->to;
      } while (at != end && at >= control.vertex_count() && faces_around[at] >= 2);
      if (at == end && !path.empty() && path.size() >= least) {
        for (PlainBoundarySide* side : path) {
          side->is_marked = true;
        }
      }
    }
  }
  std::set<std::uint32_t> crack_faces;
  for (const auto& [from, leaving] : boundary) {
    for (const PlainBoundarySide& side : leaving) {
      if (side.is_marked) {
        ++check.control_boundary_edges;
      } else {
        crack_faces.insert(side.face);
      }
    }
  }
  check.crack_faces.assign(crack_faces.begin(), crack_faces.end());
  return check;
}

void expect_same(const CrackCheck& check, const CrackCheck& expected, const std::string& what) {
  EXPECT_EQ(check.boundary_edges, expected.boundary_edges) << what;
  EXPECT_EQ(check.control_boundary_edges, expected.control_boundary_edges) << what;
  EXPECT_EQ(check.nonmanifold_edges, expected.nonmanifold_edges) << what;
  EXPECT_EQ(check.missing_control_faces, expected.missing_control_faces) << what;
  EXPECT_EQ(check.unused_vertices, expected.unused_vertices) << what;
  EXPECT_TRUE(check.crack_faces == expected.crack_faces) << what;
}

std::uint32_t below(std::size_t n, test::Random& random) {
  return static_cast<std::uint32_t>(random() % n);
}

void add_quad(RefinedMesh& mesh, std::array<std::uint32_t, 4> quad, std::size_t like) {
  mesh.quads.push_back(quad);
  // Faces that are no quads come last.
  const auto at = static_cast<std::ptrdiff_t>(mesh.quads.size() - 1);
  mesh.face_control_faces.insert(mesh.face_control_faces.begin() + at,
                                 std::uint32_t{mesh.face_control_faces[like]});
  mesh.face_levels.insert(mesh.face_levels.begin() + at, std::uint8_t{mesh.face_levels[like]});
}

void remove_quads(RefinedMesh& mesh, const std::function<bool(std::size_t)>& goes) {
  std::size_t kept = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (f < mesh.quads.size() && goes(f)) {
      continue;
    }
    if (f < mesh.quads.size()) {
      mesh.quads[kept] = mesh.quads[f];
    }
    mesh.face_control_faces[kept] = mesh.face_control_faces[f];
    mesh.face_levels[kept++] = mesh.face_levels[f];
  }
  mesh.quads.resize(kept - mesh.polygon_count());
  mesh.face_control_faces.resize(kept);
  mesh.face_levels.resize(kept);
}

/// Gives one corner of a face a vertex of its own: a crack, however near the two vertices lie.
void tear(RefinedMesh& mesh, std::size_t f, std::size_t corner) {
  mesh.positions.push_back(mesh.positions[mesh.quads[f][corner]]);
  mesh.vertex_levels.push_back(mesh.vertex_levels[mesh.quads[f][corner]]);
  mesh.quads[f][corner] = static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

/// One random fault.
void break_somewhere(RefinedMesh& mesh, test::Random& random) {
  if (mesh.quads.empty()) {
    return;
  }
  const std::uint32_t f = below(mesh.quads.size(), random);
  const std::uint32_t corner = below(4, random);
  switch (random() % 10) {
    case 0:
      remove_quads(mesh, [&](std::size_t g) { return g == f; });
      break;
    case 1:  // A hole of all faces at a vertex.
      remove_quads(mesh, [&, v = mesh.quads[f][corner]](std::size_t g) {
        return std::ranges::find(mesh.quads[g], v) != mesh.quads[g].end();
      });
      break;
    case 2:
      add_quad(mesh, mesh.quads[f], f);
      break;
    case 3:  // The same face, told from another corner, or its back.
      add_quad(mesh, {mesh.quads[f][1], mesh.quads[f][2], mesh.quads[f][3], mesh.quads[f][0]}, f);
      break;
    case 4:
      add_quad(mesh, {mesh.quads[f][3], mesh.quads[f][2], mesh.quads[f][1], mesh.quads[f][0]}, f);
      break;
    case 5:
      std::ranges::reverse(mesh.quads[f]);
      break;
    case 6:
      tear(mesh, f, corner);
      break;
    case 7:  // A T-junction: the face skips a vertex. Two corners are one.
      mesh.quads[f][corner] = mesh.quads[f][(corner + 1) % 4];
      break;
    case 8:  // Two far corners are one.
      mesh.quads[f][corner] = mesh.quads[f][(corner + 2) % 4];
      break;
    default:
      mesh.quads[f][corner] = below(mesh.vertex_count(), random);
      break;
  }
}

/// All faces once more: every star is closed twice.
void double_all(RefinedMesh& mesh) {
  const std::size_t quads = mesh.quads.size();
  for (std::size_t f = 0; f < quads; ++f) {
    add_quad(mesh, mesh.quads[f], f);
  }
}

void shuffle_quads(RefinedMesh& mesh, test::Random& random) {
  for (std::size_t f = mesh.quads.size(); f-- > 1;) {
    const std::uint32_t other = below(f + 1, random);
    std::swap(mesh.quads[f], mesh.quads[other]);
    std::swap(mesh.face_control_faces[f], mesh.face_control_faces[other]);
    std::swap(mesh.face_levels[f], mesh.face_levels[other]);
    auto& quad = mesh.quads[f];
    std::rotate(quad.begin(), quad.begin() + below(4, random), quad.end());
  }
}

RefinedMesh refined_at_random(const ControlMesh& mesh, double painted, int deepest,
                              test::Random& random) {
  IgnoreProgress progress;
  SubdivisionSettings settings;
  settings.non_quads =
      random() % 2 == 0 ? NonQuadRule::kUniformFirstStep : NonQuadRule::kWherePainted;
  const auto legal =
      legal_labels(mesh, test::random_depths(mesh, painted, deepest, random), settings, progress);
  return refine(mesh, legal.value().labels, settings, {}, progress).value();
}

std::vector<MeshPointer> small_meshes(test::Random& random) {
  return {test::cube(),
          test::mixed_prism(),
          test::control_mesh(test::grid_soup(1, 1)),
          test::control_mesh(test::grid_soup(4, 3)),
          test::control_mesh(test::torus_soup(5, 4)),
          test::control_mesh(test::trapezohedron_soup(7)),
          test::control_mesh(test::polygon_in_ring_soup(70)),
          test::control_mesh(test::with_mixed_faces(test::grid_soup(6, 5), random)),
          test::control_mesh(test::random_quads(test::torus_soup(4, 4), random))};
}

TEST(CrackCheck, AgreesWithAPlainCheckerOnBrokenMeshes) {
  test::Random random(131);
  CrackChecker checker;  // One for all: what it keeps must not matter.
  CrackCheck result;
  std::size_t whole = 0;
  std::size_t watertight = 0;
  const int rounds = static_cast<int>(3000 * test::effort());
  const std::vector<MeshPointer> meshes = small_meshes(random);
  for (int round = 0; round < rounds; ++round) {
    const MeshPointer& mesh = meshes[below(meshes.size(), random)];
    RefinedMesh refined = refined_at_random(*mesh, 0.3, 3, random);
    const std::uint32_t faults = below(4, random);
    for (std::uint32_t i = 0; i < faults; ++i) {
      break_somewhere(refined, random);
    }
    if (round % 8 == 0) {
      shuffle_quads(refined, random);
    }
    if (round % 50 == 0) {
      double_all(refined);
    }
    checker.check(*mesh, refined, result);
    expect_same(result, plain_check(*mesh, refined), "round " + std::to_string(round));
    ASSERT_FALSE(::testing::Test::HasFailure());
    whole += faults == 0 && round % 50 != 0 ? 1 : 0;
    watertight += result.is_watertight() ? 1 : 0;
  }
  EXPECT_GT(whole, static_cast<std::size_t>(rounds / 5));
  EXPECT_GE(watertight, whole);
  EXPECT_LT(watertight, whole + static_cast<std::size_t>(rounds / 20));
}

/// Results of one mesh by 1, 2 and 7 threads are what the plain checker says; with less effort,
/// what one thread says.
void expect_right_for_any_thread_count(const ControlMesh& mesh, const RefinedMesh& refined,
                                       const std::string& what) {
  const auto check_by = [&](int threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    return arena.execute([&] { return check_cracks(mesh, refined); });
  };
  const CrackCheck by_one = check_by(1);
  if (test::effort() == 1.0) {
    expect_same(by_one, plain_check(mesh, refined), what);
  }
  for (const int threads : {2, 7}) {
    expect_same(check_by(threads), by_one, what + ", " + std::to_string(threads) + " threads");
  }
}

TEST(CrackCheck, IsTheSameForAnyThreadCount) {
  // Large enough for several lanes and many runs, and to be matched in shares where faces lie in no
  // order.
  test::Random random(132);
  const MeshPointer mesh = test::control_mesh(
      test::with_mixed_faces(test::with_holes(test::grid_soup(44, 40), 12, random), random));
  RefinedMesh refined = refined_at_random(*mesh, 0.5, 4, random);
  ASSERT_GT(refined.face_count(), std::size_t{1} << 18);
  EXPECT_TRUE(check_cracks(*mesh, refined).is_watertight());
  expect_right_for_any_thread_count(*mesh, refined, "whole");
  for (int i = 0; i < 40; ++i) {
    break_somewhere(refined, random);
  }
  expect_right_for_any_thread_count(*mesh, refined, "broken");
  RefinedMesh shuffled = refined;
  shuffle_quads(shuffled, random);
  expect_right_for_any_thread_count(*mesh, shuffled, "shuffled");
}

TEST(CrackCheck, FindsAWholeMeshThatIsThereTwice) {
  // The second copy comes later than any run reaches.
  test::Random random(133);
  const MeshPointer mesh = test::control_mesh(test::torus_soup(24, 20));
  RefinedMesh doubled = refined_at_random(*mesh, 0.5, 4, random);
  ASSERT_GT(doubled.quads.size(), 20000u);
  const std::vector<std::array<std::uint32_t, 4>> quads(doubled.quads.begin(), doubled.quads.end());
  for (std::size_t f = 0; f < quads.size(); ++f) {
    doubled.quads.push_back(quads[f]);
    doubled.face_control_faces.push_back(std::uint32_t{doubled.face_control_faces[f]});
    doubled.face_levels.push_back(std::uint8_t{doubled.face_levels[f]});
  }
  const CrackCheck check = check_cracks(*mesh, doubled);
  EXPECT_EQ(check.nonmanifold_edges, 2 * quads.size());
  expect_same(check, plain_check(*mesh, doubled), "doubled");
}

TEST(CrackCheck, FindsTwoPiecesThatShareAnEdgeInEveryRun) {
  // A face far away in the list has one edge of a region that looks whole by itself.
  test::Random random(134);
  const MeshPointer mesh = test::control_mesh(test::torus_soup(24, 20));
  const RefinedMesh whole = refined_at_random(*mesh, 0.5, 4, random);
  const int rounds = static_cast<int>(20 * test::effort());
  for (int i = 0; i < rounds; ++i) {
    RefinedMesh broken = whole;
    const auto& near = whole.quads[below(1000, random)];
    auto& far = broken.quads[whole.quads.size() - 1 - below(1000, random)];
    far[0] = near[0];
    far[1] = near[1];
    expect_same(check_cracks(*mesh, broken), plain_check(*mesh, broken), std::to_string(i));
  }
}

}  // namespace
}  // namespace limn
