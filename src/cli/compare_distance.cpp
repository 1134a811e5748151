#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>

#include "cli/compare.h"
#include "cli/console.h"
#include "cli/input.h"
#include "cli/view_options.h"
#include "limn/comparison/surface_distance.h"
#include "limn/document/measured_refinement.h"
#include "limn/subdivision/label_subdivision.h"

namespace limn::cli {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

constexpr std::string_view kLimit = "limit";

struct DistanceOptions {
  PaintingOptions painting;
  ViewOptions view;
  std::string to;
  bool json = false;
};

/// The figures of both directions, and what they are of.
struct Distances {
  std::string mesh;
  std::string other;
  std::size_t vertices = 0;
  std::size_t faces = 0;
  double diagonal = 0.0;
  DirectedDistance to_other;
  DirectedDistance from_other;
  bool is_settled = false;
  double seconds = 0.0;
};

Json point_json(const glm::dvec3& p) {
  return {p.x, p.y, p.z};
}

Json directed_json(const DirectedDistance& distance) {
  return {{"greatest", distance.greatest}, {"root_mean_square", distance.root_mean_square},
          {"area", distance.area},         {"from", point_json(distance.from)},
          {"to", point_json(distance.to)}, {"samples", distance.samples}};
}

Json distances_json(const Distances& distances) {
  const double greatest = greatest_of(distances.to_other, distances.from_other);
  const double mean = root_mean_square_of(distances.to_other, distances.from_other);
  return {{"mesh", distances.mesh},
          {"vertices", distances.vertices},
          {"faces", distances.faces},
          {"compared_with", distances.other},
          {"diagonal", distances.diagonal},
          {"greatest", greatest},
          {"greatest_of_diagonal", greatest / distances.diagonal},
          {"root_mean_square", mean},
          {"root_mean_square_of_diagonal", mean / distances.diagonal},
          {"there", directed_json(distances.to_other)},
          {"back", directed_json(distances.from_other)},
          {"is_settled", distances.is_settled},
          {"seconds", distances.seconds}};
}

void print_row(std::string_view name, double greatest, double mean, double diagonal) {
  fmt::print("{:<14} {:>12.6g} {:>9.5f} % {:>12.6g} {:>9.5f} %\n", name, greatest,
             100.0 * greatest / diagonal, mean, 100.0 * mean / diagonal);
}

void print_table(const Distances& distances) {
  const DirectedDistance& there = distances.to_other;
  const DirectedDistance& back = distances.from_other;
  fmt::print("{}: {} vertices, {} faces; diagonal {:.6g}\n", distances.mesh, distances.vertices,
             distances.faces, distances.diagonal);
  fmt::print("{:<14} {:>12} {:>11} {:>12} {:>11}\n", "distance", "greatest", "of diagonal",
             "r.m.s.", "of diagonal");
  print_row(fmt::format("to {}", distances.other == kLimit ? "the limit" : "the other"),
            there.greatest, there.root_mean_square, distances.diagonal);
  print_row("back", back.greatest, back.root_mean_square, distances.diagonal);
  print_row("both ways", greatest_of(there, back), root_mean_square_of(there, back),
            distances.diagonal);
  const DirectedDistance& farthest = there.greatest >= back.greatest ? there : back;
  fmt::print("greatest between ({:.6g}, {:.6g}, {:.6g}) and ({:.6g}, {:.6g}, {:.6g})\n",
             farthest.from.x, farthest.from.y, farthest.from.z, farthest.to.x, farthest.to.y,
             farthest.to.z);
}

/// A mesh, refined as painted where it is.
struct PaintedMesh {
  Project project;
  Derived derived;
  int levels = 0;  ///< That were made at most.

  [[nodiscard]] std::shared_ptr<const ControlMesh> surface() const {
    const Document& document = project.document;
    return derived.refinement ? to_control_mesh(*derived.refinement->mesh, document.control.get())
                              : document.control;
  }
};

/// A refined mesh in a file still has the depths it was made with: to be refined once more takes
/// rules.
Result<PaintedMesh> open_refined(PaintingOptions options, const ViewOptions& view) {
  if (options.rules.empty() && !options.input.ends_with(kProjectEnding)) {
    options.levels = 0;
  }
  Result<Project> project = open_painted(options, paint_context_from(view));
  if (!project) {
    return tl::unexpected(std::move(project.error()));
  }
  Result<Derived> derived = derive(*project, options);
  if (!derived) {
    return tl::unexpected(std::move(derived.error()));
  }
  return PaintedMesh{*std::move(project), *std::move(derived), options.levels};
}

Result<void> measure_to_limit(const PaintedMesh& mesh, Distances& distances) {
  TerminalProgress progress;
  const Derived& derived = mesh.derived;
  const Result<MeasuredRefinement> measured =
      measure_refinement(mesh.project.document, derived.labels, mesh.levels,
                         derived.refinement ? derived.refinement->mesh : nullptr, progress);
  if (!measured) {
    return tl::unexpected(measured.error());
  }
  distances.vertices = measured->mesh->vertex_count();
  distances.faces = measured->mesh->face_count();
  distances.to_other = measured->distance.to_limit;
  distances.from_other = measured->distance.from_limit;
  distances.is_settled = measured->distance.is_settled;
  return {};
}

Result<void> measure_to_mesh(const PaintedMesh& mesh, const std::string& path,
                             Distances& distances) {
  PaintingOptions as_painted;
  as_painted.input = path;
  const Result<PaintedMesh> other = open_refined(as_painted, {});
  if (!other) {
    return tl::unexpected(other.error());
  }
  const std::shared_ptr<const ControlMesh> surface = mesh.surface();
  TerminalProgress progress;
  const Result<SurfaceDistance> measured =
      measure_surface_distance(*surface, *other->surface(), progress);
  if (!measured) {
    return tl::unexpected(measured.error());
  }
  distances.vertices = surface->vertex_count();
  distances.faces = surface->face_count();
  distances.to_other = measured->to_other;
  distances.from_other = measured->from_other;
  distances.is_settled = measured->is_settled;
  return {};
}

Result<void> compare_distance(const DistanceOptions& options) {
  const std::shared_ptr<void> threads = limit_threads(options.painting.threads);
  const Result<PaintedMesh> mesh = open_refined(options.painting, options.view);
  if (!mesh) {
    return tl::unexpected(mesh.error());
  }
  const Document& document = mesh->project.document;
  Distances distances;
  distances.mesh = document.name;
  distances.other = options.to;
  distances.diagonal = document.control->bounds().diagonal();
  const Clock::time_point start = Clock::now();
  Result<void> measured = options.to == kLimit ? measure_to_limit(*mesh, distances)
                                               : measure_to_mesh(*mesh, options.to, distances);
  if (!measured) {
    return measured;
  }
  distances.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  if (!distances.is_settled) {
    print_warning(
        "the figures still changed by more than 1 % when the last samples were added; they are "
        "those of the most samples that were taken");
  }
  if (options.json) {
    fmt::print("{}\n", distances_json(distances).dump(2));
  } else {
    print_table(distances);
  }
  return {};
}

}  // namespace

void add_distance_options(CLI::App& compare, Work& work) {
  const auto options = std::make_shared<DistanceOptions>();
  CLI::Option* input = compare.add_option(
      "IN", options->painting.input,
      "A mesh file (.obj, .ply, .off or .stl), a project (.limn), the name of a bundled mesh, or - "
      "for a mesh on standard input. A project is refined as it is painted, and a mesh where "
      "--paint says so; the faces of a mesh alone are taken as they are");
  CLI::Option* to =
      compare
          .add_option(
              "--to", options->to,
              "limit: the surface that the control mesh tends to. Or another mesh, named "
              "like IN; a painted project is refined. Faces are the triangles that STL files "
              "get")
          ->type_name("WHAT");
  add_painting_options(compare, options->painting);
  add_view_options(compare, options->view);
  compare.add_flag("--json", options->json, "JSON on standard output");
  compare.callback([&compare, options, input, to, &work] {
    if (!compare.get_subcommands().empty()) {
      if (to->count() > 0) {
        throw CLI::ValidationError("--to", kSphereIsNoMesh);
      }
      return;
    }
    if (input->count() == 0 || to->count() == 0) {
      throw CLI::RequiredError("IN and --to, or sphere");
    }
    work = [options] { return compare_distance(*options); };
  });
}

}  // namespace limn::cli
