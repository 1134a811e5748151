// All faces that may still be lowered are lowered at once, and those whose measured distance allows
// it stay so. A face's labels never fall below what it was measured with: who keeps its depth only
// raises those of its neighbours. What the last measurement finds too far goes up again. Where all
// faces need about the same, some fall and some just do not, and the seams between them cost more
// faces than an even painting, so that is tried in the end.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "limn/comparison/limit_distance.h"
#include "limn/painting/auto_depth/tolerance.h"
#include "limn/part_of_progress.h"
#include "limn/subdivision/label_subdivision.h"
#include "limn/subdivision/prediction.h"
#include "painting/auto_depth/first_step.h"

namespace limn {
namespace {

/// A level goes only where this part of the distance is kept: faces that figures do not depend on
/// are measured with fewer samples, which miss a little.
constexpr double kSurelyWithin = 0.97;
/// How often what is too far is raised before it gets the depth it is estimated to need.
constexpr int kMostChecks = 3;
constexpr int kMostRounds = kMaxDepth + kMostChecks + 3;
/// Parts of a round.
constexpr double kLabelled = 0.05;
constexpr double kRefined = 0.2;
constexpr LimitDistanceLimits kMeasurement{.change = 0.03, .samples = std::size_t{1} << 24};

class Lowering {
 public:
  Lowering(const ControlMesh& mesh, const SubdivisionSettings& settings,
           std::span<const double> distances, Progress& progress)
      : mesh_(&mesh), settings_(&settings), distances_(distances), progress_(&progress) {}

  [[nodiscard]] Result<ChosenDepths> run(ChosenDepths chosen) {
    const FaceDepths estimated = chosen.depths;
    FaceDepths& depths = chosen.depths;
    std::vector<std::uint8_t> may_fall(depths.size());
    for (std::size_t f = 0; f < depths.size(); ++f) {
      may_fall[f] = depths[f] > 0 ? 1 : 0;
    }
    while (std::ranges::find(may_fall, 1) != may_fall.end()) {
      FaceDepths lower = depths;
      for (std::size_t f = 0; f < depths.size(); ++f) {
        lower.set(f, depths[f] - may_fall[f]);
      }
      const auto measured = measure(lower);
      if (!measured) {
        return tl::unexpected(measured.error());
      }
      for (std::size_t f = 0; f < depths.size(); ++f) {
        if (may_fall[f] != 0 && (*measured)[f] <= kSurelyWithin * distance(f)) {
          depths.set(f, lower[f]);
          may_fall[f] = lower[f] > 0 ? 1 : 0;
        } else {
          may_fall[f] = 0;
        }
      }
    }
    return check(std::move(chosen), estimated).and_then([&](ChosenDepths checked) {
      return even_or(std::move(checked));
    });
  }

 private:
  [[nodiscard]] double distance(std::size_t f) const {
    return distances_[distances_.size() == 1 ? 0 : f];
  }

  Result<ChosenDepths> check(ChosenDepths chosen, const FaceDepths& estimated) {
    for (int i = 0; i <= kMostChecks; ++i) {
      const auto measured = measure(chosen.depths);
      if (!measured) {
        return tl::unexpected(measured.error());
      }
      chosen.expected_error = *std::ranges::max_element(*measured);
      bool is_raised = false;
      if (has_lost_first_step(chosen.depths, estimated, *measured)) {
        const auto first =
            std::ranges::find_if(estimated.values(), [](int depth) { return depth > 0; });
        chosen.depths.set(static_cast<std::size_t>(first - estimated.values().begin()), 1);
        is_raised = true;
      }
      for (std::size_t f = 0; f < measured->size(); ++f) {
        const int depth = chosen.depths[f];
        if ((*measured)[f] > distance(f) && depth < estimated[f]) {
          chosen.depths.set(f, i + 1 < kMostChecks ? depth + 1 : estimated[f]);
          is_raised = true;
        }
      }
      if (!is_raised) {
        break;
      }
    }
    return chosen;
  }

  /// The uniform first step comes with the first face that is painted, and others may rely on it.
  [[nodiscard]] bool has_lost_first_step(const FaceDepths& depths, const FaceDepths& estimated,
                                         std::span<const double> measured) const {
    if (first_step_levels(*mesh_, *settings_) == 0 || depths.deepest() > 0 ||
        estimated.deepest() == 0) {
      return false;
    }
    for (std::size_t f = 0; f < measured.size(); ++f) {
      if (measured[f] > distance(f)) {
        return true;
      }
    }
    return false;
  }

  /// The deepest even painting of fewer faces, where it keeps all distances.
  Result<ChosenDepths> even_or(ChosenDepths chosen) {
    const Result<std::uint64_t> most = count(chosen.depths);
    if (!most) {
      return tl::unexpected(most.error());
    }
    FaceDepths even(mesh_->face_count());
    for (int depth = 0; depth <= chosen.depths.deepest(); ++depth) {
      FaceDepths deeper(mesh_->face_count(), depth);
      const Result<std::uint64_t> faces = count(deeper);
      if (!faces) {
        return tl::unexpected(faces.error());
      }
      if (*faces >= *most) {
        break;
      }
      even = std::move(deeper);
    }
    if (even.deepest() == 0) {
      return chosen;  // Lowering came by that.
    }
    const auto measured = measure(even);
    if (!measured) {
      return tl::unexpected(measured.error());
    }
    for (std::size_t f = 0; f < measured->size(); ++f) {
      if ((*measured)[f] > distance(f)) {
        return chosen;
      }
    }
    return ChosenDepths{std::move(even), *std::ranges::max_element(*measured), 0};
  }

  Result<std::uint64_t> count(const FaceDepths& depths) const {
    IgnoreProgress ignore;  // A moment, beside measuring.
    return legal_labels(*mesh_, depths.values(), *settings_, ignore)
        .map([&](const Legalisation& legal) {
          return predict_refinement(*mesh_, legal.labels).faces;
        });
  }

  /// The greatest distance of each control face's part of the refined mesh.
  Result<std::vector<double>> measure(const FaceDepths& depths) {
    const double begin = static_cast<double>(rounds_) / kMostRounds;
    ++rounds_;
    const auto part = [&](double from, double to) {
      return PartOfProgress(*progress_, begin + from / kMostRounds, begin + to / kMostRounds);
    };
    PartOfProgress labelling = part(0.0, kLabelled);
    const Result<Legalisation> legal = legal_labels(*mesh_, depths.values(), *settings_, labelling);
    if (!legal) {
      return tl::unexpected(legal.error());
    }
    PartOfProgress refining = part(kLabelled, kRefined);
    const Result<RefinedMesh> refined = refine(*mesh_, legal->labels, *settings_, {}, refining);
    if (!refined) {
      return tl::unexpected(refined.error());
    }
    PartOfProgress measuring = part(kRefined, 1.0);
    return measure_limit_distance(*mesh_, legal->labels, *settings_, *refined, measuring,
                                  kMeasurement)
        .map([&](const LimitDistance& measured) {
          std::vector<double> greatest(mesh_->face_count(), 0.0);
          for (std::size_t f = 0; f < refined->face_control_faces.size(); ++f) {
            double& of_face = greatest[refined->face_control_faces[f]];
            of_face = std::max<double>(of_face, measured.of_faces[f]);
          }
          return greatest;
        });
  }

  const ControlMesh* mesh_;
  const SubdivisionSettings* settings_;
  std::span<const double> distances_;
  Progress* progress_;
  int rounds_ = 1;  ///< Choosing by estimates was the first.
};

}  // namespace

Result<ChosenDepths> depths_for_measured_tolerance(const ControlMesh& mesh,
                                                   const SubdivisionSettings& settings,
                                                   std::span<const double> distances,
                                                   Progress& progress) {
  PartOfProgress first(progress, 0.0, 1.0 / kMostRounds);
  return depths_for_tolerance(mesh, settings, distances, first).and_then([&](ChosenDepths chosen) {
    return Lowering(mesh, settings, distances, progress).run(std::move(chosen));
  });
}

}  // namespace limn
