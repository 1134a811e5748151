#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "limn/mesh/creases.h"
#include "limn/mesh/face_names.h"
#include "limn/mesh/flat_topology.h"
#include "limn/mesh/halfedge_mesh.h"
#include "limn/mesh/texture_coordinates.h"

namespace limn {

/// Axis-aligned bounds in mesh units.
struct Bounds {
  glm::dvec3 low{0.0};
  glm::dvec3 high{0.0};

  [[nodiscard]] glm::dvec3 centre() const noexcept;
  /// Length of the diagonal: the unit in which deviations are reported.
  [[nodiscard]] double diagonal() const noexcept;
};

/// What a control mesh carries besides its surface.
struct MeshAttributes {
  Creases creases;
  std::optional<CornerRule> corners;  ///< What the file asks of boundary corners, if it says so.
  TextureCoordinates texture;
  FaceNaming names;
  std::vector<glm::dvec3> loose_vertices;  ///< Vertices of the file in no face: no part of the
                                           ///< surface, kept to be written back.
};

/// The polygon mesh the artist paints: an oriented 2-manifold, with or without boundary, of
/// polygons with three or more sides. Immutable, so it can be shared between a document, its undo
/// history and a refinement that runs on another thread.
///
/// Made from a file or a PolygonSoup by `build_control_mesh` (mesh/build.h), which validates.
class ControlMesh {
 public:
  /// Takes over a half-edge mesh without isolated vertices, deleted elements or non-manifold
  /// vertices. The arrays of `attributes` are empty or fit the mesh's flat topology; sharpness is
  /// finite and not negative.
  explicit ControlMesh(HalfedgeMesh mesh, MeshAttributes attributes = {});

  /// The same surface with other attributes. Everything else is shared, not copied.
  [[nodiscard]] ControlMesh with_attributes(MeshAttributes attributes) const;

  [[nodiscard]] const HalfedgeMesh& halfedges() const noexcept { return surface_->halfedges; }
  [[nodiscard]] const FlatTopology& topology() const noexcept { return surface_->topology; }

  [[nodiscard]] std::size_t vertex_count() const noexcept { return surface_->positions.size(); }
  [[nodiscard]] std::size_t edge_count() const noexcept {
    return surface_->topology.edge_vertices.size();
  }
  [[nodiscard]] std::size_t face_count() const noexcept {
    return surface_->topology.face_offsets.size() - 1;
  }

  [[nodiscard]] std::span<const glm::dvec3> positions() const noexcept {
    return surface_->positions;
  }
  /// Vertices of face f, counter-clockwise seen from outside.
  [[nodiscard]] std::span<const std::uint32_t> face(std::size_t f) const noexcept;

  [[nodiscard]] bool is_all_quads() const noexcept { return surface_->is_all_quads; }
  [[nodiscard]] bool is_closed() const noexcept { return surface_->is_closed; }
  [[nodiscard]] const Bounds& bounds() const noexcept { return surface_->bounds; }

  [[nodiscard]] const MeshAttributes& attributes() const noexcept { return attributes_; }
  [[nodiscard]] const Creases& creases() const noexcept { return attributes_.creases; }
  [[nodiscard]] const TextureCoordinates& texture() const noexcept { return attributes_.texture; }
  /// The texture coordinates as a mesh of their own; null where there are none.
  [[nodiscard]] const TextureSurface* texture_surface() const noexcept {
    return texture_surface_.get();
  }

 private:
  struct Surface {
    HalfedgeMesh halfedges;
    FlatTopology topology;
    std::vector<glm::dvec3> positions;
    Bounds bounds;
    bool is_all_quads = false;
    bool is_closed = false;
  };

  ControlMesh(std::shared_ptr<const Surface> surface, MeshAttributes attributes);

  std::shared_ptr<const Surface> surface_;
  MeshAttributes attributes_;
  std::shared_ptr<const TextureSurface> texture_surface_;
};

}  // namespace limn
