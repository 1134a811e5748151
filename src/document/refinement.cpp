#include "limn/document/refinement.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>
#include <string_view>
#include <utility>

#include "limn/document/memory_budget.h"
#include "limn/document/scheme_refinement.h"
#include "limn/part_of_progress.h"
#include "limn/subdivision/label_subdivision.h"
#include "limn/subdivision/labels.h"
#include "limn/subdivision/schemes/adaptive_loop.h"

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

Result<DerivedLabels> label(const ControlMesh& control, std::span<const std::uint8_t> depths,
                            const FineDemands& demands, const SubdivisionSettings& settings,
                            Progress& progress) {
  Result<LabelsWithDemands> labels = legal_labels(control, depths, demands, settings, progress);
  if (!labels) {
    return tl::unexpected(std::move(labels.error()));
  }
  DerivedLabels derived;
  derived.painted = std::move(labels->painted);
  derived.legal = std::move(labels->legal);
  derived.fine = std::move(labels->fine);
  derived.illegal_faces = illegal_faces(control, derived.painted, settings.legalisation);
  derived.illegal_vertices = illegal_vertices(control, derived.painted, settings.legalisation);
  for (std::uint32_t v = 0; v < derived.painted.size(); ++v) {
    if (derived.painted[v] == 0 && derived.legal.labels[v] > 0) {
      derived.raised_vertices.push_back(v);
    }
  }
  return derived;
}

/// Labels are shown for Loop as well: how far the faces around a vertex go.
Result<DerivedLabels> balance(const ControlMesh& control, std::span<const std::uint8_t> depths) {
  if (Result<void> fits = check_fits(control, Scheme::kLoop); !fits) {
    return tl::unexpected(std::move(fits.error()));
  }
  DerivedLabels derived;
  derived.painted = vertex_labels(control, depths);
  derived.face_depths = balanced_depths(control, depths);
  derived.legal.labels = vertex_labels(control, derived.face_depths);
  for (std::size_t f = 0; f < depths.size(); ++f) {
    derived.deepened_faces += derived.face_depths[f] > depths[f] ? 1 : 0;
  }
  return derived;
}

/// No deeper than so many levels. Balanced depths stay so.
std::vector<std::uint8_t> held_to(std::span<const std::uint8_t> depths, int levels) {
  std::vector<std::uint8_t> held(depths.begin(), depths.end());
  for (std::uint8_t& depth : held) {
    depth = static_cast<std::uint8_t>(std::min<int>(depth, levels));
  }
  return held;
}

RefinementPrediction predict_loop(const ControlMesh& control,
                                  std::span<const std::uint8_t> depths) {
  const SchemeCounts counts = predict_adaptive_loop(control, depths);
  RefinementPrediction prediction;
  prediction.faces = counts.faces;
  prediction.vertices = counts.vertices;
  prediction.edges = counts.edges;
  prediction.bytes = scheme_bytes(counts);
  prediction.levels = *std::ranges::max_element(depths);
  prediction.uniform_faces = control.face_count() << (2 * prediction.levels);
  return prediction;
}

}  // namespace

Result<DerivedLabels> derive_labels(const ControlMesh& control,
                                    std::span<const std::uint8_t> depths,
                                    const SubdivisionSettings& settings, Progress& progress,
                                    const FineDemands& demands) {
  const Stopwatch watch;
  Result<DerivedLabels> derived = settings.scheme == RefinementScheme::kLoop
                                      ? balance(control, depths)
                                      : label(control, depths, demands, settings, progress);
  if (derived) {
    derived->prediction = predict_derived(control, *derived, kAllLevels);
    derived->seconds = watch.seconds();
  }
  return derived;
}

VertexLabels labels_up_to(const DerivedLabels& labels, int levels) {
  VertexLabels result = labels.legal.labels;
  for (std::uint8_t& label : result) {
    label = static_cast<std::uint8_t>(std::min<int>(label, levels));
  }
  return result;
}

RefinementPrediction predict_derived(const ControlMesh& control, const DerivedLabels& labels,
                                     int levels) {
  if (!labels.face_depths.empty()) {
    return predict_loop(control, held_to(labels.face_depths, levels));
  }
  RefinementPrediction prediction =
      predict_refinement(control, labels.legal.labels, levels, labels.fine.get());
  const std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  // A product of fewer than 2^60 vertices; the guard is for a prediction that was cut off itself.
  prediction.bytes = prediction.vertices > most / 16 || prediction.bytes > most / 2
                         ? most
                         : prediction.bytes + prediction.vertices * sizeof(glm::vec3);
  return prediction;
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

Result<Refinement> RefinementSource::derive(const ControlMesh& control, const DerivedLabels& labels,
                                            const RefinementOptions& options, Progress& progress) {
  Refinement derived;
  derived.prediction = predict_derived(control, labels, options.levels);
  if (derived.prediction.bytes > options.memory_budget &&
      derived.prediction.faces <= options.face_budget) {
    return over_memory(derived.prediction.faces, derived.prediction.bytes, options.memory_budget);
  }
  const Stopwatch refining;
  PartOfProgress refine_part(progress, 0.0, 0.7);
  // NOLINTNEXTLINE(clang-analyzer-cplusplus.NewDeleteLeaks): it goes back, or to whoever asked.
  std::unique_ptr<RefinedMesh> mesh = spare_->take();
  if (auto done = refine(control, labels, options, refine_part, *mesh); !done) {
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
  PartOfProgress check_part(progress, 0.7, 1.0);
  if (!checker_.check(control, *derived.mesh, derived.cracks, check_part)) {
    return fail(ErrorKind::kCancelled, "The refinement was cancelled.");
  }
  derived.check_seconds = checking.seconds();
  return derived;
}

Result<void> RefinementSource::refine(const ControlMesh& control, const DerivedLabels& labels,
                                      const RefinementOptions& options, Progress& progress,
                                      RefinedMesh& mesh) {
  if (labels.face_depths.empty()) {
    return refiner_.refine(control, labels.legal.labels, options.settings,
                           {options.levels, options.face_budget, true, labels.fine.get()}, progress,
                           mesh);
  }
  return refine_by_loop(control, held_to(labels.face_depths, options.levels),
                        {options.settings.weights, options.settings.corners, options.face_budget},
                        progress)
      .map([&mesh](RefinedMesh made) { mesh = std::move(made); });
}

Result<Refinement> derive_refinement(const ControlMesh& control, const DerivedLabels& labels,
                                     const RefinementOptions& options, Progress& progress) {
  return RefinementSource().derive(control, labels, options, progress);
}

}  // namespace limn
