// In order: merge repeated corners and check every face alone; match edges; orient; separate fans;
// write the half-edges and what they carry. Each step is linear, and each relies on what the ones
// before it refuse.
#include "limn/mesh/build.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "limn/contract.h"
#include "mesh/attributes.h"
#include "mesh/edge_matching.h"
#include "mesh/halfedge_assembly.h"
#include "mesh/mending.h"

namespace limn {
namespace {

/// Speaks of a soup's elements by source line where it has lines, else by 0-based number.
class Names {
 public:
  explicit Names(const PolygonSoup& soup) : soup_(soup) {}

  [[nodiscard]] std::string vertex(std::size_t v) const {
    return has_vertex_places() ? fmt::format("the vertex of line {}", soup_.vertex_places[v])
                               : fmt::format("vertex {}", v);
  }
  /// `message` goes on from the name of the vertex.
  [[nodiscard]] tl::unexpected<Error> blame_vertex(std::size_t v,
                                                   const std::string& message) const {
    return fail(ErrorKind::kBadInput,
                has_vertex_places() ? fmt::format("This vertex {}", message)
                                    : fmt::format("Vertex {} {}", v, message),
                soup_.source, has_vertex_places() ? soup_.vertex_places[v] : 0);
  }
  /// `message` goes on from the name of the face.
  [[nodiscard]] tl::unexpected<Error> blame_face(std::size_t f, const std::string& message) const {
    return fail(ErrorKind::kBadInput,
                has_face_places() ? fmt::format("This face {}", message)
                                  : fmt::format("Face {} {}", f, message),
                soup_.source, has_face_places() ? soup_.face_places[f] : 0);
  }

 private:
  [[nodiscard]] bool has_vertex_places() const { return !soup_.vertex_places.empty(); }
  [[nodiscard]] bool has_face_places() const { return !soup_.face_places.empty(); }

  const PolygonSoup& soup_;
};

void expect_well_formed(const PolygonSoup& soup) {
  LIMN_EXPECTS(!soup.face_offsets.empty() && soup.face_offsets.front() == 0);
  LIMN_EXPECTS(std::is_sorted(soup.face_offsets.begin(), soup.face_offsets.end()));
  LIMN_EXPECTS(soup.face_offsets.back() == soup.face_vertices.size());
  LIMN_EXPECTS(soup.vertex_places.empty() || soup.vertex_places.size() == soup.positions.size());
  LIMN_EXPECTS(soup.face_places.empty() || soup.face_places.size() == soup.face_count());
  LIMN_EXPECTS(soup.face_uvs.empty() || soup.face_uvs.size() == soup.face_vertices.size());
}

/// Refined positions are single precision and get squared on the graphics card, so a coordinate has
/// to stay well below the square root of what a float can hold.
constexpr double largest_coordinate = 1e18;

Result<void> check_positions(const PolygonSoup& soup, const Names& names) {
  for (std::size_t v = 0; v < soup.positions.size(); ++v) {
    const glm::dvec3& p = soup.positions[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      return names.blame_vertex(
          v, fmt::format("has a coordinate that is not a finite number: {} {} {}.", p.x, p.y, p.z));
    }
    if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > largest_coordinate) {
      return names.blame_vertex(v, fmt::format("lies too far out, at {} {} {}; coordinates up to "
                                               "{} are read. Scale the mesh down.",
                                               p.x, p.y, p.z, largest_coordinate));
    }
  }
  return {};
}

/// Copies the faces without the corners that repeat the one before them, and checks each alone.
Result<detail::WorkingFaces> clean_faces(const PolygonSoup& soup, const Names& names) {
  detail::WorkingFaces faces;
  faces.vertex_count = soup.positions.size();
  faces.offsets.reserve(soup.face_offsets.size());
  faces.vertices.reserve(soup.face_vertices.size());
  faces.uvs.reserve(soup.face_uvs.size());
  std::vector<std::uint32_t> last_seen_in(faces.vertex_count, kNone);

  for (std::uint32_t f = 0; f < soup.face_count(); ++f) {
    const std::size_t begin = faces.vertices.size();
    for (std::uint32_t c = soup.face_offsets[f]; c < soup.face_offsets[f + 1]; ++c) {
      const std::uint32_t v = soup.face_vertices[c];
      if (v >= faces.vertex_count) {
        return names.blame_face(f, fmt::format("names vertex {}, counted from 0, but there are {} "
                                               "vertices.",
                                               v, faces.vertex_count));
      }
      if (faces.vertices.size() == begin || faces.vertices.back() != v) {
        faces.vertices.push_back(v);
        if (!soup.face_uvs.empty()) {
          faces.uvs.push_back(soup.face_uvs[c]);
        }
      }
    }
    if (faces.vertices.size() > begin + 1 && faces.vertices.back() == faces.vertices[begin]) {
      faces.vertices.pop_back();
      if (!faces.uvs.empty()) {
        faces.uvs.pop_back();
      }
    }

    std::size_t distinct = 0;
    std::uint32_t repeated = kNone;
    for (std::size_t c = begin; c < faces.vertices.size(); ++c) {
      const std::uint32_t v = faces.vertices[c];
      if (std::exchange(last_seen_in[v], f) != f) {
        ++distinct;
      } else if (repeated == kNone) {
        repeated = v;
      }
    }
    if (distinct < 3) {
      return names.blame_face(f, fmt::format("has {} distinct {}; a face needs at least three. "
                                             "Delete it or give it more corners.",
                                             distinct, distinct == 1 ? "vertex" : "vertices"));
    }
    if (repeated != kNone) {
      return names.blame_face(f, fmt::format("meets {} twice. Split it into faces that meet each "
                                             "vertex once.",
                                             names.vertex(repeated)));
    }
    faces.offsets.push_back(static_cast<std::uint32_t>(faces.vertices.size()));
  }
  return faces;
}

std::size_t face_of_corner(const detail::WorkingFaces& faces, std::uint32_t corner) {
  const auto after = std::upper_bound(faces.offsets.begin(), faces.offsets.end(), corner);
  return static_cast<std::size_t>(after - faces.offsets.begin()) - 1;
}

tl::unexpected<Error> blame_crowded_edge(const detail::WorkingFaces& faces, std::uint32_t corner,
                                         const Names& names) {
  const std::size_t f = face_of_corner(faces, corner);
  const std::uint32_t next = corner + 1 < faces.offsets[f + 1] ? corner + 1 : faces.offsets[f];
  return names.blame_face(
      f, fmt::format("is the third at the edge between {} and {}; a surface has at most two. "
                     "Delete the inner faces or give this part vertices of its own.",
                     names.vertex(faces.vertices[corner]), names.vertex(faces.vertices[next])));
}

HalfedgeMesh with_positions(HalfedgeMesh mesh, const PolygonSoup& soup,
                            const std::vector<std::uint32_t>& vertex_sources) {
  for (std::size_t v = 0; v < vertex_sources.size(); ++v) {
    const glm::dvec3& p = soup.positions[vertex_sources[v]];
    mesh.set_point(OpenMesh::VertexHandle(static_cast<int>(v)), {p.x, p.y, p.z});
  }
  return mesh;
}

}  // namespace

Result<ImportedMesh> build_control_mesh(const PolygonSoup& soup, const BuildSettings&) {
  expect_well_formed(soup);
  const Names names(soup);
  if (soup.face_count() == 0) {
    return fail(ErrorKind::kBadInput, "There are no faces to paint on.", soup.source);
  }
  const auto with_source = [&](Error error) {
    error.path = soup.source;
    return tl::unexpected<Error>(std::move(error));
  };
  if (auto size = detail::check_halfedge_limits(soup.positions.size(), 0, soup.face_count());
      !size) {
    return with_source(std::move(size.error()));
  }
  if (auto finite = check_positions(soup, names); !finite) {
    return tl::unexpected<Error>(std::move(finite.error()));
  }
  auto cleaned = clean_faces(soup, names);
  if (!cleaned) {
    return tl::unexpected<Error>(std::move(cleaned.error()));
  }
  detail::WorkingFaces faces = std::move(*cleaned);
  ImportReport report;
  report.add(MendKind::kRepeatedCorner, soup.face_vertices.size() - faces.vertices.size());

  detail::EdgeMatching edges = detail::match_edges(faces.arrays());
  if (edges.crowded_corner != kNone) {
    return blame_crowded_edge(faces, edges.crowded_corner, names);
  }
  const detail::Orientation orientation = detail::orient(faces.arrays(), edges);
  if (orientation.one_sided_face != kNone) {
    return names.blame_face(orientation.one_sided_face,
                            "lies on a surface with one side only, like a Moebius band, so its "
                            "faces cannot all face outwards. Cut the surface open along an edge.");
  }
  if (orientation.flipped_faces > 0) {
    detail::flip_faces(orientation.is_flipped, faces, edges);
  }
  report.add(MendKind::kFlippedFace, orientation.flipped_faces);

  // Tags name the file's vertices; from here on they are numbered anew.
  MeshAttributes attributes;
  attributes.creases.method = soup.creasing;
  attributes.corners = soup.corner_rule;
  attributes.creases.edge_sharpness =
      detail::edge_sharpness(soup.creases, faces.arrays(), edges, report);
  const detail::Fans fans = detail::separate_fans(faces, edges);
  attributes.creases.vertex_sharpness = detail::vertex_sharpness(soup, fans.vertex_sources, report);
  attributes.texture = detail::texture_coordinates(soup, std::move(faces.uvs), report);
  report.add(MendKind::kSplitVertex, fans.split_vertices);
  report.add(MendKind::kLooseVertex, fans.isolated_vertices);
  if (auto size = detail::check_halfedge_limits(faces.vertex_count, edges.edge_corners.size(),
                                                faces.arrays().face_count());
      !size) {
    return with_source(std::move(size.error()));
  }
  return ImportedMesh{std::make_shared<const ControlMesh>(
                          with_positions(detail::assemble_halfedges(faces.arrays(), edges), soup,
                                         fans.vertex_sources),
                          std::move(attributes)),
                      std::move(report)};
}

}  // namespace limn
