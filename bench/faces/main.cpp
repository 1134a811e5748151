// limn_faces_bench [--quick] [--corpus=FOLDER] [--only=NAME]
// How many faces a mesh needs to be as near to its limit surface as a uniform one: writes all that
// was tried to standard output, as JSON. scripts/faces.sh runs it and writes the report.
#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "faces/optimum.h"
#include "faces/patches.h"
#include "faces/trials.h"
#include "limn/contract.h"
#include "limn/document/open.h"
#include "limn/mesh/bundled.h"

namespace {

using namespace limn;         // NOLINT(google-build-using-namespace)
using namespace limn::bench;  // NOLINT(google-build-using-namespace)
using nlohmann::json;

/// A uniform mesh that others are held against has no more faces than this, and levels than that.
constexpr std::uint64_t kMostUniformFaces = 26'000;
constexpr int kMostLevels = 4;

/// A distance that is asked for, in diagonals, whatever uniform meshes reach.
constexpr double kAskedTolerance = 0.001;
/// What keeps its tolerance by one measurement may miss it by another, with other samples; and an
/// even painting keeps its own distance and no less.
constexpr std::array kJustAboutTargets{0.99, 1.01};

/// Control meshes of the corpus: by artists, for games and films, remeshed, and for tests of
/// creases.
constexpr std::array kCorpusMeshes{
    "jdupuy/Bigguy.obj",
    "jdupuy/Monsterfrog.obj",
    "jdupuy/Rook.obj",
    "common3d/spot_control_mesh.obj",
    "common3d/suzanne.obj",
    "opensubdiv_shapes/catmark_pawn.obj",
    "opensubdiv_shapes/catmark_righthanded.obj",
    "opensubdiv_shapes/catmark_torus_creases0.obj",
    "opensubdiv_shapes/catmark_cubes_semisharp.obj",
    "geonum2016/cow.off",
    "geometry-central/cat_head.obj",
    "geometry-central/bob_small.ply",
    "pmp/fandisk_quads.off",
    "assimp/spider.obj",
};

struct Arguments {
  bool is_quick = false;
  std::string corpus;
  std::string only;
};

Subject with_points(Subject subject, SurfacePoints points) {
  subject.settings.points = points;
  return subject;
}

json to_json(const Trial& trial) {
  return {{"asked", trial.asked},
          {"faces", trial.faces},
          {"greatest", trial.greatest},
          {"rms", trial.root_mean_square}};
}

json to_json(const std::vector<Trial>& trials) {
  json all = json::array();
  for (const Trial& trial : trials) {
    all.push_back(to_json(trial));
  }
  return all;
}

/// The deepest level that a mesh is compared at.
int deepest_level(const ControlMesh& mesh) {
  std::uint64_t faces = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    faces += mesh.face(f).size();
  }
  int level = 1;
  while (level < kMostLevels && faces * 4 <= kMostUniformFaces) {
    faces *= 4;
    ++level;
  }
  return level;
}

/// All that is tried with one mesh.
class Comparison {
 public:
  Comparison(const ControlMesh& mesh, const SubdivisionSettings& settings)
      : at_level_(with_points({&mesh, settings}, SurfacePoints::kLevel)),
        at_limit_(with_points({&mesh, settings}, SurfacePoints::kLimit)) {}

  void run(int levels, bool is_curve_wanted) {
    for (int level = 0; level <= levels; ++level) {
      uniform_level_.push_back(try_uniform(at_level_, level));
      uniform_limit_.push_back(try_uniform(at_limit_, level));
    }
    const double greatest = uniform_level_.back().greatest;
    approach_by_tolerance(at_level_, Figure::kGreatest, greatest, level(), tolerance_level_);
    approach_at_limit(Figure::kGreatest, greatest);
    approach_at_limit(Figure::kGreatest, uniform_limit_.back().greatest);
    approach_at_limit(Figure::kRootMeanSquare, uniform_limit_.back().root_mean_square);
    for (const double target : {greatest, uniform_limit_.back().greatest}) {
      add_measured(target);
    }
    for (int level = 0; is_curve_wanted && level < levels; ++level) {
      add_to_curves(static_cast<std::size_t>(level));
    }
    asked_ = try_tolerance(at_limit_, kAskedTolerance);
    asked_measured_ = try_measured_tolerance(at_limit_, kAskedTolerance);
    patches_ = isolate_patches(at_limit_, uniform_limit_.back().greatest);
  }

  [[nodiscard]] json results() const {
    json patches = json::array();
    for (const Patches& isolated : patches_) {
      patches.push_back({{"isolation", isolated.isolation},
                         {"patches", isolated.patches},
                         {"greatest", isolated.greatest}});
    }
    return {{"uniform_level", to_json(uniform_level_)},
            {"uniform_limit", to_json(uniform_limit_)},
            {"tolerance_level", to_json(tolerance_level_)},
            {"tolerance_limit", to_json(tolerance_limit_)},
            {"budget_greatest", to_json(budget_greatest_)},
            {"budget_rms", to_json(budget_rms_)},
            {"measured_limit", to_json(measured_limit_)},
            {"asked_tolerance", to_json(asked_)},
            {"asked_measured", to_json(asked_measured_)},
            {"patches", patches}};
  }

 private:
  /// Fewest faces for a figure of a uniform mesh, with vertices on the limit surface.
  void approach_at_limit(Figure figure, double target) {
    approach_by_tolerance(at_limit_, figure, target, level(), tolerance_limit_);
    const Trial* const known = fewest_faces(tolerance_limit_, figure, target);
    approach_by_budget(at_limit_, figure, target,
                       known != nullptr ? known->faces : uniform_limit_.back().faces,
                       figure == Figure::kGreatest ? budget_greatest_ : budget_rms_);
  }

  [[nodiscard]] int level() const { return static_cast<int>(uniform_limit_.size()) - 1; }

  void add_measured(double target) {
    for (const double just_about : kJustAboutTargets) {
      measured_limit_.push_back(try_measured_tolerance(at_limit_, just_about * target));
    }
  }

  /// Fewer faces: what a coarser uniform mesh reaches.
  void add_to_curves(std::size_t level) {
    tolerance_level_.push_back(try_tolerance(at_level_, 1.3 * uniform_level_[level].greatest));
    tolerance_limit_.push_back(try_tolerance(at_limit_, 1.3 * uniform_limit_[level].greatest));
    add_measured(uniform_limit_[level].greatest);
    const std::uint64_t faces = tolerance_limit_.back().faces;
    budget_greatest_.push_back(try_budget(at_limit_, faces, FaceBudget::Goal::kGreatest));
    budget_rms_.push_back(try_budget(at_limit_, faces, FaceBudget::Goal::kMeanSquare));
  }

  Subject at_level_;
  Subject at_limit_;
  std::vector<Trial> uniform_level_;
  std::vector<Trial> uniform_limit_;
  std::vector<Trial> tolerance_level_;
  std::vector<Trial> tolerance_limit_;
  std::vector<Trial> measured_limit_;  ///< By tolerances, measured while choosing.
  std::vector<Trial> budget_greatest_;
  std::vector<Trial> budget_rms_;
  Trial asked_;
  Trial asked_measured_;
  std::vector<Patches> patches_;
};

json compare(const std::string& name, const std::string& source, const Document& document) {
  const ControlMesh& mesh = *document.control;
  const int levels = deepest_level(mesh);
  Comparison comparison(mesh, document.settings);
  comparison.run(levels, true);
  json result = comparison.results();
  result["name"] = name;
  result["source"] = source;
  result["faces"] = mesh.face_count();
  result["is_all_quads"] = mesh.is_all_quads();
  result["level"] = levels;
  return result;
}

json compare_small(const SmallMesh& small) {
  const Subject subject = with_points({small.mesh.get(), {.non_quads = NonQuadRule::kWherePainted}},
                                      SurfacePoints::kLimit);
  const int level = small.mesh->is_all_quads() ? 2 : 3;
  const Trial uniform = try_uniform(subject, level);
  // Between what uniform meshes reach a painting has most to choose from.
  const double coarser = try_uniform(subject, level - 1).greatest;
  json targets = json::array();
  for (const double target : {uniform.greatest, std::sqrt(uniform.greatest * coarser)}) {
    std::vector<Trial> by_tolerance;
    approach_by_tolerance(subject, Figure::kGreatest, target, level, by_tolerance);
    std::vector<Trial> by_budget;
    approach_by_budget(subject, Figure::kGreatest, target, uniform.faces, by_budget);
    targets.push_back({{"target", target},
                       {"uniform", uniform.faces},
                       {"optimum", to_json(optimal_painting(subject, target))},
                       {"tolerance", to_json(by_tolerance)},
                       {"budget", to_json(by_budget)}});
  }
  return {{"name", small.name}, {"faces", small.mesh->face_count()}, {"targets", targets}};
}

/// What the command line says; nothing where it says what nobody understands.
std::optional<Arguments> parse(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    constexpr std::string_view kCorpus = "--corpus=";
    constexpr std::string_view kOnly = "--only=";
    if (argument == "--quick") {
      arguments.is_quick = true;
    } else if (argument.starts_with(kCorpus)) {
      arguments.corpus = argument.substr(kCorpus.size());
    } else if (argument.starts_with(kOnly)) {
      arguments.only = argument.substr(kOnly.size());
    } else {
      std::cerr << "limn_faces_bench: unknown argument " << argument << "\n";
      return std::nullopt;
    }
  }
  return arguments;
}

int run(const Arguments& arguments) {
  json meshes = json::array();
  const auto add = [&](const std::string& name, const std::string& source,
                       const std::string& file) {
    if (!arguments.only.empty() && arguments.only != name) {
      return;
    }
    const Result<Project> project = open_document(file);
    LIMN_EXPECTS(project.has_value());
    std::cerr << name << std::endl;
    meshes.push_back(compare(name, source, project->document));
  };
  for (const BundledMesh& bundled : bundled_meshes()) {
    add(std::string(bundled.name), "bundled", std::string(bundled.name));
  }
  if (!arguments.corpus.empty() && !arguments.is_quick) {
    for (const char* file : kCorpusMeshes) {
      const std::filesystem::path path = std::filesystem::path(arguments.corpus) / file;
      if (std::filesystem::exists(path)) {
        add(path.stem().string(), path.parent_path().filename().string(), path.string());
      }
    }
  }
  json small = json::array();
  for (const SmallMesh& mesh : small_meshes()) {
    if (arguments.only.empty() || arguments.only == "small") {
      std::cerr << mesh.name << std::endl;
      small.push_back(compare_small(mesh));
    }
  }
  std::cout << json{{"meshes", meshes}, {"small", small}}.dump(1) << "\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::optional<Arguments> arguments = parse(argc, argv);
    return arguments ? run(*arguments) : 2;
  } catch (const std::exception& error) {
    std::cerr << "limn_faces_bench: " << error.what() << "\n";
    return 1;
  }
}
