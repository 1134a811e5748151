#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include "peers.h"

namespace limn::test {
namespace {

using CgalPoint = CGAL::Simple_cartesian<double>::Point_3;
using CgalMesh = CGAL::Surface_mesh<CgalPoint>;

CgalMesh to_cgal(const ControlMesh& mesh) {
  CgalMesh result;
  for (const glm::dvec3& p : mesh.positions()) {
    result.add_vertex(CgalPoint(p.x, p.y, p.z));
  }
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    std::vector<CgalMesh::Vertex_index> corners;
    for (const std::uint32_t v : mesh.face(f)) {
      corners.emplace_back(v);
    }
    result.add_face(corners);
  }
  return result;
}

PlainMesh from_cgal(CgalMesh& mesh) {
  mesh.collect_garbage();
  PlainMesh result;
  for (const CgalMesh::Vertex_index v : mesh.vertices()) {
    const CgalPoint& p = mesh.point(v);
    result.positions.emplace_back(p.x(), p.y(), p.z());
  }
  for (const CgalMesh::Face_index f : mesh.faces()) {
    std::vector<std::uint32_t> corners;
    for (const CgalMesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f))) {
      corners.push_back(v);
    }
    result.faces.push_back(corners);
  }
  return result;
}

}  // namespace

PlainMesh cgal_doo_sabin(const ControlMesh& mesh, int levels) {
  CgalMesh result = to_cgal(mesh);
  CGAL::Subdivision_method_3::DooSabin_subdivision(
      result, CGAL::parameters::number_of_iterations(static_cast<unsigned>(levels)));
  return from_cgal(result);
}

PlainMesh cgal_sqrt3(const ControlMesh& mesh, int levels) {
  CgalMesh result = to_cgal(mesh);
  CGAL::Subdivision_method_3::Sqrt3_subdivision(
      result, CGAL::parameters::number_of_iterations(static_cast<unsigned>(levels)));
  return from_cgal(result);
}

}  // namespace limn::test
