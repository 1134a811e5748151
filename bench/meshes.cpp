// An asteroid starts as an icosahedron, or a finer sphere. Its triangles are split in four until
// there are enough, then into three quads each, and those twice in four. Every step is a split at
// edge midpoints, which the flat topology of the step before numbers; new vertices are thrown out
// to the sphere.
//
//        /\             /\               +---+---+
//       /__\           /  \              |   |   |
//      /\  /\         /\  /\             +---+---+
//     /__\/__\       /___\/__\           |   |   |
//    in four        in three quads       +---+---+
#include "meshes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <span>

#include <glm/geometric.hpp>

#include "limn/contract.h"
#include "limn/mesh/build.h"
#include "limn/mesh/bundled.h"
#include "limn/mesh/import.h"
#include "limn/mesh/triangulate.h"
#include "limn/subdivision/schemes/uniform.h"

namespace limn::bench {
namespace {

using SharedMesh = std::shared_ptr<const ControlMesh>;

SharedMesh build(const PolygonSoup& soup) {
  const Result<ImportedMesh> built = build_control_mesh(soup);
  LIMN_EXPECTS(built.has_value());
  return built->mesh;
}

/// The vertices of a mesh on the unit sphere, followed by its edges' midpoints.
PolygonSoup with_midpoints(const ControlMesh& mesh) {
  PolygonSoup soup;
  soup.positions.assign(mesh.positions().begin(), mesh.positions().end());
  for (const auto& [a, b] : mesh.topology().edge_vertices) {
    soup.positions.push_back(glm::normalize(mesh.positions()[a] + mesh.positions()[b]));
  }
  return soup;
}

/// The vertices of the midpoints of a face's edges, in the soup of `with_midpoints`.
std::vector<std::uint32_t> midpoints_of(const ControlMesh& mesh, std::size_t face) {
  std::vector<std::uint32_t> midpoints;
  const FlatTopology& topology = mesh.topology();
  for (std::uint32_t c = topology.face_offsets[face]; c < topology.face_offsets[face + 1]; ++c) {
    midpoints.push_back(static_cast<std::uint32_t>(mesh.vertex_count()) + topology.corner_edges[c]);
  }
  return midpoints;
}

/// Every triangle as four.
SharedMesh split_triangles(const ControlMesh& mesh) {
  PolygonSoup soup = with_midpoints(mesh);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const std::span<const std::uint32_t> v = mesh.face(f);
    const std::vector<std::uint32_t> m = midpoints_of(mesh, f);
    soup.add_face(std::array{v[0], m[0], m[2]});
    soup.add_face(std::array{v[1], m[1], m[0]});
    soup.add_face(std::array{v[2], m[2], m[1]});
    soup.add_face(m);
  }
  return build(soup);
}

/// Every face of n sides as n quads.
SharedMesh split_into_quads(const ControlMesh& mesh) {
  PolygonSoup soup = with_midpoints(mesh);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const std::span<const std::uint32_t> v = mesh.face(f);
    const std::vector<std::uint32_t> m = midpoints_of(mesh, f);
    glm::dvec3 sum(0.0);
    for (const std::uint32_t vertex : v) {
      sum += mesh.positions()[vertex];
    }
    const auto centre = static_cast<std::uint32_t>(soup.positions.size());
    soup.positions.push_back(glm::normalize(sum));
    for (std::size_t i = 0; i < v.size(); ++i) {
      soup.add_face(std::array{v[i], m[i], centre, m[(i + v.size() - 1) % v.size()]});
    }
  }
  return build(soup);
}

/// Distance from the centre in the direction `d`: waves of three lengths that share no symmetry.
double radius(const glm::dvec3& d) {
  return 1.0 + 0.15 * std::sin(2.3 * d.x + 1.1 * d.y + 0.4) +
         0.06 * std::sin(5.1 * d.y - 3.7 * d.z + 1.3) * std::cos(4.3 * d.x + 0.7) +
         0.02 * std::sin(13.0 * d.z + 7.9 * d.x) * std::sin(11.0 * d.y + 2.1);
}

/// An asteroid of 48 * 4^splits quads for each triangle of a bundled mesh around the origin.
SharedMesh asteroid(int splits, const char* triangles = "icosahedron") {
  const Result<ImportedMesh> start = load_bundled_mesh(triangles);
  LIMN_EXPECTS(start.has_value());
  PolygonSoup soup;
  for (const glm::dvec3& position : start->mesh->positions()) {
    soup.positions.push_back(glm::normalize(position));
  }
  for (std::size_t f = 0; f < start->mesh->face_count(); ++f) {
    soup.add_face(start->mesh->face(f));
  }
  SharedMesh mesh = build(soup);
  for (int split = 0; split < splits; ++split) {
    mesh = split_triangles(*mesh);
  }
  for (int split = 0; split < 3; ++split) {
    mesh = split_into_quads(*mesh);
  }
  soup = {};
  for (const glm::dvec3& direction : mesh->positions()) {
    soup.positions.push_back(radius(direction) * direction);
  }
  for (std::size_t f = 0; f < mesh->face_count(); ++f) {
    soup.add_face(mesh->face(f));
  }
  return build(soup);
}

/// Texture coordinates and creases, which not every program refines, are left out for all.
SharedMesh without_attributes(const ControlMesh& mesh) {
  return std::make_shared<const ControlMesh>(mesh.with_attributes({}));
}

SharedMesh make(const std::string& name) {
  if (name == "asteroid_15k") {
    return asteroid(2);
  }
  if (name == "asteroid_61k") {
    return asteroid(3);
  }
  if (name == "asteroid_98k") {
    return asteroid(3, "sphere");
  }
  if (name == "asteroid_246k") {
    return asteroid(4);
  }
  if (name == "asteroid_31k_triangles") {
    return triangulated(*asteroid(2));
  }
  if (name == "asteroid_123k_triangles") {
    return triangulated(*asteroid(3));
  }
  const Result<ImportedMesh> bundled = load_bundled_mesh(name);
  LIMN_EXPECTS(bundled.has_value());
  return without_attributes(*bundled->mesh);
}

/// All meshes made so far, by name.
std::map<std::string, SharedMesh>& meshes() {
  static std::map<std::string, SharedMesh> all;
  return all;
}

}  // namespace

const ControlMesh& control_mesh(const std::string& name) {
  SharedMesh& mesh = meshes()[name];
  if (mesh == nullptr) {
    mesh = make(name);
  }
  return *mesh;
}

Result<std::string> add_control_mesh(const std::filesystem::path& file) {
  return import_mesh(file).map([&](const ImportedMesh& imported) {
    std::string name = file.stem().string();
    meshes()[name] = without_attributes(*imported.mesh);
    return name;
  });
}

Counts uniform_counts(const ControlMesh& mesh, const Work& work) {
  const Scheme scheme = work.rules == Rules::kLoop ? Scheme::kLoop : Scheme::kCatmullClark;
  const SchemeCounts counts = predict_scheme(mesh, {.scheme = scheme}, work.levels).back();
  return {counts.vertices, counts.faces};
}

const std::vector<Work>& large_works() {
  static const std::vector<Work> works = {
      {"asteroid_15k", 4}, {"asteroid_61k", 3}, {"asteroid_246k", 2}};
  return works;
}

const std::vector<Work>& loop_works() {
  static const std::vector<Work> works = {{"asteroid_31k_triangles", 3, Rules::kLoop},
                                          {"asteroid_123k_triangles", 2, Rules::kLoop},
                                          {"icosahedron", 8, Rules::kLoop}};
  return works;
}

std::string path_of(const Work& work) {
  return work.mesh + "/" + std::to_string(work.levels);
}

}  // namespace limn::bench
