// Half-edge meshes that were not assembled by this library.
#include "limn/mesh/control_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/mesh_checks.h"

namespace limn {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// An open strip made by OpenMesh face by face.
HalfedgeMesh strip_by_openmesh() {
  HalfedgeMesh mesh;
  std::vector<OpenMesh::VertexHandle> v;
  for (int i = 0; i < 6; ++i) {
    v.push_back(mesh.add_vertex({i / 2 * 1.0, i % 2 * 1.0, 0.0}));
  }
  mesh.add_face({v[2], v[3], v[1], v[0]});
  mesh.add_face({v[2], v[4], v[5], v[3]});
  return mesh;
}

TEST(ControlMesh, TakesMeshesThatOpenMeshMade) {
  const ControlMesh mesh(strip_by_openmesh());
  EXPECT_THAT(test::faults_of(mesh), IsEmpty());
  EXPECT_THAT(mesh.face(0), ElementsAre(2, 3, 1, 0));
  EXPECT_THAT(mesh.face(1), ElementsAre(2, 4, 5, 3));
  EXPECT_TRUE(mesh.is_all_quads());
  EXPECT_FALSE(mesh.is_closed());
  EXPECT_EQ(mesh.bounds().high, glm::dvec3(2.0, 1.0, 0.0));
}

TEST(ControlMesh, TakesEdgesWhoseFirstHalfedgeIsOnTheBoundary) {
  // OpenMesh leaves such edges behind when a face is deleted; here it is made by hand.
  HalfedgeMesh mesh;
  const auto a = mesh.add_vertex({0.0, 0.0, 0.0});
  const auto b = mesh.add_vertex({1.0, 0.0, 0.0});
  const auto c = mesh.add_vertex({0.0, 1.0, 0.0});
  const auto d = mesh.add_vertex({1.0, 1.0, 0.0});
  mesh.request_face_status();
  mesh.request_edge_status();
  mesh.request_vertex_status();
  mesh.request_halfedge_status();
  const auto gone = mesh.add_face(a, b, c);
  mesh.add_face(c, b, d);
  mesh.delete_face(gone, true);
  mesh.garbage_collection();
  const ControlMesh control(mesh);
  EXPECT_EQ(control.edge_count(), 3U);
  EXPECT_THAT(test::faults_of(control), IsEmpty());
}

TEST(ControlMeshDeathTest, IsolatedVerticesBreakTheContract) {
  HalfedgeMesh mesh = strip_by_openmesh();
  mesh.add_vertex({9.0, 9.0, 9.0});
  EXPECT_DEATH(ControlMesh{mesh}, "no isolated vertices");
}

TEST(MeshChecks, SeeFaults) {
  HalfedgeMesh mesh = strip_by_openmesh();
  ASSERT_THAT(test::link_faults_of(mesh), IsEmpty());
  HalfedgeMesh wrong_link = mesh;
  wrong_link.set_next_halfedge_handle(OpenMesh::HalfedgeHandle(0), OpenMesh::HalfedgeHandle(5));
  EXPECT_THAT(test::link_faults_of(wrong_link), testing::Not(IsEmpty()));
  HalfedgeMesh wrong_vertex = mesh;
  for (const auto h : mesh.halfedges()) {
    if (!mesh.is_boundary(h) && mesh.is_boundary(mesh.from_vertex_handle(h))) {
      wrong_vertex.set_halfedge_handle(mesh.from_vertex_handle(h), h);
    }
  }
  EXPECT_THAT(test::link_faults_of(wrong_vertex), testing::Not(IsEmpty()));
}

}  // namespace
}  // namespace limn
