// Vertices that lie at one point exactly are one place. A vertex of the other mesh stands for the
// nearest place, found in a grid of cells that are sorted by their numbers; a face for the sorted
// places of its corners, found in a sorted list of hashes.
#include "limn/document/painting_transfer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "limn/contract.h"

namespace limn {
namespace {

/// Six decimals are off by half of 1e-6 along each axis, single precision by less than 1e-7 of the
/// coordinate.
constexpr double kTolerance = 4e-6;

std::uint64_t mixed(std::uint64_t hash, std::uint64_t value) noexcept {
  hash = (hash ^ value) * 0x9E3779B97F4A7C15U;
  return hash ^ (hash >> 29U);
}

bool lies_before(const glm::dvec3& a, const glm::dvec3& b) {
  return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

/// The place of every vertex: the lowest vertex at the same point.
std::vector<std::uint32_t> places_of(std::span<const glm::dvec3> positions) {
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
    return positions[a] == positions[b] ? a < b : lies_before(positions[a], positions[b]);
  });
  std::vector<std::uint32_t> places(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_same = i > 0 && positions[order[i]] == positions[order[i - 1]];
    places[order[i]] = is_same ? places[order[i - 1]] : order[i];
  }
  return places;
}

/// Finds the nearest of many points within a radius.
class PointGrid {
 public:
  PointGrid(std::span<const glm::dvec3> points, double radius)
      : points_(points), radius_(radius), cells_(points.size()) {
    for (std::uint32_t v = 0; v < points.size(); ++v) {
      cells_[v] = {hash_of(cell_at(points[v])), v};
    }
    std::ranges::sort(cells_);
  }

  /// kNone where there is none.
  [[nodiscard]] std::uint32_t nearest(const glm::dvec3& point) const {
    std::uint32_t nearest = kNone;
    double shortest = radius_ * radius_;
    const Cell low = cell_at(point - radius_);
    const Cell high = cell_at(point + radius_);
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        for (std::int64_t z = low[2]; z <= high[2]; ++z) {
          look_in(hash_of({x, y, z}), point, nearest, shortest);
        }
      }
    }
    return nearest;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  using Entry = std::pair<std::uint64_t, std::uint32_t>;  ///< A cell's hash, and a point in it.

  /// Cells are four radii wide: at most two of them along an axis hold what is within a radius.
  [[nodiscard]] Cell cell_at(const glm::dvec3& point) const {
    const glm::dvec3 cell = glm::floor(point / (4.0 * radius_));
    return {static_cast<std::int64_t>(cell.x), static_cast<std::int64_t>(cell.y),
            static_cast<std::int64_t>(cell.z)};
  }
  static std::uint64_t hash_of(const Cell& cell) {
    std::uint64_t hash = 0;
    for (const std::int64_t coordinate : cell) {
      hash = mixed(hash, static_cast<std::uint64_t>(coordinate));
    }
    return hash;
  }
  void look_in(std::uint64_t hash, const glm::dvec3& point, std::uint32_t& nearest,
               double& shortest) const {
    auto at = std::ranges::lower_bound(cells_, hash, {}, &Entry::first);
    for (; at != cells_.end() && at->first == hash; ++at) {
      const glm::dvec3 way = points_[at->second] - point;
      const double length = glm::dot(way, way);
      if (length < shortest || (length == shortest && at->second < nearest)) {
        shortest = length;
        nearest = at->second;
      }
    }
  }

  std::span<const glm::dvec3> points_;
  double radius_;
  std::vector<Entry> cells_;
};

double largest_coordinate(const ControlMesh& a, const ControlMesh& b) {
  double largest = 1.0;
  for (const Bounds& bounds : {a.bounds(), b.bounds()}) {
    for (int axis = 0; axis < 3; ++axis) {
      largest = std::max({largest, std::abs(bounds.low[axis]), std::abs(bounds.high[axis])});
    }
  }
  return largest;
}

/// The vertices of both meshes by the places of the first.
struct Places {
  std::vector<std::uint32_t> from;
  std::vector<std::uint32_t> to;  ///< kNone where it is at no place of the first.
};

Places find_places(const ControlMesh& from, const ControlMesh& to) {
  Places places{places_of(from.positions()), std::vector<std::uint32_t>(to.vertex_count())};
  const double radius = kTolerance * largest_coordinate(from, to);
  const PointGrid grid(from.positions(), radius);
  const PointGrid back(to.positions(), radius);
  for (std::size_t v = 0; v < to.vertex_count(); ++v) {
    const glm::dvec3& position = to.positions()[v];
    const std::uint32_t found = grid.nearest(position);
    // Where many lie within the radius only the nearest to each other are the same.
    const bool is_mutual =
        found != kNone && to.positions()[back.nearest(from.positions()[found])] == position;
    places.to[v] = is_mutual ? places.from[found] : kNone;
  }
  return places;
}

/// The faces of a mesh, each as the places of its corners.
class PlacedFaces {
 public:
  PlacedFaces(const ControlMesh& mesh, std::span<const std::uint32_t> places)
      : offsets_(mesh.topology().face_offsets), corners_(mesh.topology().corner_vertices.size()) {
    std::ranges::transform(mesh.topology().corner_vertices, corners_.begin(),
                           [&](std::uint32_t vertex) { return places[vertex]; });
    sorted_ = corners_;
    for (std::size_t f = 0; f < count(); ++f) {
      std::sort(sorted_.begin() + offsets_[f], sorted_.begin() + offsets_[f + 1]);
    }
  }
  [[nodiscard]] std::size_t count() const { return offsets_.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> sorted(std::size_t f) const {
    return std::span(sorted_).subspan(offsets_[f], offsets_[f + 1] - offsets_[f]);
  }
  [[nodiscard]] std::span<const std::uint32_t> corners(std::size_t f) const {
    return std::span(corners_).subspan(offsets_[f], offsets_[f + 1] - offsets_[f]);
  }
  [[nodiscard]] std::uint64_t hash(std::size_t f) const {
    std::uint64_t hash = sorted(f).size();
    for (const std::uint32_t place : sorted(f)) {
      hash = mixed(hash, place);
    }
    return hash;
  }

 private:
  const std::vector<std::uint32_t>& offsets_;
  std::vector<std::uint32_t> corners_;
  std::vector<std::uint32_t> sorted_;
};

/// Whether two faces on the same places go round the same way.
bool is_turned_alike(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b) {
  for (std::size_t start = 0; start < b.size(); ++start) {
    bool is_same = true;
    for (std::size_t i = 0; i < a.size() && is_same; ++i) {
      is_same = a[i] == b[(start + i) % b.size()];
    }
    if (is_same) {
      return true;
    }
  }
  return false;
}

/// For each face of the other mesh the face it was before, or kNone.
std::vector<std::uint32_t> match_faces(const PlacedFaces& from, const PlacedFaces& to) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> known(from.count());
  for (std::uint32_t f = 0; f < from.count(); ++f) {
    known[f] = {from.hash(f), f};
  }
  std::ranges::sort(known);
  std::vector<std::uint8_t> is_taken(from.count());
  std::vector<std::uint32_t> matches(to.count(), kNone);
  // Faces with a twin on their back are told apart first; what is left over goes in order.
  for (const bool must_be_alike : {true, false}) {
    for (std::size_t f = 0; f < to.count(); ++f) {
      if (matches[f] != kNone || to.sorted(f).back() == kNone) {
        continue;
      }
      const std::uint64_t hash = to.hash(f);
      auto at = std::ranges::lower_bound(known, hash, {}, [](const auto& k) { return k.first; });
      for (; at != known.end() && at->first == hash; ++at) {
        const std::uint32_t other = at->second;
        if (is_taken[other] == 0 && std::ranges::equal(from.sorted(other), to.sorted(f)) &&
            (!must_be_alike || is_turned_alike(from.corners(other), to.corners(f)))) {
          is_taken[other] = 1;
          matches[f] = other;
          break;
        }
      }
    }
  }
  return matches;
}

using Ends = std::array<std::uint32_t, 2>;

Ends sorted_ends(const Ends& edge, std::span<const std::uint32_t> places) {
  const std::uint32_t a = places[edge[0]];
  const std::uint32_t b = places[edge[1]];
  return {std::min(a, b), std::max(a, b)};
}

/// Takes sharpness over from elements of one mesh to those of the same key in the other.
template <class Key>
void carry_over(std::vector<std::pair<Key, float>> sharp, std::span<const Key> keys,
                std::vector<float>& sharpness, PaintingTransfer& transfer) {
  std::ranges::sort(sharp);
  std::vector<std::uint8_t> is_kept(sharp.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto at =
        std::ranges::lower_bound(sharp, keys[i], {}, [](const auto& entry) { return entry.first; });
    if (at == sharp.end() || at->first != keys[i]) {
      continue;
    }
    sharpness.resize(keys.size(), 0.0F);
    if (sharpness[i] == 0.0F) {
      sharpness[i] = at->second;
    }
    is_kept[static_cast<std::size_t>(at - sharp.begin())] = 1;
  }
  const auto kept = static_cast<std::size_t>(std::ranges::count(is_kept, std::uint8_t{1}));
  transfer.kept_creases += kept;
  transfer.lost_creases += sharp.size() - kept;
}

std::shared_ptr<const ControlMesh> with_creases_of(const ControlMesh& from,
                                                   const std::shared_ptr<const ControlMesh>& to,
                                                   const Places& places,
                                                   PaintingTransfer& transfer) {
  MeshAttributes attributes = to->attributes();
  const Creases& sharp = from.creases();
  if (attributes.creases == Creases{}) {
    attributes.creases.method = sharp.method;
  }
  if (!attributes.corners) {
    attributes.corners = from.attributes().corners;
  }
  std::vector<std::pair<Ends, float>> edges;
  for (std::size_t e = 0; e < sharp.edge_sharpness.size(); ++e) {
    if (sharp.edge_sharpness[e] > 0.0F) {
      edges.emplace_back(sorted_ends(from.topology().edge_vertices[e], places.from),
                         sharp.edge_sharpness[e]);
    }
  }
  if (!edges.empty()) {
    std::vector<Ends> keys(to->edge_count());
    std::ranges::transform(to->topology().edge_vertices, keys.begin(),
                           [&](const Ends& edge) { return sorted_ends(edge, places.to); });
    carry_over<Ends>(std::move(edges), keys, attributes.creases.edge_sharpness, transfer);
  }
  std::vector<std::pair<std::uint32_t, float>> vertices;
  for (std::size_t v = 0; v < sharp.vertex_sharpness.size(); ++v) {
    if (sharp.vertex_sharpness[v] > 0.0F) {
      vertices.emplace_back(places.from[v], sharp.vertex_sharpness[v]);
    }
  }
  if (!vertices.empty()) {
    carry_over<std::uint32_t>(std::move(vertices), places.to, attributes.creases.vertex_sharpness,
                              transfer);
  }
  return std::make_shared<const ControlMesh>(to->with_attributes(std::move(attributes)));
}

}  // namespace

std::uint64_t topology_hash(const ControlMesh& mesh) noexcept {
  std::uint64_t hash = mixed(mesh.vertex_count(), mesh.face_count());
  for (const std::uint32_t offset : mesh.topology().face_offsets) {
    hash = mixed(hash, offset);
  }
  for (const std::uint32_t vertex : mesh.topology().corner_vertices) {
    hash = mixed(hash, vertex);
  }
  return hash;
}

PaintingTransfer transfer_painting(const ControlMesh& from, std::span<const std::uint8_t> depths,
                                   const std::shared_ptr<const ControlMesh>& to) {
  LIMN_EXPECTS(to != nullptr);
  LIMN_EXPECTS(depths.size() == from.face_count());
  Places places = find_places(from, *to);
  std::vector<std::uint32_t> matches =
      match_faces(PlacedFaces(from, places.from), PlacedFaces(*to, places.to));

  PaintingTransfer transfer;
  if (std::ranges::find(matches, kNone) != matches.end() &&
      topology_hash(from) == topology_hash(*to)) {
    transfer.matching = FaceMatching::kOrder;
    std::iota(matches.begin(), matches.end(), 0U);
    std::iota(places.from.begin(), places.from.end(), 0U);
    places.to = places.from;
  }
  transfer.mesh = with_creases_of(from, to, places, transfer);
  transfer.depths = FaceDepths(to->face_count());
  std::vector<std::uint8_t> is_kept(from.face_count());
  for (std::uint32_t f = 0; f < to->face_count(); ++f) {
    if (matches[f] == kNone) {
      transfer.new_faces.push_back(f);
    } else {
      transfer.depths.set(f, depths[matches[f]]);
      is_kept[matches[f]] = 1;
    }
  }
  for (std::uint32_t f = 0; f < from.face_count(); ++f) {
    if (is_kept[f] == 0 && depths[f] > 0) {
      transfer.lost_faces.push_back(f);
    }
  }
  return transfer;
}

}  // namespace limn
