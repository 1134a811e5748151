#include "limn/painting/depth_choice.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "limn/contract.h"

namespace limn {
namespace {

int merged(int painted, int chosen, DepthMerge merge) {
  switch (merge) {
    case DepthMerge::kSet:
      return chosen;
    case DepthMerge::kMax:
      return std::max(painted, chosen);
    case DepthMerge::kMin:
      return std::min(painted, chosen);
    case DepthMerge::kAdd:
      return std::min(painted + chosen, kMaxDepth);
  }
  LIMN_EXPECTS(!"a known way to merge depths");
  return painted;
}

Result<std::vector<double>> distances_of(const ControlMesh& mesh, const ChooseByTolerance& choice,
                                         const PaintContext& context, Progress& progress) {
  switch (choice.unit) {
    case ChooseByTolerance::Unit::kDiagonals:
      return std::vector<double>{choice.distance * mesh.bounds().diagonal()};
    case ChooseByTolerance::Unit::kLength:
      return std::vector<double>{choice.distance};
    case ChooseByTolerance::Unit::kPixels:
      break;
  }
  return find_views(context, choice.views).and_then([&](const std::vector<ScreenView>& views) {
    return pixel_lengths(mesh, context.settings.corners, views, progress)
        .map([&](std::vector<double> lengths) {
          for (double& length : lengths) {
            length *= choice.distance;
          }
          return lengths;
        });
  });
}

/// Carries out each kind of choice.
struct Choose {
  using Chosen = Result<ChosenDepths>;

  const ControlMesh& mesh;
  const PaintContext& context;
  Progress& progress;
  const FinishDepths& finish;

  Chosen operator()(const ChooseByTolerance& choice) const {
    const auto distances = distances_of(mesh, choice, context, progress);
    if (!distances) {
      return tl::unexpected(distances.error());
    }
    return choice.is_measured
               ? depths_for_measured_tolerance(mesh, context.settings, *distances, progress)
               : depths_for_tolerance(mesh, context.settings, *distances, progress);
  }
  Chosen operator()(const FaceBudget& budget) const {
    return depths_for_budget(mesh, context.settings, {budget, finish, context.demands}, progress)
        .map([](BudgetedDepths budgeted) { return std::move(budgeted.chosen); });
  }
  Chosen operator()(const ChooseByScreen& choice) const {
    const auto views = find_views(context, choice.views);
    if (!views) {
      return tl::unexpected(views.error());
    }
    return depths_for_screen(mesh, context.settings, choice.size, *views, progress)
        .map([](FaceDepths depths) {
          return ChosenDepths{std::move(depths), 0.0, 0};
        });
  }
  Chosen operator()(const ChooseByCurve& choice) const {
    std::vector<ScreenView> views;
    if (info(choice.measure).needs_view) {
      auto found = find_views(context, choice.views);
      if (!found) {
        return tl::unexpected(std::move(found.error()));
      }
      views = *std::move(found);
    }
    const auto values = measure_faces(mesh, context.settings, choice.measure, views, progress);
    if (!values) {
      return tl::unexpected(values.error());
    }
    ChosenDepths chosen{FaceDepths(mesh.face_count()), 0.0, 0};
    for (std::size_t f = 0; f < values->size(); ++f) {
      chosen.depths.set(f, choice.curve((*values)[f]));
    }
    return chosen;
  }
};

}  // namespace

FaceDepths merged_depths(const FaceDepths& painted, const FaceDepths& chosen, DepthMerge merge,
                         const std::vector<bool>& is_chosen_face) {
  LIMN_EXPECTS(painted.size() == chosen.size());
  LIMN_EXPECTS(is_chosen_face.empty() || is_chosen_face.size() == painted.size());
  FaceDepths result = painted;
  for (std::size_t f = 0; f < painted.size(); ++f) {
    if (is_chosen_face.empty() || is_chosen_face[f]) {
      result.set(f, merged(painted[f], chosen[f], merge));
    }
  }
  return result;
}

Result<std::vector<ScreenView>> find_views(const PaintContext& context, const ViewNames& names) {
  if (!context.views) {
    return fail(ErrorKind::kUsage,
                "Sizes on the screen need a camera to see from, and here is none.");
  }
  std::vector<ScreenView> views;
  const auto add = [&](const std::string& name) -> Result<void> {
    Result<ScreenView> view = context.views(name);
    if (!view) {
      return tl::unexpected(std::move(view.error()));
    }
    views.push_back(*view);
    return {};
  };
  if (names.empty()) {
    if (auto added = add({}); !added) {
      return tl::unexpected(std::move(added.error()));
    }
  }
  for (const std::string& name : names) {
    if (auto added = add(name); !added) {
      return tl::unexpected(std::move(added.error()));
    }
  }
  return views;
}

Result<ChosenDepths> choose_depths(const ControlMesh& mesh, const DepthChoice& choice,
                                   DepthMerge merge, const PaintContext& context,
                                   const FaceDepths& painted,
                                   const std::vector<bool>& is_chosen_face) {
  const FinishDepths finish = [&](const FaceDepths& proposed) {
    return merged_depths(painted, proposed, merge, is_chosen_face);
  };
  IgnoreProgress ignore;
  Progress& progress = context.progress != nullptr ? *context.progress : ignore;
  return std::visit(Choose{mesh, context, progress, finish}, choice).map([&](ChosenDepths chosen) {
    chosen.depths = finish(chosen.depths);
    return chosen;
  });
}

}  // namespace limn
