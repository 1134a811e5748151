#include "cli/report.h"

#include <cmath>
#include <iterator>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/fine_option.h"
#include "limn/painting/crease_palette.h"
#include "limn/subdivision/legalisation_trace.h"

namespace limn::cli {
namespace {

using Json = nlohmann::ordered_json;

Json point(const glm::dvec3& p) {
  return {p.x, p.y, p.z};
}

/// 1234567 as "1,234,567".
std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::ptrdiff_t at = std::ssize(digits) - 3; at > 0; at -= 3) {
    digits.insert(static_cast<std::size_t>(at), 1, ',');
  }
  return digits;
}

/// Lines of a table: a name and what belongs to it.
class Table {
 public:
  void row(std::string_view name, std::string_view value) {
    fmt::format_to(std::back_inserter(text_), "{:<22}{}\n", name, value);
  }
  void count(std::string_view name, std::uint64_t value) { row(name, grouped(value)); }
  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

std::string sides_name(std::size_t sides) {
  switch (sides) {
    case 3:
      return "triangles";
    case 4:
      return "quads";
    case 5:
      return "pentagons";
    case 6:
      return "hexagons";
    default:
      return fmt::format("{}-gons", sides);
  }
}

std::string painted_text(const FaceDepths& depths) {
  std::string text;
  const auto histogram = depths.histogram();
  for (std::size_t depth = 0; depth < histogram.size(); ++depth) {
    if (histogram[depth] > 0) {
      fmt::format_to(std::back_inserter(text), "{}{} at {}", text.empty() ? "" : ", ",
                     grouped(histogram[depth]), depth);
    }
  }
  return text;
}

/// How many faces fewer than uniform subdivision to the same depth, in per cent.
double saving_percent(const RefinementPrediction& prediction) {
  if (prediction.uniform_faces == 0) {
    return 0.0;
  }
  return 100.0 * (1.0 - static_cast<double>(prediction.faces) /
                            static_cast<double>(prediction.uniform_faces));
}

/// What is written: the refined mesh, or the control mesh where no level is made.
RefinementPrediction result_counts(const Document& document, const Derived& derived) {
  if (derived.refinement) {
    return derived.refinement->prediction;
  }
  if (derived.on_gpu) {
    return derived.on_gpu->prediction;
  }
  const ControlMesh& control = *document.control;
  RefinementPrediction counts;
  counts.faces = control.face_count();
  counts.vertices = control.vertex_count();
  counts.edges = control.edge_count();
  counts.uniform_faces = control.face_count();
  return counts;
}

std::string amount_of(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", grouped(count), count == 1 ? one : many);
}

/// "12 edges, 1 vertex (9 up to 2, 4 infinite)".
std::string creases_text(const ControlMesh& mesh, const MeshStatistics& counts) {
  if (counts.crease_edges + counts.sharp_vertices == 0) {
    return "none";
  }
  std::string bands;
  const CreaseCounts by_band = count_creases(mesh);
  for (std::size_t band = 0; band < by_band.size(); ++band) {
    if (by_band[band] > 0) {
      fmt::format_to(std::back_inserter(bands), "{}{} {}", bands.empty() ? " (" : ", ",
                     grouped(by_band[band]), sharpness_band_name(band));
    }
  }
  return fmt::format("{}, {}{}){}", amount_of(counts.crease_edges, "edge", "edges"),
                     amount_of(counts.sharp_vertices, "vertex", "vertices"), bands,
                     mesh.creases().method == CreasingMethod::kChaikin ? ", Chaikin" : "");
}

std::string texture_text(const MeshStatistics& counts) {
  if (counts.uv_points == 0) {
    return "none";
  }
  return fmt::format("{}, {}", amount_of(counts.uv_points, "point", "points"),
                     amount_of(counts.uv_seams, "seam edge", "seam edges"));
}

std::string verdict_of(const CrackCheck& cracks) {
  if (cracks.is_watertight()) {
    return "no cracks";
  }
  return fmt::format(
      "{} crack edges, {} non-manifold edges, {} control faces without a face, {} vertices without "
      "one",
      cracks.boundary_edges - cracks.control_boundary_edges, cracks.nonmanifold_edges,
      cracks.missing_control_faces, cracks.unused_vertices);
}

}  // namespace

Json control_report(const Document& document) {
  const MeshStatistics counts = mesh_statistics(*document.control);
  const Bounds& bounds = document.control->bounds();
  const ImportReport& mended = document.import_report;
  Json mended_counts = Json::object();
  for (std::size_t kind = 0; kind < kMendKindCount; ++kind) {
    mended_counts[std::string(name_of(MendKind(kind)))] = mended.count(MendKind(kind));
  }
  Json sides = Json::object();
  for (const auto& [side_count, faces] : counts.faces_by_sides) {
    sides[std::to_string(side_count)] = faces;
  }
  return {
      {"name", document.name},
      {"vertices", counts.vertices},
      {"edges", counts.edges},
      {"faces", counts.faces},
      {"faces_by_sides", sides},
      {"boundary_edges", counts.boundary_edges},
      {"boundary_loops", counts.boundary_loops},
      {"components", counts.components},
      {"euler_characteristic", counts.euler_characteristic},
      {"highest_valence", counts.highest_valence},
      {"crease_edges", counts.crease_edges},
      {"sharp_vertices", counts.sharp_vertices},
      {"uv_points", counts.uv_points},
      {"uv_seams", counts.uv_seams},
      {"bounds", {{"low", point(bounds.low)}, {"high", point(bounds.high)}}},
      {"mended", mended_counts},
      {"unused_data", mended.unused_data},
  };
}

Json legalisation_report(const Document& document, const Derived& derived) {
  const DerivedLabels& labels = derived.labels;
  const LegalisationTrace trace(document.control, labels.painted, labels.legal,
                                document.settings.non_quads, document.settings.legalisation);
  const bool is_greedy = trace.order() == LegalisationMethod::kGreedy;
  Json moves = Json::array();
  for (std::size_t i = 0; i < trace.size(); ++i) {
    Json vertices = Json::array();
    for (const LegalisationStep& step : trace.move(i)) {
      vertices.push_back(step.vertex);
    }
    const LegalisationStep& first = trace.move(i).front();
    Json move = {{"vertices", vertices}, {"label", first.label}};
    if (first.label > 0 && is_greedy) {
      move["illegal_neighbours"] = first.valence;
      move["cost"] = first.cost;
    } else if (first.label > 0) {
      // In tenths, as it is counted: what a float adds is noise.
      move["score"] = std::round(10.0 * static_cast<double>(first.score)) / 10.0;
    }
    moves.push_back(move);
  }
  return {{"order", is_greedy ? "greedy" : "look-ahead"}, {"moves", moves}};
}

Json refinement_report(const Document& document, const Derived& derived) {
  const RefinementPrediction counts = result_counts(document, derived);
  const DerivedLabels& labels = derived.labels;
  Json by_depth = Json::object();
  const auto histogram = document.depths.histogram();
  for (std::size_t depth = 0; depth < histogram.size(); ++depth) {
    if (histogram[depth] > 0) {
      by_depth[std::to_string(depth)] = histogram[depth];
    }
  }
  Json report = {
      {"control_faces", document.control->face_count()},
      {"faces_by_depth", by_depth},
      {"demands", document.demands.size()},
      {"illegal_faces", labels.illegal_faces.size()},
      {"illegal_vertices", labels.illegal_vertices.size()},
      {"relabelled_vertices", labels.raised_vertices.size()},
      {"deepened_faces", labels.deepened_faces},
      {"levels", counts.levels},
      {"faces", counts.faces},
      {"vertices", counts.vertices},
      {"edges", counts.edges},
      {"uniform_faces", counts.uniform_faces},
      {"saving_percent", saving_percent(counts)},
      {"seconds", {{"labels", labels.seconds}}},
  };
  if (derived.refinement) {
    const Refinement& refinement = *derived.refinement;
    const CrackCheck& cracks = refinement.cracks;
    report["bytes"] = counts.bytes;
    report["quads"] = refinement.mesh->quads.size();
    report["other_faces"] = refinement.mesh->polygon_count();
    report["watertight"] = cracks.is_watertight();
    report["boundary_edges"] = cracks.boundary_edges;
    report["crack_edges"] = cracks.boundary_edges - cracks.control_boundary_edges;
    report["nonmanifold_edges"] = cracks.nonmanifold_edges;
    report["missing_control_faces"] = cracks.missing_control_faces;
    report["unused_vertices"] = cracks.unused_vertices;
    report["seconds"]["refine"] = refinement.refine_seconds;
    report["seconds"]["check"] = refinement.check_seconds;
  }
  if (derived.on_gpu) {
    report["bytes"] = counts.bytes;
    report["quads"] = derived.on_gpu->quads;
    report["other_faces"] = derived.on_gpu->other_faces;
    report["refined_on"] = derived.on_gpu->renderer;
    report["seconds"]["refine"] = derived.on_gpu->seconds;
  }
  return report;
}

std::string control_text(const Document& document) {
  const MeshStatistics counts = mesh_statistics(*document.control);
  const Bounds& bounds = document.control->bounds();
  const glm::dvec3 size = bounds.high - bounds.low;
  Table table;
  table.row("mesh", document.name);
  table.count("vertices", counts.vertices);
  table.count("edges", counts.edges);
  table.count("faces", counts.faces);
  for (const auto& [side_count, faces] : counts.faces_by_sides) {
    table.count("  " + sides_name(side_count), faces);
  }
  table.count("boundary edges", counts.boundary_edges);
  table.count("boundary loops", counts.boundary_loops);
  table.count("components", counts.components);
  table.row("Euler characteristic", std::to_string(counts.euler_characteristic));
  table.count("highest valence", counts.highest_valence);
  table.row("creases", creases_text(*document.control, counts));
  table.row("texture", texture_text(counts));
  table.row("size", fmt::format("{:.6g} x {:.6g} x {:.6g}", size.x, size.y, size.z));
  table.row("painted", painted_text(document.depths));
  if (const auto demands = demands_text(document)) {
    table.row("finer than faces", *demands);
  }
  return table.take();
}

std::string refinement_text(const Document& document, const Derived& derived) {
  const RefinementPrediction counts = result_counts(document, derived);
  Table table;
  table.row("painted", painted_text(document.depths));
  if (const auto demands = demands_text(document)) {
    table.row("finer than faces", *demands);
  }
  if (document.settings.scheme == RefinementScheme::kLoop) {
    table.count("faces deepened", derived.labels.deepened_faces);
  } else {
    table.count("illegal vertices", derived.labels.illegal_vertices.size());
    table.count("relabelled", derived.labels.raised_vertices.size());
  }
  table.row("levels", std::to_string(counts.levels));
  table.count("faces", counts.faces);
  table.count("vertices", counts.vertices);
  table.row("uniform faces", fmt::format("{} (saving {:.1f} %)", grouped(counts.uniform_faces),
                                         saving_percent(counts)));
  if (derived.refinement) {
    const CrackCheck& cracks = derived.refinement->cracks;
    table.row("crack check", verdict_of(cracks));
    table.row("seconds",
              fmt::format("{:.3f} labels, {:.3f} refine, {:.3f} check", derived.labels.seconds,
                          derived.refinement->refine_seconds, derived.refinement->check_seconds));
  }
  return table.take();
}

}  // namespace limn::cli
