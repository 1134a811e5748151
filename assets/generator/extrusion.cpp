// Extruding keeps the faces of a patch and gives them new outline vertices; walls close the gap
// between the old outline and the new one:
//
//      +--+--+--+              +--+--+--+
//      |  |  |  |   extrude    |\ |  | /|      the patch's faces keep their numbers,
//      +--+--+--+   ------>    +-+-+-+-+       inner vertices move along,
//      |  |  |  |              | |  |  ||      outline vertices are doubled
//      +--+--+--+              |/ |  | \|
//                              +--+--+--+
#include "extrusion.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace limn::generator {
namespace {

bool is_in_mirror_plane(const HalfMesh& mesh, Index v) {
  return mesh.positions[v].x == 0.0;
}

std::vector<Index> perimeter(const Patch& patch) {
  std::vector<Index> ring;
  for (std::size_t c = 0; c < patch.columns; ++c) {
    ring.push_back(patch.vertex(c, 0));
  }
  for (std::size_t r = 0; r < patch.rows; ++r) {
    ring.push_back(patch.vertex(patch.columns, r));
  }
  for (std::size_t c = patch.columns; c > 0; --c) {
    ring.push_back(patch.vertex(c, patch.rows));
  }
  for (std::size_t r = patch.rows; r > 0; --r) {
    ring.push_back(patch.vertex(0, r));
  }
  return ring;
}

Patch grid(std::size_t columns, std::size_t rows) {
  Patch patch;
  patch.columns = columns;
  patch.rows = rows;
  patch.vertices.resize((columns + 1) * (rows + 1));
  patch.faces.resize(columns * rows);
  return patch;
}

void write_quads(HalfMesh& mesh, const Patch& patch) {
  for (std::size_t r = 0; r < patch.rows; ++r) {
    for (std::size_t c = 0; c < patch.columns; ++c) {
      mesh.quads[patch.face(c, r)] = {patch.vertex(c, r), patch.vertex(c + 1, r),
                                      patch.vertex(c + 1, r + 1), patch.vertex(c, r + 1)};
    }
  }
}

}  // namespace

Patch part(const Patch& patch, std::size_t first_column, std::size_t columns, std::size_t first_row,
           std::size_t rows) {
  Patch result = grid(columns, rows);
  for (std::size_t r = 0; r <= rows; ++r) {
    for (std::size_t c = 0; c <= columns; ++c) {
      result.vertex(c, r) = patch.vertex(first_column + c, first_row + r);
      if (r < rows && c < columns) {
        result.faces[r * columns + c] = patch.face(first_column + c, first_row + r);
      }
    }
  }
  if (patch.mirror == MirrorSide::kFirstColumn && first_column == 0) {
    result.mirror = MirrorSide::kFirstColumn;
  } else if (patch.mirror == MirrorSide::kLastColumn && first_column + columns == patch.columns) {
    result.mirror = MirrorSide::kLastColumn;
  }
  return result;
}

Spacing even_spacing(const Patch& patch) {
  const double u_low = patch.mirror == MirrorSide::kFirstColumn ? 0.0 : -1.0;
  const double u_high = patch.mirror == MirrorSide::kLastColumn ? 0.0 : 1.0;
  Spacing spacing;
  for (std::size_t c = 0; c <= patch.columns; ++c) {
    const double t = static_cast<double>(c) / static_cast<double>(patch.columns);
    spacing.u.push_back(u_low * (1.0 - t) + u_high * t);
  }
  for (std::size_t r = 0; r <= patch.rows; ++r) {
    spacing.v.push_back(2.0 * static_cast<double>(r) / static_cast<double>(patch.rows) - 1.0);
  }
  return spacing;
}

void lay(HalfMesh& mesh, const Patch& patch, const Section& section, const Spacing& spacing) {
  const glm::dvec3 out = glm::normalize(glm::cross(section.across, section.along));
  for (std::size_t r = 0; r <= patch.rows; ++r) {
    for (std::size_t c = 0; c <= patch.columns; ++c) {
      const double u = spacing.u[c];
      const double v = spacing.v[r];
      // The elliptical grid map takes the square to the disc and its outline to the circle.
      const double round_u = u * std::sqrt(1.0 - v * v / 2.0);
      const double round_v = v * std::sqrt(1.0 - u * u / 2.0);
      const double x = u + section.roundness * (round_u - u);
      const double y = v + section.roundness * (round_v - v);
      const double height =
          section.dome * std::max(0.0, 1.0 - round_u * round_u - round_v * round_v);
      mesh.positions[patch.vertex(c, r)] =
          section.centre + x * section.across + y * section.along + height * out;
    }
  }
}

Tube begin_tube(const Patch& patch) {
  return {{perimeter(patch)}, {}};
}

void extrude(HalfMesh& mesh, Patch& patch, Tube& tube) {
  const std::vector<Index> old_ring = perimeter(patch);
  const std::size_t count = old_ring.size();
  std::vector<bool> has_wall(count);
  for (std::size_t p = 0; p < count; ++p) {
    has_wall[p] = !(is_in_mirror_plane(mesh, old_ring[p]) &&
                    is_in_mirror_plane(mesh, old_ring[(p + 1) % count]));
  }
  std::vector<Index> new_ring = old_ring;
  for (std::size_t p = 0; p < count; ++p) {
    if (has_wall[p] || has_wall[(p + count - 1) % count]) {
      new_ring[p] = static_cast<Index>(mesh.positions.size());
      mesh.positions.push_back(glm::dvec3(mesh.positions[old_ring[p]]));
    }
  }
  for (Index& v : patch.vertices) {
    const auto found = std::ranges::find(old_ring, v);
    if (found != old_ring.end()) {
      v = new_ring[static_cast<std::size_t>(found - old_ring.begin())];
    }
  }
  write_quads(mesh, patch);

  std::vector<Index> walls(count, kNoWall);
  for (std::size_t p = 0; p < count; ++p) {
    if (has_wall[p]) {
      const std::size_t q = (p + 1) % count;
      walls[p] = static_cast<Index>(mesh.quads.size());
      mesh.quads.push_back({old_ring[p], old_ring[q], new_ring[q], new_ring[p]});
    }
  }
  tube.walls.push_back(std::move(walls));
  tube.rings.push_back(std::move(new_ring));
}

void grow(HalfMesh& mesh, Patch& patch, Tube& tube, const Section& section,
          const Spacing& spacing) {
  extrude(mesh, patch, tube);
  lay(mesh, patch, section, spacing);
}

void grow(HalfMesh& mesh, Patch& patch, Tube& tube, const Section& section) {
  grow(mesh, patch, tube, section, even_spacing(patch));
}

Patch side(const HalfMesh& mesh, const Tube& tube, std::size_t first_position, std::size_t columns,
           std::size_t first_ring, std::size_t rows) {
  Patch patch = grid(columns, rows);
  const std::size_t count = tube.rings.front().size();
  for (std::size_t r = 0; r <= rows; ++r) {
    for (std::size_t c = 0; c <= columns; ++c) {
      patch.vertex(c, r) = tube.rings[first_ring + r][(first_position + c) % count];
      if (r < rows && c < columns) {
        patch.faces[r * columns + c] = tube.walls[first_ring + r][(first_position + c) % count];
      }
    }
  }
  if (is_in_mirror_plane(mesh, patch.vertex(0, 0))) {
    patch.mirror = MirrorSide::kFirstColumn;
  } else if (is_in_mirror_plane(mesh, patch.vertex(columns, 0))) {
    patch.mirror = MirrorSide::kLastColumn;
  }
  return patch;
}

Pillow pillow(HalfMesh& mesh, std::size_t columns, std::size_t rows) {
  Pillow result{grid(columns, rows), grid(columns, rows)};
  const auto add_vertex = [&] {
    mesh.positions.emplace_back(0.0);
    return static_cast<Index>(mesh.positions.size() - 1);
  };
  for (std::size_t r = 0; r <= rows; ++r) {
    for (std::size_t c = 0; c <= columns; ++c) {
      // The first column lies in the mirror plane: its inner vertices belong to no outline.
      const bool is_outline = r == 0 || r == rows || c == columns;
      const Index v = add_vertex();
      result.front.vertex(c, r) = v;
      result.back.vertex(c, rows - r) = is_outline ? v : add_vertex();
    }
  }
  for (Patch* patch : {&result.front, &result.back}) {
    patch->mirror = MirrorSide::kFirstColumn;
    for (Index& face : patch->faces) {
      face = static_cast<Index>(mesh.quads.size());
      mesh.quads.emplace_back();
    }
    write_quads(mesh, *patch);
  }
  return result;
}

glm::dvec3 centre(const HalfMesh& mesh, const Patch& patch) {
  glm::dvec3 sum(0.0);
  for (const Index v : patch.vertices) {
    sum += mesh.positions[v];
  }
  return sum / static_cast<double>(patch.vertices.size());
}

glm::dvec3 normal(const HalfMesh& mesh, const Patch& patch) {
  glm::dvec3 sum(0.0);
  for (const Index f : patch.faces) {
    const auto& quad = mesh.quads[f];
    sum += glm::cross(mesh.positions[quad[2]] - mesh.positions[quad[0]],
                      mesh.positions[quad[3]] - mesh.positions[quad[1]]);
  }
  return glm::normalize(sum);
}

void extrude_by(HalfMesh& mesh, Patch& patch, Tube& tube, const glm::dvec3& offset, double scale) {
  extrude(mesh, patch, tube);
  glm::dvec3 middle = centre(mesh, patch);
  if (patch.mirror != MirrorSide::kNone) {
    middle.x = 0.0;  // stay in the mirror plane
  }
  for (const Index v : patch.vertices) {
    glm::dvec3& p = mesh.positions[v];
    p = middle + scale * (p - middle) + offset;
  }
}

PolygonSoup mirrored(const HalfMesh& half) {
  PolygonSoup soup;
  soup.positions = half.positions;
  std::vector<Index> twin(half.positions.size());
  for (std::size_t v = 0; v < half.positions.size(); ++v) {
    const glm::dvec3& p = half.positions[v];
    if (p.x == 0.0) {
      twin[v] = static_cast<Index>(v);
    } else {
      twin[v] = static_cast<Index>(soup.positions.size());
      soup.positions.emplace_back(-p.x, p.y, p.z);
    }
  }
  for (const auto& quad : half.quads) {
    soup.add_face(quad);
  }
  for (const auto& quad : half.quads) {
    soup.add_face(std::array{twin[quad[3]], twin[quad[2]], twin[quad[1]], twin[quad[0]]});
  }
  return soup;
}

}  // namespace limn::generator
