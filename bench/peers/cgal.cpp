// CGAL's subdivision on its Surface_mesh, the fastest of its containers, with float coordinates.
// It refines in place, so each run starts from a copy.
#include <optional>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include "limn/contract.h"
#include "peers/subdivider.h"

namespace limn::bench {
namespace {

using Point = CGAL::Simple_cartesian<float>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

class CgalSubdivider final : public Subdivider {
 public:
  CgalSubdivider(const ControlMesh& mesh, Rules rules) : rules_(rules) {
    LIMN_EXPECTS(mesh.is_closed());
    for (const glm::vec3 p : mesh.positions()) {
      control_.add_vertex(Point(p.x, p.y, p.z));
    }
    std::vector<Mesh::Vertex_index> corners;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      corners.clear();
      for (const std::uint32_t vertex : mesh.face(f)) {
        corners.emplace_back(vertex);
      }
      control_.add_face(corners);
    }
  }

  void prepare() override { mesh_ = control_; }
  void refine(int levels) override {
    const auto steps = CGAL::parameters::number_of_iterations(static_cast<unsigned>(levels));
    if (rules_ == Rules::kLoop) {
      CGAL::Subdivision_method_3::Loop_subdivision(*mesh_, steps);
    } else {
      CGAL::Subdivision_method_3::CatmullClark_subdivision(*mesh_, steps);
    }
  }
  void release() override { mesh_.reset(); }

  [[nodiscard]] Counts counts() const override {
    return {mesh_->number_of_vertices(), mesh_->number_of_faces()};
  }
  [[nodiscard]] std::vector<glm::vec3> positions() const override {
    std::vector<glm::vec3> values;
    for (const Mesh::Vertex_index vertex : mesh_->vertices()) {
      const Point& p = mesh_->point(vertex);
      values.emplace_back(p.x(), p.y(), p.z());
    }
    return values;
  }

 private:
  Rules rules_;
  Mesh control_;
  std::optional<Mesh> mesh_;
};

}  // namespace

std::unique_ptr<Subdivider> make_cgal(const ControlMesh& mesh, Rules rules) {
  return std::make_unique<CgalSubdivider>(mesh, rules);
}

}  // namespace limn::bench
