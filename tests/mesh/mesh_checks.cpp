#include "mesh/mesh_checks.h"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/mesh/import.h"

namespace limn::test {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

std::uint32_t index_of(const OpenMesh::BaseHandle& handle) {
  return static_cast<std::uint32_t>(handle.idx());
}

void check_faces(const ControlMesh& mesh, std::vector<std::string>& faults) {
  std::map<Pair, int> directed;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    if (std::set<std::uint32_t>(face.begin(), face.end()).size() != face.size() ||
        face.size() < 3) {
      faults.push_back(fmt::format("face {} repeats a vertex or has under three", f));
    }
    for (std::size_t i = 0; i < face.size(); ++i) {
      if (++directed[{face[i], face[(i + 1) % face.size()]}] > 1) {
        faults.push_back(fmt::format("face {} clashes with a neighbour", f));
      }
    }
    std::size_t i = 0;
    for (const auto v : mesh.halfedges().fv_range(OpenMesh::FaceHandle(static_cast<int>(f)))) {
      if (i >= face.size() || face[i++] != index_of(v)) {
        faults.push_back(fmt::format("OpenMesh's circulator of face {} disagrees", f));
        break;
      }
    }
    if (i != face.size()) {
      faults.push_back(fmt::format("OpenMesh's circulator of face {} is short", f));
    }
  }
  std::set<Pair> undirected;
  bool is_closed = true;
  for (const auto& [pair, count] : directed) {
    undirected.insert(std::minmax(pair.first, pair.second));
    is_closed = is_closed && directed.count({pair.second, pair.first}) > 0;
  }
  if (undirected.size() != mesh.edge_count()) {
    faults.push_back(fmt::format("{} edges, not {}", mesh.edge_count(), undirected.size()));
  }
  if (is_closed != mesh.is_closed()) {
    faults.push_back("is_closed is wrong");
  }
}

void check_edges(const ControlMesh& mesh, std::vector<std::string>& faults) {
  const FlatTopology& t = mesh.topology();
  for (std::uint32_t e = 0; e < mesh.edge_count(); ++e) {
    if (t.edge_corners[e][0] >= t.edge_corners[e][1]) {
      faults.push_back(fmt::format("edge {} has its higher corner first", e));
    }
    for (std::size_t side = 0; side < 2; ++side) {
      const std::uint32_t c = t.edge_corners[e][side];
      if (c == kNone) {
        if (side == 0) {
          faults.push_back(fmt::format("edge {} has no first corner", e));
        }
        continue;
      }
      const std::uint32_t f = t.corner_faces[c];
      const std::uint32_t next = c + 1 < t.face_offsets[f + 1] ? c + 1 : t.face_offsets[f];
      if (t.corner_edges[c] != e || t.corner_vertices[c] != t.edge_vertices[e][side] ||
          t.corner_vertices[next] != t.edge_vertices[e][1 - side]) {
        faults.push_back(fmt::format("edge {} and its corner {} disagree", e, c));
      }
    }
  }
}

void check_vertices(const ControlMesh& mesh, std::vector<std::string>& faults) {
  const FlatTopology& t = mesh.topology();
  std::vector<int> seen(t.corner_vertices.size(), 0);
  const auto face_beyond = [&](std::uint32_t c) {
    const auto& pair = t.edge_corners[t.corner_edges[c]];
    const std::uint32_t other = pair[0] == c ? pair[1] : pair[0];
    return other == kNone ? kNone : t.corner_faces[other];
  };
  const auto arriving = [&](std::uint32_t c) {
    const std::uint32_t f = t.corner_faces[c];
    return c > t.face_offsets[f] ? c - 1 : t.face_offsets[f + 1] - 1;
  };
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    const std::uint32_t begin = t.vertex_offsets[v];
    const std::uint32_t end = t.vertex_offsets[v + 1];
    if (begin == end) {
      faults.push_back(fmt::format("vertex {} is isolated", v));
      continue;
    }
    const std::uint32_t first = t.vertex_corners[begin];
    const std::uint32_t last = t.vertex_corners[end - 1];
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint32_t c = t.vertex_corners[i];
      ++seen[c];
      if (t.corner_vertices[c] != v) {
        faults.push_back(fmt::format("corner {} is not at vertex {}", c, v));
      }
      // Counter-clockwise: the next face lies beyond the edge that arrives at v in this one.
      if (i + 1 < end && face_beyond(arriving(c)) != t.corner_faces[t.vertex_corners[i + 1]]) {
        faults.push_back(fmt::format("faces around vertex {} are not in order", v));
      }
    }
    const bool starts_at_boundary = face_beyond(first) == kNone;
    const bool ends_at_boundary = face_beyond(arriving(last)) == kNone;
    const bool is_ring = face_beyond(arriving(last)) == t.corner_faces[first];
    if (starts_at_boundary != ends_at_boundary || (!starts_at_boundary && !is_ring)) {
      faults.push_back(fmt::format("faces around vertex {} are neither a ring nor a fan", v));
    }
  }
  if (std::any_of(seen.begin(), seen.end(), [](int count) { return count != 1; })) {
    faults.push_back("vertex_corners is no permutation of the corners");
  }
}

}  // namespace

PolygonSoup soup_of(std::size_t vertex_count,
                    const std::vector<std::vector<std::uint32_t>>& faces) {
  PolygonSoup soup;
  for (std::size_t v = 0; v < vertex_count; ++v) {
    const auto t = static_cast<double>(v);
    soup.positions.emplace_back(t, t * t, t * t * t);
  }
  for (const auto& face : faces) {
    soup.add_face(face);
  }
  return soup;
}

std::vector<std::vector<std::uint32_t>> faces_of(const ControlMesh& mesh) {
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    faces.emplace_back(face.begin(), face.end());
  }
  return faces;
}

std::vector<std::string> link_faults_of(const HalfedgeMesh& mesh) {
  std::vector<std::string> faults;
  for (const auto h : mesh.halfedges()) {
    const auto next = mesh.next_halfedge_handle(h);
    const auto previous = mesh.prev_halfedge_handle(h);
    if (!next.is_valid() || !previous.is_valid() || mesh.prev_halfedge_handle(next) != h ||
        mesh.next_halfedge_handle(previous) != h) {
      faults.push_back(fmt::format("half-edge {}: next and previous are not inverse", h.idx()));
      continue;
    }
    if (mesh.face_handle(next) != mesh.face_handle(h) ||
        mesh.to_vertex_handle(h) != mesh.from_vertex_handle(next)) {
      faults.push_back(fmt::format("half-edge {} and its next do not fit", h.idx()));
    }
    if (mesh.is_boundary(h) && mesh.is_boundary(mesh.opposite_halfedge_handle(h))) {
      faults.push_back(fmt::format("half-edge {} lies in no face", h.idx()));
    }
  }
  if (!faults.empty()) {
    return faults;  // Circulators need not come to an end.
  }
  std::vector<std::size_t> outgoing(mesh.n_vertices(), 0);
  std::vector<std::size_t> boundary(mesh.n_vertices(), 0);
  for (const auto h : mesh.halfedges()) {
    ++outgoing[index_of(mesh.from_vertex_handle(h))];
    boundary[index_of(mesh.from_vertex_handle(h))] += mesh.is_boundary(h) ? 1 : 0;
  }
  for (const auto v : mesh.vertices()) {
    if (mesh.from_vertex_handle(mesh.halfedge_handle(v)) != v || boundary[index_of(v)] > 1 ||
        mesh.is_boundary(mesh.halfedge_handle(v)) != (boundary[index_of(v)] == 1)) {
      faults.push_back(fmt::format("vertex {} has the wrong half-edge", v.idx()));
    }
    if (mesh.valence(v) != outgoing[index_of(v)]) {
      faults.push_back(fmt::format("vertex {} has more than one fan", v.idx()));
    }
  }
  for (const auto f : mesh.faces()) {
    if (mesh.face_handle(mesh.halfedge_handle(f)) != f) {
      faults.push_back(fmt::format("face {} has the wrong half-edge", f.idx()));
    }
  }
  return faults;
}

std::vector<std::string> faults_of(const ControlMesh& mesh) {
  std::vector<std::string> faults = link_faults_of(mesh.halfedges());
  check_faces(mesh, faults);
  check_edges(mesh, faults);
  check_vertices(mesh, faults);
  return faults;
}

std::vector<std::size_t> edge_use_counts(const PolygonSoup& soup) {
  std::map<Pair, std::size_t> uses;
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    const auto face = soup.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      ++uses[std::minmax(face[i], face[(i + 1) % face.size()])];
    }
  }
  std::vector<std::size_t> counts(3, 0);
  for (const auto& [pair, count] : uses) {
    counts.resize(std::max(counts.size(), count + 1), 0);
    ++counts[count];
  }
  return counts;
}

ImportedMesh import_text(std::string_view text) {
  auto imported = import_obj(text, "text.obj");
  EXPECT_TRUE(imported.has_value()) << to_string(imported.error());
  if (!imported) {
    return ImportedMesh{};
  }
  EXPECT_THAT(faults_of(*imported->mesh), testing::IsEmpty());
  return *imported;
}

std::string refusal_of(std::string_view text) {
  const auto imported = import_obj(text, "text.obj");
  if (imported.has_value()) {
    return "accepted";
  }
  EXPECT_EQ(imported.error().kind, ErrorKind::kBadInput);
  return to_string(imported.error());
}

}  // namespace limn::test
