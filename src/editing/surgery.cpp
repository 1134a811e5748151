// Corners linked to the next one of their face and to the one across their edge. With a -> b the
// edge, x and y the vertices opposite:
//
//            x                x                          x                x
//          / | \            / | \                      /   \            / | \        .
//        /   |   \        /   |   \                  /       \        /   |   \      .
//       a----+--->b  =>  a----m----b                a-------->b  =>  a    |    b
//        \   |   /        \   |   /                  \       /        \   |   /
//          \   /            \ | /                      \   /            \ v /
//            y                y                          y                y
//               split: x-m-y are the spokes                 flip: the corner now leaves y
#include "editing/surgery.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "limn/contract.h"
#include "limn/mesh/build.h"

namespace limn {

/// The neighbours of the vertex that a corner leaves, one after the other: counter-clockwise, and
/// beyond a boundary on from the corner the other way.
class Surgery::Neighbours {
 public:
  Neighbours(const Surgery& mesh, std::uint32_t corner)
      : mesh_(mesh), start_(corner), corner_(corner) {}

  /// kNone after the last.
  [[nodiscard]] std::uint32_t next() {
    if (corner_ == kNone) {
      return kNone;
    }
    if (is_clockwise_) {
      const std::uint32_t neighbour = mesh_.to(corner_);
      const std::uint32_t across = mesh_.twin(corner_);
      corner_ = across == kNone ? kNone : mesh_.next(across);
      return neighbour;
    }
    const std::uint32_t entering = mesh_.previous(corner_);
    const std::uint32_t neighbour = mesh_.from(entering);
    corner_ = mesh_.twin(entering);
    if (corner_ == kNone) {
      is_clockwise_ = true;
      corner_ = start_;
    } else if (corner_ == start_) {
      corner_ = kNone;
    }
    return neighbour;
  }

 private:
  const Surgery& mesh_;
  std::uint32_t start_;
  std::uint32_t corner_;
  bool is_clockwise_ = false;
};

Surgery::Surgery(const ControlMesh& mesh)
    : positions_(mesh.positions().begin(), mesh.positions().end()),
      vertex_sharpness_(mesh.creases().vertex_sharpness),
      uvs_(mesh.texture().values),
      creasing_(mesh.creases().method),
      corner_rule_(mesh.attributes().corners),
      names_(mesh.attributes().names),
      loose_vertices_(mesh.attributes().loose_vertices) {
  const FlatTopology& flat = mesh.topology();
  const std::vector<float>& sharpness = mesh.creases().edge_sharpness;
  const std::vector<std::uint32_t>& uvs = mesh.texture().corner_values;
  first_corners_.assign(flat.face_offsets.begin(), flat.face_offsets.end() - 1);
  face_sources_.resize(first_corners_.size());
  std::iota(face_sources_.begin(), face_sources_.end(), 0U);
  corners_.reserve(flat.corner_vertices.size());
  for (std::uint32_t c = 0; c < flat.corner_vertices.size(); ++c) {
    const std::uint32_t face = flat.corner_faces[c];
    const std::uint32_t after =
        c + 1 == flat.face_offsets[face + 1] ? flat.face_offsets[face] : c + 1;
    corners_.push_back({flat.corner_vertices[c], after, flat.corner_twins[c], face,
                        uvs.empty() ? kNone : uvs[c],
                        sharpness.empty() ? 0.0f : sharpness[flat.corner_edges[c]]});
  }
}

std::uint32_t Surgery::previous(std::uint32_t corner) const {
  std::uint32_t before = next(corner);
  while (next(before) != corner) {
    before = next(before);
  }
  return before;
}

bool Surgery::is_triangle(std::uint32_t corner) const {
  return next(next(next(corner))) == corner;
}

bool Surgery::is_seam(std::uint32_t corner) const {
  const std::uint32_t across = twin(corner);
  return corners_[corner].uv != corners_[next(across)].uv ||
         corners_[next(corner)].uv != corners_[across].uv;
}

bool Surgery::are_joined(std::uint32_t one, std::uint32_t other) const {
  // Both walks at once, so that the shorter one ends them.
  Neighbours of_one(*this, one);
  Neighbours of_other(*this, other);
  while (true) {
    const std::uint32_t beside_one = of_one.next();
    const std::uint32_t beside_other = of_other.next();
    if (beside_one == from(other) || beside_other == from(one)) {
      return true;
    }
    if (beside_one == kNone || beside_other == kNone) {
      return false;
    }
  }
}

std::optional<std::string_view> Surgery::why_not_split(std::uint32_t corner) const {
  const std::uint32_t across = twin(corner);
  if (!is_triangle(corner) || (across != kNone && !is_triangle(across))) {
    return "a face at it is no triangle";
  }
  if (across != kNone && opposite(corner) == opposite(across)) {
    return "its two triangles lie back to back, and the halves would share an edge";
  }
  return std::nullopt;
}

std::optional<std::string_view> Surgery::why_not_flip(std::uint32_t corner) const {
  const std::uint32_t across = twin(corner);
  if (across == kNone) {
    return "it lies on the boundary and has one face only";
  }
  if (!is_triangle(corner) || !is_triangle(across)) {
    return "a face at it is no triangle";
  }
  if (opposite(corner) == opposite(across)) {
    return "its two triangles lie back to back, with one vertex opposite in both";
  }
  if (are_joined(next(next(corner)), next(next(across)))) {
    return "the vertices opposite are joined by an edge already, which would be doubled";
  }
  if (is_seam(corner)) {
    return "it is a seam of the texture, which the flipped edge would cross";
  }
  return std::nullopt;
}

void Surgery::pair(std::uint32_t one, std::uint32_t other) {
  corners_[one].twin = other;
  corners_[other].twin = one;
}

void Surgery::make_triangle(std::uint32_t face, std::array<std::uint32_t, 3> corners) {
  for (std::size_t i = 0; i < 3; ++i) {
    corners_[corners[i]].next = corners[(i + 1) % 3];
    corners_[corners[i]].face = face;
  }
}

std::uint32_t Surgery::add_uv_between(std::uint32_t one, std::uint32_t other) {
  uvs_.push_back(0.5 * (uvs_[one] + uvs_[other]));
  return static_cast<std::uint32_t>(uvs_.size() - 1);
}

Surgery::Halves Surgery::cut(std::uint32_t corner, const Cut& cut) {
  const std::uint32_t after = next(corner);
  const std::uint32_t before = next(after);
  const std::uint32_t face = corners_[corner].face;
  const std::uint32_t first = first_corners_[face];
  const auto new_face = static_cast<std::uint32_t>(first_corners_.size());
  const auto rest = static_cast<std::uint32_t>(corners_.size());
  const std::uint32_t out = rest + 1;
  const std::uint32_t in = rest + 2;
  corners_.push_back(corners_[corner]);
  corners_.push_back({cut.middle, kNone, kNone, face, cut.uv, 0.0f});
  corners_.push_back({corners_[before].vertex, kNone, kNone, face, corners_[before].uv, 0.0f});
  pair(out, in);

  Corner& middle = corners_[cut.keeps_start ? rest : corner];
  middle.vertex = cut.middle;
  middle.uv = cut.uv;
  // Both halves have the corners of the whole, one of them replaced, and start where it did.
  std::array<std::uint32_t, 3> kept{corner, after, before};
  std::array<std::uint32_t, 3> added{rest, after, before};
  (cut.keeps_start ? kept[1] : kept[2]) = cut.keeps_start ? out : in;
  (cut.keeps_start ? added[2] : added[1]) = cut.keeps_start ? in : out;
  make_triangle(face, kept);
  make_triangle(new_face, added);
  const std::size_t start = first == corner ? 0 : first == after ? 1 : 2;
  first_corners_[face] = kept[start];
  first_corners_.push_back(added[start]);
  face_sources_.push_back(face_sources_[face]);
  return {rest, out};
}

Surgery::Split Surgery::split(std::uint32_t corner) {
  LIMN_ASSERT(!why_not_split(corner));
  const std::uint32_t across = twin(corner);
  const auto middle = static_cast<std::uint32_t>(positions_.size());
  positions_.push_back(0.5 * (positions_[from(corner)] + positions_[to(corner)]));
  if (!vertex_sharpness_.empty()) {
    vertex_sharpness_.push_back(0.0f);
  }
  const bool has_uvs = corners_[corner].uv != kNone;
  std::uint32_t uv = kNone;
  std::uint32_t uv_across = kNone;
  if (has_uvs) {
    uv = add_uv_between(corners_[corner].uv, corners_[next(corner)].uv);
    uv_across = across == kNone || !is_seam(corner)
                    ? uv
                    : add_uv_between(corners_[across].uv, corners_[next(across)].uv);
  }
  const Halves halves = cut(corner, {middle, uv, true});
  if (across == kNone) {
    return {middle, halves.rest, {halves.spoke, kNone}};
  }
  const Halves halves_across = cut(across, {middle, uv_across, false});
  pair(halves.rest, halves_across.rest);
  return {middle, halves.rest, {halves.spoke, halves_across.spoke}};
}

void Surgery::flip(std::uint32_t corner) {
  LIMN_ASSERT(!why_not_flip(corner));
  const std::uint32_t across = twin(corner);
  const std::uint32_t after = next(corner);
  const std::uint32_t before = next(after);
  const std::uint32_t after_across = next(across);
  const std::uint32_t before_across = next(after_across);
  const std::uint32_t face = corners_[corner].face;
  const std::uint32_t face_across = corners_[across].face;
  corners_[corner].vertex = corners_[before_across].vertex;
  corners_[corner].uv = corners_[before_across].uv;
  corners_[across].vertex = corners_[before].vertex;
  corners_[across].uv = corners_[before].uv;
  corners_[corner].sharpness = 0.0f;
  corners_[across].sharpness = 0.0f;
  make_triangle(face, {after_across, corner, before});
  make_triangle(face_across, {after, across, before_across});
  first_corners_[face] = after_across;
  first_corners_[face_across] = after;
}

void Surgery::move_vertices(std::vector<glm::dvec3> positions) {
  LIMN_EXPECTS(positions.size() == positions_.size());
  positions_ = std::move(positions);
}

void Surgery::set_vertex_sharpness(std::vector<float> sharpness) {
  LIMN_EXPECTS(sharpness.empty() || sharpness.size() == positions_.size());
  vertex_sharpness_ = std::move(sharpness);
}

void Surgery::set_sharpness(std::uint32_t corner, float sharpness) {
  corners_[corner].sharpness = sharpness;
  if (twin(corner) != kNone) {
    corners_[twin(corner)].sharpness = sharpness;
  }
}

std::shared_ptr<const ControlMesh> Surgery::finish() const {
  PolygonSoup soup;
  soup.positions = positions_;
  soup.face_offsets.reserve(first_corners_.size() + 1);
  soup.face_vertices.reserve(corners_.size());
  soup.uvs = uvs_;
  soup.creasing = creasing_;
  soup.corner_rule = corner_rule_;
  soup.names = names_by_source(names_, face_sources_);
  for (const std::uint32_t first : first_corners_) {
    std::uint32_t corner = first;
    do {
      const Corner& here = corners_[corner];
      soup.face_vertices.push_back(here.vertex);
      if (here.uv != kNone) {
        soup.face_uvs.push_back(here.uv);
      }
      if (here.sharpness > 0.0f && (here.twin == kNone || corner < here.twin)) {
        soup.creases.push_back({{here.vertex, to(corner)}, here.sharpness});
      }
      corner = here.next;
    } while (corner != first);
    soup.face_offsets.push_back(static_cast<std::uint32_t>(soup.face_vertices.size()));
  }
  for (std::uint32_t v = 0; v < vertex_sharpness_.size(); ++v) {
    if (vertex_sharpness_[v] > 0.0f) {
      soup.corners.push_back({v, vertex_sharpness_[v]});
    }
  }
  Result<ImportedMesh> built = build_control_mesh(soup);
  LIMN_EXPECTS(built.has_value() && !built->report.is_mended());
  if (loose_vertices_.empty()) {
    return std::move(built->mesh);
  }
  MeshAttributes attributes = built->mesh->attributes();
  attributes.loose_vertices = loose_vertices_;
  return std::make_shared<const ControlMesh>(built->mesh->with_attributes(std::move(attributes)));
}

}  // namespace limn
