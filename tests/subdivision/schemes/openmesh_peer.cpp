#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/ModifiedButterFlyT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/Sqrt3T.hh>

#include "limn/contract.h"
#include "peers.h"

namespace limn::test {
namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using TriangleMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

template <class Subdivider>
PlainMesh subdivided(const ControlMesh& mesh, int levels) {
  TriangleMesh triangles;
  for (const glm::dvec3& p : mesh.positions()) {
    triangles.add_vertex({p.x, p.y, p.z});
  }
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const auto vertex = [&face](std::size_t i) {
      return OpenMesh::VertexHandle(static_cast<int>(face[i]));
    };
    triangles.add_face(vertex(0), vertex(1), vertex(2));
  }
  Subdivider subdivider;
  LIMN_EXPECTS(subdivider(triangles, static_cast<std::size_t>(levels)));
  PlainMesh result;
  for (const OpenMesh::VertexHandle v : triangles.vertices()) {
    const OpenMesh::Vec3d& p = triangles.point(v);
    result.positions.emplace_back(p[0], p[1], p[2]);
  }
  for (const OpenMesh::FaceHandle f : triangles.faces()) {
    std::vector<std::uint32_t> corners;
    for (const OpenMesh::VertexHandle v : triangles.fv_ccw_range(f)) {
      corners.push_back(static_cast<std::uint32_t>(v.idx()));
    }
    result.faces.push_back(corners);
  }
  return result;
}

}  // namespace

PlainMesh openmesh_butterfly(const ControlMesh& mesh, int levels) {
  return subdivided<OpenMesh::Subdivider::Uniform::ModifiedButterflyT<TriangleMesh, double>>(
      mesh, levels);
}

PlainMesh openmesh_sqrt3(const ControlMesh& mesh, int levels) {
  return subdivided<OpenMesh::Subdivider::Uniform::Sqrt3T<TriangleMesh, double>>(mesh, levels);
}

PlainMesh openmesh_loop(const ControlMesh& mesh, int levels) {
  return subdivided<OpenMesh::Subdivider::Uniform::LoopT<TriangleMesh, double>>(mesh, levels);
}

}  // namespace limn::test
