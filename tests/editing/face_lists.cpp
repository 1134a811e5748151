#include "face_lists.h"

#include <algorithm>
#include <map>
#include <set>

#include "limn/editing/edge_edits.h"

namespace limn::test {
namespace {

/// The faces around one vertex as steps from neighbour to neighbour: whether they make one path or
/// one ring.
bool is_one_fan(const std::vector<std::array<std::uint32_t, 2>>& steps) {
  std::map<std::uint32_t, std::uint32_t> after;
  std::set<std::uint32_t> entered;
  for (const auto& [from, to] : steps) {
    if (!after.emplace(from, to).second || !entered.insert(to).second) {
      return false;
    }
  }
  std::uint32_t start = steps.front()[0];
  for (const auto& [from, to] : steps) {
    if (!entered.contains(from)) {
      start = from;
    }
  }
  std::size_t walked = 0;
  for (auto at = after.find(start); at != after.end(); at = after.find(at->second)) {
    ++walked;
    if (at->second == start) {
      break;
    }
  }
  return walked == steps.size();
}

}  // namespace

Faces faces_of(const ControlMesh& mesh) {
  Faces faces;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    faces.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
  }
  return faces;
}

Faces sorted_faces(Faces faces) {
  for (auto& face : faces) {
    std::rotate(face.begin(), std::ranges::min_element(face), face.end());
  }
  std::ranges::sort(faces);
  return faces;
}

bool is_manifold(const Faces& faces, std::size_t vertices) {
  std::set<std::array<std::uint32_t, 2>> directed;
  std::vector<std::vector<std::array<std::uint32_t, 2>>> around(vertices);
  for (const auto& face : faces) {
    const std::size_t n = face.size();
    if (std::set<std::uint32_t>(face.begin(), face.end()).size() != n) {
      return false;
    }
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t before = face[(i + n - 1) % n];
      const std::uint32_t next = face[(i + 1) % n];
      if (!directed.insert({face[i], next}).second) {
        return false;
      }
      around[face[i]].push_back({next, before});
    }
  }
  return std::ranges::all_of(around,
                             [](const auto& steps) { return !steps.empty() && is_one_fan(steps); });
}

PolygonSoup triangulated(const PolygonSoup& soup) {
  PolygonSoup result;
  result.positions = soup.positions;
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    const auto face = soup.face(f);
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      result.add_face(std::array{face[0], face[i], face[i + 1]});
    }
  }
  return result;
}

MeshPointer random_triangles(int i, Random& random) {
  PolygonSoup soup = i % 2 == 0 ? torus_soup(5, 4) : grid_soup(6, 4);
  if (i % 4 == 2) {
    soup = cube_soup();
  }
  soup = triangulated(soup);
  if (i % 3 == 0) {
    soup = with_holes(soup, 4, random);
  }
  // Holes can leave vertices that are copies of one another; jittered, all are apart.
  const MeshPointer built = control_mesh(soup);
  soup = {};
  soup.positions.assign(built->positions().begin(), built->positions().end());
  for (std::size_t f = 0; f < built->face_count(); ++f) {
    soup.add_face(built->face(f));
  }
  MeshPointer mesh = control_mesh(jittered(soup, 0.2, random));
  for (int flips = 0; flips < 40; ++flips) {
    std::uniform_int_distribution<std::uint32_t> edge(
        0, static_cast<std::uint32_t>(mesh->edge_count() - 1));
    if (auto flipped = flip_edge(*mesh, edge(random))) {
      mesh = *flipped;
    }
  }
  return mesh;
}

}  // namespace limn::test
