#include "legalisation_table.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "limn/contract.h"
#include "limn/mesh/build.h"
#include "limn/subdivision/legalisation.h"
#include "limn/subdivision/prediction.h"
#include "meshes.h"
#include "paintings.h"
#include "subdivision/legalisation_optimum.h"

namespace limn::bench {
namespace {

constexpr NonQuadRule kRule = NonQuadRule::kWherePainted;

/// What legalisation did to one or more paintings.
struct Sums {
  std::uint64_t relabels = 0;
  std::uint64_t faces = 0;

  void add(const ControlMesh& mesh, const VertexLabels& painted, const VertexLabels& labels) {
    for (std::size_t v = 0; v < labels.size(); ++v) {
      relabels += painted[v] == 0 && labels[v] > 0 ? 1 : 0;
    }
    faces += predict_refinement(mesh, labels).faces;
  }
};

/// One line of a table.
struct Line {
  std::uint64_t illegal = 0;  ///< Vertices, by the paper's rule.
  Sums greedy;
  Sums look_ahead;
};

VertexLabels legalised(const ControlMesh& mesh, const VertexLabels& painted, bool looks_ahead) {
  IgnoreProgress progress;
  Result<Legalisation> legal = looks_ahead ? legalise_look_ahead(mesh, painted, kRule, progress)
                                           : legalise_greedy(mesh, painted, kRule, progress);
  LIMN_EXPECTS(legal.has_value());
  return std::move(legal->labels);
}

void add_painting(Line& line, const ControlMesh& mesh, const VertexLabels& painted) {
  line.illegal += illegal_vertices(mesh, painted).size();
  line.greedy.add(mesh, painted, legalised(mesh, painted, false));
  line.look_ahead.add(mesh, painted, legalised(mesh, painted, true));
}

std::string percent_fewer(const Sums& sums, const Sums& than) {
  return fmt::format("{:.1f} %", 100.0 - 100.0 * static_cast<double>(sums.faces) /
                                             static_cast<double>(than.faces));
}

/// Meshes as artists have them, and large tori.
bool write_large(std::ostream& out) {
  out << "| mesh | painted to depth 3 | illegal vertices | relabels greedy | look-ahead | "
         "faces greedy | look-ahead | fewer |\n|---|---|--:|--:|--:|--:|--:|--:|\n";
  bool holds = true;
  const auto write = [&](const std::string& name, const ControlMesh& mesh) {
    for (const Layout layout : {Layout::kPatches, Layout::kScattered}) {
      for (const int percent : {1, 5, 20, 50}) {
        Line line;
        add_painting(line, mesh,
                     apply_non_quad_rule(
                         mesh, vertex_labels(mesh, depths_of(mesh, {layout, percent, 3})), kRule));
        holds = holds && line.look_ahead.faces <= line.greedy.faces;
        fmt::print(out, "| {} | {} %, {} | {} | {} | {} | {} | {} | {} |\n", name, percent,
                   layout == Layout::kPatches ? "patches" : "scattered", line.illegal,
                   line.greedy.relabels, line.look_ahead.relabels, line.greedy.faces,
                   line.look_ahead.faces, percent_fewer(line.look_ahead, line.greedy));
      }
    }
  };
  for (const char* name : {"teapot", "creature", "torus_open", "mixed", "asteroid_15k"}) {
    write(name, control_mesh(name));
  }
  write("torus 64 x 64", torus(64));
  write("torus 256 x 256", torus(256));
  return holds;
}

/// Many random paintings of small meshes, those that can be solved.
bool write_small(std::ostream& out) {
  constexpr std::uint32_t kPaintings = 200;
  constexpr std::size_t kMostWidth = 17;
  out << "| mesh | painted | paintings solved | relabels greedy | look-ahead | optimum | faces "
         "greedy | look-ahead | optimum | look-ahead optimal in |\n"
         "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  bool holds = true;
  const auto write = [&](const std::string& name, const ControlMesh& mesh) {
    for (const double part : {0.03, 0.1, 0.3}) {
      Line line;
      Sums optimum;
      int solved = 0;
      int optimal = 0;
      for (std::uint32_t seed = 0; seed < kPaintings; ++seed) {
        const VertexLabels painted = random_labels(mesh, part, seed);
        const auto best = test::optimal_legalisation(mesh, painted, kRule,
                                                     test::LegalisationGoal::kFaces, kMostWidth);
        if (!best) {
          continue;
        }
        ++solved;
        const Line before = line;
        add_painting(line, mesh, painted);
        optimum.relabels += best->relabels;
        optimum.faces += best->faces;
        const std::uint64_t faces = line.look_ahead.faces - before.look_ahead.faces;
        optimal += faces == best->faces ? 1 : 0;
        holds = holds && faces <= line.greedy.faces - before.greedy.faces;
      }
      const auto mean = [&](std::uint64_t sum) {
        return solved == 0 ? 0.0 : static_cast<double>(sum) / solved;
      };
      fmt::print(
          out,
          "| {} | {} % | {} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.0f} % |\n",
          name, std::lround(100.0 * part), solved, mean(line.greedy.relabels),
          mean(line.look_ahead.relabels), mean(optimum.relabels), mean(line.greedy.faces),
          mean(line.look_ahead.faces), mean(optimum.faces),
          solved == 0 ? 0.0 : 100.0 * optimal / solved);
    }
  };
  write("cube", control_mesh("cube"));
  write("grid", control_mesh("grid"));
  write("torus 8 x 8", torus(8));
  write("torus 10 x 10", torus(10));
  return holds;
}

}  // namespace

ControlMesh torus(std::uint32_t n) {
  LIMN_EXPECTS(n >= 3);
  PolygonSoup soup;
  const double turn = 2.0 * std::numbers::pi / n;
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x < n; ++x) {
      const double radius = 2.0 + std::cos(turn * x);
      soup.positions.emplace_back(radius * std::cos(turn * y), radius * std::sin(turn * y),
                                  std::sin(turn * x));
      const std::uint32_t right = (x + 1) % n;
      const std::uint32_t up = (y + 1) % n;
      soup.add_face(std::array{y * n + x, up * n + x, up * n + right, y * n + right});
    }
  }
  const Result<ImportedMesh> built = build_control_mesh(soup);
  LIMN_EXPECTS(built.has_value());
  return *built->mesh;
}

VertexLabels random_labels(const ControlMesh& mesh, double part, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto least = static_cast<std::uint32_t>(part * static_cast<double>(std::mt19937::max()));
  std::vector<std::uint8_t> depths(mesh.face_count());
  for (std::uint8_t& depth : depths) {
    depth = random() < least ? 3 : 0;
  }
  return apply_non_quad_rule(mesh, vertex_labels(mesh, depths), kRule);
}

bool write_legalisation_tables(std::ostream& out) {
  const bool large = write_large(out);
  out << "\n";
  return write_small(out) && large;
}

}  // namespace limn::bench
