#include "limn/contract.h"
#include "limn/subdivision/label_subdivision.h"
#include "peers/refiner.h"

namespace limn::bench {
namespace {

class LimnRefiner final : public Refiner {
 public:
  explicit LimnRefiner(const ControlMesh& mesh) : mesh_(mesh) {}

  void prepare() override {}
  void refine(int levels) override {
    const VertexLabels labels(mesh_.vertex_count(), static_cast<std::uint8_t>(levels));
    IgnoreProgress progress;
    Result<RefinedMesh> refined = limn::refine(mesh_, labels, {}, {}, progress);
    LIMN_EXPECTS(refined.has_value());
    result_ = std::move(*refined);
  }
  void release() override { result_ = {}; }

  [[nodiscard]] Counts counts() const override {
    return {result_.vertex_count(), result_.face_count()};
  }
  [[nodiscard]] std::vector<glm::vec3> positions() const override {
    std::vector<glm::vec3> world;
    for (std::size_t v = 0; v < result_.vertex_count(); ++v) {
      world.emplace_back(result_.position(v));
    }
    return world;
  }
  [[nodiscard]] std::size_t result_bytes() const override { return result_.bytes(); }

 private:
  const ControlMesh& mesh_;
  RefinedMesh result_;
};

}  // namespace

std::unique_ptr<Refiner> make_limn(const ControlMesh& mesh) {
  return std::make_unique<LimnRefiner>(mesh);
}

}  // namespace limn::bench
