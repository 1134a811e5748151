#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "limn/mesh/polygon_soup.h"

/// A small modelling kit: grow a quad mesh by extruding rectangular patches of it.
///
/// Only the half with x >= 0 is modelled. Vertices at exactly x = 0 lie in the mirror plane; an
/// edge between two of them gets no wall when its patch is extruded, and `mirrored` closes the mesh
/// there.
namespace limn::generator {

using Index = std::uint32_t;
inline constexpr Index kNoWall = 0xFFFFFFFFu;

/// Where a patch touches the mirror plane, if it does: with its first or its last column.
enum class MirrorSide { kNone, kFirstColumn, kLastColumn };

struct HalfMesh {
  std::vector<glm::dvec3> positions;
  std::vector<std::array<Index, 4>> quads;
};

/// A grid of faces, columns along u and rows along v; u x v points out of the mesh.
struct Patch {
  std::size_t columns = 0;
  std::size_t rows = 0;
  MirrorSide mirror = MirrorSide::kNone;
  std::vector<Index> vertices;  ///< (columns + 1) * (rows + 1), row by row.
  std::vector<Index> faces;     ///< columns * rows, row by row.

  [[nodiscard]] Index& vertex(std::size_t column, std::size_t row) {
    return vertices[row * (columns + 1) + column];
  }
  [[nodiscard]] Index vertex(std::size_t column, std::size_t row) const {
    return vertices[row * (columns + 1) + column];
  }
  [[nodiscard]] Index face(std::size_t column, std::size_t row) const {
    return faces[row * columns + column];
  }
};

/// Part of a patch, as a patch.
[[nodiscard]] Patch part(const Patch& patch, std::size_t first_column, std::size_t columns,
                         std::size_t first_row, std::size_t rows);

/// A plane that a patch is laid into: the patch's u in [-1, 1] runs along `across`, v along `along`
/// (a patch at the mirror plane covers only half of u). The patch bulges out of the plane by
/// `dome`. `roundness` 0 leaves it a rectangle, 1 makes it an ellipse.
struct Section {
  glm::dvec3 centre{0.0};
  glm::dvec3 across{1.0, 0.0, 0.0};  ///< Half the width, as a vector.
  glm::dvec3 along{0.0, 1.0, 0.0};   ///< Half the height, as a vector.
  double dome = 0.0;
  double roundness = 1.0;
};

/// Where the lines of a patch stand inside a section: u or v of every column or row line, ascending
/// within [-1, 1].
struct Spacing {
  std::vector<double> u;
  std::vector<double> v;
};
[[nodiscard]] Spacing even_spacing(const Patch& patch);

/// Moves the patch's vertices into the section.
void lay(HalfMesh& mesh, const Patch& patch, const Section& section, const Spacing& spacing);

/// What extruding patches one after the other leaves behind. Position p of the perimeter runs
/// counter-clockwise seen from outside: along the first row, the last column, back along the last
/// row and down the first column.
struct Tube {
  std::vector<std::vector<Index>> rings;  ///< Perimeter vertices, one ring more than walls.
  std::vector<std::vector<Index>> walls;  ///< Faces between ring k and k + 1; kNoWall in the plane.
};
[[nodiscard]] Tube begin_tube(const Patch& patch);

/// Extrudes the patch: its faces move off on a ring of new walls, and stay addressed by `patch`.
/// The new vertices start where the old ones are; `lay` them where they belong.
void extrude(HalfMesh& mesh, Patch& patch, Tube& tube);

/// Extrude and lay in one.
void grow(HalfMesh& mesh, Patch& patch, Tube& tube, const Section& section, const Spacing& spacing);
void grow(HalfMesh& mesh, Patch& patch, Tube& tube, const Section& section);

/// A patch of a tube's walls: u along the perimeter, v along the tube.
[[nodiscard]] Patch side(const HalfMesh& mesh, const Tube& tube, std::size_t first_position,
                         std::size_t columns, std::size_t first_ring, std::size_t rows);

/// Two patches back to back, sharing their outline: the start of a mesh. The first looks along
/// u x v; the second has its rows in the opposite order and looks the other way. Both touch the
/// mirror plane with their first column. All vertices are at the origin until they are laid.
struct Pillow {
  Patch front;
  Patch back;
};
[[nodiscard]] Pillow pillow(HalfMesh& mesh, std::size_t columns, std::size_t rows);

/// Mean of the patch's vertices, and its mean outward normal, of length 1.
[[nodiscard]] glm::dvec3 centre(const HalfMesh& mesh, const Patch& patch);
[[nodiscard]] glm::dvec3 normal(const HalfMesh& mesh, const Patch& patch);

/// Extrudes and then scales the patch about its centre by `scale` and moves it by `offset`.
void extrude_by(HalfMesh& mesh, Patch& patch, Tube& tube, const glm::dvec3& offset, double scale);

/// Both halves, joined in the plane x = 0: exactly symmetric.
[[nodiscard]] PolygonSoup mirrored(const HalfMesh& half);

}  // namespace limn::generator
