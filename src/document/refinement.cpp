#include "limn/document/refinement.h"

#include <chrono>
#include <memory>
#include <mutex>
#include <string_view>
#include <utility>

#include "limn/subdivision/label_subdivision.h"
#include "limn/subdivision/labels.h"

namespace limn {
namespace {

class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Shows an algorithm's 0..1 as a part of a longer run.
class PartOf final : public Progress {
 public:
  PartOf(Progress& whole, double from, double to) : whole_(whole), from_(from), to_(to) {}
  [[nodiscard]] bool report(double fraction, std::string_view stage) override {
    return whole_.report(from_ + (to_ - from_) * fraction, stage);
  }

 private:
  Progress& whole_;
  double from_;
  double to_;
};

}  // namespace

Result<DerivedLabels> derive_labels(const ControlMesh& control,
                                    std::span<const std::uint8_t> depths,
                                    const SubdivisionSettings& settings, Progress& progress) {
  const Stopwatch watch;
  DerivedLabels derived;
  derived.painted =
      apply_non_quad_rule(control, vertex_labels(control, depths), settings.non_quads);
  derived.illegal_faces = illegal_faces(control, derived.painted, settings.legalisation);
  derived.illegal_vertices = illegal_vertices(control, derived.painted, settings.legalisation);
  Result<Legalisation> legal = legal_labels(control, depths, settings, progress);
  if (!legal) {
    return tl::unexpected(std::move(legal.error()));
  }
  derived.legal = *std::move(legal);
  for (std::uint32_t v = 0; v < derived.painted.size(); ++v) {
    if (derived.painted[v] == 0 && derived.legal.labels[v] > 0) {
      derived.raised_vertices.push_back(v);
    }
  }
  derived.prediction = predict_refinement(control, derived.legal.labels);
  derived.seconds = watch.seconds();
  return derived;
}

/// One refined mesh that nobody uses, for the next refinement to write over.
struct RefinementSource::Spare {
  std::mutex mutex;
  std::unique_ptr<RefinedMesh> mesh;

  [[nodiscard]] std::unique_ptr<RefinedMesh> take() {
    const std::lock_guard lock(mutex);
    return mesh != nullptr ? std::move(mesh) : std::make_unique<RefinedMesh>();
  }
  void put_back(std::unique_ptr<RefinedMesh> unused) {
    const std::lock_guard lock(mutex);
    mesh = std::move(unused);  // What was there before goes.
  }
};

RefinementSource::RefinementSource() : spare_(std::make_shared<Spare>()) {}
RefinementSource::~RefinementSource() = default;

Result<Refinement> RefinementSource::derive(const ControlMesh& control, const VertexLabels& labels,
                                            const RefinementOptions& options, Progress& progress) {
  Refinement derived;
  derived.prediction = predict_refinement(control, labels, options.levels);
  const Stopwatch refining;
  PartOf refine_part(progress, 0.0, 0.7);
  std::unique_ptr<RefinedMesh> mesh = spare_->take();
  if (auto done = refiner_.refine(control, labels, options.settings,
                                  {options.levels, options.face_budget, true}, refine_part, *mesh);
      !done) {
    spare_->put_back(std::move(mesh));
    return tl::unexpected(std::move(done.error()));
  }
  derived.mesh = std::shared_ptr<const RefinedMesh>(
      mesh.release(), [spare = spare_](const RefinedMesh* unused) {
        // It was made here, and not const.
        spare->put_back(std::unique_ptr<RefinedMesh>(const_cast<RefinedMesh*>(unused)));
      });
  derived.refine_seconds = refining.seconds();

  if (!progress.report(0.7, "Checking for cracks")) {
    return fail(ErrorKind::kCancelled, "The refinement was cancelled.");
  }
  const Stopwatch checking;
  checker_.check(control, *derived.mesh, derived.cracks);
  derived.check_seconds = checking.seconds();
  return derived;
}

Result<Refinement> derive_refinement(const ControlMesh& control, const VertexLabels& labels,
                                     const RefinementOptions& options, Progress& progress) {
  return RefinementSource().derive(control, labels, options, progress);
}

}  // namespace limn
