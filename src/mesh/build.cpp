// The steps of mesh/manifold in order: clean faces, match corners, orient, join at crowded edges,
// separate fans; then the half-edges are written, and what they carry.
#include "limn/mesh/build.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "limn/contract.h"
#include "mesh/attributes.h"
#include "mesh/edge_matching.h"
#include "mesh/halfedge_assembly.h"
#include "mesh/manifold/clean_faces.h"
#include "mesh/manifold/crowded_edges.h"
#include "mesh/manifold/fans.h"
#include "mesh/manifold/mend_log.h"
#include "mesh/manifold/orientation.h"
#include "mesh/manifold/positions.h"
#include "mesh/manifold/soup_names.h"

namespace limn {
namespace {

using detail::SoupNames;

void expect_well_formed(const PolygonSoup& soup) {
  LIMN_EXPECTS(!soup.face_offsets.empty() && soup.face_offsets.front() == 0);
  LIMN_EXPECTS(std::is_sorted(soup.face_offsets.begin(), soup.face_offsets.end()));
  LIMN_EXPECTS(soup.face_offsets.back() == soup.face_vertices.size());
  LIMN_EXPECTS(soup.vertex_places.empty() || soup.vertex_places.size() == soup.positions.size());
  LIMN_EXPECTS(soup.face_places.empty() || soup.face_places.size() == soup.face_count());
  const auto fits = [&](const auto& of_faces) {
    return of_faces.empty() || of_faces.size() == soup.face_count();
  };
  LIMN_EXPECTS(fits(soup.face_depths) && fits(soup.names.objects.of_faces) &&
               fits(soup.names.groups.of_faces) && fits(soup.names.materials.of_faces));
  LIMN_EXPECTS(soup.face_uvs.empty() || soup.face_uvs.size() == soup.face_vertices.size());
}

/// Of the vertices in faces: what lies in none may be set aside.
Result<void> check_positions(const PolygonSoup& soup, const SoupNames& names) {
  std::vector<std::uint8_t> is_used(soup.positions.size(), 0);
  for (const std::uint32_t v : soup.face_vertices) {
    is_used[v] = 1;
  }
  for (std::size_t v = 0; v < soup.positions.size(); ++v) {
    const glm::dvec3& p = soup.positions[v];
    if (is_used[v] == 0 || detail::is_usable(p)) {
      continue;
    }
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      return names.blame_vertex(
          v, fmt::format("has a coordinate that is not a finite number: {} {} {}.", p.x, p.y, p.z));
    }
    return names.blame_vertex(v, fmt::format("lies too far out, at {} {} {}; coordinates up to "
                                             "{} are read. Scale the mesh down.",
                                             p.x, p.y, p.z, detail::kLargestCoordinate));
  }
  return {};
}

Result<void> check_indices(const PolygonSoup& soup, const SoupNames& names) {
  const auto beyond = std::ranges::find_if(
      soup.face_vertices, [&](std::uint32_t v) { return v >= soup.positions.size(); });
  if (beyond == soup.face_vertices.end()) {
    return {};
  }
  const auto corner = static_cast<std::uint32_t>(beyond - soup.face_vertices.begin());
  const auto after = std::ranges::upper_bound(soup.face_offsets, corner);
  return names.blame_face(static_cast<std::size_t>(after - soup.face_offsets.begin()) - 1,
                          fmt::format("names vertex {}, counted from 0, but there are {} "
                                      "vertices.",
                                      *beyond, soup.positions.size()));
}

/// A face that is there twice runs along each of its edges as its double does, so that edges are
/// crowded or clash.
bool may_have_duplicates(const detail::WorkingFaces& faces,
                         const detail::CornerMatching& matching) {
  if (matching.is_crowded()) {
    return true;
  }
  for (std::uint32_t c = 0; c < matching.twins.size(); ++c) {
    const std::uint32_t twin = matching.twins[c];
    if (twin != kNone && faces.vertices[c] == faces.vertices[twin]) {
      return true;
    }
  }
  return false;
}

/// Matched, oriented faces and the fans around their vertices.
struct Manifold {
  detail::CleanFaces clean;
  detail::CornerMatching matching;
  detail::FanOwners owners;
};

Manifold make_manifold(const PolygonSoup& soup, detail::MendLog& log) {
  Manifold result{detail::clean_faces(soup, log), {}, {}};
  detail::WorkingFaces& faces = result.clean.faces;
  result.matching = detail::match_corners(faces.arrays());
  if (may_have_duplicates(faces, result.matching) && detail::drop_duplicates(result.clean, log)) {
    result.matching = detail::match_corners(faces.arrays());
  }
  detail::orient(faces, result.matching, log);
  result.owners = result.matching.is_crowded()
                      ? detail::join_crowded_edges(faces, result.matching, soup.positions, log)
                      : detail::find_fans(faces.arrays(), result.matching.twins);
  return result;
}

/// Faces with a vertex twice are harmless where the fans around that vertex are apart.
Result<void> check_pinched(const PolygonSoup& soup, const Manifold& manifold,
                           const SoupNames& names) {
  const detail::WorkingFaces& faces = manifold.clean.faces;
  for (const std::uint32_t f : manifold.clean.pinched) {
    std::vector<std::uint32_t> owners(manifold.owners.of_corners.begin() + faces.offsets[f],
                                      manifold.owners.of_corners.begin() + faces.offsets[f + 1]);
    std::ranges::sort(owners);
    const auto twice = std::ranges::adjacent_find(owners);
    if (twice != owners.end()) {
      const std::uint32_t v = *twice < soup.positions.size()
                                  ? *twice
                                  : manifold.owners.copy_sources[*twice - soup.positions.size()];
      return names.blame_face(
          faces.sources[f], fmt::format("meets {} twice. Split it into faces that meet each vertex "
                                        "once.",
                                        names.vertex(v)));
    }
  }
  return {};
}

/// Strictness: the first mend as an error.
Error refusal_of(const ImportReport& report, const std::string& source) {
  const Mend& mend = report.mends.front();
  std::string message =
      "Refused, since nothing may be mended. Else: " + sentence_of(mend.kind, mend.count);
  if (!report.has_places || mend.elements.empty()) {
    return {ErrorKind::kBadInput, std::move(message), source, 0};
  }
  return detail::error_at(report.place_unit, mend.elements.front().place, std::move(message),
                          source);
}

HalfedgeMesh with_positions(HalfedgeMesh mesh, const PolygonSoup& soup,
                            const std::vector<std::uint32_t>& vertex_sources) {
  for (std::size_t v = 0; v < vertex_sources.size(); ++v) {
    const glm::dvec3& p = soup.positions[vertex_sources[v]];
    mesh.set_point(OpenMesh::VertexHandle(static_cast<int>(v)), {p.x, p.y, p.z});
  }
  return mesh;
}

std::vector<glm::dvec3> loose_vertices(const PolygonSoup& soup,
                                       const std::vector<std::uint32_t>& vertex_sources) {
  std::vector<std::uint8_t> is_used(soup.positions.size(), 0);
  for (const std::uint32_t v : vertex_sources) {
    is_used[v] = 1;
  }
  std::vector<glm::dvec3> loose;
  for (std::size_t v = 0; v < is_used.size(); ++v) {
    if (is_used[v] == 0 && detail::is_usable(soup.positions[v])) {
      loose.push_back(soup.positions[v]);
    }
  }
  return loose;
}

std::vector<std::uint32_t> depths_of(const PolygonSoup& soup,
                                     const std::vector<std::uint32_t>& face_sources) {
  std::vector<std::uint32_t> depths;
  if (!soup.face_depths.empty()) {
    depths.reserve(face_sources.size());
    for (const std::uint32_t f : face_sources) {
      depths.push_back(soup.face_depths[f]);
    }
  }
  return depths;
}

}  // namespace

Result<ImportedMesh> build_control_mesh(const PolygonSoup& soup, const BuildSettings& settings) {
  expect_well_formed(soup);
  const SoupNames names(soup);
  const auto with_source = [&](Error error) {
    error.path = soup.source;
    return tl::unexpected<Error>(std::move(error));
  };
  if (soup.face_count() == 0) {
    return fail(ErrorKind::kBadInput, "There are no faces to paint on.", soup.source);
  }
  if (auto size = detail::check_halfedge_limits(soup.positions.size(), 0, soup.face_count());
      !size) {
    return with_source(std::move(size.error()));
  }
  if (auto finite =
          check_indices(soup, names).and_then([&] { return check_positions(soup, names); });
      !finite) {
    return tl::unexpected<Error>(std::move(finite.error()));
  }

  detail::MendLog log(soup);
  Manifold manifold = make_manifold(soup, log);
  detail::WorkingFaces& faces = manifold.clean.faces;
  if (faces.sources.empty()) {
    return fail(ErrorKind::kBadInput,
                fmt::format("There are no faces to paint on: {}",
                            sentence_of(MendKind::kDegenerateFace, soup.face_count())),
                soup.source);
  }
  if (auto harmless = check_pinched(soup, manifold, names); !harmless) {
    return tl::unexpected<Error>(std::move(harmless.error()));
  }
  const detail::EdgeMatching edges = detail::number_edges(manifold.matching.twins);

  // Tags name the file's vertices; from here on they are numbered anew.
  MeshAttributes attributes;
  attributes.creases.method = soup.creasing;
  attributes.corners = soup.corner_rule;
  attributes.creases.edge_sharpness =
      detail::edge_sharpness(soup.creases, faces.arrays(), edges, log.report());
  const std::vector<std::uint32_t> vertex_sources =
      detail::separate_fans(faces, manifold.owners, log);
  attributes.creases.vertex_sharpness =
      detail::vertex_sharpness(soup, vertex_sources, log.report());
  attributes.texture = detail::texture_coordinates(soup, std::move(faces.uvs), log.report());
  attributes.names = names_by_source(soup.names, faces.sources);
  attributes.loose_vertices = loose_vertices(soup, vertex_sources);
  log.report().add(MendKind::kBrokenUv, soup.broken_uvs);
  if (auto size = detail::check_halfedge_limits(faces.vertex_count, edges.edge_corners.size(),
                                                faces.arrays().face_count());
      !size) {
    return with_source(std::move(size.error()));
  }

  ImportedMesh imported;
  imported.report = log.finish(faces.sources, vertex_sources);
  if (settings.is_strict && imported.report.is_mended()) {
    return tl::unexpected<Error>(refusal_of(imported.report, soup.source));
  }
  imported.report.unused_data.insert(imported.report.unused_data.begin(), soup.unused_data.begin(),
                                     soup.unused_data.end());
  imported.depths = depths_of(soup, faces.sources);
  imported.mesh = std::make_shared<const ControlMesh>(
      with_positions(detail::assemble_halfedges(faces.arrays(), edges), soup, vertex_sources),
      std::move(attributes));
  return imported;
}

}  // namespace limn
