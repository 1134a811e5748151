// OpenMesh's subdivider refines a mesh in place, so each run starts from a copy. Its rule at
// boundaries is not Catmull-Clark's: closed meshes only.
#include <optional>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>

#include "limn/contract.h"
#include "peers/subdivider.h"

namespace limn::bench {
namespace {

/// Float positions and nothing that the subdivider does not need.
struct Traits : OpenMesh::DefaultTraits {
  VertexAttributes(OpenMesh::Attributes::None);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
  EdgeAttributes(OpenMesh::Attributes::None);
  FaceAttributes(OpenMesh::Attributes::None);
};
using Polygons = OpenMesh::PolyMesh_ArrayKernelT<Traits>;
using CatmullClark = OpenMesh::Subdivider::Uniform::CatmullClarkT<Polygons, float>;
using Triangles = OpenMesh::TriMesh_ArrayKernelT<Traits>;
using Loop = OpenMesh::Subdivider::Uniform::LoopT<Triangles, float>;

template <class Mesh, class Method>
class OpenMeshSubdivider final : public Subdivider {
 public:
  explicit OpenMeshSubdivider(const ControlMesh& mesh) {
    LIMN_EXPECTS(mesh.is_closed());
    for (const glm::vec3 p : mesh.positions()) {
      control_.add_vertex({p.x, p.y, p.z});
    }
    std::vector<OpenMesh::VertexHandle> corners;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      corners.clear();
      for (const std::uint32_t vertex : mesh.face(f)) {
        corners.emplace_back(static_cast<int>(vertex));
      }
      control_.add_face(corners);
    }
  }

  void prepare() override { mesh_ = control_; }
  void refine(int levels) override {
    Method subdivider;
    LIMN_EXPECTS(subdivider(*mesh_, static_cast<std::size_t>(levels)));
  }
  void release() override { mesh_.reset(); }

  [[nodiscard]] Counts counts() const override { return {mesh_->n_vertices(), mesh_->n_faces()}; }
  [[nodiscard]] std::vector<glm::vec3> positions() const override {
    std::vector<glm::vec3> values;
    for (const OpenMesh::VertexHandle vertex : mesh_->vertices()) {
      const typename Mesh::Point& p = mesh_->point(vertex);
      values.emplace_back(p[0], p[1], p[2]);
    }
    return values;
  }

 private:
  Mesh control_;
  std::optional<Mesh> mesh_;
};

}  // namespace

std::unique_ptr<Subdivider> make_openmesh(const ControlMesh& mesh, Rules rules) {
  if (rules == Rules::kLoop) {
    return std::make_unique<OpenMeshSubdivider<Triangles, Loop>>(mesh);
  }
  return std::make_unique<OpenMeshSubdivider<Polygons, CatmullClark>>(mesh);
}

}  // namespace limn::bench
