#pragma once

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

namespace limn {

/// Double positions, no stored normals or colours: what Limn needs of OpenMesh and no more.
struct ControlMeshTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  VertexAttributes(OpenMesh::Attributes::None);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
  EdgeAttributes(OpenMesh::Attributes::None);
  FaceAttributes(OpenMesh::Attributes::None);
};

/// The half-edge mesh that a control mesh lives in and that a refined mesh can be converted to.
using HalfedgeMesh = OpenMesh::PolyMesh_ArrayKernelT<ControlMeshTraits>;

}  // namespace limn
