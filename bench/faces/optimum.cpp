#include "faces/optimum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include "limn/contract.h"
#include "limn/mesh/build.h"
#include "limn/mesh/bundled.h"
#include "limn/subdivision/label_subdivision.h"
#include "limn/subdivision/prediction.h"

namespace limn::bench {
namespace {

std::shared_ptr<const ControlMesh> build(const PolygonSoup& soup) {
  const Result<ImportedMesh> built = build_control_mesh(soup);
  LIMN_EXPECTS(built.has_value());
  return built->mesh;
}

/// An open grid of quads with heights.
template <class Height>
std::shared_ptr<const ControlMesh> sheet(std::uint32_t width, std::uint32_t depth,
                                         const Height& height) {
  PolygonSoup soup;
  for (std::uint32_t y = 0; y <= depth; ++y) {
    for (std::uint32_t x = 0; x <= width; ++x) {
      soup.positions.emplace_back(x, y, height(x, y));
    }
  }
  for (std::uint32_t y = 0; y < depth; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      const std::uint32_t v = y * (width + 1) + x;
      soup.add_face(std::array{v, v + 1, v + width + 2, v + width + 1});
    }
  }
  return build(soup);
}

/// A bundled mesh whose first vertex is pulled away from the centre.
std::shared_ptr<const ControlMesh> pulled(std::string_view name, double by) {
  const Result<ImportedMesh> bundled = load_bundled_mesh(name);
  LIMN_EXPECTS(bundled.has_value());
  const ControlMesh& mesh = *bundled->mesh;
  PolygonSoup soup;
  soup.positions.assign(mesh.positions().begin(), mesh.positions().end());
  soup.positions[0] += by * (soup.positions[0] - mesh.bounds().centre());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    soup.add_face(mesh.face(f));
  }
  return build(soup);
}

std::shared_ptr<const ControlMesh> tetrahedron(double height) {
  PolygonSoup soup;
  soup.positions = {{1.0, 0.0, 0.0}, {-0.5, 0.8, 0.0}, {-0.5, -0.8, 0.0}, {0.0, 0.0, height}};
  soup.add_face(std::array{0U, 2U, 1U});
  soup.add_face(std::array{0U, 1U, 3U});
  soup.add_face(std::array{1U, 2U, 3U});
  soup.add_face(std::array{2U, 0U, 3U});
  return build(soup);
}

/// Labels and how many faces they make. As text, which compares well.
using Candidate = std::pair<std::uint64_t, std::string>;

VertexLabels labels_of(const std::string& text) {
  return {text.begin(), text.end()};
}

/// Every painting once, those with the fewest faces first.
std::vector<Candidate> all_paintings(const Subject& subject) {
  const std::size_t faces = subject.mesh->face_count();
  IgnoreProgress progress;
  std::set<Candidate> all;
  std::vector<std::uint8_t> depths(faces, 0);
  for (bool is_more = true; is_more;) {
    const Result<Legalisation> legal =
        legal_labels(*subject.mesh, depths, subject.settings, progress);
    LIMN_EXPECTS(legal.has_value());
    all.insert({predict_refinement(*subject.mesh, legal->labels).faces,
                std::string(legal->labels.begin(), legal->labels.end())});
    std::size_t digit = 0;
    while (digit < faces && depths[digit] == kSmallDepth) {
      depths[digit++] = 0;
    }
    is_more = digit < faces;
    if (is_more) {
      ++depths[digit];
    }
  }
  return {all.begin(), all.end()};
}

/// A face and the labels at the corners of all faces that it shares a vertex with.
using Piece = std::pair<std::size_t, std::string>;

/// The vertices of a face and of those that it shares a vertex with, ascending, for every face.
std::vector<std::vector<std::uint32_t>> vertices_around(const ControlMesh& mesh) {
  std::vector<std::vector<std::uint32_t>> around(mesh.face_count());
  for (std::size_t f = 0; f < around.size(); ++f) {
    std::set<std::uint32_t> vertices;
    for (std::size_t g = 0; g < mesh.face_count(); ++g) {
      if (std::ranges::find_first_of(mesh.face(f), mesh.face(g)) != mesh.face(f).end()) {
        vertices.insert(mesh.face(g).begin(), mesh.face(g).end());
      }
    }
    around[f].assign(vertices.begin(), vertices.end());
  }
  return around;
}

Piece piece_of(std::size_t f, const std::vector<std::uint32_t>& around, const std::string& labels) {
  Piece piece{f, {}};
  for (const std::uint32_t v : around) {
    piece.second.push_back(labels[v]);
  }
  return piece;
}

}  // namespace

std::vector<SmallMesh> small_meshes() {
  return {{"cube", load_bundled_mesh("cube").value().mesh},
          {"cube, a corner pulled", pulled("cube", 2.0)},
          {"tetrahedron, tall", tetrahedron(4.0)},
          {"sheet of 8, folded once",
           sheet(4, 2, [](std::uint32_t x, std::uint32_t) { return x == 1 ? 1.0 : 0.0; })},
          {"sheet of 8, a wave",
           sheet(4, 2, [](std::uint32_t x, std::uint32_t y) { return 0.5 * std::sin(x * x + y); })},
          {"sheet of 9, a corner lifted",
           sheet(3, 3, [](std::uint32_t x, std::uint32_t y) { return x + y == 6 ? 2.0 : 0.0; })},
          {"sheet of 9, a tip", sheet(3, 3, [](std::uint32_t x, std::uint32_t y) {
             return x == 1 && y == 1 ? 1.5 : 0.0;
           })}};
}

Trial optimal_painting(const Subject& subject, double target) {
  const ControlMesh& mesh = *subject.mesh;
  LIMN_EXPECTS(mesh.face_count() <= kMostSmallFaces);
  const double distance = target * mesh.bounds().diagonal();
  const std::vector<std::vector<std::uint32_t>> around = vertices_around(mesh);
  std::set<Piece> too_far;
  std::vector<double> of_faces;
  for (const auto& [faces, text] : all_paintings(subject)) {
    bool is_hopeless = false;
    for (std::size_t f = 0; f < mesh.face_count() && !is_hopeless; ++f) {
      is_hopeless = too_far.contains(piece_of(f, around[f], text));
    }
    if (is_hopeless) {
      continue;
    }
    const Trial trial = measure(subject, labels_of(text), &of_faces);
    if (trial.greatest <= target) {
      return trial;
    }
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      if (of_faces[f] > distance) {
        too_far.insert(piece_of(f, around[f], text));
      }
    }
  }
  return {};
}

}  // namespace limn::bench
