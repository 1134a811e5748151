// OpenSubdiv's Far: a topology refiner whose base level is made once a control mesh, refined
// uniformly without full topology in the last level, then positions interpolated level by level.
// Only the levels read and written are kept, not all of them in one buffer as in its tutorials.
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include "limn/contract.h"
#include "peers/subdivider.h"

namespace limn::bench {
namespace {

using namespace OpenSubdiv;  // NOLINT(google-build-using-namespace): its version namespace.
using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;

/// A position the way PrimvarRefiner wants it. Left unset until `Clear`.
struct Position {
  Position() {}  // NOLINT(modernize-use-equals-default): a vector would zero it.

  void Clear() { value = glm::vec3(0.0F); }                                           // NOLINT
  void AddWithWeight(const Position& p, float weight) { value += weight * p.value; }  // NOLINT

  glm::vec3 value;
};

std::unique_ptr<Far::TopologyRefiner> base_level(const ControlMesh& mesh, Rules rules) {
  std::vector<int> sides;
  std::vector<Far::Index> vertices;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    sides.push_back(static_cast<int>(face.size()));
    vertices.insert(vertices.end(), face.begin(), face.end());
  }
  Far::TopologyDescriptor descriptor;
  descriptor.numVertices = static_cast<int>(mesh.vertex_count());
  descriptor.numFaces = static_cast<int>(mesh.face_count());
  descriptor.numVertsPerFace = sides.data();
  descriptor.vertIndicesPerFace = vertices.data();
  Sdc::Options options;
  options.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
  std::unique_ptr<Far::TopologyRefiner> refiner(Factory::Create(
      descriptor,
      Factory::Options(rules == Rules::kLoop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK, options)));
  LIMN_EXPECTS(refiner != nullptr);
  return refiner;
}

class OpenSubdivSubdivider final : public Subdivider {
 public:
  OpenSubdivSubdivider(const ControlMesh& mesh, Rules rules) : base_(base_level(mesh, rules)) {
    control_.resize(mesh.vertex_count());
    for (std::size_t v = 0; v < control_.size(); ++v) {
      control_[v].value = mesh.positions()[v];
    }
  }

  void prepare() override { refiner_.reset(Factory::Create(*base_)); }
  void refine(int levels) override {
    Far::TopologyRefiner::UniformOptions uniform(levels);
    uniform.fullTopologyInLastLevel = false;
    refiner_->RefineUniform(uniform);

    const Far::PrimvarRefiner primvars(*refiner_);
    std::vector<Position> coarse;
    for (int level = 1; level <= levels; ++level) {
      coarse.swap(finest_);
      finest_ = std::vector<Position>(
          static_cast<std::size_t>(refiner_->GetLevel(level).GetNumVertices()));
      primvars.Interpolate(level, level == 1 ? control_ : coarse, finest_);
    }
  }
  void release() override {
    refiner_.reset();
    finest_ = {};
  }

  [[nodiscard]] Counts counts() const override {
    const Far::TopologyLevel level = refiner_->GetLevel(refiner_->GetMaxLevel());
    return {finest_.size(), static_cast<std::size_t>(level.GetNumFaces())};
  }
  [[nodiscard]] std::vector<glm::vec3> positions() const override {
    std::vector<glm::vec3> values;
    for (const Position& position : finest_) {
      values.push_back(position.value);
    }
    return values;
  }

 private:
  std::unique_ptr<Far::TopologyRefiner> base_;
  std::vector<Position> control_;
  std::unique_ptr<Far::TopologyRefiner> refiner_;
  std::vector<Position> finest_;
};

}  // namespace

std::unique_ptr<Subdivider> make_opensubdiv(const ControlMesh& mesh, Rules rules) {
  return std::make_unique<OpenSubdivSubdivider>(mesh, rules);
}

}  // namespace limn::bench
