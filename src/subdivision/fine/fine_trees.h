#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "subdivision/control_faces.h"
#include "subdivision/fine/fine_counts.h"
#include "subdivision/fine/fine_walk.h"
#include "subdivision/fine/quad_forest.h"

// Control faces with labels of finer levels. Internal to this folder.
namespace limn {

/// A piece of a control edge that is an edge of the refined mesh.
struct EdgePiece {
  int level = 0;
  std::ptrdiff_t index = 0;  ///< Among the control edge's pieces of that level.
  std::array<std::uint32_t, 2> vertices{};
};

/// The quadtrees of such faces in one cage, down to the faces of the refined mesh, with the numbers
/// of all vertices and who writes them.
class FineTrees {
 public:
  /// `plan` has everything but what is planned here. Stops after so many levels.
  void build(const RefinementPlan& plan, const FineLabels& fine, int levels);

  [[nodiscard]] bool has(std::uint32_t face) const noexcept {
    return forest_.root_of(face) != kNone;
  }
  /// Writes everything that becomes of a control face, as `refine_face` does.
  void write_face(const RefinementPlan& plan, std::uint32_t face, Patch& patch,
                  const RefinedArrays& arrays) const;
  /// The pieces of a control face's side, in its direction.
  void list_pieces(std::uint32_t face, std::uint32_t side, std::vector<EdgePiece>& pieces) const;

 private:
  class Writer;

  void grow(const RefinementPlan& plan, const FineWalk& walk);
  void number_vertices(const RefinementPlan& plan);
  void number_inside(std::uint32_t node, std::uint32_t& next);
  void number_middle(std::uint32_t vertex, std::uint32_t& next);
  void find_owners(const RefinementPlan& plan);
  void restrict_owners(const RefinementPlan& plan);
  void claim_around(std::uint32_t node, int level);
  void claim(std::uint32_t vertex, std::uint32_t node, std::uint32_t root, int level);

  struct Piece {
    int level = 0;
    std::ptrdiff_t index = 0;
    std::array<std::uint32_t, 2> ends{};  ///< As the forest numbers vertices.
  };
  void walk_root_side(const ForestRoot& root, std::uint32_t side, std::vector<Piece>& pieces) const;
  void walk_side(std::uint32_t node, std::uint32_t side, const Piece& whole,
                 std::vector<Piece>& pieces) const;

  QuadForest forest_;
  std::vector<std::uint32_t> node_roots_;
  std::vector<std::uint32_t> numbers_;     ///< Of each vertex in the refined mesh,
  std::vector<std::uint32_t> owners_;      ///< the node that writes it,
  std::vector<std::uint8_t> levels_;       ///< and the level at which it last moves.
  std::vector<std::uint32_t> only_roots_;  ///< The root that its owner must belong to.
};

}  // namespace limn
