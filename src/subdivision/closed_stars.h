#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "limn/mesh/large_array.h"
#include "limn/mesh/refined_mesh.h"

// The cheap proof that nearly all edges of a refined mesh are whole. Internal to this folder.
namespace limn {

/// What was seen of a vertex.
struct StarMark {
  std::uint8_t is_closed = 0;  ///< Its star was closed in a run,
  std::uint8_t is_open = 0;    ///< or in another left open.
};

/// Where that is noted: one entry per vertex, and one for none.
struct StarMarks {
  StarMark* marks = nullptr;
  std::size_t vertex_count = 0;
};

/// The faces around the vertices of a run of faces, as far as they belong to the run.
class StarTable {
 public:
  /// Makes room for so many vertices, or as many as make a run. Those with numbers below
  /// `early_vertices` may come in any order without much harm.
  void prepare(std::size_t vertices, std::uint32_t early_vertices);
  /// Looks at some faces of the mesh, run by run, and marks all their vertices, most of them as
  /// closed. Returns how many stars were closed.
  std::size_t mark(const RefinedMesh& mesh, std::size_t first_face, std::size_t last_face,
                   const StarMarks& marks);

 private:
  using Quad = std::array<std::uint32_t, 4>;

  /// The places, and where vertices are at home there.
  struct Places {
    std::uint32_t* table = nullptr;
    std::uint32_t half = 0;  ///< Half of the number of places.
    std::uint32_t early_vertices = 0;

    [[nodiscard]] std::uint32_t home_of(std::uint32_t vertex) const noexcept;
    [[nodiscard]] std::uint32_t* entry(std::uint32_t place) const noexcept;
  };

  const Quad* add_quads(const Quad* quad, const Quad* end);
  void add_polygon(std::span<const std::uint32_t> polygon, const StarMarks& marks);
  [[nodiscard]] std::size_t finish_run(const StarMarks& marks);

  struct Taken;
  [[nodiscard]] static Taken place_of(std::uint32_t vertex, const Places& places,
                                      std::uint32_t& used);
  [[nodiscard]] static std::uint32_t distant_place_of(std::uint32_t vertex, const Places& places);

  LargeArray<std::uint32_t> memory_;
  Places places_;
  std::uint32_t used_ = 0;
};

/// Tells settled vertices from others. A vertex is settled if the edges on which its faces leave it
/// are all different, those on which they come to it likewise, and both are the same edges. Then
/// each edge there has two faces, which run along it in opposite directions.
class SettledVertices {
 public:
  explicit SettledVertices(const StarMark* marks) : marks_(marks) {}
  /// 1 where the vertex is settled, otherwise 0.
  [[nodiscard]] std::uint32_t operator[](std::uint32_t v) const noexcept {
    return marks_[v].is_closed;
  }

 private:
  const StarMark* marks_;
};

/// Finds settled vertices.
class ClosedStars {
 public:
  /// Vertices with numbers below `early_vertices` may lie anywhere, the others had better come in
  /// about the order of the faces. Memory of an earlier call is used again.
  void find(const RefinedMesh& mesh, std::size_t early_vertices);

  /// Most vertices that could be are settled, yet not all.
  [[nodiscard]] SettledVertices settled() const noexcept { return SettledVertices(marks_.data()); }
  /// Vertices without a face.
  [[nodiscard]] std::size_t unused_vertices() const noexcept { return unused_; }

 private:
  void combine(std::size_t stars);

  struct Lane {
    StarTable table;
    std::size_t closed = 0;
  };
  std::vector<Lane> lanes_;
  LargeArray<StarMark> marks_;
  std::size_t unused_ = 0;
};

}  // namespace limn
