#include "limn/contract.h"
#include "limn/subdivision/label_subdivision.h"
#include "limn/subdivision/schemes/uniform.h"
#include "peers/subdivider.h"

namespace limn::bench {
namespace {

std::vector<glm::vec3> world(const RefinedMesh& mesh) {
  std::vector<glm::vec3> positions;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    positions.emplace_back(mesh.position(v));
  }
  return positions;
}

class LimnSubdivider final : public Subdivider {
 public:
  explicit LimnSubdivider(const ControlMesh& mesh) : mesh_(mesh) {}

  void prepare() override {}
  void refine(int levels) override {
    labels_.assign(mesh_.vertex_count(), static_cast<std::uint8_t>(levels));
    IgnoreProgress progress;
    LIMN_EXPECTS(refiner_.refine(mesh_, labels_, {}, {}, progress, result_).has_value());
  }
  void release() override {
    labels_ = {};
    refiner_ = {};
    result_ = {};
  }
  void recycle() override {}

  [[nodiscard]] Counts counts() const override {
    return {result_.vertex_count(), result_.face_count()};
  }
  [[nodiscard]] std::vector<glm::vec3> positions() const override { return world(result_); }
  [[nodiscard]] std::size_t result_bytes() const override { return result_.bytes(); }

 private:
  const ControlMesh& mesh_;
  VertexLabels labels_;
  limn::Refiner refiner_;
  RefinedMesh result_;
};

class LimnLoop final : public Subdivider {
 public:
  explicit LimnLoop(const ControlMesh& mesh) : mesh_(mesh) {}

  void prepare() override {}
  void refine(int levels) override {
    IgnoreProgress progress;
    result_ = subdivide(mesh_, {.scheme = Scheme::kLoop}, {.levels = levels}, progress).value();
  }
  void release() override { result_ = {}; }

  [[nodiscard]] Counts counts() const override {
    return {result_.vertex_count(), result_.face_count()};
  }
  [[nodiscard]] std::vector<glm::vec3> positions() const override { return world(result_); }
  [[nodiscard]] std::size_t result_bytes() const override { return result_.bytes(); }

 private:
  const ControlMesh& mesh_;
  RefinedMesh result_;
};

}  // namespace

std::unique_ptr<Subdivider> make_limn(const ControlMesh& mesh, Rules rules) {
  if (rules == Rules::kLoop) {
    return std::make_unique<LimnLoop>(mesh);
  }
  return std::make_unique<LimnSubdivider>(mesh);
}

}  // namespace limn::bench
