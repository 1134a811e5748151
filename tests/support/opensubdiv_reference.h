#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "limn/mesh/control_mesh.h"
#include "limn/subdivision/labels.h"
#include "limn/subdivision/settings.h"

// OpenSubdiv as the judge of positions and, through its parent-child relations, of connectivity.
namespace limn::test {

/// Vertices of one level on the limit surface, by vertex number.
struct ReferenceLimits {
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;  ///< Of length 1, or not finite where the tangents are parallel.
};

/// Whose steps.
enum class ReferenceScheme { kCatmullClark, kLoop, kBilinear };

/// A control mesh after 0..levels uniform steps, Catmull-Clark's if nothing else is said, with its
/// creases and texture coordinates, by OpenSubdiv in double precision. Level 0 has the control
/// mesh's vertex and face numbers.
class UniformHierarchy {
 public:
  UniformHierarchy(const ControlMesh& mesh, int levels, CornerRule corners,
                   TextureRule texture = TextureRule::kSmoothInside,
                   ReferenceScheme scheme = ReferenceScheme::kCatmullClark);
  ~UniformHierarchy();
  UniformHierarchy(const UniformHierarchy&) = delete;
  UniformHierarchy& operator=(const UniformHierarchy&) = delete;

  [[nodiscard]] int levels() const;
  /// Positions of all levels from the given ones at level 0: `[level][vertex]`.
  [[nodiscard]] std::vector<std::vector<glm::dvec3>> positions(
      std::span<const glm::dvec3> control) const;
  /// Limit positions and normals of the last level's vertices. OpenSubdiv takes creases that are
  /// still semi-sharp there for infinitely sharp ones.
  [[nodiscard]] ReferenceLimits limits(std::span<const glm::dvec3> control) const;

  /// Texture coordinates of all levels from the given ones at level 0: `[level][value]`. For a mesh
  /// that has some.
  [[nodiscard]] std::vector<std::vector<glm::dvec2>> uvs(std::span<const glm::dvec2> control) const;
  /// Into these, one for each corner of a face.
  [[nodiscard]] std::vector<std::uint32_t> face_uvs(int level, std::uint32_t face) const;

  [[nodiscard]] std::uint32_t vertex_count(int level) const;
  [[nodiscard]] std::uint32_t edge_count(int level) const;
  [[nodiscard]] std::uint32_t face_count(int level) const;
  [[nodiscard]] std::vector<std::uint32_t> face_vertices(int level, std::uint32_t face) const;
  /// Edge i runs from vertex i of the face to the next.
  [[nodiscard]] std::vector<std::uint32_t> face_edges(int level, std::uint32_t face) const;
  [[nodiscard]] std::array<std::uint32_t, 2> edge_vertices(int level, std::uint32_t edge) const;
  /// Around a vertex, counter-clockwise: face i lies between edges i and i + 1. A boundary vertex
  /// has one edge more than faces, the first and the last on the boundary.
  [[nodiscard]] std::vector<std::uint32_t> vertex_edges(int level, std::uint32_t vertex) const;
  [[nodiscard]] std::vector<std::uint32_t> vertex_faces(int level, std::uint32_t vertex) const;
  /// What is left of it at this level; boundary edges are infinitely sharp.
  [[nodiscard]] float edge_sharpness(int level, std::uint32_t edge) const;
  [[nodiscard]] float vertex_sharpness(int level, std::uint32_t vertex) const;
  /// What becomes of something of this level in the next one. Child face i lies at corner i.
  [[nodiscard]] std::vector<std::uint32_t> child_faces(int level, std::uint32_t face) const;
  [[nodiscard]] std::uint32_t child_of_face(int level, std::uint32_t face) const;
  [[nodiscard]] std::uint32_t child_of_edge(int level, std::uint32_t edge) const;
  [[nodiscard]] std::uint32_t child_of_vertex(int level, std::uint32_t vertex) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// The adaptive mesh that labels ask for, told in vertices of the uniform hierarchy.
struct ReferenceMesh {
  struct Vertex {
    int level = 0;            ///< At which it was made or last moved,
    std::uint32_t index = 0;  ///< and its number there.
  };
  struct Face {
    std::vector<std::uint32_t> vertices;  ///< Into `vertices`.
    int level = 0;
    std::uint32_t control_face = 0;
  };
  std::vector<Vertex> vertices;  ///< Control vertices first, in order.
  std::vector<Face> faces;
};

/// Labels of the vertices of every level of a hierarchy: `[level][vertex]`.
using LevelLabels = std::vector<std::vector<std::uint8_t>>;

/// The rules of one level, spelled out on the uniform meshes without regard to cost: an
/// implementation that shares nothing with the library's. `given`: labels of finer levels, in place
/// of those that follow from the level before.
[[nodiscard]] ReferenceMesh reference_refinement(const UniformHierarchy& hierarchy,
                                                 const VertexLabels& labels, int levels,
                                                 const LevelLabels* given = nullptr);

}  // namespace limn::test
